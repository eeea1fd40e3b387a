#!/usr/bin/python3
"""Measures accuracy on small scenes that are hard for the methods:
    tests/bench/hard_scenes.py [BUILD] [OUT]     with BUILD/bin/saccade-eval, by default build/release
It prints a line for each figure: the value now, and the one that is asked. SACCADE_HARD_SCENES names the folder of the
scenes, by default ../shared/accuracy; others are those of the project, or of its stability suite. A figure without its
scenes is left out by name. OUT keeps what was measured, by default out/hard_scenes, and the same command continues there:
remove it after a change of the program.
"""
import csv
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SIZE = ["--size", "64x48"]
CELL = [*SIZE, "--motions", "right", "--speeds", "0.67", "--frames", "20:21", "--repeats", "4", "--reference", "1024",
        "--baselines", "event_svgf@2,svgf@2", "--candidates", "irradiance_cache@2,irradiance_cache@8,irradiance_cache@32"]
FEW, MANY = 64, 16384  # paths per pixel of a picture, and of its reference


class Bench:
    """Runs saccade-eval, and keeps its results for the figures that share them."""

    def __init__(self, build, out, scenes):
        self.program, self.out, self.scenes = Path(build) / "bin/saccade-eval", Path(out), Path(scenes)

    def path(self, scene):
        """Of the scene file; it may be absent."""
        places = [self.scenes / scene / "scene.xml", ROOT / f"tests/stability/scenes/{scene}.xml",
                  ROOT / "scenes" / scene / "scene.xml"]
        return next((place for place in places if place.exists()), places[0])

    def run(self, *arguments):
        command = [self.program, *map(str, arguments)]
        return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout

    def cell(self, scene, method, spp, column):
        """A column of results.csv of `cells`."""
        folder = self.out / scene
        self.run("cells", self.path(scene), *CELL, "--cache", self.out / "cache", "-o", folder)
        with open(folder / "results.csv", encoding="utf-8") as file:
            return cell_of(file.read(), method, spp, column)

    def picture(self, scene, spp):
        path = self.out / f"{scene}_{spp}.exr"
        if not path.exists():
            self.run("render", self.path(scene), *SIZE, "--bounces", 3, "--spp", spp, "--seed", spp,
                     "-o", path)
        return path

    def noise(self, scene, truth):
        """Of a picture with few paths, relative to a reference of the scene `truth`, which must look alike."""
        return noise_of(self.run("compare-renders", self.picture(scene, FEW), self.picture(truth, MANY)))


def cell_of(table, method, spp, column):
    lines = [line for line in table.splitlines() if not line.startswith("#")]
    for row in csv.DictReader(lines):
        if (row["method"], row["spp"]) == (method, str(spp)):
            return float(row[column])
    raise ValueError(f"no row of {method}@{spp}")


def noise_of(text):
    return float(re.search(r"^relative noise: (\S+)$", text, re.MULTILINE)[1])


def ours(bench, scene, column, spp=2):
    return bench.cell(scene, "irradiance_cache", spp, column)


def share(scene):
    return [scene], lambda bench: ours(bench, scene, "dL_share")


def over_rivals(scene, column):
    """Over the better of both rivals."""
    return [scene], lambda bench: ours(bench, scene, column) / min(
        bench.cell(scene, rival, 2, column) for rival in ("event_svgf", "svgf"))


def over_svgf(scene, column):
    return [scene], lambda bench: ours(bench, scene, column) / bench.cell(scene, "svgf", 2, column)


def over_scene(scene, base, column):
    return [scene, base], lambda bench: ours(bench, scene, column) / ours(bench, base, column)


def over_two_paths(scene, spp):
    return [scene], lambda bench: ours(bench, scene, "dL_error", spp) / ours(bench, scene, "dL_error")


def over_noise(scene, base):
    return [scene, base], lambda bench: bench.noise(scene, base) / bench.noise(base, base)


# Name, (scenes, value), "<=" or ">=", what is asked.
FIGURES = [
    ("blinds: share of dL that arrives", share("blinds"), ">=", 0.9),
    ("tree_sun: share of dL that arrives", share("tree_sun"), ">=", 0.8),
    ("tree_sun: false events over svgf's", over_svgf("tree_sun", "false_events"), "<=", 1),
    ("tree_bulb: share of dL that arrives", share("tree_bulb"), ">=", 0.8),
    ("lamps_thousand: dI over that of lamps_one", over_scene("lamps_thousand", "lamps_one", "dI_l1"), "<=", 1.2),
    ("bulb_sky_1000: noise at 64 paths over bulb_nosky's", over_noise("bulb_sky_1000", "bulb_nosky"), "<=", 1.2),
    ("house_sky_50: noise at 64 paths over house_nosky's", over_noise("house_sky_50", "house_nosky"), "<=", 1.2),
    *((f"{scene}: {column} over the better rival's", over_rivals(scene, column), "<=", 1)
      for scene in ("glass_and_mirror", "metal_ball", "plastic_balls", "rough_plastics")
      for column in ("dI_error", "false_events", "missed_events")),
    ("cornell-bunny: error of dL at 8 paths over that at 2", over_two_paths("cornell-bunny", 8), "<=", 0.8),
    ("cornell-bunny: error of dL at 32 paths over that at 2", over_two_paths("cornell-bunny", 32), "<=", 0.6),
]


def line(name, value, sign, asked):
    holds = value >= asked if sign == ">=" else value <= asked
    return f"{name:54} {value:8.3g}  asked {sign} {asked:<4g} {'' if holds else 'short'}".rstrip()


def main(build=ROOT / "build/release", out=ROOT / "out/hard_scenes"):
    scenes = Path(os.environ.get("SACCADE_HARD_SCENES", ROOT.parent / "shared/accuracy"))
    Path(out).mkdir(parents=True, exist_ok=True)
    bench = Bench(build, out, scenes)
    for name, (needed, value), sign, asked in FIGURES:
        absent = [scene for scene in needed if not bench.path(scene).exists()]
        print(f"{name}: absent: {', '.join(absent)}" if absent else line(name, value(bench), sign, asked), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
