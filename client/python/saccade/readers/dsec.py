"""HDF5 as the data set DSEC has it: /events/t, x, y, p, and /t_offset, which counts for each t; microseconds.

Further sensors of a recording have the same in the groups /sensor_1, /sensor_2 and so on.

Labels are /events/source and artefact, and objects /events/object.
"""
from __future__ import annotations

import pathlib
from collections.abc import Iterator
from typing import Any

import numpy as np

from saccade.errors import FormatError
from saccade.events import Events
from saccade.readers.columns import events_of, fact_names


def chunks(path: pathlib.Path, chunk: int, group: str = "") -> Iterator[Events]:
    """group: of the sensor, where it is not the first: "sensor_1/"."""
    import h5py
    with h5py.File(path, "r") as whole:
        if group and group not in whole:
            raise FormatError(f"no group '{group.rstrip('/')}'")
        file = whole[group] if group else whole
        names = [f"events/{name}" for name in "txyp"]
        missing = [name for name in names if name not in file]
        if missing:
            raise FormatError(f"no data set '{missing[0]}', as DSEC has it")
        columns = [file[name] for name in names]
        facts = {name: file[f"events/{name}"] for name in fact_names(file["events"].keys())}
        offset = int(file["t_offset"][()]) if "t_offset" in file else 0
        size = _size(file)
        for first in range(0, max(len(column) for column in columns), chunk):
            part = slice(first, first + chunk)
            t, x, y, p = (column[part] for column in columns)
            yield events_of(t.astype(np.int64) + offset, x, y, p, size,
                            {name: column[part] for name, column in facts.items()})


def _size(file: Any) -> tuple[int, int] | None:
    """As evutils and RVT write it; DSEC itself does not."""
    if {"width", "height"} <= file.attrs.keys():
        return int(file.attrs["width"]), int(file.attrs["height"])
    if {"width", "height"} <= file["events"].keys():
        return int(file["events/width"][()]), int(file["events/height"][()])
    return None
