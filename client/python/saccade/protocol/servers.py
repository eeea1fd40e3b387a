"""The servers that a client may open streams on: where they are, which are lost, and which has most room."""
from __future__ import annotations

import math
import random
import time
from collections.abc import Callable, Sequence
from typing import NamedTuple

from saccade.errors import NoAnswer, SaccadeError
from saccade.protocol.control import Control
from saccade.protocol.network import Network
from saccade.protocol.sockets import Keys
from saccade.v1 import control_pb2

KNOWN_S = 5.0  # before the addresses of a name are asked for again
AGAIN_S = 2.0  # before a lost server is asked again
GRACE_S = 0.25  # how long it is waited for then
BELIEVED_S = 10.0  # how long one stream believes another that a server is lost
READ_S = 0.05  # for a reply that has arrived
QUESTION = control_pb2.Request(server_info=control_pb2.ServerInfo())


class Answer(NamedTuple):
    control: Control
    server: control_pb2.ServerDescription


class Servers:
    def __init__(self, network: Network, addresses: Sequence[str], keys: Keys | None) -> None:
        """Does not wait for them. Raises ValueError for a malformed endpoint or key."""
        self.network, self.keys, self.closed = network, keys, False
        self._controls: list[Control] = []
        try:
            self._controls += (Control(network, address, keys) for address in addresses)
        except ValueError:
            self.close()
            raise
        self._found = {address: [address] for address in addresses}  # the endpoints of each
        self._found_until = -math.inf
        self._lost: dict[str, float] = {}  # endpoint, and when that was found
        self._epochs: dict[str, int] = {}  # by endpoint, of the last answer

    async def call(self, request: control_pb2.Request) -> control_pb2.Reply:
        """Asks the first server that answers. Raises as Control.call()."""
        *others, last = sorted(self._controls, key=lambda control: self.is_lost(control.endpoint))
        for control in others:
            try:
                return await control.call(request)
            except NoAnswer:
                self.lose(control.endpoint)
        return await last.call(request)

    async def endpoints(self) -> list[str]:
        """One for each server. A name with several addresses stands for several servers, and these may change."""
        if time.monotonic() >= self._found_until:
            for address in self._found:
                if found := await self.network.resolve(address):
                    self._found[address] = found
            self._found_until = time.monotonic() + KNOWN_S
        return list(dict.fromkeys(endpoint for found in self._found.values() for endpoint in found))

    async def several(self, own: str | None = None) -> bool:
        """Whether there are several, or others than `own`."""
        return len({*await self.endpoints(), own} - {None}) > 1

    def lose(self, endpoint: str) -> None:
        """Call it for a server that does not answer."""
        self._lost[endpoint] = time.monotonic()

    def is_lost(self, endpoint: str, within_s: float = math.inf) -> bool:
        """Whether that was found in the last `within_s` seconds, and the server has not answered since."""
        return time.monotonic() - self._lost.get(endpoint, -math.inf) < within_s

    def is_gone(self, endpoint: str, epoch: int) -> bool:
        """Whether others have found that this run of the server is over, or lost it lately."""
        return self._epochs.get(endpoint, epoch) != epoch or self.is_lost(endpoint, BELIEVED_S)

    async def ask(self, connect: Callable[[str], Control], wait_s: float) -> tuple[list[Answer], list[SaccadeError]]:
        """Asks all servers about themselves. Gives the answers, that with most room first, and the failures.

        A lost server is asked from time to time, and waited for only if there is no other. connect: makes a control
        socket for an endpoint.
        """
        due = await self._due()
        choice = len(due) > 1 and not all(self.is_lost(endpoint) for endpoint in due)
        began = time.monotonic()
        asked = [(control, await control.tell(QUESTION)) for control in map(connect, due)]
        answers: list[Answer] = []
        failures: list[SaccadeError] = []
        for control, request_id in asked:
            until = began + (GRACE_S if choice and self.is_lost(control.endpoint) else wait_s)
            try:
                reply = await self._reply(control, request_id, until, choice)
            except SaccadeError as failure:
                self.lose(control.endpoint)
                failures.append(failure)
            else:
                self._lost.pop(control.endpoint, None)
                self._epochs[control.endpoint] = reply.server_info.epoch
                answers.append(Answer(control, reply.server_info))
        return sorted(answers, key=_fullness), failures

    async def _reply(self, control: Control, request_id: int, until: float, choice: bool) -> control_pb2.Reply:
        """choice: whether there are others, so that one that is not there need not be waited for."""
        if choice:
            try:
                return await control.reply_to(request_id, QUESTION, GRACE_S)
            except NoAnswer:
                if await self.network.refuses(control.endpoint):
                    raise
        return await control.reply_to(request_id, QUESTION, max(until - time.monotonic(), READ_S))

    async def _due(self) -> list[str]:
        endpoints = await self.endpoints()
        return [endpoint for endpoint in endpoints if not self.is_lost(endpoint, AGAIN_S)] or endpoints

    def close(self) -> None:
        self.closed = True
        for control in self._controls:
            control.close()


def _fullness(answer: Answer) -> tuple[float, float, float]:
    """The used share of the limit that is nearest, and the number of streams. Chance decides between equal ones."""
    limits = [limit for limit in answer.server.limits if limit.HasField("used") and limit.value > 0]
    streams = sum(limit.used for limit in limits if limit.name == "streams")
    return max((limit.used / limit.value for limit in limits), default=0.0), streams, random.random()
