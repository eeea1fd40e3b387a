"""The events of a file on the clock of the recording that FILE.json describes."""
from __future__ import annotations

import pathlib
from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from saccade.camera import Camera, cameras_of
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
    camera = _camera(path, about)
    held, t0 = replace(events_of(NONE, NONE, NONE, NONE, size), sensor=about.sensor), begin
    for events in chunks:
        if events.t[0] < begin or events.t[-1] >= end:
            raise FormatError(f"{path}: the events are not those that {path}.json describes; remove that file if it is "
                              "of another recording")
        if len(held):
            yield replace(held, interval=(t0, held.t1), camera=camera)
            t0 = int(events.t[0])  # the chunk before may have events of the same time
        held = events
    yield replace(held, interval=(t0, end), camera=camera)


def _camera(path: pathlib.Path, about: recording_pb2.Recording) -> Camera | None:
    """That of its sensor; None where the request is not known."""
    if about.sensor >= len(about.request.sensors):
        return None
    view: int = about.request.sensors[about.sensor].view
    try:
        return cameras_of(about.request)[view]
    except (ValueError, IndexError) as fault:
        raise FormatError(f"{path}.json: its camera cannot be: {fault}") from fault
