"""Sends requests to the control socket; each returns its reply or raises."""
from __future__ import annotations

import time

import zmq
from google.protobuf.message import DecodeError

from saccade.errors import NoAnswer, SaccadeError, refusal
from saccade.protocol.network import Network
from saccade.protocol.sockets import Keys
from saccade.v1 import control_pb2

PROTOCOL_VERSION = 1
DEADLINE_S = 3.0  # for calls that need no rendering or loading
PARTING_S = 0.2  # to deliver a last message when the socket closes
UNREAD = 0  # request_id of a reply to an unreadable request; ours count from 1


class Control:
    """The control socket of one server."""

    def __init__(self, network: Network, endpoint: str, keys: Keys | None) -> None:
        """Does not wait for the server. Raises ValueError for a malformed endpoint or key."""
        self.network, self.endpoint, self.keys = network, endpoint, keys
        self._channel = network.connect(zmq.DEALER, endpoint, keys)
        self._request_id = 0

    async def call(self, request: control_pb2.Request, deadline_s: float = DEADLINE_S) -> control_pb2.Reply:
        """Raises NoAnswer, Refused, or SaccadeError for a reply that cannot be read."""
        request_id = await self.tell(request)
        reply = await self._await(request_id, deadline_s)
        if reply.status.code != control_pb2.CODE_OK:
            raise refusal(reply.status)
        return reply

    async def tell(self, request: control_pb2.Request) -> int:
        """Sends a request without waiting for its reply. Returns its request_id."""
        self._request_id += 1
        request.request_id, request.protocol_version = self._request_id, PROTOCOL_VERSION
        await self._channel.send(request.SerializeToString())
        return self._request_id

    async def _await(self, request_id: int, deadline_s: float) -> control_pb2.Reply:
        until = time.monotonic() + deadline_s
        while (left := until - time.monotonic()) > 0:
            parts = await self._channel.receive(left)
            if parts is None:
                continue
            reply = self._parse(parts)
            if reply.request_id in (request_id, UNREAD):  # others are late replies to earlier requests
                return reply
        raise NoAnswer(f"no saccaded answers at {self.endpoint}: is it running, is this its control port, "
                       "and does it want keys?", self.endpoint)

    def _parse(self, parts: list[bytes]) -> control_pb2.Reply:
        if len(parts) != 1:
            raise SaccadeError(f"{self.endpoint} is not a control socket; is it the data port?")
        try:
            reply: control_pb2.Reply = control_pb2.Reply.FromString(parts[0])
        except DecodeError as fault:
            raise SaccadeError(f"the server at {self.endpoint} sent a reply that cannot be read") from fault
        return reply

    def close(self) -> None:
        self._channel.close(PARTING_S)
