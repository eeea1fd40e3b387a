"""HDF5 in the layout of DSEC, with all sensors and views of a rig in one file."""
from __future__ import annotations

import pathlib
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.events import Events
from saccade.representations import known_size
from saccade.truth import TruthArrays

US_PER_MS = 1000
MOST_US = (1 << 32) - 1
PACKED: dict[str, Any] = {"compression": "gzip", "compression_opts": 1, "shuffle": True}


def write_hdf5(path: pathlib.Path, sensors: Mapping[str, Events], truth: Mapping[str, TruthArrays]) -> None:
    """Both by group, such as "/" and "/truth/depth". Raises ValueError for times that cannot be, and ImportError."""
    import h5py
    with h5py.File(path, "w") as file:
        for name, events in sensors.items():
            _write_sensor(file.require_group(name), events)
        for name, arrays in truth.items():
            _write_channel(file.create_group(name), arrays)


def _write_sensor(group: Any, events: Events) -> None:
    if len(events) and not 0 <= events.t[0] <= events.t[-1] <= MOST_US:
        raise ValueError("the DSEC layout holds times from 0 to 4294.9 s; .npz holds others")
    group.attrs["width"], group.attrs["height"] = (np.uint32(side) for side in known_size(events))
    inside = group.create_group("events")
    inside["width"], inside["height"] = (np.uint32(side) for side in known_size(events))
    for name, kind in (("x", "<u2"), ("y", "<u2"), ("p", "u1"), ("t", "<u4")):
        _write_column(inside, name, getattr(events, name).astype(kind))
    for name, fact in events.facts().items():
        _write_column(inside, name, fact)
    milliseconds = np.arange(events.t1 // US_PER_MS + 2)  # entry m: the events before millisecond m
    _write_column(group, "ms_to_idx", np.searchsorted(events.t, milliseconds * US_PER_MS).astype("<u8"))
    group["t_offset"] = np.int64(0)


def _write_channel(group: Any, arrays: TruthArrays) -> None:
    _write_column(group, "t", arrays.t)
    _write_column(group, "data", arrays.data)
    if arrays.exposure is not None:
        _write_column(group, "exposure_begin", arrays.exposure[:, 0])
        _write_column(group, "exposure_end", arrays.exposure[:, 1])
    group.attrs["unit"], group.attrs["description"] = arrays.unit, arrays.description
    group.attrs["planes"] = list(arrays.planes)


def _write_column(group: Any, name: str, column: NDArray[Any]) -> None:
    group.create_dataset(name, data=column, maxshape=(None, *column.shape[1:]), chunks=True, **PACKED)
