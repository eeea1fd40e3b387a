"""Events as pictures: counts, voxel grids and time surfaces. The methods of Events describe them."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from saccade.values import MOST_U32, check, positive, whole

if TYPE_CHECKING:
    from saccade.events import Events


def known_size(events: Events) -> tuple[int, int]:
    """Width and height. Raises ValueError where the file did not tell them."""
    if events.size is None:
        raise ValueError("the size of the sensor is unknown: give read() or open_file() size=(width, height)")
    return events.size


def frame(events: Events) -> NDArray[np.int32]:
    width, height = known_size(events)
    counts = np.bincount(_cells(events, events.p), minlength=2 * height * width)
    return counts.reshape(2, height, width).astype(np.int32)


def voxel(events: Events, bins: int) -> NDArray[np.float32]:
    """As A. Zhu et al. define it, "Unsupervised Event-based Learning of Optical Flow, Depth, and Egomotion", CVPR 2019.

    t* = (bins - 1) (t - t_first) / (t_last - t_first), and an event adds p max(0, 1 - |b - t*|) to bin b.
    """
    bins = check("bins", bins, whole(2, MOST_U32))
    width, height = known_size(events)
    grid = np.zeros(bins * height * width)
    if len(events):
        since_first = events.t - events.t[0]
        position = (bins - 1) * since_first / max(since_first[-1], 1)
        lower = np.minimum(position.astype(np.int64), bins - 2)
        polarity = np.where(events.p, 1.0, -1.0)
        for index, weight in ((lower, 1 - (position - lower)), (lower + 1, position - lower)):
            grid += np.bincount(_cells(events, index), polarity * weight, grid.size)
    return grid.reshape(bins, height, width).astype(np.float32)


def time_surface(events: Events, tau_us: float, at_us: int) -> NDArray[np.float32]:
    """As X. Lagorce et al. define it, "HOTS: A Hierarchy of Event-Based Time-Surfaces", PAMI 2017."""
    tau_us = check("tau_us", tau_us, positive)
    width, height = known_size(events)
    past = events[: int(np.searchsorted(events.t, at_us, side="right"))]
    surface = np.zeros(2 * height * width, np.float32)
    surface[_cells(past, past.p)] = np.exp((past.t - at_us) / tau_us)  # of equal indices the last, newest one stays
    return surface.reshape(2, height, width)


def _cells(events: Events, plane: NDArray[Any]) -> NDArray[np.int64]:
    """The flat index of each event in planes of height * width."""
    width, height = known_size(events)
    return (plane.astype(np.int64) * height + events.y) * width + events.x
