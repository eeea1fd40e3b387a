"""The two networks: sockets that block, and sockets of asyncio."""
from __future__ import annotations

import asyncio
import threading
import time
from collections.abc import Coroutine
from socket import AF_INET, create_connection, getaddrinfo
from typing import Any, Protocol, TypeVar

import zmq
import zmq.asyncio

from saccade.errors import SaccadeError
from saccade.protocol.sockets import Keys, KeyWatch, configure, endpoints_of, host_and_port, name_in

PROBE_S = 0.5  # for a connection to be refused
T = TypeVar("T")


class Channel(Protocol):
    """A connected socket. Once it is closed, its calls raise SaccadeError, and PermissionDenied for a refused key."""

    async def send(self, message: bytes) -> None: ...

    async def receive(self, timeout_s: float) -> list[bytes] | None:
        """The parts of the next message; None after the timeout."""

    async def receive_waiting(self) -> list[bytes] | None:
        """The parts of the next message; None if none waits."""

    def close(self, linger_s: float = 0) -> None:
        """Closes the socket. Messages that were just sent have `linger_s` seconds to leave."""


class Network(Protocol):
    def connect(self, kind: int, endpoint: str, keys: Keys | None, topics: tuple[str, ...] = ()) -> Channel:
        """Raises ValueError for a malformed endpoint or key."""

    async def resolve(self, endpoint: str) -> list[str]:
        """As sockets.endpoints_of(), after a look-up; empty where that finds nothing."""

    async def refuses(self, endpoint: str) -> bool:
        """Whether the host of an endpoint of TCP says at once that no program listens there."""

    async def sleep(self, seconds: float) -> None: ...


def run(coroutine: Coroutine[Any, Any, T]) -> T:
    """The result of a coroutine over BlockingNetwork, which never suspends."""
    try:
        coroutine.send(None)
    except StopIteration as stop:
        result: T = stop.value
        return result
    raise RuntimeError("a coroutine over a blocking network has suspended")


class BlockingChannel:
    def __init__(self, socket: zmq.Socket[bytes], key: KeyWatch) -> None:
        self._socket, self._key, self._thread = socket, key, threading.get_ident()

    async def send(self, message: bytes) -> None:
        self._require_usable()
        self._key.require()
        self._socket.send(message)

    async def receive(self, timeout_s: float) -> list[bytes] | None:
        self._require_usable()
        if not self._socket.poll(_milliseconds(timeout_s)):
            self._key.require()
            return None
        # Copied into bytes: numpy then finds the columns aligned, which they are not within a message of ZeroMQ.
        return self._socket.recv_multipart()

    async def receive_waiting(self) -> list[bytes] | None:
        try:
            return self._socket.recv_multipart(zmq.NOBLOCK)
        except zmq.Again:
            return None

    def close(self, linger_s: float = 0) -> None:
        self._key.close()
        self._socket.close(linger=_milliseconds(linger_s))

    def _require_usable(self) -> None:
        _require_open(self._socket)
        if threading.get_ident() != self._thread:
            raise SaccadeError("a client and its streams belong to the thread that made them: connect() in each thread")


class BlockingNetwork:
    def connect(self, kind: int, endpoint: str, keys: Keys | None, topics: tuple[str, ...] = ()) -> BlockingChannel:
        socket = zmq.Context.instance().socket(kind)
        key = KeyWatch(socket, keys)
        return BlockingChannel(configure(socket, endpoint, keys, topics), key)

    async def resolve(self, endpoint: str) -> list[str]:
        try:
            host = name_in(endpoint)
            return endpoints_of(endpoint, getaddrinfo(host, None, AF_INET) if host else [])
        except (OSError, ValueError):
            return []

    async def refuses(self, endpoint: str) -> bool:
        try:
            create_connection(host_and_port(endpoint), PROBE_S).close()
        except (OSError, ValueError) as fault:
            return isinstance(fault, ConnectionRefusedError)
        return False

    async def sleep(self, seconds: float) -> None:
        time.sleep(seconds)


class AsyncChannel:
    def __init__(self, socket: zmq.asyncio.Socket, key: KeyWatch) -> None:
        self._socket, self._key = socket, key

    async def send(self, message: bytes) -> None:
        _require_open(self._socket)
        self._key.require()
        await self._socket.send(message)

    async def receive(self, timeout_s: float) -> list[bytes] | None:
        _require_open(self._socket)
        if not await self._socket.poll(_milliseconds(timeout_s)):
            self._key.require()
            return None
        return await self._socket.recv_multipart()

    async def receive_waiting(self) -> list[bytes] | None:
        try:
            return await self._socket.recv_multipart(zmq.NOBLOCK)
        except zmq.Again:
            return None

    def close(self, linger_s: float = 0) -> None:
        self._key.close()
        self._socket.close(linger=_milliseconds(linger_s))


class AsyncNetwork:
    def connect(self, kind: int, endpoint: str, keys: Keys | None, topics: tuple[str, ...] = ()) -> AsyncChannel:
        socket = zmq.asyncio.Context.instance().socket(kind)
        key = KeyWatch(socket, keys)
        return AsyncChannel(configure(socket, endpoint, keys, topics), key)

    async def resolve(self, endpoint: str) -> list[str]:
        try:
            host = name_in(endpoint)
            found = await asyncio.get_running_loop().getaddrinfo(host, None, family=AF_INET) if host else []
            return endpoints_of(endpoint, found)
        except (OSError, ValueError):
            return []

    async def refuses(self, endpoint: str) -> bool:
        try:
            _, writer = await asyncio.wait_for(asyncio.open_connection(*host_and_port(endpoint)), PROBE_S)
        except (OSError, ValueError, asyncio.TimeoutError) as fault:
            return isinstance(fault, ConnectionRefusedError)
        writer.close()
        return False

    async def sleep(self, seconds: float) -> None:
        await asyncio.sleep(seconds)


def _require_open(socket: zmq.Socket[Any]) -> None:
    if socket.closed:
        raise SaccadeError("the client or stream is closed")


def _milliseconds(seconds: float) -> int:
    return max(0, round(seconds * 1000))
