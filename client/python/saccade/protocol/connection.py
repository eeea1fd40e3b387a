"""One connection to a stream: attaches, gives credit, acknowledges, and receives checked packets."""
from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import NamedTuple

import zmq

from saccade.errors import PacketFault, StreamRefused
from saccade.protocol.network import Channel, Network
from saccade.protocol.packets import Packet, decode_packet, read_header, read_packet
from saccade.protocol.sockets import Keys
from saccade.v1 import control_pb2, events_pb2

CREDIT = 4 << 20  # bytes that the server may send ahead
TAKEN_AT_ONCE = 1024  # messages
FREE = (events_pb2.KIND_HEARTBEAT, events_pb2.KIND_ERROR)  # of credit


class _Arrived(NamedTuple):
    header: events_pb2.PacketHeader
    payload: bytes
    cost: int  # credit, in bytes


class Connection:
    """To the data socket, for LOSSLESS and LIVE."""

    def __init__(self, channel: Channel) -> None:
        self._channel = channel
        self._arrived: deque[_Arrived] = deque()  # and not received yet
        self._waiting = 0  # their cost
        self._used = 0  # cost of what was received since credit was last given
        self._stored: dict[int, int] = {}  # the newest seq of each sensor since then

    @classmethod
    async def attach(cls, network: Network, endpoint: str, keys: Keys | None, opened: control_pb2.StreamOpened,
                     from_seqs: Sequence[int]) -> Connection:
        """from_seqs: the first seq that is wanted, by sensor."""
        connection = cls(network.connect(zmq.DEALER, endpoint, keys))
        attach = events_pb2.Attach(stream_id=opened.stream_id, token=opened.token, from_seqs=from_seqs)
        await connection._send(events_pb2.DataRequest(attach=attach))
        await connection._give_credit(CREDIT)
        return connection

    async def receive(self, timeout_s: float) -> Packet | None:
        """The next packet of any sensor, or a heartbeat; None after the timeout. Acknowledges the packets before.

        Raises StreamRefused for a packet of KIND_ERROR, and PacketFault for one that fails its checks or was sent
        without credit.
        """
        if self._used >= CREDIT // 2:  # early, so that the server does not wait for a round trip
            await self._give_back()
        await self._take(timeout_s)
        if not self._arrived:
            return None
        arrived = self._arrived.popleft()
        self._waiting -= arrived.cost
        self._used += arrived.cost
        packet = _not_refused(decode_packet(arrived.header, arrived.payload), arrived.payload)
        if packet.header.kind != events_pb2.KIND_HEARTBEAT:
            self._stored[packet.header.sensor] = packet.header.seq
        return packet

    async def _take(self, timeout_s: float) -> None:
        """Takes what waits at the socket, whose queue has no bound of its own; waits if there is nothing."""
        if not self._arrived and (parts := await self._channel.receive(timeout_s)) is not None:
            self._add(parts)
        for _ in range(TAKEN_AT_ONCE):
            if not self._arrived or self._ends_with(events_pb2.KIND_ERROR):
                return
            if (parts := await self._channel.receive_waiting()) is None:
                return
            self._add(parts)

    def _add(self, parts: list[bytes]) -> None:
        """The server sends while credit is above zero. A heartbeat stands for those before it."""
        head, payload = _checked(parts)
        header = read_header(head)
        if header.kind == events_pb2.KIND_HEARTBEAT and self._ends_with(events_pb2.KIND_HEARTBEAT):
            self._arrived.pop()
        cost = 0 if header.kind in FREE else len(head) + len(payload)
        if cost > 0 and self._used + self._waiting >= CREDIT:
            raise PacketFault("the server sends more than it has credit for")
        self._waiting += cost
        self._arrived.append(_Arrived(header, payload, cost))

    def _ends_with(self, kind: int) -> bool:
        return bool(self._arrived) and self._arrived[-1].header.kind == kind

    def close(self) -> None:
        self._channel.close()

    async def _give_back(self) -> None:
        for sensor, seq in self._stored.items():
            await self._send(events_pb2.DataRequest(ack=events_pb2.Ack(sensor=sensor, seq=seq)))
        self._stored.clear()
        used, self._used = self._used, 0
        await self._give_credit(used)

    async def _give_credit(self, size: int) -> None:
        await self._send(events_pb2.DataRequest(credit=events_pb2.Credit(bytes=size)))

    async def _send(self, request: events_pb2.DataRequest) -> None:
        await self._channel.send(request.SerializeToString())


class BroadcastConnection:
    """To the broadcast socket, which has neither credit nor acknowledgement."""

    def __init__(self, network: Network, endpoint: str, keys: Keys | None, topics: Sequence[str]) -> None:
        self._channel = network.connect(zmq.SUB, endpoint, keys, tuple(topics))

    async def receive(self, timeout_s: float) -> Packet | None:
        """As Connection.receive()."""
        parts = await self._channel.receive(timeout_s)
        if parts is None:
            return None
        head, payload = _checked(parts[1:])
        return _not_refused(read_packet(head, payload), payload)

    def close(self) -> None:
        self._channel.close()


def _checked(parts: list[bytes]) -> list[bytes]:
    if len(parts) != 2:
        raise PacketFault("the server sent a message that is not a packet")
    return parts


def _not_refused(packet: Packet, payload: bytes) -> Packet:
    if packet.header.kind == events_pb2.KIND_ERROR:
        raise StreamRefused(payload.decode(errors="replace"), bool(packet.header.stream_id))
    return packet
