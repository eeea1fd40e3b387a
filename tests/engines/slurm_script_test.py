"""The batch script of `saccade-farm slurm` without Slurm: scontrol only notes what it is asked, and a worker does as told.
slurm_script_test.py FARM"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

import data_sets

FARM = sys.argv[1]

# Notes its shard, makes a sequence for each word `made`, and ends as the shard's line of `fates` says.
WORKER = """#!/bin/bash
cd "$(dirname "$0")"
shard=${4%/*}
echo "$shard" >>calls
for word in $(sed -n "$((shard + 1))p" fates); do
  case $word in
    made) mkdir -p "$2/shards/0000$shard/00000$RANDOM" && touch "$(ls -d "$2/shards/0000$shard/"* | tail -1)/sequence.json" ;;
    wait) trap 'exit 75' TERM; touch waiting; while :; do read -t 1 <>fifo; done ;;
    killed) kill -KILL $$ ;;
    *) exit "$word" ;;
  esac
done
"""
SCONTROL = '#!/bin/bash\necho "$*" >>"$(dirname "$0")/calls"\n'


class Script(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.farm = data_sets.Farm(FARM, self.folder)
        for name, text in {"worker": WORKER, "scontrol": SCONTROL}.items():
            (self.folder / name).write_text(text, encoding="utf-8")
            (self.folder / name).chmod(0o755)
        os.mkfifo(self.folder / "fifo")

    def start(self, data_set, task=0, restarts=0, options=()):
        script = self.farm("slurm", data_set, *options)
        environment = {**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}", "SLURM_ARRAY_TASK_ID": str(task),
                       "SLURM_ARRAY_JOB_ID": "7", "SLURM_RESTART_COUNT": str(restarts)}
        return subprocess.Popen(["bash", "-c", script], env=environment, cwd=self.folder, stderr=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL)

    def fate(self, *fates, send=None, options=(), **how):
        """What happens where the workers of the shards end as told: the exit code, and the calls."""
        data_set = self.folder / "fate"
        if not data_set.exists():
            self.farm.plan("fate", sequences=4)
        (self.folder / "fates").write_text("\n".join(fates) + "\n", encoding="utf-8")
        (self.folder / "calls").write_text("", encoding="utf-8")
        with self.start(data_set, options=["--program", self.folder / "worker", *options], **how) as script:
            if send:
                data_sets.until((self.folder / "waiting").exists, "the worker runs")
                script.send_signal(send)
        (self.folder / "waiting").unlink(missing_ok=True)
        return script.returncode, (self.folder / "calls").read_text(encoding="utf-8").splitlines()

    def test_a_folder_with_a_nasty_name_harms_nothing(self):
        name = data_sets.NASTY + "\n#SBATCH --wrap=x\ntouch PWNED"
        data_set = self.farm.plan(name, sequences=2, shards=2, duration=0.02)
        for task in range(2):
            with self.start(data_set, task) as script:
                pass
            self.assertEqual(script.returncode, 0)
        self.assertEqual(data_sets.published(data_set), 2)
        self.assertEqual(list(self.folder.rglob("PWNED")), [])

    def test_a_worker_that_is_killed_or_says_75_runs_again(self):
        self.assertEqual(self.fate("75"), (75, ["0", "requeue 7_0"]))
        self.assertEqual(self.fate("killed", restarts=2), (137, ["0", "requeue 7_0"]))
        self.assertEqual(self.fate("1", restarts=3), (1, ["0"]))
        self.assertEqual(self.fate("made 75", restarts=30), (75, ["0", "requeue 7_0"]))

    def test_what_no_run_can_mend_does_not_run_again(self):
        self.assertEqual(self.fate("78"), (78, ["0"]))
        self.assertEqual(self.fate("2"), (2, ["0"]))

    def test_a_task_makes_several_shards(self):
        self.assertEqual(self.fate("0", "0", "0", "0", options=["--tasks", "2"], task=1), (0, ["1", "3"]))
        self.assertEqual(self.fate("0", "78", "0", "0", options=["--tasks", "2"], task=1), (78, ["1", "3"]))
        self.assertEqual(self.fate("0", "75", "0", "0", options=["--tasks", "2"], task=1), (75, ["1", "requeue 7_1"]))

    def test_the_worker_ends_in_good_order_when_the_time_is_up_and_runs_again(self):
        self.assertEqual(self.fate("wait", send=signal.SIGUSR1), (75, ["0", "requeue 7_0"]))

    def test_a_task_that_slurm_ends_leaves_it_to_slurm_whether_it_runs_again(self):
        self.assertEqual(self.fate("wait", send=signal.SIGTERM), (75, ["0"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
