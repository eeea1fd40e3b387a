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
                "t.npy: is of type <f8; little-endian whole numbers and bool": {"t": events["t"] / 1e6},
                "x.npy: is of type >i4": {"x": events["x"].astype(">i4")},
                "x.npy: is not one column of numbers: {'descr'": {"x": np.zeros((1000, 2), "u2")},
                "are not arrays of equal lengths": {"y": np.zeros(999, "u2")},
                "p -1; t counts microseconds": {"p": np.full(1000, -1)},
                "event 1000 has t 9223372036854775807": {"t": np.r_[np.zeros(999, "u8"), np.uint64(2**64 - 1)]},
                "width.npy is not a single number": {"width": np.zeros(2, "i8")},
                "has height -1; valid are": {"height": -1},
        }.items():
            np.savez(self.npz, **{**events, **changes})
            self.assertIn(fault, self.fault())
        np.savez(self.npz, t=events["t"])
        self.assertIn("x.npy: No such file", self.fault())
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
