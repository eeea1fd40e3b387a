"""Receives the packets of a stream, and reconnects when the connection or the server is lost.

After silence a new connection resumes where the old one stopped. If the server has lost a LOSSLESS stream, or ended it
early, the stream is opened again, unless it is steered: only its client knows the next poses. With several servers it
may be another one that goes on. No event is missing then, and none comes twice. Of a LIVE or BROADCAST stream, lost
packets are counted.
"""
from __future__ import annotations

import logging
import time
from collections.abc import Awaitable, Callable
from dataclasses import replace

from saccade.errors import NoAnswer, StreamFault, StreamRefused
from saccade.events import Events
from saccade.printable import printable
from saccade.protocol.columns import NS_PER_US
from saccade.protocol.connection import BroadcastConnection, Connection
from saccade.protocol.handle import StreamHandle
from saccade.protocol.packets import Packet
from saccade.protocol.retry import RetryPolicy, is_shortage, retry
from saccade.protocol.samples import Samples
from saccade.protocol.sequence import FreshPart, SequenceCheck
from saccade.v1 import control_pb2, events_pb2

LOST = "the connection to the server is lost"
log = logging.getLogger("saccade")


class Subscription:
    def __init__(self, handle: StreamHandle, policy: RetryPolicy) -> None:
        self.handle = handle
        self.sequence = SequenceCheck(handle.opened.resolved)
        self._policy = policy
        self._connection: Connection | BroadcastConnection | None = None
        self._heard = False  # whether this connection has delivered anything
        self._last_heard = 0.0  # at first: when the connection was made
        self._lost_since: float | None = None  # set while the connection is lost
        self._lost_for = 0.0  # before, since new data has arrived
        self._failure = ""  # why the stream was opened again; empty once new data arrives

    async def connect(self) -> None:
        if self._connection is None or not self.handle.broadcast:  # a SUB reconnects by itself, and misses less
            self.close()
            self._connection = await self.handle.connect(self.sequence.seqs())
        self._heard, self._last_heard = False, time.monotonic()

    def close(self) -> None:
        """Closes the connection, not the stream."""
        if self._connection is not None:
            self._connection.close()
            self._connection = None

    async def receive(self) -> Packet:
        """The next packet with new content of any sensor: events, a snapshot or END. Waits for it.

        After a reconnection it holds the new part of its packet. Raises StreamFault or Refused if the stream cannot go
        on.
        """
        while True:
            if self._connection is None:
                raise StreamFault("the stream is closed")
            gone = self.handle.server_gone and self._may_start_again()
            silent_at = self._last_heard + (0 if gone else self._policy.silence_s)
            try:
                packet = await self._connection.receive(silent_at - time.monotonic())
            except StreamRefused as refused:
                await self._recover_from(refused)
                continue
            if packet is None:
                await self._reconnect()
            elif (fresh := await self._take(packet)) is not None:
                return fresh

    async def _recover_from(self, refused: StreamRefused) -> None:
        if self._heard and not refused.names_stream:
            await self.connect()
        else:
            await self._start_again(str(refused))

    async def _take(self, packet: Packet) -> Packet | None:
        self._found()
        self._heard, self._last_heard = True, time.monotonic()
        if packet.header.kind == events_pb2.KIND_END and self._ends_early(packet.header):
            await self._start_again(end_text(packet.header))
            return None
        fresh = self.sequence.add(packet.header)
        if fresh is None:
            return None
        if self.handle.lossless and self.sequence.losses.gaps > 0:
            raise StreamFault("packets of a LOSSLESS stream are missing")
        self._failure, self._lost_for = "", 0.0
        return _cut_off(fresh, packet)

    def _ends_early(self, header: events_pb2.PacketHeader) -> bool:
        """Whether the server ended the stream before its last frame, and it can be opened again."""
        left = header.end_reason in (events_pb2.END_REASON_DRAINING, events_pb2.END_REASON_ABANDONED)
        last_frame = 0 < self.handle.opened.frames <= header.frame
        return left and not last_frame and self._may_start_again()

    def _may_start_again(self) -> bool:
        again = self.handle.lossless and not self.handle.own_frames
        return again and not self.handle.closed and self._policy.retry_time_s > 0

    async def _reconnect(self) -> None:
        """Called after silence. Tries a new connection first; if that is silent too, asks the server for the stream."""
        if time.monotonic() >= self._give_up_at(LOST):
            raise StreamFault(LOST)
        if self._may_start_again() and await self.handle.servers.several(self.handle.control.endpoint):
            return await self._reconnect_or_move()
        if self._heard and not self.handle.broadcast:
            return await self.connect()
        infos: list[control_pb2.StreamInfo | None] = []

        async def ask(deadline_s: float) -> None:
            infos.append(await self.handle.info())

        await self._retry_after(LOST, ask)
        if infos[-1] is None:
            return await self._start_again("the server no longer knows the stream")
        if self.handle.broadcast and 0 < self.handle.opened.frames <= infos[-1].frames_done:
            raise StreamFault("the end of the stream was lost")
        await self.connect()

    async def _reconnect_or_move(self) -> None:
        """Where there are other servers, a lost one is not waited for."""
        endpoint = self.handle.control.endpoint
        lost = f"the server at {endpoint} is lost"
        if self.handle.server_gone:
            return await self._start_again(lost)
        try:
            if await self.handle.servers.network.refuses(endpoint):
                raise NoAnswer(lost)
            info = await self.handle.info(self._policy.failover_s)
        except NoAnswer:
            self.handle.servers.lose(endpoint)
            return await self._start_again(lost)
        if info is None:
            return await self._start_again("the server no longer knows the stream")
        await self.connect()

    async def _start_again(self, failure: str) -> None:
        if self.handle.own_frames:
            raise StreamFault(f"{failure}; a stream that its client steers or pushes is not opened again")
        if not self._may_start_again():
            raise StreamFault(failure)
        epoch = self.handle.opened.epoch

        async def reopen(deadline_s: float) -> None:
            await self.handle.reopen(self.sequence.events(), deadline_s)

        await self._retry_after(failure, reopen)
        if failure == self._failure and self.handle.opened.epoch == epoch:
            raise StreamFault(failure)  # nothing new has arrived since the last one, and no restart explains this one
        log.warning("the stream was opened again at %s, which renders up to the last event again",
                    self.handle.control.endpoint)
        self._failure = failure
        self._found()
        self.sequence.restart()
        await self.connect()

    async def _retry_after(self, loss: str, attempt: Callable[[float], Awaitable[None]]) -> None:
        until = self._give_up_at(loss)
        try:
            await retry(self.handle.control.network, attempt, until, is_shortage)
        except NoAnswer as silence:
            raise StreamFault(f"{loss}, and {silence}") from silence

    def _give_up_at(self, loss: str) -> float:
        """When the retry time ends. It runs while the server is lost, and begins anew with new data."""
        if self._lost_since is None:
            self._lost_since = time.monotonic()
            log.warning("%s; trying again for %g s", printable(loss), self._policy.retry_time_s)
        return self._lost_since + self._policy.retry_time_s - self._lost_for

    def _found(self) -> None:
        """Call it after a loss. The silence before it counts, too."""
        if self._lost_since is not None:
            self._lost_for += time.monotonic() - min(self._lost_since, self._last_heard)
        self._lost_since = None


def end_text(end: events_pb2.PacketHeader) -> str:
    """How the server ended a stream early, from the header of its END packet."""
    if end.end_reason == events_pb2.END_REASON_DRAINING:
        return f"the server has stopped and ended the stream at frame {end.frame}"
    if end.end_reason == events_pb2.END_REASON_ABANDONED:
        return f"the server ended the stream, which nobody received, at frame {end.frame}"
    return f"the server ended the stream at frame {end.frame}"


def _cut_off(fresh: FreshPart, packet: Packet) -> Packet:
    """Removes from a packet what arrived before."""
    header = packet.header
    if header.suppressed < fresh.known_suppressed:
        raise StreamFault("the stream does not come out as it did before it was lost")
    header.suppressed -= fresh.known_suppressed
    if isinstance(packet.content, Samples):
        return Packet(header, packet.content.after(fresh.known_events))
    if not isinstance(packet.content, Events) or header.t0_ns == fresh.t0_ns and not fresh.known_events:
        return packet
    interval = fresh.t0_ns // NS_PER_US, packet.content.t1
    events = replace(packet.content[fresh.known_events :], interval=interval)
    if len(events) and events.t[0] < events.t0:
        raise StreamFault("the stream does not come out as it did before it was lost")
    return Packet(header, events)
