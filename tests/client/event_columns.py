"""Files of events for the tests of formats: random events, and `saccade convert` from and to CSV."""
import subprocess
import sys

import numpy as np

COLUMNS = ["t", "x", "y", "p"]
SIZE = (1280, 720)


def skip(reason):
    """Ends the test; ctest reports it as skipped."""
    print(f"skipped: {reason}")
    sys.exit(77)


def random_events(count, gap_us=20, seed=1):
    """Columns of int64 in time order, with quiet times, on all of the image."""
    rng = np.random.default_rng(seed)
    gaps = rng.integers(0, gap_us, count)
    gaps[rng.random(count) < 0.001] = 7000
    return {"t": np.cumsum(gaps), "x": rng.integers(0, SIZE[0], count), "y": rng.integers(0, SIZE[1], count),
            "p": rng.integers(0, 2, count)}


def write_csv(path, events):
    lines = map("%d,%d,%d,%d\n".__mod__, zip(*(events[c].tolist() for c in COLUMNS)))
    path.write_text("t,x,y,p\n" + "".join(lines), encoding="ascii")


def read_csv(path):
    table = np.loadtxt(path, delimiter=",", skiprows=1, dtype=np.int64, ndmin=2).reshape(-1, 4)
    return dict(zip(COLUMNS, table.T))


class Converter:
    """`saccade convert`, which takes the size of the image from SIZE unless the input tells it."""

    def __init__(self, saccade):
        self.saccade = saccade

    def run(self, source, target, *options):
        """Returns the exit code and the text of errors."""
        command = [self.saccade, "convert", "--force", *options, str(source), str(target)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        return done.returncode, done.stderr

    def __call__(self, source, target, *options):
        code, errors = self.run(source, target, *options)
        if code:
            raise AssertionError(f"{source} to {target}: {errors}")
        return target

    def from_events(self, events, folder, target, *options):
        write_csv(folder / "in.csv", events)
        return self(folder / "in.csv", target, "--size", "%dx%d" % SIZE, *options)

    def to_events(self, source, folder):
        return read_csv(self(source, folder / "out.csv", "--size", "%dx%d" % SIZE))


def assert_equal(events, expected):
    for column in COLUMNS:
        np.testing.assert_array_equal(events[column], expected[column], err_msg=column)
