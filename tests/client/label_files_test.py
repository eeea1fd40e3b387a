"""Labels in .h5 and .npz files, read by h5py and NumPy. Usage: label_files_test.py SACCADE SACCADED"""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import event_columns

try:
    import h5py
    import numpy as np
except ImportError as fault:
    event_columns.skip(fault)

SACCADE, SACCADED = sys.argv[1:3]
REQUEST = ["cornell-box", "--trajectory", "right", "--size", "32x24", "--duration", "0.05", "--noise", "shot_hz=50"]


class Labels(unittest.TestCase):
    def setUp(self):
        sockets = [word for name in ("control", "data", "broadcast") for word in (f"--{name}", "tcp://127.0.0.1:*")]
        self.server = subprocess.Popen([SACCADED, *sockets, "--http", "off"], stderr=subprocess.STDOUT,
                                       stdout=subprocess.PIPE, text=True)
        self.addCleanup(self.stop)
        ready = (re.search(r"ready: control (\S+)", line) for line in self.server.stdout)
        self.control = next(filter(None, ready))[1]
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def stop(self):
        self.server.terminate()
        self.server.communicate()

    def record(self, name, *options):
        file = self.folder / name
        subprocess.run([SACCADE, "record", *REQUEST, *options, "-o", file, "--control", self.control], check=True,
                       capture_output=True, timeout=60)
        return file

    def test_both_formats_hold_the_labels_of_the_same_events(self):
        with np.load(self.record("a.npz", "--labels")) as npz, h5py.File(self.record("a.h5", "--labels")) as h5:
            event_columns.assert_equal(h5["events"], npz)
            for name in ("source", "artefact"):
                self.assertEqual((npz[name].dtype, h5["events"][name].dtype), (np.uint8, np.uint8))
                np.testing.assert_array_equal(h5["events"][name][:], npz[name])
            noise = npz["source"] == 1
            self.assertEqual(set(npz["source"]), {0, 1})
            self.assertEqual(set(npz["artefact"][noise]), {0})
            self.assertGreater(npz["artefact"][~noise].max(), 0)
            # 50 Hz of 768 pixels in 0.05 s, and a quarter of it where the scene is bright.
            self.assertLess(480, noise.sum())
            self.assertLess(noise.sum(), 2100)

    def test_files_without_labels_have_no_such_columns(self):
        with np.load(self.record("a.npz")) as npz, h5py.File(self.record("a.h5")) as h5:
            self.assertEqual(set(npz.files), {*event_columns.COLUMNS, "width", "height"})
            self.assertEqual(set(h5["events"]), {*event_columns.COLUMNS, "width", "height"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
