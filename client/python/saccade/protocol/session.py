"""Asks a server, and opens streams, as coroutines: what the blocking and the asyncio form of the client share."""
from __future__ import annotations

import logging
import os
import time

from saccade.errors import SaccadeError
from saccade.protocol.control import Control
from saccade.protocol.handle import StreamHandle
from saccade.protocol.network import Network
from saccade.protocol.retry import RetryPolicy, is_absence, retry
from saccade.protocol.sockets import Key, read_keys
from saccade.protocol.subscription import Subscription
from saccade.v1 import control_pb2

ADDRESS = "tcp://127.0.0.1:5770"
log = logging.getLogger("saccade")


def make_control(network: Network, address: str | None, secret_key: Key | None, server_key: Key | None) -> Control:
    """The variables of the command `saccade` stand in for arguments that are None."""
    if address is not None and not isinstance(address, str):
        raise TypeError(f"an address is a text such as '{ADDRESS}', not {type(address).__name__}")
    keys = read_keys(secret_key or os.environ.get("SACCADE_CLIENT_KEY"),
                     server_key or os.environ.get("SACCADE_SERVER_KEY"))
    return Control(network, address or os.environ.get("SACCADE_SERVER") or ADDRESS, keys)


async def scenes(control: Control) -> list[control_pb2.SceneInfo]:
    reply = await control.call(control_pb2.Request(list_scenes=control_pb2.ListScenes()))
    return list(reply.list_scenes.scenes)


async def info(control: Control) -> control_pb2.ServerDescription:
    return (await control.call(control_pb2.Request(server_info=control_pb2.ServerInfo()))).server_info


async def open_subscription(control: Control, request: control_pb2.OpenStream, policy: RetryPolicy) -> Subscription:
    """Each stream has a control socket of its own: it may reconnect while another call waits for its reply.

    Waits for a server that is not up yet, or restarts, as the policy says.
    """
    if not isinstance(request, control_pb2.OpenStream):
        raise TypeError(f"a request is an OpenStream, such as Stream.resolved, not {type(request).__name__}")
    if not isinstance(policy, RetryPolicy):
        raise TypeError(f"retry is a saccade.RetryPolicy, not {type(policy).__name__}")
    if control.closed:
        raise SaccadeError("the client is closed")
    own = Control(control.network, control.endpoint, control.keys)
    try:
        subscription = Subscription(await _open(own, request, policy.retry_time_s), policy)
        await subscription.connect()
    except BaseException:
        own.close()
        raise
    return subscription


async def _open(control: Control, request: control_pb2.OpenStream, retry_time_s: float) -> StreamHandle:
    async def attempt(deadline_s: float) -> StreamHandle:
        return await StreamHandle.open(control, request)

    def tell(fault: SaccadeError) -> None:
        log.warning("%s; trying again for %g s in all", fault, retry_time_s)

    return await retry(control.network, attempt, time.monotonic() + retry_time_s, is_absence, tell)
