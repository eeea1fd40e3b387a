"""Shuffles the windows of a shard so that few sequences are open at a time."""
from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def mix(rng: np.random.Generator, before: NDArray[np.int64],
        share: NDArray[np.float64]) -> NDArray[np.int64]:
    """Puts sequences together at random, as many as fit into memory, and shuffles the windows of each group.

    before: number of the first window of each sequence, and the end of the last one. share: of the memory that each
    takes. So each file is opened and unpacked once.
    """
    order = rng.permutation(len(share))
    filled = np.cumsum(share[order])
    group = (filled - share[order]).astype(np.int64)  # the groups end where 1, 2, ... are reached
    counts = np.diff(before)[order]
    first = np.cumsum(counts) - counts
    numbers = np.arange(counts.sum()) + np.repeat(before[:-1][order] - first, counts)
    mixed: NDArray[np.int64] = numbers[np.lexsort((rng.random(len(numbers)), np.repeat(group, counts)))]
    return mixed
