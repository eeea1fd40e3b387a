"""Asks servers, and opens streams, as coroutines: what the blocking and the asyncio form of the client share."""
from __future__ import annotations

import logging
import os
import time
from collections.abc import Iterable, Sequence
from typing import Union

from saccade.errors import SaccadeError
from saccade.protocol.handle import StreamHandle
from saccade.protocol.network import Network
from saccade.protocol.retry import RetryPolicy, is_absence, retry
from saccade.protocol.servers import Servers
from saccade.protocol.sockets import Key, read_keys
from saccade.protocol.subscription import Subscription
from saccade.v1 import control_pb2

ADDRESS = "tcp://127.0.0.1:5770"
Address = Union[str, Sequence[str]]
log = logging.getLogger("saccade")


def make_servers(network: Network, address: Address | None, secret_key: Key | None, server_key: Key | None) -> Servers:
    """The variables of the command `saccade` stand in for arguments that are None."""
    addresses = _addresses_of(address or os.environ.get("SACCADE_SERVER") or ADDRESS)
    keys = read_keys(secret_key or os.environ.get("SACCADE_CLIENT_KEY"),
                     server_key or os.environ.get("SACCADE_SERVER_KEY"))
    return Servers(network, addresses, keys)


def _addresses_of(address: Address) -> list[str]:
    """Each once, from a list or from a text with commas between them."""
    texts = address.split(",") if isinstance(address, str) else address
    for text in texts if isinstance(texts, Iterable) else (texts,):
        if not isinstance(text, str):
            raise TypeError(f"an address is a text such as '{ADDRESS}', not {type(text).__name__}")
    return list(dict.fromkeys(text.strip() for text in texts))


async def scenes(servers: Servers) -> list[control_pb2.SceneInfo]:
    reply = await servers.call(control_pb2.Request(list_scenes=control_pb2.ListScenes()))
    return list(reply.list_scenes.scenes)


async def info(servers: Servers) -> control_pb2.ServerDescription:
    return (await servers.call(control_pb2.Request(server_info=control_pb2.ServerInfo()))).server_info


async def open_subscription(servers: Servers, request: control_pb2.OpenStream, policy: RetryPolicy) -> Subscription:
    """Each stream has a control socket of its own: it may reconnect while another call waits for its reply.

    Waits for a server that is not up yet, or restarts, as the policy says.
    """
    if not isinstance(request, control_pb2.OpenStream):
        raise TypeError(f"a request is an OpenStream, such as Stream.resolved, not {type(request).__name__}")
    if not isinstance(policy, RetryPolicy):
        raise TypeError(f"retry is a saccade.RetryPolicy, not {type(policy).__name__}")
    if servers.closed:
        raise SaccadeError("the client is closed")
    subscription = Subscription(await _open(servers, request, policy), policy)
    try:
        await subscription.connect()
    except BaseException:
        subscription.handle.control.close()
        raise
    return subscription


async def _open(servers: Servers, request: control_pb2.OpenStream, policy: RetryPolicy) -> StreamHandle:
    async def attempt(deadline_s: float) -> StreamHandle:
        return await StreamHandle.open(servers, request, policy.failover_s)

    def tell(fault: SaccadeError) -> None:
        log.warning("%s; trying again for %g s in all", fault, policy.retry_time_s)

    return await retry(servers.network, attempt, time.monotonic() + policy.retry_time_s, is_absence, tell)
