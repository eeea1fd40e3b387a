"""The order in which windows are drawn: shuffled by shard, divided among processes, resumed anywhere."""
from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.stored.mixing import mix
from saccade.values import MOST_U32, check, whole

TOGETHER = 10_000  # numbers that are Python's at a time; an array needs a quarter of the memory


class Order:
    """Numbers of windows of a Dataset, see Dataset.order(). torch takes it as the sampler of a DataLoader.

    Each pass gives the same ones for the same seed and epoch: set_epoch() before the next pass. The windows of all
    `world` ranks differ, and each has as many; up to world - 1 windows are left out of an epoch.
    """

    def __init__(self, shards: NDArray[np.int64], before: NDArray[np.int64], share: NDArray[np.float64], *,
                 seed: int, shuffle: bool, rank: int, world: int) -> None:
        """shards: the first row of each, and the number of all. before: the windows before each row, and of all."""
        self._shards, self._before, self._share = shards, before, share
        check("rank", rank, whole(0, check("world", world, whole(1, MOST_U32)) - 1))
        self._seed, self._shuffle = check("seed", seed, whole(0, MOST_U32)), shuffle
        total = int(before[-1]) // world
        self._begin, self._end = rank * total, (rank + 1) * total  # in the order of all ranks
        self._epoch = self._given = self._skipped = 0

    def __len__(self) -> int:
        """The windows of a pass."""
        return self._end - self._begin

    def set_epoch(self, epoch: int) -> None:
        """The next pass is that of another epoch."""
        self._epoch = check("epoch", epoch, whole(0, MOST_U32))

    def __iter__(self) -> Iterator[int]:
        self._given, self._skipped = self._skipped, 0
        for numbers in self._blocks(self._begin + self._given):
            for first in range(0, len(numbers), TOGETHER):
                for number in numbers[first : first + TOGETHER].tolist():
                    self._given += 1
                    yield number

    def part(self, number: int, count: int) -> Order:
        """The part of this order that process `number` of `count` takes, all of which share its windows."""
        part = object.__new__(Order)
        part.__dict__.update(self.__dict__)
        cut = [self._begin + len(self) * i // count for i in (number, number + 1)]
        part._begin, part._end, part._given, part._skipped = cut[0], cut[1], 0, 0
        return part

    def state_dict(self, given: int | None = None) -> dict[str, Any]:
        """What load_state_dict() takes to go on behind this place.

        given: windows that the training has had of this pass; by default those that this object has given. Behind a
            DataLoader say it: its workers are ahead of the training.
        """
        return {"seed": self._seed, "epoch": self._epoch, "given": self._given if given is None else given,
                "of": [self._begin, self._end, int(self._before[-1])], "shuffle": self._shuffle}

    def load_state_dict(self, state: dict[str, Any]) -> None:
        """The next pass goes on where that of the state was. Raises ValueError for that of another order."""
        own = self.state_dict()
        if any(state.get(name) != own[name] for name in ("of", "shuffle")):
            raise ValueError(f"the state is of another data set, other windows or another rank: {state}")
        self._seed, self._epoch = check("seed", state.get("seed"), whole(0, MOST_U32)), int(state["epoch"])
        self._skipped = self._given = check("given", state.get("given"), whole(0, len(self)))

    def _blocks(self, begin: int) -> Iterator[NDArray[np.int64]]:
        """The windows from a place in the order of all ranks on, shard by shard."""
        count = len(self._shards) - 1
        rng = np.random.default_rng([self._seed, self._epoch])
        shards = rng.permutation(count) if self._shuffle else np.arange(count)
        place = 0
        for shard in shards.tolist():
            rows = slice(self._shards[shard], self._shards[shard + 1])
            size = int(self._before[rows.stop] - self._before[rows.start])
            if begin < place + size and place < self._end:
                numbers = self._of_shard(shard, rows)
                yield numbers[max(begin - place, 0) : self._end - place]
            place += size

    def _of_shard(self, shard: int, rows: slice) -> NDArray[np.int64]:
        before = self._before[rows.start : rows.stop + 1]
        if not self._shuffle:
            return np.arange(before[0], before[-1])
        return mix(np.random.default_rng([self._seed, self._epoch, 1 + shard]), before, self._share[rows])
