"""Files .npz and NumPy. Usage: npz_files_test.py SACCADE"""
import io
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import event_columns

try:
    import numpy as np
except ImportError as fault:
    event_columns.skip(fault)

convert = event_columns.Converter(sys.argv[1])


class Npz(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.npz = self.folder / "a.npz"

    def fault(self):
        code, errors = convert.run(self.npz, self.folder / "out.csv", "--size", "1280x720")
        self.assertEqual(code, 1, errors)
        self.assertIn(f"{self.npz}: ", errors)
        return errors

    def test_numpy_reads_the_types_of_evutils(self):
        for count in [0, 1, 200_000]:
            events = event_columns.random_events(count)
            events["t"] += 1_700_000_000_123_456
            convert.from_events(events, self.folder, self.npz)
            with np.load(self.npz, allow_pickle=False) as file:
                self.assertEqual({name: file[name].dtype for name in file.files},
                                 {"t": np.int64, "x": np.uint16, "y": np.uint16, "p": np.uint8, "width": np.int64,
                                  "height": np.int64})
                self.assertEqual((file["width"][()], file["height"][()]), event_columns.SIZE)
                event_columns.assert_equal(file, events)

    def test_python_finds_no_fault_in_the_archive(self):
        convert.from_events(event_columns.random_events(1000), self.folder, self.npz)
        with zipfile.ZipFile(self.npz) as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual(archive.namelist(), [c + ".npy" for c in event_columns.COLUMNS + ["width", "height"]])

    def test_files_of_numpy_are_read(self):
        events = event_columns.random_events(140_000)
        for save in [np.savez, np.savez_compressed]:
            save(self.npz, **events)
            event_columns.assert_equal(convert.to_events(self.npz, self.folder), events)
            save(self.npz, **{**events, "x": events["x"].astype("u4"), "y": events["y"].astype("i2"),
                              "p": events["p"].astype(bool), "t": events["t"].astype("u8"), "extra": np.zeros((2, 2))})
            event_columns.assert_equal(convert.to_events(self.npz, self.folder), events)

    def read(self, *options):
        code, errors = convert.run(self.npz, self.folder / "out.csv", "--size", "1280x720", *options)
        self.assertEqual(code, 0, errors)
        return event_columns.read_csv(self.folder / "out.csv"), errors

    def test_layouts_of_others_are_read(self):
        events = event_columns.random_events(70_000)
        t, x, y, p = (events[name] for name in event_columns.COLUMNS)
        whole = "read t as microseconds (it has whole numbers), columns "
        table = np.stack([t, x, y, p], 1)
        structured = np.zeros(len(t), np.dtype([("x", "<u2"), ("y", "<u2"), ("t", "<i8"), ("p", "|b1")], align=True))
        for name in event_columns.COLUMNS:
            structured[name] = events[name]
        for said, arrays in [
                (whole + "timestamp x y polarity, size 1280x720 from --size",
                 {"x": x, "y": y, "timestamp": t, "polarity": p}),  # Time Lens
                (whole + "t x y p", {**events, "p": (2 * p - 1).astype("i1")}),
                (whole + "t x y p", {**events, "p": np.where(p, 1, 2**32 - 1).astype("u8")}),  # v2e#47
                ("t as seconds (it has a decimal point), columns t x y p", {**events, "t": t / 1e6}),
                ("", {"t_us": t, "x": x, "y": y, "p": p}), ("", {"x": x, "y": y, "time_ns": t * 1000, "on": p > 0}),
                (whole + "t x y p of events", {"events": table, "others": np.zeros((3, 2))}),
                (whole + "t x y p of events", {"events": np.asfortranarray(table)}),
                (whole + "x y t p of events", {"events": table[:, [1, 2, 0, 3]].astype("i4")}),
                ("t as seconds (it has a decimal point), columns x y t p of arr_0",
                 {"arr_0": np.stack([x, y, t / 1e6, 2 * p - 1], 1)}),
                (whole + "t x y p of events", {"events": structured, "name": np.array(["a", "b"])}),
        ]:
            np.savez(self.npz, **arrays)
            read, errors = self.read()
            event_columns.assert_equal(read, events)
            self.assertIn(said, errors)
            if not said:
                self.assertEqual(errors, "")

    def test_what_may_be_read_in_two_ways_needs_an_option(self):
        np.savez(self.npz, events=[[0, 0, 0, 1], [10, 0, 10, 1]])
        self.assertIn("may be t,x,y,p or x,y,t,p: give --columns t,x,y,p or --columns x,y,t,p", self.fault())
        self.assertEqual(self.read("--columns", "t_ms,x,y,p")[0]["t"].tolist(), [0, 10_000])
        events = event_columns.random_events(1000)
        np.savez(self.npz, **{**events, "t": events["t"] * 1.0})
        self.assertIn("it may count seconds or microseconds: give --unit s or --unit us", self.fault())
        event_columns.assert_equal(self.read("--unit", "us")[0], events)
        np.savez(self.npz, a=events["t"], b=events["x"], c=events["y"], d=events["p"])
        self.assertIn("its arrays are a b c d; --columns", self.fault())
        event_columns.assert_equal(self.read("--columns", "a,b,c,d")[0], events)
        np.savez(self.npz, **events, timestamps=events["t"] + 1)
        self.assertIn("'t' and 'timestamps' may both be t", self.fault())
        event_columns.assert_equal(self.read("--columns", "p,t,y,x")[0], events)

    def test_all_versions_of_the_format_are_read(self):
        events = event_columns.random_events(1000)
        for version in [(1, 0), (2, 0), (3, 0)]:
            with zipfile.ZipFile(self.npz, "w") as archive:
                for name, values in events.items():
                    array = io.BytesIO()
                    np.lib.format.write_array(array, values, version)
                    archive.writestr(name + ".npy", array.getvalue())
            event_columns.assert_equal(convert.to_events(self.npz, self.folder), events)

    def test_the_size_of_the_image_is_read(self):
        np.savez(self.npz, **event_columns.random_events(0), width=np.uint16(640), height=480)
        convert(self.npz, self.folder / "out.txt")
        self.assertEqual((self.folder / "out.txt").read_text(), "640 480\n")

    def test_arrays_that_are_none_of_events_are_refused(self):
        events = event_columns.random_events(1000)
        for fault, changes in {
                "t.npy: is of type <c16; little-endian numbers": {"t": events["t"].astype(complex)},
                "x.npy: is of type >i4": {"x": events["x"].astype(">i4")},
                "x.npy: is not one column of numbers": {"x": np.zeros((1000, 2), "u2")},
                "unequal lengths: t has 1000 values, y has 999": {"y": np.zeros(999, "u2")},
                "p 2; t is within 292 years": {"p": np.full(1000, 2)},
                "p -1; t is within 292 years": {"p": np.r_[0, np.full(999, -1)]},
                "t has whole numbers above 10000000000000000; it may count": {"t": np.r_[np.zeros(999, "u8"), np.uint64(2**64 - 1)]},
                "width.npy is not a single number": {"width": np.zeros(2, "i8")},
                "has height -1; valid are": {"height": -1},
        }.items():
            np.savez(self.npz, **{**events, **changes})
            self.assertIn(fault, self.fault())
        np.savez(self.npz, t=events["t"])
        self.assertIn("has no arrays t, x, y and p, and no table of them; its arrays are t;", self.fault())
        self.npz.write_bytes(b"x" * 1000)
        self.assertIn("is not a whole zip archive", self.fault())

    def test_arrays_of_another_length_than_they_say_are_refused(self):
        events = event_columns.random_events(1000)
        for fault, change in {"ends too early": lambda b: b[:-8], "goes on after its last value": lambda b: b + bytes(8)}.items():
            with zipfile.ZipFile(self.npz, "w") as archive:
                for name, values in events.items():
                    array = io.BytesIO()
                    np.lib.format.write_array(array, values)
                    archive.writestr(name + ".npy", change(array.getvalue()) if name == "t" else array.getvalue())
            self.assertIn("t.npy: " + fault, self.fault())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
