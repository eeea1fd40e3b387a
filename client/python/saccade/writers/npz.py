""".npz with t (microseconds), x, y, p, width, height, labels, objects, and truth channels as NAME, NAME_t and NAME_exposure."""
from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from saccade.representations import known_size
from saccade.truth import TruthArrays

if TYPE_CHECKING:
    from saccade.events import Events


def write_npz(path: str | os.PathLike[str], events: Events, truth: Mapping[str, TruthArrays] = {}) -> None:
    """Raises ValueError where the size of the sensor is unknown."""
    width, height = known_size(events)
    arrays: dict[str, NDArray[Any]] = {name: channel.data for name, channel in truth.items()}
    arrays |= {f"{name}_t": channel.t for name, channel in truth.items()}
    arrays |= {f"{name}_exposure": channel.exposure for name, channel in truth.items() if channel.exposure is not None}
    arrays |= events.facts()
    np.savez_compressed(path, t=events.t, x=events.x, y=events.y, p=events.p.view(np.uint8), width=width, height=height,
                        **arrays)
