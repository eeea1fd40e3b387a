"""Makes Events from the columns of a file, whatever their types."""
from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.errors import FormatError
from saccade.events import FACTS, LABELS, Events

# t in microseconds, x, y, p
Columns = tuple[NDArray[np.int64], NDArray[np.uint16], NDArray[np.uint16], NDArray[np.bool_]]
MOST_PIXELS = 1 << 16  # along an axis


def fact_names(names: Collection[str]) -> list[str]:
    """The columns of facts among those of a file. Labels count where both are there."""
    labels = LABELS if set(LABELS) <= set(names) else ()
    return [*labels, *(["object"] if "object" in names else [])]


def events_of(t: NDArray[Any], x: NDArray[Any], y: NDArray[Any], p: NDArray[Any],
              size: tuple[int, int] | None, facts: Mapping[str, NDArray[Any]] | None = None) -> Events:
    """t in microseconds; polarities above 0 are ON, so that 0 and 1 serve as well as -1 and 1.

    Raises FormatError for coordinates that are no pixels and other polarities, and ValueError for unequal lengths.
    """
    for name, column in (("x", x), ("y", y)):
        if column.size and not 0 <= column.min() <= column.max() < MOST_PIXELS:
            raise FormatError(f"{name} lies outside 0 to {MOST_PIXELS - 1}")
    if p.size and not np.isin(p, (-1, 0, 1)).all():
        raise FormatError("a polarity is not 0 and 1, or -1 and 1")
    events = Events(t.astype(np.int64, copy=False), x.astype(np.uint16, copy=False), y.astype(np.uint16, copy=False),
                    p > 0, size)
    known: dict[str, Any] = {name: column.astype(FACTS[name], copy=False) for name, column in (facts or {}).items()}
    return replace(events, **known)
