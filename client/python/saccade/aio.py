"""The client for asyncio: saccade.aio.connect() is saccade.connect(), and everything that waits is awaited."""
from __future__ import annotations

import os
from collections.abc import AsyncIterator, Sequence
from types import TracebackType
from typing import TYPE_CHECKING

from saccade.events import Events
from saccade.frames import Frame
from saccade.protocol import session
from saccade.protocol.network import AsyncNetwork
from saccade.protocol.request import make_request
from saccade.protocol.retry import RetryPolicy
from saccade.protocol.session import Address
from saccade.protocol.sockets import Key
from saccade.protocol.steering import Objects
from saccade.protocol.stream_state import Picture, StreamState
from saccade.settings import SensorSettings, Settings
from saccade.truth import Truth
from saccade.v1 import control_pb2
from saccade.writers import Items

if TYPE_CHECKING:
    from typing_extensions import Self, Unpack


def connect(address: Address | None = None, *, secret_key: Key | None = None, server_key: Key | None = None,
            retry: RetryPolicy = RetryPolicy()) -> Client:
    """As saccade.connect(). A client and its streams belong to one event loop; one task at a time calls a client."""
    return Client(address, secret_key, server_key, retry)


class Client:
    """As saccade.Client, and an asynchronous context manager."""

    def __init__(self, address: Address | None, secret_key: Key | None, server_key: Key | None,
                 retry: RetryPolicy) -> None:
        self._servers = session.make_servers(AsyncNetwork(), address, secret_key, server_key)
        self._retry = retry

    async def scenes(self) -> list[control_pb2.SceneInfo]:
        return await session.scenes(self._servers)

    async def info(self) -> control_pb2.ServerDescription:
        return await session.info(self._servers)

    async def open(self, **settings: Unpack[Settings]) -> Stream:
        return Stream(await session.open_subscription(self._servers, make_request(settings), self._retry))

    async def open_request(self, request: control_pb2.OpenStream) -> Stream:
        return Stream(await session.open_subscription(self._servers, request, self._retry))

    def close(self) -> None:
        self._servers.close()

    async def __aenter__(self) -> Self:
        return self

    async def __aexit__(self, kind: type[BaseException] | None, fault: BaseException | None,
                        trace: TracebackType | None) -> None:
        self.close()


class Stream(StreamState):
    """As saccade.Stream, for `async for` and `async with`."""

    def __aiter__(self) -> Self:
        self._require_more()
        return self

    async def __anext__(self) -> Events:
        events = await self._next_events()
        if events is None:
            raise StopAsyncIteration
        return events

    async def samples(self) -> AsyncIterator[Events | Truth]:
        self._require_more()
        while (item := await self._next_item()) is not None:
            yield item

    async def steer(self, pose: Sequence[float] | None = None, *, velocity: Sequence[float] | None = None,
                    objects: Objects | None = None) -> int:
        return await self._steer(pose, velocity, objects)

    async def step(self, pose: Sequence[float] | None = None, *, velocity: Sequence[float] | None = None,
                   objects: Objects | None = None) -> list[Events]:
        return await self._step(pose, velocity, objects)

    async def push(self, frame: Frame) -> list[Events]:
        return await self._push(frame)

    async def change_sensor(self, sensor: int = 0, **change: Unpack[SensorSettings]) -> int:
        return await self._change_sensor(sensor, change)

    async def describe(self) -> control_pb2.OpenStream:
        return await self._subscription.handle.describe()

    async def save(self, path: str | os.PathLike[str], events: Items) -> None:
        await self._save(path, events)

    async def info(self) -> control_pb2.StreamInfo:
        return await self._info()

    async def picture(self) -> Picture:
        return await self._take_picture()

    async def stop(self) -> None:
        await self._subscription.handle.close()

    async def close(self) -> None:
        await self._close_all()

    async def __aenter__(self) -> Self:
        return self

    async def __aexit__(self, kind: type[BaseException] | None, fault: BaseException | None,
                        trace: TracebackType | None) -> None:
        await self.close()
