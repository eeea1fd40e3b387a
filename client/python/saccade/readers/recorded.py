"""The events of a file on the clock of the recording that FILE.json describes."""
from __future__ import annotations

import pathlib
from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from saccade.errors import FormatError
from saccade.events import Events
from saccade.protocol.columns import NS_PER_US
from saccade.readers.columns import events_of
from saccade.v1 import recording_pb2

NONE = np.empty(0)


def within_recording(path: pathlib.Path, chunks: Iterable[Events], about: recording_pb2.Recording,
                     size: tuple[int, int] | None) -> Iterator[Events]:
    """The chunks without gaps from the begin of the recording to its end; one without events if there are none."""
    begin, end = about.begin_ns // NS_PER_US, -(-about.end_ns // NS_PER_US)
    held, t0 = events_of(NONE, NONE, NONE, NONE, size), begin
    for events in chunks:
        if events.t[0] < begin or events.t[-1] >= end:
            raise FormatError(f"{path}: the events are not those that {path}.json describes; remove that file if it is "
                              "of another recording")
        if len(held):
            yield replace(held, interval=(t0, held.t1))
            t0 = int(events.t[0])  # the chunk before may have events of the same time
        held = events
    yield replace(held, interval=(t0, end))
