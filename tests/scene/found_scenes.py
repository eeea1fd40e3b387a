#!/usr/bin/python3
"""Says which scene files of other authors open, and why the others do not:
    tests/scene/found_scenes.py FOLDER... [--build build/dev] [--leave-out PART]...
It asks `saccade-eval scene` for every .xml, .gltf, .glb, .obj and .ply in the folders, but for meshes beside a scene of
Mitsuba or glTF, and for parts that other files include. Each line of the table is a file. The last line counts those
that open, and those that lack a mesh or a picture and have no other fault: these say nothing about the reader.
--leave-out names files whose path has this part. It needs no other package.
"""
import argparse
import re
import subprocess
import sys
from pathlib import Path

SCENES, MODELS = {".xml", ".gltf", ".glb"}, {".obj", ".ply"}
ABSENT = re.compile(r"is absent")
SECONDS = 300  # for one file


def holds_scene(path):
    return path.suffix != ".xml" or b"<scene" in path.read_bytes()[:100_000]


def found_in(folder, left_out):
    """Scene files, and models in folders that have none at or above them."""
    files = sorted(p for p in folder.rglob("*") if p.suffix in SCENES | MODELS and not any(part in str(p) for part in left_out))
    scenes = [p for p in files if p.suffix in SCENES and holds_scene(p)]
    places = {p.parent for p in scenes}
    models = [p for p in files if p.suffix in MODELS and places.isdisjoint(p.parents)]
    return scenes + models


def faults_of(program, scene):
    """None where it opens, else the sentences that say why it does not."""
    done = subprocess.run([program, "scene", scene], capture_output=True, text=True, timeout=SECONDS)
    if done.returncode == 0:
        return None
    lines = (done.stdout + done.stderr).splitlines()
    return [line.removeprefix("fault").strip() for line in lines if line.startswith("fault")] or lines[:1]


def summary(faults):
    """One fault that is no absent file if there is such a one, without its place."""
    if faults is None:
        return "opens"
    told = [f for f in faults if not ABSENT.search(f)]
    more = f" (and {len(faults) - 1} more)" if len(faults) > 1 else ""
    what = re.sub(r"^\S*?:(?:\d+:)? ", "", (told or faults)[0])
    return (what if told else "a file is absent: " + what) + more


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("folders", type=Path, nargs="+")
    p.add_argument("--build", type=Path, default="build/dev")
    p.add_argument("--leave-out", action="append", default=[])
    a = p.parse_args()
    program, opened, incomplete, count = a.build / "bin/saccade-eval", 0, 0, 0
    print("| file | result |\n|---|---|")
    for folder in a.folders:
        for path in found_in(folder, a.leave_out):
            faults = faults_of(program, path)
            opened, count = opened + (faults is None), count + 1
            incomplete += faults is not None and all(ABSENT.search(f) for f in faults)
            print(f"| {path.relative_to(folder)} | {summary(faults)} |", flush=True)
    print(f"\n{opened} of {count} files open. Of the others {incomplete} lack a file, and have no other fault.")
    return 0 if opened == count else 1


if __name__ == "__main__":
    sys.exit(main())
