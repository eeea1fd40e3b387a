"""The examples, run as they are against a real saccaded."""
import importlib.util
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import saccade
from saccaded import Server

SOURCE = pathlib.Path(os.environ["SOURCE"])
EXAMPLES = SOURCE / "client/python/examples"


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        server = cls.enterClassContext(Server())
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.environment = {**os.environ, "SACCADE_SERVER": server.address, "MPLBACKEND": "Agg",
                           "MPLCONFIGDIR": str(cls.folder)}

    def run_example(self, name, *arguments):
        done = subprocess.run([sys.executable, "-B", EXAMPLES / name, *arguments], env=self.environment,
                              capture_output=True, text=True, timeout=300, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_the_first_client_of_the_pages(self):
        blocks = [re.search(r"```python\n(import saccade.*?)```", (SOURCE / page).read_text(), re.DOTALL)[1]
                  for page in ("README.md", "client/README.md")]
        self.assertEqual(blocks[0], blocks[1])
        (self.folder / "first.py").write_text(blocks[0])
        told = self.run_example(self.folder / "first.py").splitlines()
        self.assertRegex(told[-1], r"^\d+ events until 500000 us, \d+ of them ON$")

    def test_record_a_data_set(self):
        told = self.run_example("record_dataset.py", self.folder / "set")
        for motion, threshold, count in re.findall(r"(\S+), threshold (\S+): (\d+) events", told):
            events = saccade.read(self.folder / f"set/{motion.replace(':', '')}-{threshold}.npz")
            self.assertEqual((len(events), events.size), (int(count), (64, 48)))
        self.assertEqual(json.loads((self.folder / "set/pan20.json").read_text())["scene"], "cornell-box")
        self.assertEqual(len(list((self.folder / "set").iterdir())), 12)

    def test_close_a_loop(self):
        told = self.run_example("closed_loop.py", "150")
        # Half of the lamp's half width. The loop amplifies noise: eight seeds give 0.04 to 0.30.
        self.assertLess(float(re.search(r"steps; (\S+) scene units", told)[1]), 0.33)
        self.assertRegex(told, r"a frame takes \d+\.\d ms of CPU")

    @unittest.skipUnless(importlib.util.find_spec("torch"), "torch is not installed")
    def test_train_on_a_live_stream(self):
        steps = 100 if os.environ.get("SACCADE_FULL") else 10
        told = self.run_example("train_live.py", str(steps))
        right = re.findall(r"step \d+: loss \d\.\d+, (\d+) of the last 100 right", told)
        self.assertEqual(len(right), steps // 10)
        if steps == 100:
            self.assertGreater(int(right[-1]), 90)

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
    def test_look_at_a_stream(self):
        self.run_example("view.py", "cornell-box", self.folder / "view.png")
        self.assertEqual((self.folder / "view.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
    def test_where_no_surface_is_the_depth_has_no_colour(self):
        spec = importlib.util.spec_from_file_location("look_at_truth", EXAMPLES / "look_at_truth.py")
        example = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(example)
        depth = example.surface_depth(np.array([[2, 1e5, 3]], np.float32))
        self.assertEqual((np.nanmin(depth), np.nanmax(depth)), (2, 3))
        self.assertTrue(np.isnan(depth[0, 1]))

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
    def test_look_at_truth(self):
        recording, picture = self.folder / "pair.npz", self.folder / "pair.png"
        truth = [option for name in ("frame", "flow_forward", "depth") for option in ("--truth", name)]
        subprocess.run([os.environ["SACCADE"], "record", "cornell-box", "--motion", "right", "--size", "32x24",
                        "--rate", "200", "--duration", "0.05", "--further-view", "0.2,0,0", *truth, "-o", recording],
                       env=self.environment, check=True, capture_output=True)
        self.run_example("look_at_truth.py", picture, recording)
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")


if __name__ == "__main__":
    unittest.main()
