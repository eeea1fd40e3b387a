"""Files of text, .npz and HDF5, and what all readers check."""
import importlib.util
import pathlib
import tempfile
import unittest

import numpy as np

import saccade

T, X, Y, P = [5, 7, 7, 249], [0, 345, 2, 3], [1, 259, 0, 3], [1, 0, 1, 1]


class Readers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name

    def expect(self, path, expected_size, **more):
        whole = saccade.read(path, **more)
        self.assertEqual((whole.t.tolist(), whole.x.tolist(), whole.y.tolist(), whole.p.tolist()), (T, X, Y, P))
        self.assertEqual(whole.size, expected_size)
        pieces = list(saccade.open_file(path, chunk=3, **more))
        self.assertEqual([piece.t.tolist() for piece in pieces], [T[:3], T[3:]])

    def test_csv(self):
        lines = [f"{t},{x},{y},{p}\n" for t, x, y, p in zip(T, X, Y, P)]
        self.expect(self.write("old.csv", "t_us,x,y,p\n" + "".join(lines)), None)
        path = self.write("a.csv", "t,x,y,p\n" + "".join(lines))
        self.expect(path, None)
        self.expect(path, (346, 260), size=(346, 260))
        self.assertEqual(len(saccade.read(self.write("none.csv", "t,x,y,p\n"))), 0)

    def test_txt_in_seconds(self):
        lines = [f"{t / 1e6:.9f} {x} {y} {p}\n" for t, x, y, p in zip(T, X, Y, P)]
        self.expect(self.write("a.txt", "346 260\n" + "".join(lines)), (346, 260))
        self.expect(self.write("b.txt", "".join(lines)), None)

    def test_npz(self):
        path = self.folder / "a.npz"
        np.savez(path, t=np.array(T, np.int64), x=np.array(X, np.uint16), y=np.array(Y, np.uint16),
                 p=np.array(P, np.uint8), width=346, height=260)
        self.expect(path, (346, 260))
        signed = np.array(P) * 2 - 1  # as rpg_vid2e has it
        np.savez(path, t=np.array(T), x=np.array(X), y=np.array(Y), p=signed)
        self.expect(path, None)

    def expect_labels(self, path):
        whole, pieces = saccade.read(path), list(saccade.open_file(path, chunk=3))
        self.assertEqual((whole.source.tolist(), whole.artefact.tolist()), ([0, 1, 0, 1], [9, 0, 255, 0]))
        self.assertEqual(pieces[1].source.tolist(), [1])

    def test_labels(self):
        path = self.folder / "a.npz"
        columns = {"t": np.array(T), "x": np.array(X), "y": np.array(Y), "p": np.array(P)}
        labels = {"source": np.array([0, 1, 0, 1], np.uint8), "artefact": np.array([9, 0, 255, 0], np.uint8)}
        np.savez(path, **columns, **labels)
        self.expect_labels(path)
        events = saccade.read(path, size=(346, 260))
        events.save(self.folder / "b.npz")
        self.expect_labels(self.folder / "b.npz")
        np.savez(path, **columns)
        self.assertIsNone(saccade.read(path).source)
        np.savez(path, **columns, source=np.zeros(3, np.uint8), artefact=labels["artefact"])
        with self.assertRaisesRegex(saccade.FormatError, "labels must have the length of t"):
            saccade.read(path)
        if importlib.util.find_spec("h5py"):
            import h5py
            with h5py.File(self.folder / "a.h5", "w") as file:
                for name, column in {**columns, **labels}.items():
                    file[f"events/{name}"] = column
            self.expect_labels(self.folder / "a.h5")

    @unittest.skipUnless(importlib.util.find_spec("h5py"), "h5py is not installed")
    def test_hdf5_of_dsec(self):
        import h5py
        path = self.folder / "a.h5"
        with h5py.File(path, "w") as file:
            for name, values, kind in (("t", np.array(T) - 5, "u4"), ("x", X, "u2"), ("y", Y, "u2"), ("p", P, "u1")):
                file.create_dataset(f"events/{name}", data=np.array(values, kind), chunks=True, compression="gzip")
            file["t_offset"] = 5
            file.attrs.update(width=346, height=260)
        self.expect(path, (346, 260))
        with h5py.File(path, "a") as file:
            del file["events/p"]
        self.expectFault(path, "no data set 'events/p'")
        self.expectFault(self.write("b.h5", "no"), "file signature not found")

    def with_sidecar(self, begin_ns, end_ns, size=(346, 260)):
        """The events as CSV, which holds no size, with a description as `saccade record` writes it."""
        lines = [f"{t},{x},{y},{p}\n" for t, x, y, p in zip(T, X, Y, P)]
        self.write("a.csv.json", f'{{"width": {size[0]}, "height": {size[1]}, "begin_ns": "{begin_ns}", '
                                 f'"end_ns": "{end_ns}"}}')
        return self.write("a.csv", "t_us,x,y,p\n" + "".join(lines))

    def test_a_recording_begins_and_ends_as_its_description_says(self):
        path = self.with_sidecar(0, 400_000)
        whole = saccade.read(path)
        self.assertEqual((whole.t0, whole.t1, whole.size), (0, 400, (346, 260)))
        self.assertEqual([(w.t0, w.t1, len(w)) for w in whole.windows(duration_us=100)],
                         [(0, 100, 3), (100, 200, 0), (200, 300, 1), (300, 400, 0)])
        pieces = list(saccade.open_file(path, chunk=1))
        self.assertEqual([piece.t.tolist() for piece in pieces], [[5], [7], [7], [249]])
        self.assertEqual([w.t0 for w in saccade.windows(pieces, duration_us=100)], [0, 100, 200, 300])
        self.assertEqual(saccade.read(self.with_sidecar(3_000, 250_000)).t0, 3)

    def test_a_recording_without_events_has_its_interval_too(self):
        self.write("none.csv.json", '{"width": 9, "height": 5, "end_ns": "20000"}')
        none = saccade.read(self.write("none.csv", "t_us,x,y,p\n"))
        self.assertEqual((len(none), none.t0, none.t1, none.size), (0, 0, 20, (9, 5)))

    def test_the_description_of_another_recording_is_refused(self):
        for begin, end in ((0, 249_000), (6_000, 400_000)):
            self.expectFault(self.with_sidecar(begin, end), "not those that .*a.csv.json describes")
        self.expectFault(self.with_sidecar(0, 400_000, (9, 5)), "outside 9x5")
        self.write("a.csv.json", "no")
        self.expectFault(self.folder / "a.csv", "a.csv.json")

    def expectFault(self, path, text, **more):
        with self.assertRaisesRegex(saccade.FormatError, text):
            saccade.read(path, **more)

    def test_faults_are_told(self):
        self.expectFault("a.bag", r"not one of \.raw, \.aedat4, \.h5, \.npz, \.csv, \.txt")
        self.expectFault(self.write("a.csv", "time,x,y,p\n"), "heading is 'time,x,y,p'")
        self.expectFault(self.write("a.csv", "t_us,x,y,p\n1,2,3,one\n"), "a.csv")
        self.expectFault(self.write("a.csv", "t_us,x,y,p\n1,2,3\n"), "3 numbers instead of 4")
        self.expectFault(self.write("a.csv", "t_us,x,y,p\n5,2,3,1\n4,2,3,1\n"), "run backwards")
        self.expectFault(self.write("a.csv", "t_us,x,y,p\n5,-1,3,1\n"), "x lies outside")
        self.expectFault(self.write("a.csv", "t_us,x,y,p\n5,1,3,4\n"), "polarity")
        self.expectFault(self.write("a.csv", "t_us,x,y,p\n5,2,3,1\n"), "outside 2x9", size=(2, 9))
        self.expectFault(self.write("a.txt", "9 9\n0.1 2 3 1\n"), r"size is \(9, 9\)", size=(8, 8))
        self.expectFault(self.write("a.npz", "no"), "a.npz")
        np.savez(self.folder / "b.npz", t=T)
        self.expectFault(self.folder / "b.npz", "no array 'p'")
        np.savez(self.folder / "c.npz", t=T, x=X, y=Y, p=P[:2])
        self.expectFault(self.folder / "c.npz", "one length")
        with self.assertRaises(FileNotFoundError):
            saccade.read(self.folder / "none.npz")

    def test_times_are_checked_from_piece_to_piece(self):
        path = self.write("a.csv", "t_us,x,y,p\n5,2,3,1\n4,2,3,1\n")
        with self.assertRaisesRegex(saccade.FormatError, "backwards"):
            list(saccade.open_file(path, chunk=1))


if __name__ == "__main__":
    unittest.main()
