"""A sequence whose files are open."""
from __future__ import annotations

import json
import pathlib
from dataclasses import dataclass, replace
from typing import Protocol, Union

from saccade.errors import FormatError
from saccade.events import Events
from saccade.recording import Recording
from saccade.stored.hdf5 import Hdf5Events, Hdf5Truth
from saccade.stored.index import BAD_LINE
from saccade.stored.layout import damaged
from saccade.stored.sequence import Sequence
from saccade.truth import TruthArrays


class Source(Protocol):
    """The events of a sensor."""

    def between(self, t0: int, t1: int) -> Events:
        """Those of [t0, t1)."""

    def numbered(self, first: int, last: int) -> Events:
        """From event `first` to `last`, exclusive. They cover the time from the first to the last of them."""


class WholeEvents:
    """The events of a sensor in memory."""

    def __init__(self, events: Events) -> None:
        self._all = events

    def between(self, t0: int, t1: int) -> Events:
        return self._all.slice(t0, t1)

    def numbered(self, first: int, last: int) -> Events:
        return replace(self._all[first:last], interval=None)


class WholeTruth:
    """A channel of truth in memory."""

    def __init__(self, arrays: TruthArrays) -> None:
        self._all = arrays

    def within(self, t0: int, t1: int) -> TruthArrays:
        """The samples of the closed interval."""
        found = self._all
        part = slice(found.t.searchsorted(t0), found.t.searchsorted(t1, "right"))
        exposure = found.exposure[part] if found.exposure is not None else None
        return TruthArrays(found.t[part], found.data[part], exposure, found.planes, found.unit, found.description)


@dataclass(frozen=True)
class Opened:
    """interval: of the recording, microseconds."""

    sequence: Sequence
    source: Source
    truth: dict[str, Union[Hdf5Truth, WholeTruth]]
    interval: tuple[int, int]


def open_events(root: pathlib.Path, path: pathlib.Path, group: str, size: tuple[int, int], sensor: int, count: int,
                names: list[str]) -> tuple[Source, dict[str, Union[Hdf5Truth, WholeTruth]]]:
    """The events of a sensor, and the channels of its camera. count: of its events. group: in an .h5.

    Raises KeyError for a channel that is not there, and what the readers raise.
    """
    if path.suffix != ".h5":
        return _of_other(path, sensor, names)
    events = Hdf5Events(path, group, size, sensor, count)
    view = _group_of_view(root, path, sensor) if names else ""
    return events, {name: events.truth(view, name) for name in names}


def _group_of_view(root: pathlib.Path, path: pathlib.Path, sensor: int) -> str:
    """That of the truth of a sensor's camera. It reads FILE.json without the checks of find_files(), which take longer."""
    about = path.with_name(path.name + (f".sensor{sensor}.json" if sensor else ".json"))
    if not about.exists():
        return ""
    try:
        sensors = json.loads(about.read_text(encoding="utf-8")).get("request", {}).get("sensors", [])
        view = int(sensors[sensor].get("view", 0)) if sensor < len(sensors) else 0
    except BAD_LINE as fault:
        raise damaged(root, about, fault) from fault
    return f"view_{view}/" if view else ""


def _of_other(path: pathlib.Path, sensor: int, names: list[str]
              ) -> tuple[Source, dict[str, Union[Hdf5Truth, WholeTruth]]]:
    recording = Recording(path)
    channels = recording.truth[recording.view_of(sensor)] if names else {}
    if missing := [name for name in names if name not in channels]:
        raise FormatError(f"of its truth '{missing[0]}' cannot be read; .h5 and .npz hold all channels")
    return WholeEvents(recording.events[sensor]), {name: WholeTruth(channels[name]) for name in names}
