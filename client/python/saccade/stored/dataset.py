"""The windows of a data set."""
from __future__ import annotations

import os
import pathlib
from collections.abc import Callable, Iterator, Sequence as Several
from dataclasses import dataclass
from typing import Any

import numpy as np

from saccade.events import Events
from saccade.stored.cuts import Cuts
from saccade.stored.index_cache import load_index
from saccade.stored.kept import Kept, shares
from saccade.stored.layout import finished_shards, naming, read_plan
from saccade.stored.opened import Opened, open_events
from saccade.stored.order import Order
from saccade.stored.selection import select
from saccade.stored.sequence import Sequence, read_sequence
from saccade.truth import TruthArrays
from saccade.v1 import dataset_pb2

LOADED = ("_index", "_rows", "_before", "_share", "_kept")  # the members that a copy in another process makes anew


@dataclass(frozen=True, eq=False, repr=False)
class Window:
    """A window of a sequence.

    events: its events; read-only. truth: by name, the samples with events.t0 <= t <= events.t1: the last one is the
    newest. sequence: what was drawn for its sequence. place: its place among the windows of the sequence.
    """

    events: Events
    truth: dict[str, TruthArrays]
    sequence: Sequence
    place: int

    def __repr__(self) -> str:
        return f"Window({self.events}, truth of {list(self.truth)}, {self.place} of sequence {self.sequence.number})"


class Dataset:
    """The windows of a data set that saccade-farm has made: data[i], len(data), and iteration in the order of the plan.

    path: its folder, which is only read. split: such as "train"; by default all. sensor: its number.
    window_s: windows of so many seconds, of which the first begins with the recording; count: windows of so many
        events. Without both a window is a whole recording.
    stride: from the begin of a window to that of the next, in seconds or events; by default windows follow each other.
        The end of a recording that fills no window is left out.
    truth: names of the truth channels of the sensor's camera to read.
    transform: makes an item of a Window; by default the item is the Window. Workers of torch pickle it.
    partial: reads the finished shards of a data set that is not finished.
    cache: folder for the index of a large data set; by default `saccade` in the user's folder of caches.

    An object belongs to a thread. It may be pickled; forked processes share its index, and open files of their own.
    Raises ValueError for arguments that cannot be, FormatError for files that are missing or damaged, here or when they
    are needed, ImportError without h5py, and OSError.
    """

    def __init__(self, path: str | os.PathLike[str], *, split: str | None = None, sensor: int = 0,
                 window_s: float | None = None, count: int | None = None, stride: float | None = None,
                 truth: Several[str] = (), transform: Callable[[Window], Any] | None = None, partial: bool = False,
                 cache: str | os.PathLike[str] | None = None) -> None:
        self._cuts = Cuts.of(window_s, count, stride)
        self._root = pathlib.Path(path)
        self._plan = read_plan(self._root)
        self._shards = finished_shards(self._root, self._plan, partial)
        self._cache = pathlib.Path(cache) if cache is not None else None
        self._split, self._sensor, self._truth, self._transform = split, sensor, list(truth), transform
        self._load()

    def _load(self) -> None:
        self._index = load_index(self._root, self._shards, self._cache)
        self._rows = select(self._index, self._plan, self._split, self._sensor, self._truth)
        chosen = self._index.rows[self._rows]
        self._before = np.concatenate([[0], np.cumsum(self._cuts.numbers(chosen))])
        self._share = shares(chosen["events"])
        self._kept = Kept()

    @property
    def plan(self) -> dataset_pb2.DataSetPlan:
        """What plan.json says."""
        return self._plan

    def __len__(self) -> int:
        return int(self._before[-1])

    def __iter__(self) -> Iterator[Any]:
        return map(self.__getitem__, range(len(self)))

    def __getitem__(self, number: int) -> Any:
        """Window `number`, from 0 on; below 0 it counts from the end. Raises IndexError."""
        if not -len(self) <= number < len(self):
            raise IndexError(f"there is no window {number}; there are {len(self)}")
        number = int(number) % len(self)
        row = int(self._before.searchsorted(number, "right")) - 1
        opened = self._kept.get(row, float(self._share[row]), lambda: self._open(row))
        with naming(self._root, opened.sequence.path):
            window = self._cut(opened, number - int(self._before[row]))
        return window if self._transform is None else self._transform(window)

    def order(self, *, seed: int = 0, shuffle: bool = True, rank: int = 0, world: int = 1) -> Order:
        """Numbers of windows, shuffled by shard. rank: of this process, of `world` ones that train together.

        Within a shard it mixes as many sequences as 256 MiB hold, and at most 128. So a pass opens each file once.
        """
        shards = self._index.rows["shard"][self._rows]
        first = np.flatnonzero(np.diff(shards, prepend=-1, append=-1))
        return Order(first, self._before, self._share, seed=seed, shuffle=shuffle, rank=rank, world=world)

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name not in LOADED}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._load()

    def _open(self, row: int) -> Opened:
        about = self._index.rows[self._rows[row]]
        file, sensor = self._index.files[about["file"]], int(about["sensor"])
        sequence = read_sequence(self._root, int(about["shard"]), int(about["line"]), int(about["number"]), file)
        group = f"sensor_{sensor}/" if sensor and file in self._index.joint else ""
        size = int(about["width"]), int(about["height"])
        with naming(self._root, sequence.path):
            source, truth = open_events(self._root, sequence.path, group, size, sensor, int(about["events"]), self._truth)
        return Opened(sequence, source, truth, (int(about["begin_us"]), int(about["end_us"])))

    def _cut(self, opened: Opened, place: int) -> Window:
        cuts, (begin, end) = self._cuts, opened.interval
        first = place * cuts.stride
        if not cuts.timed:
            events = opened.source.numbered(first, first + cuts.length)
        elif cuts.length:
            events = opened.source.between(begin + first, begin + first + cuts.length)
        else:
            events = opened.source.between(begin, end)
        truth = {name: channel.within(events.t0, events.t1) for name, channel in opened.truth.items()}
        return Window(events, truth, opened.sequence, place)
