"""Repeats a call to a server that does not answer or is short of resources."""
from __future__ import annotations

import time
from collections.abc import Awaitable, Callable
from dataclasses import dataclass
from typing import TypeVar

from saccade.errors import LimitExceeded, NoAnswer, SaccadeError, Unavailable
from saccade.protocol.control import DEADLINE_S
from saccade.protocol.network import Network

LONGEST_PAUSE_S = 4.0
T = TypeVar("T")


@dataclass(frozen=True)
class RetryPolicy:
    """How long a stream tries to begin without a server, and to go on after a loss.

    retry_time_s: how long there may be no server in all, until new data arrives; 0: it is not waited for.
    silence_s: after this much silence a connection counts as lost. Heartbeats come every second.
    failover_s: with several servers, one that then answers nothing for so long is lost, or at once if its host refuses
        connections. Others take its streams.
    """

    retry_time_s: float = 60.0
    silence_s: float = 3.0
    failover_s: float = 3.0


def is_shortage(fault: SaccadeError) -> bool:
    return isinstance(fault, (NoAnswer, Unavailable, LimitExceeded))


def is_absence(fault: SaccadeError) -> bool:
    """Whether no server is there, or it is stopping or has restarted: then no field of the request is at fault."""
    return isinstance(fault, NoAnswer) or isinstance(fault, Unavailable) and not fault.field


async def retry(network: Network, attempt: Callable[[float], Awaitable[T]], until: float,
                may_pass: Callable[[SaccadeError], bool],
                failed: Callable[[SaccadeError], None] | None = None) -> T:
    """What attempt(deadline_s) returns; deadline and pause double from one attempt to the next.

    After the time.monotonic() `until`, passes on what may_pass(); any other exception at once. Calls failed() with
    each fault before that.
    """
    deadline_s = DEADLINE_S
    while True:
        try:
            return await attempt(deadline_s)
        except SaccadeError as fault:
            if not may_pass(fault) or time.monotonic() >= until:
                raise
            if failed:
                failed(fault)
        await network.sleep(min(deadline_s / 12, LONGEST_PAUSE_S))
        deadline_s *= 2
