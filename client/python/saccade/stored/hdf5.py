"""Windows of an .h5 as `saccade record` writes it. readers/dsec.py says what is in it.

It calls the lower half of h5py. The upper half takes as long to open a data set as a window of 1,000 events does.
"""
from __future__ import annotations

import functools
import os
import pathlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.errors import FormatError
from saccade.events import FACTS, Events
from saccade.stored.hdf5_column import Column, read_number
from saccade.truth import TruthArrays

US_PER_MS = 1000


@functools.lru_cache(maxsize=None)
def _access() -> Any:
    """How files are opened: without a cache, because columns keep what is unpacked."""
    import h5py
    access = h5py.h5p.create(h5py.h5p.FILE_ACCESS)
    access.set_cache(0, 521, 0, 0.75)
    return access


class Hdf5Events:
    """The events of a sensor. group: of the sensor, empty or such as "sensor_1/".

    The file is closed with the last reference to it. Raises KeyError, ValueError or OSError for a damaged file, and
    ImportError without h5py.
    """

    def __init__(self, path: pathlib.Path, group: str, size: tuple[int, int], sensor: int, count: int) -> None:
        import h5py
        self._file = h5py.h5f.open(os.fsencode(path), h5py.h5f.ACC_RDONLY, _access())
        self._group, self._size, self._sensor, self._count = group, size, sensor, count
        self._t, self._x, self._y, self._p = (self._column(name) for name in "txyp")
        self._facts = {name: self._column(name) for name in FACTS if f"{group}events/{name}".encode() in self._file}
        self._offset = read_number(self._file, f"{group}t_offset")
        self._index: NDArray[np.uint64] | None = None
        self._full = False

    def between(self, t0: int, t1: int) -> Events:
        """Those of [t0, t1)."""
        begin, end = t0 - self._offset, t1 - self._offset
        first, last = (0, self._count) if self._t.one_chunk else self._near(begin, end)
        self._fill(first, last)
        t = self._t.all[first:last]
        one, two = (int(t.searchsorted(self._t.clipped(time))) for time in (begin, end))
        return self._events(first + one, first + two, (t0, t1))

    def numbered(self, first: int, last: int) -> Events:
        """From event `first` to `last`, exclusive. They cover the time from the first to the last of them."""
        self._fill(first, last)
        return self._events(first, last, None)

    def truth(self, group: str, name: str) -> Hdf5Truth:
        """group: of the view, empty or such as "view_1/"."""
        import h5py
        return Hdf5Truth(h5py.File(self._file)[f"{group}truth/{name}"])

    def _column(self, name: str) -> Column:
        return Column(self._file, f"{self._group}events/{name}", self._count)

    def _events(self, first: int, last: int, interval: tuple[int, int] | None) -> Events:
        t = self._t.all[first:last].astype(np.int64)
        if self._offset:
            t += self._offset
        facts: dict[str, Any] = {name: column.view[first:last] for name, column in self._facts.items()}
        return Events(t, self._x.view[first:last], self._y.view[first:last], self._p.view[first:last].view(np.bool_),
                      self._size, interval, self._sensor, **facts)

    def _near(self, begin: int, end: int) -> tuple[int, int]:
        """Events that hold those of the interval, and at most a millisecond more on both sides."""
        if self._index is None:
            import h5py
            self._index = h5py.File(self._file)[f"{self._group}ms_to_idx"][:]
        most, after = len(self._index) - 1, -(-end // US_PER_MS)
        first = int(self._index[min(max(begin // US_PER_MS, 0), most)])
        return first, int(self._index[after]) if after <= most else self._count

    def _fill(self, first: int, last: int) -> None:
        if self._full:
            return
        for part in self._t.fill(first, last):
            t = self._t.all[part]
            if (t[1:] < t[:-1]).any():
                raise FormatError("times run backwards")
        for column, most, what in ((self._x, self._size[0], "pixel"), (self._y, self._size[1], "pixel"),
                                   (self._p, 2, "polarity")):
            if any(column.all[part].max() >= most for part in column.fill(first, last)):
                raise FormatError(f"a {what} is {most} or more")
        for column in self._facts.values():
            list(column.fill(first, last))
        self._full = self._t.full


class Hdf5Truth:
    """A channel of truth."""

    def __init__(self, group: Any) -> None:
        self._data, self._times = group["data"], group["t"][:]
        self._exposure = None
        if "exposure_begin" in group:
            self._exposure = np.stack([group["exposure_begin"][:], group["exposure_end"][:]], axis=1)
        self._about = (tuple(map(str, group.attrs.get("planes", ()))), str(group.attrs.get("unit", "")),
                       str(group.attrs.get("description", "")))
        if len(self._times) != len(self._data):
            raise FormatError(f"{group.name} has {len(self._data)} samples, but {len(self._times)} times")

    def within(self, t0: int, t1: int) -> TruthArrays:
        """The samples of the closed interval."""
        first, last = self._times.searchsorted(t0), self._times.searchsorted(t1, "right")
        exposure = self._exposure[first:last] if self._exposure is not None else None
        return TruthArrays(self._times[first:last], self._data[first:last], exposure, *self._about)
