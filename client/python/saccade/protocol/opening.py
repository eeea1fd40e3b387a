"""Opens a stream on one of several servers."""
from __future__ import annotations

from typing import NamedTuple

from saccade.errors import NoAnswer, SaccadeError, StreamFault, Unavailable
from saccade.protocol.control import DEADLINE_S, Control
from saccade.protocol.opened_check import check_opened
from saccade.protocol.retry import is_shortage
from saccade.protocol.servers import Servers
from saccade.v1 import control_pb2

OPEN_DEADLINE_S = 600.0  # a large scene takes long to load


class Place(NamedTuple):
    """Where a stream is."""

    control: Control  # of the stream alone
    server: control_pb2.ServerDescription
    opened: control_pb2.StreamOpened

    async def tell_close(self) -> None:
        close = control_pb2.CloseStream(stream_id=self.opened.stream_id, token=self.opened.token)
        await self.control.tell(control_pb2.Request(close_stream=close))


class Opening:
    """A request, to be opened on any of the servers.

    before: where the stream was until now. It goes on with equal events, so the servers must be of one kind.
    deadline_s: for a single server, which may be a lost one; of several the lost ones are passed over.
    failover_s: as in RetryPolicy.
    """

    def __init__(self, servers: Servers, request: control_pb2.OpenStream, before: Place | None, deadline_s: float,
                 failover_s: float) -> None:
        self._servers, self._request, self._before = servers, request, before
        self._deadline_s, self._failover_s, self._several = deadline_s, failover_s, False
        self._sockets: list[Control] = []  # made for the question

    async def run(self) -> Place:
        """On the server with most room that takes it. Closes `before`, if the stream moves.

        Raises NoAnswer, Refused, or StreamFault for a reply that cannot be, and then changes nothing.
        """
        place = None
        try:
            place = await self._open()
        finally:
            for control in self._sockets:
                if place is None or control is not place.control:
                    control.close()
        if self._before and place.control is not self._before.control:
            await self._before.tell_close()
            self._before.control.close()
        return place

    async def _open(self) -> Place:
        self._several = await self._servers.several(self._before.control.endpoint if self._before else None)
        # server_info first, with a short deadline: the long one is for a server that is there.
        answers, failures = await self._servers.ask(self._connect, self._failover_s if self._several else DEADLINE_S)
        for control, server in answers:
            try:
                return Place(control, server, await self._open_at(control, server))
            except SaccadeError as failure:
                if not is_shortage(failure):
                    raise
                failures.append(failure)
        raise next((one for one in failures if not isinstance(one, NoAnswer)), failures[0])

    def _connect(self, endpoint: str) -> Control:
        if self._before and self._before.control.endpoint == endpoint:
            return self._before.control
        self._sockets.append(Control(self._servers.network, endpoint, self._servers.keys))
        return self._sockets[-1]

    async def _open_at(self, control: Control, server: control_pb2.ServerDescription) -> control_pb2.StreamOpened:
        if self._before:
            _require_equal(server, self._before.server, control.endpoint)
            if control is self._before.control:
                await self._before.tell_close()  # its place is free then
        call = control_pb2.Request(open_stream=self._request)
        if self._several:
            reply = await control.call(call, OPEN_DEADLINE_S, watch=True, silence_s=self._failover_s)
        else:
            reply = await control.call(call, self._deadline_s, watch=True)
        check_opened(reply.open_stream, self._request)
        if self._before and reply.open_stream.bake_digest != self._before.opened.bake_digest:
            raise StreamFault("the light that was computed ahead differs from that of the stream that was lost")
        return reply.open_stream


def _require_equal(server: control_pb2.ServerDescription, before: control_pb2.ServerDescription, endpoint: str) -> None:
    """Raises Unavailable where another build or instruction set gives other events."""
    kinds = [f"saccaded {one.version} with {one.instruction_set}" for one in (server, before)]
    if kinds[0] != kinds[1]:
        raise Unavailable(f"the server at {endpoint} is {kinds[0]}, and the stream is of {kinds[1]}: its events differ")
