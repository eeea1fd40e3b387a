"""Repeats a call to a server that does not answer or is short of resources."""
from __future__ import annotations

import time
from collections.abc import Awaitable, Callable
from dataclasses import dataclass

from saccade.errors import LimitExceeded, NoAnswer, Unavailable
from saccade.protocol.control import DEADLINE_S
from saccade.protocol.network import Network

LONGEST_PAUSE_S = 4.0


@dataclass(frozen=True)
class RetryPolicy:
    """How long a stream tries to go on after a loss.

    retry_time_s: how long to try to reconnect, from the first sign of a loss; 0: not at all.
    silence_s: after this much silence a connection counts as lost. Heartbeats come every second.
    """

    retry_time_s: float = 60.0
    silence_s: float = 3.0


async def retry(network: Network, attempt: Callable[[float], Awaitable[None]], until: float) -> None:
    """Calls attempt(deadline_s) until it returns; deadline and pause double from one attempt to the next.

    After the time.monotonic() `until`, passes on NoAnswer, Unavailable and LimitExceeded; any other exception at once.
    """
    deadline_s = DEADLINE_S
    while True:
        try:
            return await attempt(deadline_s)
        except (NoAnswer, Unavailable, LimitExceeded):
            if time.monotonic() >= until:
                raise
        await network.sleep(min(deadline_s / 12, LONGEST_PAUSE_S))
        deadline_s *= 2
