"""Data sets through the pods of the Job that `saccade-farm kubernetes` writes, whose bytes are those of a local run:
pods_test.py FARM [ROOT]. ROOT is that of the image; without it, the pods have the programs of this machine."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

import data_sets
import pods

USER = 65532
INSIDE = "SACCADE_IN_NAMESPACE"


def enter():
    """Returns within a namespace of mounts, or ends the program: as skipped where there can be none."""
    if os.environ.get(INSIDE):
        return
    missing = [tool for tool in ("unshare", "rclone") if shutil.which(tool) is None]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed")
        sys.exit(77)
    if subprocess.run(["unshare", "--mount", "true"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
        print("skipped: this user may make no namespaces")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as roots:
        os.environ[INSIDE] = roots
        command = ["unshare", "--mount", sys.executable, "-B", *sys.argv]
        sys.exit(subprocess.run(command, check=False).returncode)


def given_away(folder):
    subprocess.run(["chown", "-R", f"{USER}:{USER}", folder], check=True)


def root_of_this_machine(folder, program):
    root = pods.overlay(folder)
    if root is None:
        print("skipped: this machine mounts no overlays")
        sys.exit(77)
    (root / "usr/local/bin/saccade-farm").symlink_to(os.path.realpath(program))
    return root


def root_of_rclone(folder):
    """What the image of rclone has, of what the Job takes from it."""
    root = pods.overlay(folder)
    shutil.copy(shutil.which("rclone"), root / "usr/local/bin/rclone")
    (root / "etc/ssl/certs").mkdir(parents=True, exist_ok=True)
    (root / "etc/ssl/certs/ca-certificates.crt").touch()
    return root


def on_a_volume(farm, roots):
    """Every shard, on a volume with a nasty name of a folder."""
    claim = farm.folder / "claim"
    data_set = farm.plan("claim/" + data_sets.NASTY)
    given_away(claim)
    jobs = pods.Pods(farm("kubernetes", data_set, "--image", "saccade", "--claim", "sets"), roots, claims={"sets": claim})
    codes = [jobs.run(shard) for shard in range(jobs.job["spec"]["completions"])]
    assert codes == [0, 0, 0, 0], codes
    data_sets.check_same(farm, farm.made("whole"), data_set)
    assert not list(farm.folder.rglob("PWNED"))
    return "4 pods"


def whole_sequences(bucket):
    """The sequences in a bucket that say they are whole, and are."""
    whole = 0
    for line in bucket.glob("shards/*/*/sequence.json"):
        text = line.read_text(encoding="utf-8")
        if not text.endswith("\n"):
            continue  # a local bucket shows files that are being written
        whole += 1
        for file in json.loads(text)["files"]:
            assert (line.parent / file["name"]).stat().st_size == int(file["bytes"]), (line, file)
    return whole


def times_of(bucket):
    """When the files of sequences that are whole were written."""
    whole = [line.parent for line in bucket.glob("shards/*/*/sequence.json")]
    return {file: file.stat().st_mtime_ns for folder in whole for file in folder.iterdir()}


def in_a_bucket(farm, roots):
    """Pods that are killed and ended while they work; the last one does the rest."""
    bucket, secret = farm.folder / "bucket", farm.folder / "secret"
    secret.mkdir()
    (secret / "rclone.conf").write_text("[store]\ntype = local\n", encoding="utf-8")
    data_set = farm.plan("bucket/set " + data_sets.NASTY, shards=1, duration=0.4)
    given_away(bucket)
    job = farm("kubernetes", data_set, "--image", "saccade", "--bucket", f"store:/bucket/{data_set.name}", "--rclone-secret",
               "store", "--rclone-image", "rclone")
    jobs = pods.Pods(job, roots, secrets={"store": secret}, more={"/bucket": bucket})
    counts = []
    for end in (signal.SIGKILL, signal.SIGTERM):
        with tempfile.TemporaryDirectory(dir=farm.folder) as scratch:
            with jobs.start(0, scratch, {"UPLOAD_EVERY_S": "0.1", "SLURM_CPUS_PER_TASK": "1"}) as pod:
                before = whole_sequences(data_set)
                data_sets.until(lambda: whole_sequences(data_set) > before or pod.poll() is not None, "a sequence is uploaded")
                assert pod.poll() is None, pod.returncode
                pods.send(pod, end)
            assert end == signal.SIGKILL or pod.returncode == 75, pod.returncode
        counts.append(whole_sequences(data_set))
    assert counts[1] < 12, counts
    times = times_of(data_set)
    assert jobs.run(0) == 0
    assert times.items() <= times_of(data_set).items(), "what was there has been made again"
    data_sets.check_same(farm, farm.made("whole-shard", shards=1, duration=0.4), data_set)
    assert not list(farm.folder.rglob("PWNED"))
    return f"pods were killed after {counts[0]} and ended after {counts[1]} of 12 sequences"


def main():
    enter()
    with tempfile.TemporaryDirectory() as folder:
        farm = data_sets.Farm(sys.argv[1], folder)
        places = pathlib.Path(os.environ[INSIDE])
        subprocess.run(["mount", "-t", "tmpfs", "none", places], check=True)
        image = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else root_of_this_machine(places / "machine", farm.program)
        roots = {"saccade": image, "rclone": root_of_rclone(places / "rclone")}
        for trial in (on_a_volume, in_a_bucket):
            print(f"{trial.__name__}: {trial(farm, roots)}", flush=True)


if __name__ == "__main__":
    main()
