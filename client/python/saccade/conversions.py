"""Events in the form of other libraries. The methods of Events describe them."""
from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import torch

    from saccade.events import Events

TONIC = np.dtype([("x", np.int16), ("y", np.int16), ("t", np.int64), ("p", np.bool_)])


def to_tonic(events: Events) -> NDArray[np.void]:
    array = np.empty(len(events), TONIC)
    for name in ("x", "y", "t", "p"):
        array[name] = getattr(events, name)
    return array


def to_torch(events: Events) -> dict[str, torch.Tensor]:
    import torch
    signed = {"t": np.int64, "x": np.int16, "y": np.int16, "p": np.bool_}  # torch 1.13 has no unsigned 16 bits
    return {name: torch.from_numpy(getattr(events, name).astype(dtype)) for name, dtype in signed.items()}
