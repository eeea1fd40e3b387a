"""Checks that the packets of a stream are complete and in order, and finds where a sensor resumes after a break.

Truth channels count as sensors here, and their samples as events, but for losses.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from saccade.errors import StreamFault
from saccade.v1 import control_pb2, events_pb2


@dataclass
class Losses:
    """Packets of a LIVE or BROADCAST stream that did not arrive."""

    gaps: int = 0  # runs of missing packets
    packets: int = 0
    events: int = 0
    samples: int = 0  # of truth channels


class FreshPart(NamedTuple):
    """The new part of a packet: it begins after known_events, at t0_ns, and leaves out known_suppressed."""

    known_events: int
    t0_ns: int
    known_suppressed: int


@dataclass
class _Due:
    """Where the next packet of a sensor begins."""

    seq: int = 0
    event: int = 0
    suppressed: int = 0  # of the newest packet
    t_ns: int | None = None
    joined: bool = True  # False: the next packet may have any seq, but holds `event`
    ended: bool = False


class SequenceCheck:
    """Each sensor starts at seq 0, at any time; with from_event it starts at any seq, at the packet with that event."""

    def __init__(self, resolved: control_pb2.OpenStream) -> None:
        self.losses = Losses()
        self._sensors = len(resolved.sensors)
        firsts = [sensor.from_event for sensor in resolved.sensors] + [truth.from_sample for truth in resolved.truth]
        self._due = [_Due(event=first, joined=first == 0) for first in firsts]

    def add(self, header: events_pb2.PacketHeader) -> FreshPart | None:
        """None if the whole packet came before, or if its kind has no seq. Counts the losses before it.

        Raises StreamFault if it does not continue the packet before it.
        """
        if header.sensor >= len(self._due):
            raise StreamFault("a packet is of a sensor that the stream does not have")
        due = self._due[header.sensor]
        if header.kind in (events_pb2.KIND_HEARTBEAT, events_pb2.KIND_ERROR) or due.ended:
            return None
        fresh = self._follow(due, header) if due.joined else _join(due, header)
        due.seq = max(due.seq, header.seq + 1)
        if fresh is not None:
            due.event = header.first_event_index + header.count
            due.t_ns, due.suppressed, due.joined = header.t1_ns, header.suppressed, True
            due.ended = header.kind == events_pb2.KIND_END
        return fresh

    def _follow(self, due: _Due, header: events_pb2.PacketHeader) -> FreshPart | None:
        if header.seq < due.seq:
            return None
        if header.first_event_index < due.event:
            raise StreamFault("events run backwards")
        if header.seq > due.seq:
            self.losses.gaps += 1
            self.losses.packets += header.seq - due.seq
            missing = header.first_event_index - due.event
            if header.sensor < self._sensors:
                self.losses.events += missing
            else:
                self.losses.samples += missing
        elif due.t_ns not in (None, header.t0_ns) or header.first_event_index != due.event:
            raise StreamFault("a packet does not continue the one before it")
        return FreshPart(0, header.t0_ns, 0)

    def restart(self) -> None:
        """Call it when the request has been opened again, from events() on."""
        for due in self._due:
            due.joined, due.seq = False, 0

    def seqs(self) -> Sequence[int]:
        """The next seq of each sensor."""
        return [due.seq for due in self._due]

    def events(self) -> Sequence[int]:
        """The next event of each sensor."""
        return [due.event for due in self._due]

    def all_ended(self) -> bool:
        return all(due.ended for due in self._due)

    def end_ns(self) -> int:
        """Stream time up to which all sensors are complete."""
        return min(due.t_ns or 0 for due in self._due)


def _join(due: _Due, header: events_pb2.PacketHeader) -> FreshPart | None:
    """The last packet of a drained stream was cut short. Its events come again, with the events after them."""
    begin, is_end = header.first_event_index, header.kind == events_pb2.KIND_END
    if begin > due.event or (is_end and begin < due.event):
        raise StreamFault(f"the stream was to resume at event {due.event}, not at {begin}")
    t_ns = header.t0_ns if due.t_ns is None else due.t_ns
    nothing_new = begin < due.event or (due.t_ns is not None and header.t1_ns <= t_ns)
    if not is_end and begin + header.count <= due.event and nothing_new:
        return None
    again = header.t0_ns < t_ns
    return FreshPart(due.event - begin, max(t_ns, header.t0_ns), due.suppressed if again else 0)
