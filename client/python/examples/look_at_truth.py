"""Draws a recording, a row for each camera: events over the exposed frame, optical flow as colours, and depth.

    python3 look_at_truth.py PICTURE.png stereo.h5

The recording has the truth channels frame, flow_forward and depth. The direction of the flow is the hue: red is to
the right, and the hues turn clockwise. Its length is the saturation: white stands still. Black has no valid flow. White
in the depth has no surface.
Events are those of the exposure: ON is red, OFF is blue.
"""
from __future__ import annotations

import argparse
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import hsv_to_rgb
from numpy.typing import NDArray

import saccade

NO_SURFACE = 1e5  # what the channel depth has there


def frame_with_events(frames: saccade.TruthArrays, sample: int, events: saccade.Events) -> NDArray[np.float64]:
    """Colours, float (height, width, 3)."""
    grey = frames.data[sample, ..., 0] / np.iinfo(frames.data.dtype).max
    colours = np.repeat(grey[..., np.newaxis], 3, axis=-1)
    assert frames.exposure is not None  # pictures have it
    begin, end = frames.exposure[sample]
    for polarity, colour in ((False, (0, 0, 1)), (True, (1, 0, 0))):
        seen = (events.t >= begin) & (events.t < end) & (events.p == polarity)
        colours[events.y[seen], events.x[seen]] = colour
    return colours


def flow_colours(flow: NDArray[np.float32]) -> NDArray[np.float64]:
    """Of flow (height, width, 3): x, y and valid."""
    x, y, valid = np.moveaxis(flow, -1, 0)
    length = np.hypot(x, y)
    longest = max(float(length[valid > 0].max(initial=0)), 1e-9)
    hue = np.arctan2(y, x) / (2 * np.pi) % 1
    saturation, value = np.minimum(length / longest, 1), 0.9 * (valid > 0)
    colours: NDArray[np.float64] = hsv_to_rgb(np.stack([hue, saturation, value], axis=-1))
    return colours


def surface_depth(depth: NDArray[np.float32]) -> NDArray[np.float32]:
    """NaN where no surface is, so that it does not set the scale of the colours."""
    return np.where(depth < NO_SURFACE, depth, np.float32(np.nan))


def draw(recording: saccade.Recording, view: int, row: Any) -> None:
    truth = recording.truth[view]
    for kind in ("frame", "flow_forward", "depth"):
        if kind not in truth:
            raise SystemExit(f"camera {view} has no truth channel {kind}; record it with --truth {kind}")
    sensor = next(sensor for sensor in recording.sensors if recording.view_of(sensor) == view)
    frames, flow, depth = truth["frame"], truth["flow_forward"], truth["depth"]
    middle = len(frames.t) // 2
    row[0].imshow(frame_with_events(frames, middle, recording.events[sensor]))
    row[0].set_title(f"camera {view}: events over the frame at {frames.t[middle] / 1e6:.3f} s")
    row[1].imshow(flow_colours(flow.data[len(flow.t) // 2]))
    row[1].set_title("flow into the next frame")
    row[2].imshow(surface_depth(depth.data[len(depth.t) // 2, ..., 0]), cmap="viridis")
    row[2].set_title("depth")


def main() -> None:
    parser = argparse.ArgumentParser(description="Draws a recording with truth.")
    parser.add_argument("picture", help="PNG to write")
    parser.add_argument("recording", help=".h5 or .npz with frame, flow_forward and depth")
    options = parser.parse_args()
    recording = saccade.Recording(options.recording)
    figure, rows = plt.subplots(len(recording.truth), 3, figsize=(15, 4.5 * len(recording.truth)), squeeze=False)
    for view, row in zip(recording.truth, rows):
        draw(recording, view, row)
    figure.tight_layout()
    figure.savefig(options.picture)


if __name__ == "__main__":
    main()
