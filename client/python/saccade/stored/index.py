"""What is in a data set, as one array: a row for each sensor of each sequence."""
from __future__ import annotations

import json
import pathlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.protocol.columns import NS_PER_US
from saccade.stored.layout import damaged, index_of

ROW = np.dtype([
    ("begin_us", "<i8"), ("end_us", "<i8"), ("events", "<i8"),
    ("number", "<i8"),  # of the sequence
    ("line", "<i8"),    # position of its line in the index.jsonl of the shard, in bytes
    ("shard", "<u4"), ("width", "<u2"), ("height", "<u2"), ("sensor", "<u2"),
    ("split", "<u2"), ("file", "<u2"),  # numbers in `splits` and `files`
])
MOST_U16, MOST_I64 = (1 << 16) - 1, (1 << 63) - 1
TOGETHER = 10_000  # rows that are tuples at a time; an array needs a fifth of the memory
BAD_LINE = (ValueError, KeyError, TypeError, AttributeError, OverflowError)  # of JSON that holds something else


@dataclass(frozen=True)
class Index:
    """rows: of ROW, by shard and number. It may be a file in memory, which processes share.

    truth: names of the channels. joint: names of the files that hold several sensors.
    """

    rows: NDArray[np.void]
    splits: list[str]
    files: list[str]
    truth: list[str]
    joint: list[str]


class Names:
    """Numbers names in the order in which they come."""

    def __init__(self) -> None:
        self._numbers: dict[str, int] = {}

    def number(self, name: Any) -> int:
        found = self._numbers.get(name)
        if found is None:
            if not isinstance(name, str) or not name or "/" in name:
                raise ValueError(f"{name!r} is not the name of a file, a split or a channel")
            found = self._numbers[name] = len(self._numbers)
        return found

    def all(self) -> list[str]:
        return list(self._numbers)


def build_index(root: pathlib.Path, shards: list[int]) -> Index:
    """Reads the lists of the shards. Raises FormatError for a line that cannot be, and OSError."""
    names = Names(), Names(), Names()
    table = np.concatenate([np.empty(0, ROW), *(part for shard in shards for part in _of_shard(root, shard, *names))])
    splits, files, truth = (each.all() for each in names)
    sensors = np.unique(table[["sensor", "file"]])["file"].tolist()
    return Index(table, splits, files, truth, [name for code, name in enumerate(files) if sensors.count(code) > 1])


def _of_shard(root: pathlib.Path, shard: int, splits: Names, files: Names, truth: Names
              ) -> Iterator[NDArray[np.void]]:
    path, line = index_of(root, shard), 0
    rows: list[tuple[int, ...]] = []
    with path.open("rb") as file:
        for number, text in enumerate(file, 1):
            try:
                rows += _rows_of(json.loads(text), shard, line, splits, files, truth)
            except BAD_LINE as fault:
                raise damaged(root, path, f"line {number} is no sequence of shard {shard}: {fault!r}") from fault
            line += len(text)
            if len(rows) >= TOGETHER:
                yield np.array(rows, ROW)
                rows = []
    yield np.array(rows, ROW)


def _rows_of(about: dict[str, Any], shard: int, line: int, splits: Names, files: Names,
             truth: Names) -> Iterator[tuple[int, ...]]:
    """Those of a sequence, whose JSON is that of DataSetSequence: numbers of 64 bits are texts, and 0 may lack."""
    if int(about.get("shard", 0)) != shard:
        raise ValueError(f"its shard is {about.get('shard', 0)}")
    split, number = splits.number(about["split"]), int(about.get("number", 0))
    for recording in about["recordings"]:
        for name in recording.get("truth", ()):
            truth.number(name)
        width, height, sensor = int(recording["width"]), int(recording["height"]), int(recording.get("sensor", 0))
        times = int(recording.get("begin_ns", 0)), int(recording["end_ns"])
        events = int(recording.get("events", 0))
        if not (0 < width <= MOST_U16 and 0 < height <= MOST_U16 and 0 <= sensor <= MOST_U16 and 0 <= events <= MOST_I64
                and 0 <= number <= MOST_I64 and -MOST_I64 <= times[0] <= times[1] <= MOST_I64):
            raise ValueError(f"numbers that cannot be in {recording}")
        yield (times[0] // NS_PER_US, -(-times[1] // NS_PER_US), events, number, line, shard, width, height, sensor,
               split, files.number(recording["file"]))
