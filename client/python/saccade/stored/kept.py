"""The sequences that stay open: as many as fit into a budget of memory."""
from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

from numpy.typing import NDArray

import numpy as np

from saccade.stored.opened import Opened

MOST_BYTES, MOST_FILES = 256 << 20, 128  # of a process
BYTES_PER_EVENT = 9


def shares(events: NDArray[np.int64]) -> NDArray[np.float64]:
    """The share of the budget that a recording takes, by the number of its events."""
    return np.maximum(events * (BYTES_PER_EVENT / MOST_BYTES), 1 / MOST_FILES)


class Kept:
    """Closes the sequence that was not used for the longest time. A process that was forked opens its own files.

    It pickles as an empty one.
    """

    def __init__(self) -> None:
        self._open: dict[int, tuple[float, Opened]] = {}  # by row; the last one used is at the end
        self._share, self._process = 0.0, os.getpid()

    def get(self, row: int, share: float, make: Callable[[], Opened]) -> Opened:
        if self._process != os.getpid():
            self.__init__()  # type: ignore[misc]
        found = self._open.pop(row, None)
        if found is None:
            while self._open and self._share + share > 1:
                oldest = next(iter(self._open))
                self._share -= self._open.pop(oldest)[0]
            found = share, make()
            self._share += share
        self._open[row] = found
        return found[1]

    def __reduce__(self) -> tuple[Any, ...]:
        return Kept, ()
