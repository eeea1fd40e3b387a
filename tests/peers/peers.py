#!/usr/bin/python3
"""Compares our events with those of other simulators on equal frames, and prints one table:
    tests/peers/peers.py [BUILD [SCENE]]     with BUILD/bin, by default build/dev; --help tells the options
README.md beside it says where the other programs are looked for, and what the columns mean.
"""
import argparse
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent / "python")]
import rivals  # noqa: E402
import saccaded  # noqa: E402

TRIES = 5  # a server that has forgotten a stream, as it may at once after its end, tells no times


def write_png(path, picture):
    """8-bit grey, row by row from the top."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    height, width = picture.shape
    rows = np.hstack([np.zeros((height, 1), np.uint8), picture]).tobytes()
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows, 1)) + chunk(b"IEND", b""))


def run(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{Path(command[0]).name}: {done.stderr.strip()}")
    return done.stdout + done.stderr


def render(o, server, folder):
    """Renders the frames into folder/frames and folder/clip.npz, as an 8-bit camera with sRGB has them.

    The first one has even numbers only and the others odd ones. So no pixel comes back to its first level exactly,
    where the last bit of a sum would decide about an event.
    """
    run([o.bin / "saccade", "record", o.scene, "--motion", o.motion, "--size", o.size, "--rate", o.rate, "--duration",
         o.duration, "--spp", o.spp, "--truth", "frame", "--control", server.address, "-o", folder / "scene.npz"])
    with np.load(folder / "scene.npz") as file:
        frames = file["frame"][..., 0] | 1
    frames[0] -= 1
    np.savez(folder / "clip.npz", frames=frames, rate=o.rate, threshold=o.threshold, bias=o.bias)
    (folder / "frames").mkdir()
    for number, picture in enumerate(frames):
        write_png(folder / "frames" / f"{number:06}.png", picture)
    return len(frames)


def our_events(o, server, folder):
    """Writes folder/saccade.npz. Returns the CPU ms per frame of the stage that makes events."""
    command = [o.bin / "saccade", "events", folder / "frames", "--transfer", "linear", "--rate", o.rate, "--threshold",
               o.threshold, "--bias", o.bias, "--start-level", "zero", "--max-events", 65536, "--control",
               server.address, "--force", "-o", folder / "saccade.npz"]
    for _ in range(TRIES):
        told = re.search(r"CPU ms per frame.* events ([\d.e+-]+)", run(command))
        if told:
            return float(told.group(1))
    raise RuntimeError("the server told no CPU times")


def rivals_events(name, folder):
    """Writes folder/NAME.npz. Returns the CPU seconds, or why there are none."""
    done = subprocess.run([sys.executable, "-B", HERE / "rivals.py", name, folder / "clip.npz", folder / "frames",
                           folder / f"{name}.npz"], capture_output=True, text=True, check=False)
    if done.returncode == 0:
        return float(done.stdout.split()[-1])
    return done.stderr.strip().splitlines()[-1]


def compare(o, folder, name):
    """What `saccade-eval compare-events` says of a rival's events, A, and ours, B."""
    return json.loads(run([o.bin / "saccade-eval", "compare-events", "--json", "--size", o.size, "--window", o.window,
                           folder / f"{name}.npz", folder / "saccade.npz"]))


def events_in(path):
    with np.load(path) as file:
        return len(file["t"])


def row(name, events, found, ours_ms, ms):
    """A line of the table; the first number of a pair is that of the rival."""
    chamfer = "-" if found["chamfer_px"] is None else f"{found['chamfer_px']:.3f}"
    return (f"| `{name}` | {events} | {100 * (1 - found['count_error']):.2f} | {chamfer} | "
            f"{100 * found['same_time'][0]:.1f} | {found['most_at_one_time'][0]} | {ms:.3g} | {ms / ours_ms:.1f} |")


def table(o, folder):
    """The lines of the table, and then those of rivals that are missing."""
    with saccaded.Server() as server:
        frames = render(o, server, folder)
        ours_ms = our_events(o, server, folder)

    def line(name, ms):
        return row(name, events_in(folder / f"{name}.npz"), compare(o, folder, name), ours_ms, ms)

    yield f"{o.scene}, {o.motion}, {o.size}, {frames} frames at {o.rate:g} Hz, C {o.threshold:g}, bias {o.bias:g}\n"
    yield "| simulator | events | equal, % | distance, px | same time, % | most at once | CPU ms | over ours |"
    yield "|---|---|---|---|---|---|---|---|"
    yield line("saccade", ours_ms)
    missing = []
    for name in rivals.RIVALS:
        seconds = rivals_events(name, folder)
        if isinstance(seconds, str):
            missing.append(f"skipped {name}: {seconds}")
        else:
            yield line(name, 1e3 * seconds / frames)
    yield from missing


def options(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=Path, default=HERE.parents[1] / "build" / "dev")
    parser.add_argument("scene", nargs="?", default="cornell-bunny")
    for name, default, what in [("--motion", "orbit:0.3px", "of the camera"), ("--size", "346x260", "WIDTHxHEIGHT"),
                                ("--rate", 1000.0, "frames per second"),
                                ("--duration", 0.1, "seconds"), ("--spp", 2, "paths per pixel and frame"),
                                ("--threshold", 0.2, "C, natural log units"), ("--bias", 0.02, "I_eps, of white"),
                                ("--window", 0.01, "seconds, for distances; see compare-events")]:
        parser.add_argument(name, default=default, type=type(default), help=f"{what}; default {default}")
    o = parser.parse_args(arguments)
    o.bin = o.build / "bin"
    os.environ["SACCADED"] = str(o.bin / "saccaded")
    return o


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as scratch:
        for text in table(options(), Path(scratch)):
            print(text, flush=True)
