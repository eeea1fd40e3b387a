#!/usr/bin/python3
"""Paths per CPU second at equal variance, against Blender's Cycles.

    tests/bench/cycles_speed.py FOLDER [--build build/dev] [--scene cornell-bunny] [--size 256x256] [--spp 128]
        [--bounces 3] [--rounds 3]

The scene may have diffuse meshes of OBJ files, and lamps of one side. Both programs render pixel centres with two seeds:
the variance is half the mean square of the difference. CPU time is that of a process with all paths less that of one with an
eighth of them, so that no start counts. Programs run in turn, and each time is the least of some rounds. It prints the
ratios of rates and variances, and their quotient. It also prints the ratio of the means of both pictures, which is 1
where scenes are equal.
It needs the Debian packages blender, python3-numpy and python3-openimageio, and takes two minutes.
"""
import argparse
import math
import pathlib
import resource
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent / "statistical")]  # Blender looks elsewhere
from gltf_in_cycles import inside_blender, prepare_cycles, render_in_blender, run_blender
from motion_in_cycles import luminance

ROOT = HERE.parents[1]
A_FEW = 8  # the part of the paths that tells what a start takes


def look_at_pixel_centres():
    import bpy

    cycles, render = bpy.context.scene.cycles, bpy.context.scene.render
    cycles.pixel_filter_type, cycles.filter_width, render.threads_mode, render.threads = "GAUSSIAN", 0.01, "FIXED", 1


def cpu_seconds(run):
    """User and system time of the processes that run() starts and waits for."""
    used = lambda: sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
    before = used()
    run()
    return used() - before


class Cycles:
    name = "cycles"

    def __init__(self, a):
        self.settings = [ROOT / "scenes" / a.scene / "scene.xml", *a.size, a.bounces]

    def render(self, picture, spp, seed):
        run_blender(__file__, *self.settings, spp, seed, picture.resolve())


class Saccade:
    name = "saccade"

    def __init__(self, a):
        self.command = [a.build / "bin/saccade-eval", "render", a.scene, "--bounces", str(a.bounces), "--size",
                        "x".join(map(str, a.size))]

    def render(self, picture, spp, seed):
        subprocess.run([*self.command, "--spp", str(spp), "--seed", str(seed), "-o", picture], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def variance_and_mean(pictures):
    of = [luminance(p) for p in pictures]
    return ((of[0] - of[1]) ** 2).mean() / 2, (of[0] + of[1]).mean() / 2


def measure(a):
    programs = Cycles(a), Saccade(a)
    seconds = {p.name: math.inf for p in programs}
    for n in range(a.rounds):
        for p in programs:
            times = [cpu_seconds(lambda: p.render(a.folder / f"{p.name}_{n}_{spp}.exr", spp, n))
                     for spp in (a.spp, a.spp // A_FEW)]
            seconds[p.name] = min(seconds[p.name], times[0] - times[1])
            print(f"round {n + 1} of {a.rounds}, {p.name}: {times[0]:.1f} s", file=sys.stderr)
    paths = a.size[0] * a.size[1] * (a.spp - a.spp // A_FEW)
    rate = {name: paths / s for name, s in seconds.items()}
    of = {p.name: variance_and_mean([a.folder / f"{p.name}_{n}_{a.spp}.exr" for n in (0, 1)]) for p in programs}
    for p in programs:
        print(f"{p.name:8} {1e-6 * rate[p.name]:.3f} million paths per CPU second, variance {of[p.name][0]:.3g}")
    variances, means = (ours / theirs for ours, theirs in zip(of["saccade"], of["cycles"]))
    rates = rate["saccade"] / rate["cycles"]
    print(f"rate {rates:.2f}, variance {variances:.2f}, mean {means:.4f}")
    print(f"paths per CPU second at equal variance: {rates / variances:.2f} (asked 3.5)")


def main():
    if arguments := inside_blender():
        from cycles_scene import open_scene

        scene, width, height, bounces, spp, seed, picture = arguments
        open_scene(pathlib.Path(scene))
        prepare_cycles((int(width), int(height)), int(spp), int(bounces))
        look_at_pixel_centres()
        return render_in_blender(picture, 0, int(seed))
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("folder", type=pathlib.Path)
    p.add_argument("--build", type=pathlib.Path, default=ROOT / "build/dev")
    p.add_argument("--scene", default="cornell-bunny")
    p.add_argument("--size", type=lambda s: [int(n) for n in s.split("x")], default=[256, 256])
    p.add_argument("--spp", type=int, default=128)
    p.add_argument("--bounces", type=int, default=3)
    p.add_argument("--rounds", type=int, default=3)
    a = p.parse_args()
    if a.rounds < 2:
        p.error("--rounds: a variance needs two seeds at least")
    a.folder.mkdir(parents=True, exist_ok=True)
    measure(a)


if __name__ == "__main__":
    main()
