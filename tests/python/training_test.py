"""Data sets of saccade-farm in Python, and the page "From a recipe to a trained model" with a smaller recipe."""
import importlib.util
import itertools
import json
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest

import saccade

PAGE = pathlib.Path(os.environ["SOURCE"]) / "client/python/TRAINING.md"
EXAMPLES = PAGE.parent / "examples"
SMALLER = {"sequences = 240": "sequences = 30", "shards = 8": "shards = 2",
           '"cornell-box", "cornell-bunny"': '"cornell-box"'}
RIG = """
name = "rig"
seed = 7
sequences = 2
shards = 1
splits = {{ train = 1.0 }}
[record]
output = "{output}"
scene = "cornell-box"
motion = "right"
size = "32x24"
rate = 500
duration = 0.06
threshold = "0.2,0.4"
further-view = "0.1,0,0"
truth = ["depth:5", "pose"]
"""


def blocks(language):
    return re.findall(rf"```{language}\n(.*?)```", PAGE.read_text(), re.DOTALL)


def run(*command, folder=None):
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, check=False, timeout=300, cwd=folder)
    assert done.returncode == 0, (command, done.stdout, done.stderr)
    return done.stdout


def samples_of(path):
    """Members that follow each other and have the same name up to its first point, as webdataset groups them."""
    with tarfile.open(path) as tar:
        members = [re.fullmatch(r"([^.]+)[.]([^/]*)", member.name).groups() + (tar.extractfile(member).read(),)
                   for member in tar]
    for key, group in itertools.groupby(members, lambda member: member[0]):
        yield key, {name: content for _, name, content in group}


class Training(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        recipe = (EXAMPLES / "train_small.toml").read_text()
        for large, small in SMALLER.items():
            assert large in recipe, large
            recipe = recipe.replace(large, small)
        (cls.folder / "train_small.toml").write_text(recipe)
        run(os.environ["SACCADE_FARM"], "plan", cls.folder / "train_small.toml", "-o", cls.folder / "turns")
        run(os.environ["SACCADE_FARM"], "run", cls.folder / "turns")

    def test_the_page_shows_the_recipe(self):
        recipe = (EXAMPLES / "train_small.toml").read_text()
        self.assertEqual(blocks("toml"), [re.sub(r"^#.*\n", "", recipe)])

    def test_the_page_loads_the_data_set(self):
        told = run(sys.executable, "-B", "-c", blocks("python")[0], folder=self.folder).splitlines()
        self.assertRegex(told[0], r"^63 \d+ \(5, 48, 64\)$")
        self.assertRegex(told[-1], r"'across': '-?0\.\d+'.*--motion=(pan|tilt):-?0\.\d+px")

    def test_the_example_beats_the_mean(self):
        told = run(sys.executable, "-B", EXAMPLES / "train_small.py", self.folder / "turns")
        error, trivial = map(float, re.search(r"error (\S+) pixels per frame, and (\S+) of", told).groups())
        self.assertLess(error, 0.6 * trivial, told)

    def test_windows_are_those_of_the_recordings(self):
        data = saccade.Dataset(self.folder / "turns", window_s=0.05, truth=["flow_forward"])
        self.assertEqual(len(data), 60)
        for number in (0, 17, 59):
            window = data[number]
            recorded = window.sequence.recording
            expected = recorded.events[0].slice(window.events.t0, window.events.t1)
            for name in "txyp":
                self.assertEqual(getattr(window.events, name).tolist(), getattr(expected, name).tolist())
            flow = recorded.truth[0]["flow_forward"]
            inside = (flow.t >= window.events.t0) & (flow.t <= window.events.t1)
            self.assertEqual(window.truth["flow_forward"].data.tolist(), flow.data[inside].tolist())

    def test_samples_of_its_tar_files_are_found_as_webdataset_does(self):
        run(os.environ["SACCADE_FARM"], "pack", self.folder / "turns")
        sequences = {window.sequence.number: window.sequence for window in saccade.Dataset(self.folder / "turns")}
        found = []
        for path in sorted((self.folder / "turns/webdataset").glob("*.tar")):
            for key, sample in samples_of(path):
                about = json.loads(sample["sequence.json"])
                sequence = sequences[int(about.get("number", 0))]
                self.assertEqual((key, path.name.rpartition("-")[0]), (f"{sequence.number:06}", sequence.split))
                self.assertEqual(about["draws"], sequence.draws)
                self.assertEqual(sample["events.h5"], sequence.path.read_bytes())
                found.append(sequence.number)
        self.assertEqual(sorted(found), list(range(30)))

    def test_what_is_lost_is_told_by_both(self):
        data = saccade.Dataset(self.folder / "turns")
        path = data[29].sequence.path
        kept = path.read_bytes()
        path.unlink()
        try:
            with self.assertRaisesRegex(saccade.FormatError, f"{path}: the file is missing. `saccade-farm verify"):
                saccade.Dataset(self.folder / "turns")[29]
            told = subprocess.run([os.environ["SACCADE_FARM"], "verify", self.folder / "turns"], capture_output=True,
                                  text=True, check=False)
            self.assertNotEqual(told.returncode, 0)
            self.assertIn("000029", told.stdout + told.stderr)
        finally:
            path.write_bytes(kept)


class Rig(unittest.TestCase):
    """Two cameras with two sensors each, in one file and in four."""

    def test_each_sensor_has_its_events_and_the_truth_of_its_camera(self):
        for output in ("events.h5", "events.npz", "events.raw"):
            with tempfile.TemporaryDirectory() as folder:
                recipe, root = pathlib.Path(folder, "rig.toml"), pathlib.Path(folder, "rig")
                recipe.write_text(RIG.format(output=output))
                run(os.environ["SACCADE_FARM"], "plan", recipe, "-o", root)
                run(os.environ["SACCADE_FARM"], "run", root)
                truth = ["pose"] if output == "events.raw" else ["depth", "pose"]
                for sensor in range(4):
                    window = saccade.Dataset(root, sensor=sensor, window_s=0.02, truth=truth)[4]
                    self.expect_as_recorded(window, sensor, truth)

    def expect_as_recorded(self, window, sensor, truth):
        recorded, t0, t1 = window.sequence.recording, window.events.t0, window.events.t1
        self.assertEqual((t0, t1, window.sequence.number), (20_000, 40_000, 1))
        expected = recorded.events[sensor].slice(t0, t1)
        self.assertGreater(len(expected), 100)
        for name in "txyp":
            self.assertEqual(getattr(window.events, name).tolist(), getattr(expected, name).tolist())
        for name in truth:
            channel = recorded.truth[recorded.view_of(sensor)][name]
            inside = (channel.t >= t0) & (channel.t <= t1)
            self.assertGreater(inside.sum(), 2)
            self.assertEqual(window.truth[name].data.tolist(), channel.data[inside].tolist())


if __name__ == "__main__":
    if importlib.util.find_spec("h5py") is None:
        print("skipped: this Python has no h5py")
        sys.exit(77)
    unittest.main()
