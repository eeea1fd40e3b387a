"""One core takes at least 10 million events per second into numpy. Exit code 77: SACCADE_FULL is unset."""
import os
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(os.environ["SOURCE"]) / "tests/bench"))


class Speed(unittest.TestCase):
    def test_ten_million_events_per_second(self):
        from python_speed import measure
        self.assertGreater(measure(4096), 10e6)


if __name__ == "__main__":
    if not os.environ.get("SACCADE_FULL"):
        print("skipped: set SACCADE_FULL=1 to measure")
        sys.exit(77)
    unittest.main()
