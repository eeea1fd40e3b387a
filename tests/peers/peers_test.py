"""The table of event simulators: its parts by formulas, and whole on a few small frames. Usage: peers_test.py BUILD"""
import os
import sys
import tempfile
import unittest
import zlib
from pathlib import Path
from types import SimpleNamespace

try:
    import numpy as np
except ImportError as fault:
    print(f"skipped: {fault}")
    sys.exit(77)

import peers
import rivals

BUILD = sys.argv[1]


def clip(lights, **numbers):
    """One pixel."""
    light = np.reshape(lights, (-1, 1, 1)).astype(float)
    return SimpleNamespace(light=light, rate=100, threshold=0.1, bias=0.5, **numbers)


class Parts(unittest.TestCase):
    def test_events_of_the_formula_stand_where_a_line_crosses_the_levels(self):
        logs = np.array([0, 0.45, 0.45, 0.22])  # levels .1 .2 .3 .4 go up, and .3 goes down
        events, _ = rivals.run("formula", clip(np.exp(logs) - 0.5))
        np.testing.assert_allclose(events["t"], [2222, 4444, 6666, 8888, 26521], atol=1)
        np.testing.assert_array_equal(events["p"], [1, 1, 1, 1, 0])

    def test_a_pixel_without_change_has_no_event(self):
        events, _ = rivals.run("formula", clip([1, 1, 1]))
        self.assertEqual(len(events["t"]), 0)

    def test_pictures_hold_the_frames(self):
        picture = np.arange(6, dtype=np.uint8).reshape(2, 3)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "a.png"
            peers.write_png(path, picture)
            data = path.read_bytes()
        start = data.index(b"IDAT") + 4
        self.assertEqual(zlib.decompressobj().decompress(data[start:]), b"\0\0\1\2\0\3\4\5")

    def test_a_row_compares_with_ours(self):
        found = {"count_error": 0.25, "chamfer_px": 0.5, "same_time": [0.5, 0], "most_at_one_time": [7, 1]}
        self.assertEqual(peers.row("a", 10, found, 2, 5), "| `a` | 10 | 75.00 | 0.500 | 50.0 | 7 | 5 | 2.5 |")


class Table(unittest.TestCase):
    def test_ours_are_those_of_the_formula_and_what_is_missing_is_named(self):
        for _, variable in rivals.RIVALS.values():
            os.environ.pop(variable or "", None)
        with tempfile.TemporaryDirectory() as folder:
            o = peers.options([BUILD, "--size=48x36", "--duration=0.02", "--motion=orbit:1px"])
            lines = list(peers.table(o, Path(folder)))
        rows = {cells[1].strip(" `"): cells[2:-1] for cells in (line.split("|") for line in lines) if len(cells) > 2}
        self.assertGreater(int(rows["saccade"][0]), 100)
        self.assertEqual(float(rows["saccade"][1]), 100)
        self.assertGreater(float(rows["formula"][1]), 99.9)
        self.assertLess(float(rows["formula"][2]), 0.02)
        for name in rivals.RIVALS:
            self.assertTrue(name in rows or any(line.startswith(f"skipped {name}: ") for line in lines), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
