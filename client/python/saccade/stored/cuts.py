"""Where the windows of a recording begin and end."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from saccade.values import MOST_U32, check, positive, whole

US_PER_S = 1e6
EVENTS = whole(1, MOST_U32)


@dataclass(frozen=True)
class Cuts:
    """length, stride: in microseconds, or in events; a length of 0 is a whole recording."""

    length: int
    stride: int
    timed: bool = True

    @classmethod
    def of(cls, window_s: float | None, count: int | None, stride: float | None) -> Cuts:
        """Raises ValueError as saccade.Dataset."""
        if window_s is not None and count is not None:
            raise ValueError("give window_s or count, not both")
        if count is not None:
            step = count if stride is None else stride
            return cls(check("count", count, EVENTS), check("stride", step, EVENTS), False)
        if window_s is None:
            if stride is not None:
                raise ValueError("stride goes with window_s or count")
            return cls(0, 0)
        length = _microseconds("window_s", window_s)
        return cls(length, _microseconds("stride", stride) if stride is not None else length)

    def numbers(self, rows: NDArray[np.void]) -> NDArray[np.int64]:
        """How many windows each row of the index has."""
        if self.length == 0:
            return np.ones(len(rows), np.int64)
        room = (rows["end_us"] - rows["begin_us"] if self.timed else rows["events"]) - self.length
        return np.where(room >= 0, room // self.stride + 1, 0)


def _microseconds(name: str, seconds: float) -> int:
    found: int = round(check(name, seconds, positive) * US_PER_S)
    if found < 1:
        raise ValueError(f"{name}: {seconds} is less than a microsecond")
    return found
