"""Dataset gives at least 0.8 times the windows per second of h5py's bare read. Exit code 77: SACCADE_FULL is unset."""
import os
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(os.environ["SOURCE"]) / "tests/bench"))


class Speed(unittest.TestCase):
    def test_windows_per_second(self):
        from dataset_speed import drawn
        self.assertGreater(drawn(), 0.8)


if __name__ == "__main__":
    if not os.environ.get("SACCADE_FULL"):
        print("skipped: set SACCADE_FULL=1 to measure")
        sys.exit(77)
    unittest.main()
