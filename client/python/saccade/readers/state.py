"""State that words of a RAW file set for the words after them, as columns."""
from __future__ import annotations

import warnings

import numpy as np
from numpy.typing import NDArray

UNKNOWN = -1


def tell_unknown(words: int) -> None:
    if words > 0:
        warnings.warn(f"{words} words of events are left out: they come before the first words of time and place",
                      stacklevel=2)


class Latched:
    """A value that holds from the word that sets it until the next one, over the borders of blocks too."""

    def __init__(self) -> None:
        self._value = UNKNOWN

    def spread(self, sets: NDArray[np.bool_], values: NDArray[np.int64]) -> NDArray[np.int64]:
        """The value at each word. `sets` marks the words that set one, and `values` are theirs."""
        known = np.concatenate([[self._value], values])
        self._value = int(known[-1])
        return known[np.cumsum(sets)]


class Wraps:
    """Continues a counter of so many bits beyond its wraps."""

    def __init__(self, bits: int) -> None:
        self._period, self._before, self._epoch = 1 << bits, 0, 0

    def unwrap(self, counts: NDArray[np.int64]) -> NDArray[np.int64]:
        if counts.size == 0:
            return counts
        steps = np.diff(counts, prepend=self._before)
        epochs = self._epoch + np.cumsum(steps < -self._period // 2)
        self._before, self._epoch = int(counts[-1]), int(epochs[-1])
        return counts + epochs * self._period
