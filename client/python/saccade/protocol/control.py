"""Sends requests to the control socket; each returns its reply or raises."""
from __future__ import annotations

import logging
import math
import time

import zmq
from google.protobuf.message import DecodeError

from saccade.errors import NoAnswer, SaccadeError, Unavailable, refusal
from saccade.printable import printable
from saccade.protocol.network import Network
from saccade.protocol.sockets import Keys
from saccade.v1 import control_pb2

PROTOCOL_VERSION = 1
DEADLINE_S = 3.0  # for calls that need no rendering or loading
WATCH_S = 2.0  # between two questions how far a call is
PARTING_S = 0.2  # to deliver a last message when the socket closes
MOST_UNKNOWN = 3  # lists without a call, whose reply comes after it has left the list
UNREAD = 0  # request_id of a reply to an unreadable request; ours count from 1
log = logging.getLogger("saccade")


class Control:
    """The control socket of one server."""

    def __init__(self, network: Network, endpoint: str, keys: Keys | None) -> None:
        """Does not wait for the server. Raises ValueError for a malformed endpoint or key."""
        self.network, self.endpoint, self.keys = network, endpoint, keys
        self._channel = network.connect(zmq.DEALER, endpoint, keys)
        self._request_id = 0
        self.closed = False

    async def call(self, request: control_pb2.Request, deadline_s: float = DEADLINE_S, watch: bool = False,
                   silence_s: float = math.inf) -> control_pb2.Reply:
        """Raises NoAnswer, Refused, or SaccadeError for a reply that cannot be read or has no result.

        watch: logs what the server does while it opens a stream, and raises Unavailable where it knows of none.
        silence_s: how long it may answer nothing at all meanwhile.
        """
        return await self.reply_to(await self.tell(request), request, deadline_s, watch, silence_s)

    async def reply_to(self, request_id: int, request: control_pb2.Request, deadline_s: float, watch: bool = False,
                       silence_s: float = math.inf) -> control_pb2.Reply:
        """The reply to a request that tell() has sent. As call()."""
        reply = await self._await(request_id, deadline_s, min(WATCH_S, silence_s / 2) if watch else math.inf, silence_s)
        if reply.status.code != control_pb2.CODE_OK:
            raise refusal(reply.status)
        if reply.WhichOneof("result") != request.WhichOneof("call"):
            raise SaccadeError(f"the server at {self.endpoint} sent a reply without the result of the call")
        return reply

    async def tell(self, request: control_pb2.Request) -> int:
        """Sends a request without waiting for its reply. Returns its request_id."""
        self._request_id += 1
        request.request_id, request.protocol_version = self._request_id, PROTOCOL_VERSION
        await self._channel.send(request.SerializeToString())
        return self._request_id

    async def _await(self, request_id: int, deadline_s: float, watch_s: float, silence_s: float) -> control_pb2.Reply:
        """watch_s: after so much silence, asks how far the call is."""
        heard = time.monotonic()
        until = heard + deadline_s
        unknown = 0  # lists in a row that do not have the call
        while (left := min(until, heard + silence_s) - time.monotonic()) > 0:
            parts = await self._channel.receive(min(left, watch_s))
            if parts is None:
                if watch_s < math.inf:
                    await self.tell(control_pb2.Request(list_streams=control_pb2.ListStreams()))
                continue
            heard = time.monotonic()
            reply = self._parse(parts)
            if reply.request_id in (request_id, UNREAD):  # others are late replies to earlier requests
                return reply
            if watch_s < math.inf and reply.HasField("list_streams"):
                known = [opening for opening in reply.list_streams.opening if opening.request_id == request_id]
                for opening in known:
                    _log_opening(opening)
                unknown = 0 if known else unknown + 1
            if unknown == MOST_UNKNOWN:
                raise Unavailable("the server has restarted and no longer knows the request")
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
        self.closed = True
        self._channel.close(PARTING_S)


def _log_opening(opening: control_pb2.OpeningInfo) -> None:
    done = f": {100 * opening.done:.0f} %" if opening.done > 0 else ""
    log.warning("opening %s: %s%s", printable(opening.scene), printable(opening.doing), done)
