"""Which rows of an index a Dataset has."""
from __future__ import annotations

import pathlib

import numpy as np
from numpy.typing import NDArray

from saccade.readers import FORMATS
from saccade.stored.index import Index
from saccade.v1 import dataset_pb2

PREFERRED = [".h5", *FORMATS]  # of a sequence with files of several formats; only .h5 is read in parts


def select(index: Index, plan: dataset_pb2.DataSetPlan, split: str | None, sensor: int,
           truth: list[str]) -> NDArray[np.int64]:
    """The numbers of the rows. Raises ValueError, which says what is valid."""
    splits = [item.name for item in plan.splits]
    _check("split", split, [None, *splits, *index.splits])
    _check("sensor", sensor, np.unique(index.rows["sensor"]).tolist())
    for name in truth:
        _check("truth", name, index.truth)
    suffixes = [pathlib.PurePath(name).suffix for name in index.files]
    ranks = np.array([PREFERRED.index(item) if item in PREFERRED else len(PREFERRED) for item in suffixes], np.int64)
    if (ranks == len(PREFERRED)).all():
        raise ValueError(f"the package reads {', '.join(FORMATS)}; the data set has {', '.join(index.files)}")
    wanted = index.rows["sensor"] == sensor
    if split is not None:
        wanted &= index.rows["split"] == (index.splits.index(split) if split in index.splits else len(splits))
    return _best_files(index, np.flatnonzero(wanted), ranks)


def _best_files(index: Index, rows: NDArray[np.int64], ranks: NDArray[np.int64]) -> NDArray[np.int64]:
    """One row for each sequence: that of the file whose rank is the lowest."""
    numbers, rank = index.rows["number"][rows], ranks[index.rows["file"][rows]]
    order = np.lexsort((rank, numbers))
    first = np.diff(numbers[order], prepend=-1) != 0
    readable = rank[order] < len(PREFERRED)
    return np.sort(rows[order[first & readable]])


def _check(name: str, value: object, valid: list[object] | list[str]) -> None:
    if value not in valid:
        known = ", ".join(dict.fromkeys(map(str, filter(lambda item: item is not None, valid))))
        raise ValueError(f"{name}: {value!r} is not one of {known}" if known else f"{name}: the data set has none")
