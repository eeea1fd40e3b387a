"""A column of an .h5, unpacked chunk by chunk as it is needed."""
from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.errors import FormatError
from saccade.stored.packing import is_shuffled_and_deflated, unpack


class Column:
    """all: the whole column, of which fill() has read parts. view: the same, which cannot be written.

    Memory is taken for what is read. Raises KeyError where the column is not there, and FormatError for another length.
    """

    def __init__(self, file: Any, name: str, count: int) -> None:
        import h5py
        self._spaces, self._data, self._count = h5py.h5s, h5py.h5d.open(file, name.encode()), count
        if self._data.shape != (count,):
            raise FormatError(f"{name} has {self._data.shape} values, not {count}")
        layout = self._data.get_create_plist()
        chunked = layout.get_layout() == h5py.h5d.CHUNKED
        self._chunk = layout.get_chunk()[0] if chunked else max(count, 1)
        self.all: NDArray[Any] = np.empty(count, self._data.dtype)
        if self.all.dtype.kind != "u":
            raise FormatError(f"{name} is of {self.all.dtype}")
        self._packed = chunked and self.all.dtype.isnative and is_shuffled_and_deflated(layout)
        self.view = self.all[:]
        self.view.flags.writeable = False
        self._most = np.iinfo(self.all.dtype).max
        self._filled = bytearray(-(-count // self._chunk))

    @property
    def one_chunk(self) -> bool:
        return len(self._filled) <= 1

    @property
    def full(self) -> bool:
        return all(self._filled)

    def clipped(self, value: int) -> Any:
        """The value in the type of the column, so that a search needs no copy in another type."""
        return self.all.dtype.type(min(max(value, 0), self._most))

    def fill(self, first: int, last: int) -> Iterator[slice]:
        """Reads the chunks of these values, exclusive, that are not read yet, and gives their places."""
        for chunk in range(first // self._chunk, -(-last // self._chunk)):
            if not self._filled[chunk]:
                begin = chunk * self._chunk
                end = min(begin + self._chunk, self._count)
                self._read(begin, end)
                self._filled[chunk] = 1
                yield slice(begin, end)

    def _read(self, begin: int, end: int) -> None:
        if self._packed:
            skipped, packed = self._data.read_direct_chunk((begin,))
            if skipped == 0:  # no filter is left out of this chunk
                unpack(packed, self._chunk, self.all[begin:end])
                return
        place = self._data.get_space()
        place.select_hyperslab((begin,), (end - begin,))
        self._data.read(self._spaces.create_simple((end - begin,)), place, self.all[begin:end])


def read_number(file: Any, name: str) -> int:
    """Of a data set with a single number."""
    import h5py
    value = np.empty((), np.int64)
    h5py.h5d.open(file, name.encode()).read(h5py.h5s.ALL, h5py.h5s.ALL, value)
    return int(value)
