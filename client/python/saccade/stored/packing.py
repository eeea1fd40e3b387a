"""Unpacks a chunk of HDF5 that the filters shuffle and deflate have packed, faster than the library does."""
from __future__ import annotations

import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.errors import FormatError


def is_shuffled_and_deflated(properties: Any) -> bool:
    """properties: those that a data set was created with, of h5py."""
    import h5py
    filters = [properties.get_filter(i)[0] for i in range(properties.get_nfilters())]
    return filters == [h5py.h5z.FILTER_SHUFFLE, h5py.h5z.FILTER_DEFLATE]


def unpack(packed: bytes, chunk: int, out: NDArray[Any]) -> None:
    """Writes the first values of a chunk of so many into `out`, unsigned numbers in the byte order of this machine.

    The filter shuffle puts the lowest bytes of all values first, and the highest last. Raises FormatError, and zlib.error.
    """
    width = out.dtype.itemsize
    plain = zlib.decompress(packed, bufsize=chunk * width)
    if len(plain) != chunk * width:
        raise FormatError(f"a chunk has {len(plain)} bytes, not {chunk * width}")
    planes = np.frombuffer(plain, np.uint8).reshape(width, chunk)[:, : len(out)]
    out[:] = planes[-1]
    for plane in planes[-2::-1]:
        out <<= 8
        out |= plane
