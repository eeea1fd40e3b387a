"""Reads the layouts of payloads as numpy arrays."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.errors import PacketFault
from saccade.events import Events
from saccade.v1 import events_pb2

BYTES_PER_EVENT = {events_pb2.LAYOUT_COLUMNS: 9, events_pb2.LAYOUT_LABELLED_COLUMNS: 11,
                   events_pb2.LAYOUT_OBJECT_COLUMNS: 13, events_pb2.LAYOUT_LABELLED_OBJECT_COLUMNS: 15}
LABELLED = (events_pb2.LAYOUT_LABELLED_COLUMNS, events_pb2.LAYOUT_LABELLED_OBJECT_COLUMNS)
WITH_OBJECTS = (events_pb2.LAYOUT_OBJECT_COLUMNS, events_pb2.LAYOUT_LABELLED_OBJECT_COLUMNS)
BYTES_PER_PIXEL = 8  # of a snapshot
NS_PER_US = 1000


@dataclass(frozen=True)
class Snapshot:
    """The pixels of a sensor at the microsecond t, where its events begin.

    brightness, reference: float32 (height, width), natural log units. The next ON event comes when the brightness
    reaches reference + C.
    """

    t: int
    brightness: NDArray[np.float32]
    reference: NDArray[np.float32]


def read_columns(header: events_pb2.PacketHeader, payload: bytes) -> Events:
    """The events of a payload of BYTES_PER_EVENT. All but t are views of it. Raises PacketFault for a bad event."""
    n = header.count
    dt = np.frombuffer(payload, "<u4", n)
    x = np.frombuffer(payload, "<u2", n, offset=4 * n)
    y = np.frombuffer(payload, "<u2", n, offset=6 * n)
    p = np.frombuffer(payload, "u1", n, offset=8 * n)
    length = header.t1_ns - header.t0_ns
    if header.t0_ns < 0 or length < 0:
        raise PacketFault("an interval that runs backwards")
    if n > 0:
        _check_events(header, length, dt, x, y, p)
    t = (header.t0_ns + dt.astype(np.int64) * header.dt_unit_ns) // NS_PER_US
    interval = header.t0_ns // NS_PER_US, header.t1_ns // NS_PER_US
    facts = _read_labels(n, payload) if header.layout in LABELLED else {}
    if header.layout in WITH_OBJECTS:
        facts["object"] = np.frombuffer(payload, "<u4", n, offset=(11 if header.layout in LABELLED else 9) * n)
    return Events(t, x, y, p.view(np.bool_), (header.width, header.height), interval, header.sensor, **facts)


def _read_labels(n: int, payload: bytes) -> dict[str, Any]:
    source = np.frombuffer(payload, "u1", n, offset=9 * n)
    if n > 0 and source.max() > max(events_pb2.EventSource.values()):
        raise PacketFault("a source that is unknown")
    return {"source": source, "artefact": np.frombuffer(payload, "u1", n, offset=10 * n)}


def _check_events(header: events_pb2.PacketHeader, length_ns: int, dt: NDArray[np.uint32], x: NDArray[np.uint16],
                  y: NDArray[np.uint16], p: NDArray[np.uint8]) -> None:
    if (dt[1:] < dt[:-1]).any():
        raise PacketFault("times that run backwards")
    last_ns = int(dt[-1]) * header.dt_unit_ns
    if last_ns >= length_ns and last_ns > 0:  # with an empty interval, all events are at its begin
        raise PacketFault("a time outside the packet's interval")
    if x.max() >= header.width or y.max() >= header.height:
        raise PacketFault("a pixel outside the view")
    if p.max() > 1:
        raise PacketFault("a polarity that is neither 0 nor 1")


def read_planes(header: events_pb2.PacketHeader, payload: bytes) -> Snapshot:
    planes = np.frombuffer(payload, "<f4").reshape(2, header.height, header.width)
    return Snapshot(header.t0_ns // NS_PER_US, planes[0], planes[1])
