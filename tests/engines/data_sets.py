"""Small data sets for the tests of engines."""
import filecmp
import json
import os
import pathlib
import subprocess
import time

RECIPE = """
name = "tiny"
seed = 3
sequences = {sequences}
shards = {shards}
[record]
output = "events.h5"
scene = "cornell-box"
motion = "random:1px"
size = "64x48"
rate = 500
duration = {duration}
"""

# A folder's name that does harm wherever it is not quoted.
NASTY = "a'b \"c\"; touch PWNED; $(touch PWNED) `touch PWNED` {x} %d \\ ..;"


class Farm:
    """saccade-farm, with data sets in a folder."""

    def __init__(self, program, folder):
        self.program, self.folder = str(program), pathlib.Path(folder)

    def __call__(self, *words, expect=0):
        done = subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, check=False)
        assert done.returncode == expect, (words, done.returncode, done.stdout, done.stderr)
        return done.stdout

    def plan(self, name, sequences=12, shards=4, duration=0.2):
        recipe = self.folder / "recipe.toml"
        recipe.write_text(RECIPE.format(sequences=sequences, shards=shards, duration=duration), encoding="utf-8")
        self("plan", recipe, "-o", self.folder / name, "--no-estimate", "--instructions", "avx2")
        return self.folder / name

    def made(self, name, **sizes):
        """A data set that a local run has made, undisturbed."""
        data_set = self.plan(name, **sizes)
        self("run", data_set)
        return data_set

    def status(self, data_set):
        return json.loads(self("status", data_set, "--json"))


def difference(one, other):
    """Names of what differs between two folders, byte by byte."""
    found = filecmp.dircmp(one, other)
    _, wrong, errors = filecmp.cmpfiles(one, other, found.common_files, shallow=False)
    return [*found.left_only, *found.right_only, *wrong, *errors,
            *(name for sub in found.common_dirs for name in difference(os.path.join(one, sub), os.path.join(other, sub)))]


def check_same(farm, whole, other):
    """A data set has the bytes of one that was made undisturbed, and nothing else."""
    found = difference(whole / "shards", other / "shards")
    assert found == [], found
    assert "0 damaged, 0 missing, 0 foreign" in farm("verify", other)


def published(data_set):
    return len(list((data_set / "shards").glob("*/*/sequence.json")))


def until(condition, what, seconds=60):
    """Waits for something, and returns it."""
    end = time.monotonic() + seconds
    while not (found := condition()):
        assert time.monotonic() < end, f"after {seconds} s, not yet: {what}"
        time.sleep(0.02)
    return found
