"""Runs whose processes are killed at random end with the bytes of an undisturbed run: killed_workers_test.py FARM [SEED]."""
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

import data_sets

# A sequence is given up after three workers have died of it, and a run tries each sequence once.
RUNS_WITH_KILLED_WORKERS = 2
KILLED_RUNS = 4


def start(farm, data_set):
    return subprocess.Popen([farm.program, "run", data_set, "--workers", "3"], stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL)


def children(process):
    try:
        text = pathlib.Path(f"/proc/{process}/task/{process}/children").read_text(encoding="utf-8")
    except OSError:
        return []
    return [int(word) for word in text.split()]


def kill(process):
    try:
        os.kill(process, signal.SIGKILL)
        return 1
    except ProcessLookupError:
        return 0


def kill_workers(farm, data_set, chance):
    """A run, one of whose workers is killed now and then. How many were."""
    killed = 0
    with start(farm, data_set) as run:
        while run.poll() is None:
            time.sleep(chance.uniform(0.05, 0.4))
            if workers := children(run.pid):
                killed += kill(chance.choice(workers))
    assert run.returncode in (0, 75), run.returncode
    return killed


def kill_run(farm, data_set, chance):
    with start(farm, data_set) as run:
        time.sleep(chance.uniform(0.05, 0.6))
        kill(run.pid)


def main():
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    chance = random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        farm = data_sets.Farm(sys.argv[1], folder)
        whole, other = farm.made("whole"), farm.plan("other")
        killed = sum(kill_workers(farm, other, chance) for _ in range(RUNS_WITH_KILLED_WORKERS))
        for _ in range(KILLED_RUNS):
            kill_run(farm, other, chance)
        left = 12 - data_sets.published(other)
        farm("run", other)
        data_sets.check_same(farm, whole, other)
        status = farm.status(other)
        assert (status["done"], status["retry"], status["never"]) == (12, 0, 0), status
        print(f"seed {seed}: {killed} workers and {KILLED_RUNS} runs killed; {left} sequences were left to the last run")
        assert killed > 0


if __name__ == "__main__":
    main()
