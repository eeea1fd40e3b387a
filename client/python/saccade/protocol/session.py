"""Asks a server, and opens streams, as coroutines: what the blocking and the asyncio form of the client share."""
from __future__ import annotations

import os

from saccade.protocol.control import Control
from saccade.protocol.handle import StreamHandle
from saccade.protocol.network import Network
from saccade.protocol.request import make_request
from saccade.protocol.retry import RetryPolicy
from saccade.protocol.sockets import Key, read_keys
from saccade.protocol.subscription import Subscription
from saccade.settings import Settings
from saccade.v1 import control_pb2

ADDRESS = "tcp://127.0.0.1:5770"


def make_control(network: Network, address: str | None, secret_key: Key | None, server_key: Key | None) -> Control:
    """The variables of the command `saccade` stand in for arguments that are None."""
    keys = read_keys(secret_key or os.environ.get("SACCADE_CLIENT_KEY"),
                     server_key or os.environ.get("SACCADE_SERVER_KEY"))
    return Control(network, address or os.environ.get("SACCADE_SERVER") or ADDRESS, keys)


async def scenes(control: Control) -> list[control_pb2.SceneInfo]:
    reply = await control.call(control_pb2.Request(list_scenes=control_pb2.ListScenes()))
    return list(reply.list_scenes.scenes)


async def info(control: Control) -> control_pb2.ServerDescription:
    return (await control.call(control_pb2.Request(server_info=control_pb2.ServerInfo()))).server_info


async def open_subscription(control: Control, settings: Settings | control_pb2.OpenStream,
                            policy: RetryPolicy) -> Subscription:
    """Each stream has a control socket of its own: it may reconnect while another call waits for its reply."""
    request = settings if isinstance(settings, control_pb2.OpenStream) else make_request(settings)
    own = Control(control.network, control.endpoint, control.keys)
    try:
        subscription = Subscription(await StreamHandle.open(own, request), policy)
        await subscription.connect()
    except BaseException:
        own.close()
        raise
    return subscription
