"""A Slurm of two nodes on this machine, in namespaces of its own: nothing of it is left or seen outside.

enter() runs the program again within the namespaces. There a Cluster starts slurmctld and a slurmd for each node; the
second has a namespace of processes of its own, so that the loss of the node ends all that runs on it."""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import data_sets

TOOLS = ["munged", "slurmctld", "slurmd", "sbatch", "scontrol", "squeue", "unshare", "ip", "mount"]
NAMESPACES = ["unshare", "--mount", "--pid", "--fork", "--net", "--uts", "--ipc", "--mount-proc", "--kill-child"]
# The first process of a namespace, which takes in the orphans: Slurm waits for those that nobody has.
INIT = ["bash", "-c", '"$@"; exit $?', "init"]
INSIDE = "SACCADE_IN_NAMESPACES"
ADDRESS = "192.0.2.1"

CONFIGURATION = """
ClusterName=farm
SlurmctldHost=farm
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
SlurmdParameters=config_overrides
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=1,sched_interval=1,sched_min_interval=0,bf_interval=1
MpiDefault=none
ReturnToService=2
JobRequeue=1
KillWait=2
OverTimeLimit=0
SlurmdTimeout=5
NodeName=n1 NodeHostname=farm Port=17001 CPUs=1 RealMemory=1000
NodeName=n2 NodeHostname=farm Port=17002 CPUs=1 RealMemory=1000
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def enter():
    """Returns within the namespaces, or ends the program: as skipped where they cannot be."""
    if os.environ.get(INSIDE):
        return
    missing = [tool for tool in TOOLS if shutil.which(tool) is None]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (packages slurm-wlm, munge, iproute2)")
        sys.exit(77)
    if subprocess.run([*NAMESPACES, "true"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
        print("skipped: this user may make no namespaces")
        sys.exit(77)
    os.environ[INSIDE] = "1"
    sys.exit(subprocess.run([*NAMESPACES, *INIT, sys.executable, "-B", *sys.argv], check=False).returncode)


def call(*words):
    return subprocess.run(list(map(str, words)), check=True, capture_output=True, text=True).stdout


class Cluster:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.daemons, self.hurried = {}, {}
        configuration = self.folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(folder=folder), encoding="utf-8")
        os.environ["SLURM_CONF"] = str(configuration)
        self._name_machine()
        self._start_munge()
        self._start("slurmctld", "slurmctld", "-D", "-c")
        self.start_node("n1")
        self.start_node("n2")
        data_sets.until(lambda: self.node_states() == ["idle", "idle"], "both nodes are idle")

    def _name_machine(self):
        hosts = self.folder / "hosts"
        hosts.write_text(f"127.0.0.1 localhost\n{ADDRESS} farm\n", encoding="utf-8")
        call("hostname", "farm")
        call("ip", "link", "set", "lo", "up")
        call("ip", "addr", "add", f"{ADDRESS}/32", "dev", "lo")
        call("mount", "--bind", hosts, "/etc/hosts")

    def _start_munge(self):
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self._start("munged", "munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.folder}/munge.socket",
                    f"--pid-file={self.folder}/munge.pid", f"--log-file={self.folder}/munge.log",
                    f"--seed-file={self.folder}/munge.seed")
        data_sets.until((self.folder / "munge.socket").exists, "munged listens")

    def _start(self, name, *command):
        with open(self.folder / f"{name}.out", "ab") as output:
            self.daemons[name] = subprocess.Popen(command, stdout=output, stderr=output, stdin=subprocess.DEVNULL)

    def start_node(self, name):
        own = ["unshare", "--pid", "--fork", "--mount", "--mount-proc", "--kill-child", *INIT] if name == "n2" else []
        self._start(name, *own, "slurmd", "-D", "-N", name)

    def lose_node(self):
        """The second node is gone with all its processes."""
        self.daemons["n2"].kill()
        self.daemons["n2"].wait()

    def node_states(self):
        """Of n1 and n2; nothing while slurmctld does not answer yet."""
        command = ["sinfo", "--noheader", "--Node", "--format=%t"]
        return subprocess.run(command, check=False, capture_output=True, text=True).stdout.split()

    def submit(self, script, *options):
        return call("sbatch", "--parsable", "--chdir", self.folder, *options, script).strip()

    def tasks(self):
        """The tasks that have not ended: job, number, state, and where or why."""
        return [tuple(line.split("|")) for line in
                call("squeue", "--noheader", "--array", "--format=%F|%K|%T|%R").splitlines()]

    def running(self):
        return {int(task) for _, task, state, _ in self.tasks() if state == "RUNNING"}

    def on(self, node):
        """The number of the task on a node, or None."""
        return next((int(task) for _, task, state, where in self.tasks() if state == "RUNNING" and where == node), None)

    def hurry(self):
        """Slurm lets a requeued task wait for two minutes. This makes them seconds, and returns all tasks. At once would
        be too early: the node still holds the task for one that is being ended."""
        tasks, now = self.tasks(), time.monotonic()
        for job, task, _, reason in tasks:
            if reason == "(BeginTime)" and now > self.hurried.get((job, task), 0) + 15:
                self.hurried[job, task] = now
                subprocess.run(["scontrol", "update", f"jobid={job}_{task}", "starttime=now+3"], check=False,
                               capture_output=True)
        return tasks

    def wait(self, seconds=120):
        data_sets.until(lambda: not self.hurry(), "all tasks have ended", seconds)

    def told(self):
        """What Slurm and the tasks say, for the reader of a fault."""
        logs = [*self.folder.glob("slurmctld.log"), *self.folder.glob("slurm-*.out")]
        texts = [f"== {log.name}\n" + "\n".join(log.read_text(encoding="utf-8", errors="replace").splitlines()[-15:]) for log in logs]
        return call("scontrol", "show", "job") + call("squeue", "--array") + "\n".join(texts)

    def stop(self):
        for daemon in reversed(self.daemons.values()):
            daemon.send_signal(signal.SIGKILL)
            daemon.wait()


def words_of(process):
    try:
        return pathlib.Path(f"/proc/{process}/cmdline").read_bytes().split(b"\0")
    except OSError:
        return []


def parent_of(process):
    try:
        return int(pathlib.Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()[1])
    except OSError:
        return 0


def worker_of(data_set, task):
    """The `saccade-farm run` of a task, without the processes that it has forked; None where there is none. Those of
    namespaces below are there too."""
    def is_run(process):
        words = words_of(process)
        return words[1:4] == [b"run", str(data_set).encode(), b"--shard"] and words[4].startswith(f"{task}/".encode())
    runs = [int(folder.name) for folder in pathlib.Path("/proc").glob("[0-9]*") if is_run(folder.name)]
    return next((process for process in runs if parent_of(process) not in runs), None)
