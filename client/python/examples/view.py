"""Shows a stream while it is rendered: ON events blue, OFF events red, as a time surface.

    python3 view.py [SCENE [PICTURE.png]]

The server is that of $SACCADE_SERVER, or the one on this machine.
"""
from __future__ import annotations

import argparse

import matplotlib.pyplot as plt
import numpy as np
from numpy.typing import NDArray

import saccade

WINDOW_US, TAU_US = 20_000, 10_000.0


def picture(events: saccade.Events) -> NDArray[np.float32]:
    """Colours, float32 (height, width, 3): white where nothing happened."""
    off, on = events.time_surface(TAU_US)
    return np.stack([1 - on, 1 - np.maximum(on, off), 1 - off], axis=-1)


def main() -> None:
    parser = argparse.ArgumentParser(description="Shows a stream while it is rendered.")
    parser.add_argument("scene", nargs="?", default="cornell-box")
    parser.add_argument("picture", nargs="?", help="a file: show half a second, and save the last picture")
    options = parser.parse_args()
    (width, height), duration_s = (160, 120), 0.5 if options.picture else 0.0  # 0: until the window is closed
    image = plt.imshow(np.ones((height, width, 3)))
    with saccade.connect() as client:
        with client.open(scene=options.scene, motion="right", size=(width, height),
                         duration_s=duration_s) as stream:
            for events in saccade.windows(stream, duration_us=WINDOW_US):
                if not plt.fignum_exists(image.figure.number):
                    break
                image.set_data(picture(events))
                plt.title(f"{options.scene}: {len(events)} events in {WINDOW_US} us at {events.t0 / 1e6:.2f} s")
                plt.pause(0.001)
    if options.picture:
        plt.savefig(options.picture)


if __name__ == "__main__":
    main()
