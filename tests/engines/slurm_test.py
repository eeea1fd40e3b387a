"""One data set through a real Slurm, whose bytes are those of a local run: slurm_test.py FARM [SCENARIO...]."""
import os
import signal
import sys
import tempfile
import time

import data_sets
import slurm_cluster
from data_sets import until
from slurm_cluster import worker_of

USUAL = {"sequences": 12, "shards": 4, "duration": 0.8}  # seconds for a task, so that faults find it at work
LONG = {"sequences": 4, "shards": 2, "duration": 8}


class Trial:
    """A data set in the hands of Slurm."""

    def __init__(self, cluster, farm, name, options=(), sizes=None):
        self.cluster, self.farm, self.sizes = cluster, farm, sizes or USUAL
        self.data_set = farm.plan(name, **self.sizes)
        script = cluster.folder / f"{name}.sh"
        farm("slurm", self.data_set, "-o", script, "--cpus", "1", "--memory", "500", *options)
        self.job = cluster.submit(script)

    def wait_for_worker(self, node):
        """The task on a node, whose worker has begun and has not yet done."""
        return until(lambda: next((task for task in [self.cluster.on(node)] if task is not None and
                                   worker_of(self.data_set, task)), None), f"a worker runs on {node}")

    def kill_worker(self, node):
        """Ends a worker as the machine's lack of memory would. It says whether there was one."""
        task = self.cluster.on(node)
        process = worker_of(self.data_set, task)
        if process:
            os.kill(process, signal.SIGKILL)
        return task

    def restarts(self):
        return sum("its task runs again" in path.read_text(encoding="utf-8", errors="replace")
                   for path in self.cluster.folder.glob(f"slurm-{self.job}_*.out"))


def node_lost_and_worker_killed(cluster, farm):
    trial = Trial(cluster, farm, "lost")
    trial.wait_for_worker("n1")
    lost = trial.wait_for_worker("n2")
    cluster.lose_node()
    killed = trial.kill_worker("n1")
    until(lambda: trial.restarts() > 0, "the task of the killed worker asks to run again")
    until(lambda: lost not in cluster.running(), "Slurm misses the node")
    cluster.start_node("n2")
    cluster.wait()
    return trial, f"tasks {killed} (killed) and {lost} (lost) ran again"


def requeued(cluster, farm):
    trial = Trial(cluster, farm, "requeued")
    task = trial.wait_for_worker("n1")
    slurm_cluster.call("scontrol", "requeue", f"{trial.job}_{task}")
    cluster.wait()
    assert trial.restarts() == 0
    return trial, f"task {task}"


def drained(cluster, farm):
    trial = Trial(cluster, farm, "drained")
    task = trial.wait_for_worker("n2")
    slurm_cluster.call("scontrol", "update", "nodename=n2", "state=drain", "reason=test")
    until(lambda: task not in cluster.running(), "the task on the drained node ends")
    states = cluster.node_states()
    assert "drain" in states[1] or "drng" in states[1], states
    cluster.wait()
    slurm_cluster.call("scontrol", "update", "nodename=n2", "state=resume")
    return trial, f"task {task} ended on the node, the others on n1"


def cancelled(cluster, farm):
    trial = Trial(cluster, farm, "cancelled")
    trial.wait_for_worker("n1")
    slurm_cluster.call("scancel", trial.job)
    cluster.wait()
    left = 12 - data_sets.published(trial.data_set)
    assert left > 0 and trial.restarts() == 0
    cluster.submit(cluster.folder / "cancelled.sh")
    cluster.wait()
    return trial, f"nothing came back by itself; {left} sequences were made by another sbatch"


def out_of_time(cluster, farm):
    """The least limit is a minute, and the warning comes up to a minute earlier than asked for."""
    trial = Trial(cluster, farm, "late", ["--time", "1", "--warning", "50"], LONG)
    cluster.wait(600)
    assert trial.restarts() > 0
    return trial, f"{trial.restarts()} tasks ran again"


# The first one alone unless others are named.
SCENARIOS = [node_lost_and_worker_killed, requeued, drained, cancelled, out_of_time]


def main():
    slurm_cluster.enter()
    chosen = [scenario for scenario in SCENARIOS if scenario.__name__ in sys.argv[2:]] or SCENARIOS[:1]
    with tempfile.TemporaryDirectory() as folder:
        farm = data_sets.Farm(sys.argv[1], folder)
        cluster = slurm_cluster.Cluster(folder)
        try:
            for scenario in chosen:
                begin = time.monotonic()
                trial, told = scenario(cluster, farm)
                took = time.monotonic() - begin
                whole = farm.made(trial.data_set.name + "-local", **trial.sizes)
                data_sets.check_same(farm, whole, trial.data_set)
                print(f"{scenario.__name__}: {took:.0f} s; {told}", flush=True)
        except AssertionError:
            print(cluster.told())
            raise
        finally:
            cluster.stop()


if __name__ == "__main__":
    main()
