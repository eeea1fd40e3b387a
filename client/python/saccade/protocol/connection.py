"""One connection to a stream: attaches, gives credit, acknowledges, and receives checked packets."""
from __future__ import annotations

from collections.abc import Sequence

import zmq

from saccade.errors import PacketFault, StreamRefused
from saccade.protocol.network import Channel, Network
from saccade.protocol.packets import Packet, read_packet
from saccade.protocol.sockets import Keys
from saccade.v1 import control_pb2, events_pb2

CREDIT = 4 << 20  # bytes that the server may send ahead


class Connection:
    """To the data socket, for LOSSLESS and LIVE."""

    def __init__(self, channel: Channel) -> None:
        self._channel = channel
        self._used = 0  # bytes received since credit was last given
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

        Raises StreamRefused for a packet of KIND_ERROR, and PacketFault for one that fails its checks.
        """
        if self._used >= CREDIT // 2:  # early, so that the server does not wait for a round trip
            await self._give_back()
        parts = await self._channel.receive(timeout_s)
        if parts is None:
            return None
        packet = _packet_of(parts)
        if packet.header.kind != events_pb2.KIND_HEARTBEAT:
            self._used += len(parts[0]) + len(parts[1])
            self._stored[packet.header.sensor] = packet.header.seq
        return packet

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
        return None if parts is None else _packet_of(parts[1:])

    def close(self) -> None:
        self._channel.close()


def _packet_of(parts: list[bytes]) -> Packet:
    if len(parts) != 2:
        raise PacketFault("the server sent a message that is not a packet")
    packet = read_packet(*parts)
    if packet.header.kind == events_pb2.KIND_ERROR:
        raise StreamRefused(parts[1].decode(errors="replace"), bool(packet.header.stream_id))
    return packet
