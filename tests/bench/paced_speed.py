"""How fast the image may move on a PACED stream with a bake: refined intervals of a pixel, against frames every half
pixel.

Usage: SACCADED=build/dev/bin/saccaded paced_speed.py [SCENE...], with the package saccade installed. A FAST stream of
each kind tells how many pixels of motion the server renders per second. A PACED stream then runs at 0.95 times that
speed. The most that it was late is printed: a second counts as lag.
"""
import argparse
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
import saccade
from saccaded import Server

PX_PER_S, TURN_PX = 500, 40  # of the stream; then the camera turns back
# The fastest pixels move by less than two where most move by one: so a frame is one interval.
KINDS = {"refined": {"rate_hz": PX_PER_S, "motion": "truck:1px", "interval_px": 2},
         "frames": {"rate_hz": 2 * PX_PER_S, "motion": "truck:0.5px"}}
PART = 0.95  # of the fastest


class Run:
    """A stream that has run: its seconds, those of the wall clock, and how late it was at most. `speed`: None for FAST."""

    def __init__(self, client, seconds, speed, settings):
        self.late_s = 0
        with client.open(**settings, clock="paced" if speed else "fast", speed=speed or 1) as stream:
            begin = None
            for part in stream:
                now = time.perf_counter()
                if begin is None:  # the first packet may have waited for the client
                    begin, first_s = now, part.t1 / 1e6
                self.wall_s, self.stream_s = now - begin, part.t1 / 1e6 - first_s
                if speed:
                    self.late_s = max(self.late_s, self.wall_s - self.stream_s / speed)
                if self.wall_s > seconds:
                    return


def measure(client, scene, a):
    print(f"{scene} {a.size}: pixels per second of the wall clock, and ms late at most in {a.seconds:g} s")
    size = tuple(map(int, a.size.split("x")))
    speeds = {}
    for name, kind in KINDS.items():
        settings = {"scene": scene, "size": size, "bake_error": 0.02, "delivery": "lossless",
                    "turn_s": TURN_PX / PX_PER_S, "duration_s": 0, **kind}
        fast = Run(client, a.seconds / 3, None, settings)
        speed = PART * fast.stream_s / fast.wall_s
        paced = Run(client, a.seconds, speed, settings)
        speeds[name] = speed * PX_PER_S
        print(f"{name:8} {speeds[name]:6.1f} {1e3 * paced.late_s:6.0f}", flush=True)
    print(f"refined against frames: {speeds['refined'] / speeds['frames']:.2f}")


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--seconds", type=float, default=60)
    p.add_argument("--threads", type=int, default=2)
    p.add_argument("--size", default="346x260")
    p.add_argument("scenes", nargs="*", default=["cornell-bunny"])
    a = p.parse_args()
    with Server(threads=a.threads) as server, saccade.connect(server.address) as client:
        for scene in a.scenes:
            measure(client, scene, a)


if __name__ == "__main__":
    main()
