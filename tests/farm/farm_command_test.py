"""saccade-farm as its user sees it: files as `saccade record` writes them, and a run that is cut and goes on."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "engines"))
from data_sets import difference

FARM, SACCADE, SACCADED = sys.argv[1:4]

RECIPE = """
name = "small"
seed = 3
sequences = 8
shards = 3
splits = { train = 0.75, test = 0.25 }
[draw]
speed = { log_uniform = [0.2, 1] }
[record]
output = ["events.h5", "events.raw"]
scene = { each = ["cornell-box", "textured-cornell-box"] }
motion = "random:{speed}px"
size = "32x24"
rate = 500
duration = 0.05
truth = "pose"
threshold = [0.1, 0.3]
write-calibration = true
"""


def farm(*words, expect=0):
    done = subprocess.run([FARM, *words], capture_output=True, text=True)
    assert done.returncode == expect, (words, done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


class Farm(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.recipe = self.path("recipe.toml")
        self.write(RECIPE)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, text):
        with open(self.recipe, "w", encoding="utf-8") as file:
            file.write(text)

    def plan(self, name):
        farm("plan", self.recipe, "-o", self.path(name), "--no-estimate", "--instructions", "avx2")
        return self.path(name)

    def status(self, folder):
        return json.loads(farm("status", folder, "--json"))

    def test_a_run_that_is_killed_goes_on_and_gives_the_same_bytes(self):
        whole, cut = self.plan("whole"), self.plan("cut")
        farm("run", whole, "--workers", "1")
        for _ in range(3):
            run = subprocess.Popen([FARM, "run", cut, "--workers", "2"], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, start_new_session=True)
            before = self.status(cut)["done"]
            while run.poll() is None and self.status(cut)["done"] < min(before + 2, 8):
                pass
            os.killpg(run.pid, signal.SIGKILL)
            run.wait()
        farm("run", cut)
        end = time.monotonic() + 30
        while os.listdir(os.path.join(cut, "workers")) and time.monotonic() < end:
            farm("run", cut)  # a killed worker that waits for the disk still has its lock
        self.assertEqual(difference(os.path.join(whole, "shards"), os.path.join(cut, "shards")), [])
        self.assertEqual(os.listdir(os.path.join(cut, "partial")), [])
        self.assertEqual(os.listdir(os.path.join(cut, "workers")), [])
        self.assertEqual(self.status(cut)["done"], 8)
        self.assertIn("0 damaged, 0 missing, 0 foreign", farm("verify", cut))

    def test_a_damaged_sequence_is_made_again(self):
        folder = self.plan("damaged")
        farm("run", folder)
        damaged = os.path.join(folder, "shards/00001/000004")
        with open(os.path.join(damaged, "events.h5"), "r+b") as file:
            file.truncate(100)
        self.assertIn("damaged: shards/00001/000004/events.h5", farm("verify", folder, expect=1))
        shutil.rmtree(damaged)
        self.assertIn("missing: shards/00001/000004", farm("verify", folder, expect=1))
        farm("run", folder)
        farm("verify", folder)

    def test_shards_are_made_one_by_one(self):
        folder = self.plan("shards")
        farm("run", folder, "--shard", "1/3")
        self.assertEqual(self.status(folder)["done"], 3)
        self.assertTrue(os.path.exists(os.path.join(folder, "shards/00001/index.jsonl")))
        self.assertIn("the shards 0/3 to 2/3", farm("run", folder, "--shard", "3/3", expect=2))
        self.assertIn("'1' is not K/N", farm("run", folder, "--shard", "1", expect=2))

    def test_files_are_those_of_record(self):
        folder = self.plan("records")
        farm("run", folder, "--shard", "0/3")
        with open(os.path.join(folder, "shards/00000/index.jsonl"), encoding="utf-8") as lines:
            sequences = [json.loads(line) for line in lines]
        server = subprocess.Popen(
            [SACCADED, "--control", f"ipc://{self.path('c')}", "--data", f"ipc://{self.path('d')}", "--broadcast",
             f"ipc://{self.path('b')}", "--http", "off", "--instructions", "avx2", "--log-level", "off"])
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        for sequence in sequences:
            there = os.path.join(folder, "shards/00000", sequence["number"].zfill(6))
            for name in ("events.h5", "events.raw"):
                here = self.path(sequence["number"])
                os.makedirs(here, exist_ok=True)
                subprocess.run([SACCADE, "record", *sequence["options"], "-o", os.path.join(here, name), "--control",
                                f"ipc://{self.path('c')}"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            os.remove(os.path.join(there, "sequence.json"))
            self.assertEqual(difference(there, here), [])

    def test_faults_have_their_exit_codes(self):
        self.write(RECIPE.replace("rate = 500", "rate = -5"))
        self.assertIn("recipe.toml:14: record.rate", farm("check", self.recipe, expect=78))
        self.assertIn("recipe.toml:14: record.rate",
                      farm("plan", self.recipe, "-o", self.path("never"), expect=78))
        self.assertFalse(os.path.exists(self.path("never")))
        farm("run", self.path("never"), expect=75)
        farm("run", expect=2)
        self.assertIn("did you mean verify?", farm("verfy", expect=2))
        self.assertIn("did you mean --workers?", farm("run", self.path("never"), "--worker", "1", expect=2))
        self.write(RECIPE)
        folder = self.plan("planned")
        self.plan("planned")  # the same plan again
        self.write(RECIPE.replace("seed = 3", "seed = 4"))
        self.assertIn("another recipe", farm("plan", self.recipe, "-o", folder, "--no-estimate", expect=78))
        plan = os.path.join(folder, "plan.json")
        with open(plan, encoding="utf-8") as file:
            text = file.read()
        with open(plan, "w", encoding="utf-8") as file:
            file.write(text.replace('"software_version":"', '"software_version":"9'))
        self.assertIn("was planned by version 9", farm("run", folder, expect=78))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
