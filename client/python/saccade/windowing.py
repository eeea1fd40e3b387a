"""Cuts a sequence of Events into windows of fixed duration, or of a fixed number of events."""
from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from typing import Protocol

from saccade.events import Events, concatenate
from saccade.values import MOST_U64, check, whole


def windows(parts: Iterable[Events], *, duration_us: int | None = None, count: int | None = None) -> Iterator[Events]:
    """Cuts a stream, the chunks of a file or a list of Events into windows, for each sensor by itself.

    duration_us: windows [t, t + duration_us), one after the other from the start of each sensor on. A window comes as
    soon as its interval is complete, also if it has no events. The last one may be shorter.
    count: windows of so many events. The last one may have fewer.
    Raises ValueError unless exactly one of the two is given, a positive whole number.
    """
    if (duration_us is None) == (count is None):
        raise ValueError("give either duration_us or count")
    if duration_us is not None:
        return _cut(parts, _OfDuration(check("duration_us", duration_us, whole(1, MOST_U64))))
    return _cut(parts, _OfCount(check("count", count, whole(1, MOST_U64))))


@dataclass
class _Held:
    """The parts of one sensor since its last window."""

    parts: list[Events] = field(default_factory=list)
    count: int = 0  # of their events

    def add(self, part: Events) -> None:
        self.parts.append(part)
        self.count += len(part)


class _Cutter(Protocol):
    def reached(self, held: _Held) -> bool:
        """Whether a window is complete."""

    def split(self, events: Events) -> tuple[Events, Events]:
        """The window, and the rest."""


class _OfDuration:
    def __init__(self, duration_us: int) -> None:
        self.duration_us = duration_us

    def reached(self, held: _Held) -> bool:
        return held.parts[-1].t1 - held.parts[0].t0 >= self.duration_us

    def split(self, events: Events) -> tuple[Events, Events]:
        middle = events.t0 + self.duration_us
        return events.slice(events.t0, middle), events.slice(middle, events.t1)


class _OfCount:
    def __init__(self, count: int) -> None:
        self.count = count

    def reached(self, held: _Held) -> bool:
        return held.count >= self.count

    def split(self, events: Events) -> tuple[Events, Events]:
        first, rest = events[: self.count], events[self.count :]
        middle = int(first.t[-1]) + 1
        after = int(rest.t[0]) if len(rest) else middle  # another event of the same microsecond may follow
        return replace(first, interval=(events.t0, middle)), replace(rest, interval=(after, events.t1))


def _cut(parts: Iterable[Events], cutter: _Cutter) -> Iterator[Events]:
    held: dict[int, _Held] = {}  # by sensor
    for part in parts:
        mine = held.setdefault(part.sensor, _Held())
        mine.add(part)
        while cutter.reached(mine):
            window, rest = cutter.split(concatenate(mine.parts))
            mine.parts, mine.count = [rest], len(rest)
            yield window
    for mine in held.values():
        rest = concatenate(mine.parts)
        if rest.t1 > rest.t0:
            yield rest
