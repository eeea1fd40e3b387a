"""A stream of saccaded for a node: parameters, camera and stamps. It is the same for ROS 1 and ROS 2."""
from __future__ import annotations

import contextlib
import math
import time

import saccade

# Parameters that are settings of the stream, with their defaults: an empty text or 0 leaves the choice to the server.
SETTINGS = {
    "scene": "cornell-box",
    "trajectory": "",  # this or the next
    "motion": "",
    "animation": "",
    "rate_hz": 0.0,
    "duration_s": 0.0,
    "fov_x_deg": 0.0,
    "threshold": 0.0,
    "threshold_off": 0.0,
    "bias": 0.0,
    "refractory_s": 0.0,
    "clock": "",
    "delivery": "",
}
# All parameters. client/README.md describes them.
PARAMETERS = {**SETTINGS, "objects": "", "server": "", "width": 240, "height": 180, "frame_id": "camera",
              "stream_time": False, "wait_for_subscriber": True}

NS_PER_US, NS_PER_S = 1000, 1_000_000_000
POLL_S = 0.02


def wait_for_subscriber(count, stopped):
    """Returns when count() is above 0, or stopped() is true."""
    while count() == 0 and not stopped():
        time.sleep(POLL_S)


@contextlib.contextmanager
def open_stream(parameters):
    """Gives a saccade.Stream. parameters: the values of PARAMETERS, by name."""
    settings = {name: parameters[name] for name in SETTINGS if parameters[name]}
    if parameters["objects"]:
        settings["objects"] = objects_of(parameters["objects"])
    with saccade.connect(parameters["server"] or None) as client:
        with client.open(size=(parameters["width"], parameters["height"]), **settings) as stream:
            yield stream


def objects_of(text):
    """The paths of objects by name, of NAME=PATH,NAME=PATH."""
    pairs = [pair.partition("=") for pair in text.split(",")]
    if not all(name and path for name, _, path in pairs):
        raise ValueError(f"objects: '{text}' is not NAME=PATH,NAME=PATH, such as bunny=spin:90,light=still")
    return {name: path for name, _, path in pairs}


def intrinsics(stream):
    """The matrix K of the camera, row by row: square pixels, whose centres are at whole numbers."""
    width, height = stream.size
    focal = width / (2 * math.tan(math.radians(stream.resolved.view.fov_x_deg) / 2))
    return [focal, 0.0, (width - 1) / 2, 0.0, focal, (height - 1) / 2, 0.0, 0.0, 1.0]


def projection(matrix):
    """The matrix P of a camera without a second one beside it, row by row."""
    return [value for row in range(3) for value in (*matrix[3 * row:3 * row + 3], 0.0)]


class LossWatch:
    """Tells of packets that a LIVE or BROADCAST stream has lost."""

    def __init__(self, stream, warn):
        self.stream, self.warn, self.told = stream, warn, 0

    def check(self):
        losses = self.stream.losses
        if losses.packets > self.told:
            self.told = losses.packets
            self.warn(f"{losses.packets} packets with {losses.events} events were lost so far")
