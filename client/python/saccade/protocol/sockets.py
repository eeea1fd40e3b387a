"""Options, keys and endpoints of the client's sockets."""
from __future__ import annotations

import itertools
import os
import pathlib
import stat
import warnings
from collections.abc import Iterable
from typing import Any, NamedTuple, TypeVar, Union

import zmq

from saccade.errors import PermissionDenied

MOST_WAITING = 20_000  # packets
MOST_MESSAGE = 129 << 20  # bytes; the largest picture of truth has 128 MiB
REFUSED_KEY = "the server refuses your key: it is not on its list, the file of saccaded --client-keys"
_WATCHES = itertools.count()  # makes their addresses
Key = Union[str, "os.PathLike[str]", bytes]
S = TypeVar("S", bound="zmq.Socket[Any]")


class Keys(NamedTuple):
    """CURVE keys, 40 bytes each."""

    secret: bytes  # the client's own
    server_public: bytes


def read_keys(secret_key: Key | None, server_key: Key | None) -> Keys | None:
    """Keys from files that `saccade keygen` writes, or from bytes.

    Raises ValueError if only one is given or one is no key, and OSError for a file that cannot be read.
    """
    if secret_key is None and server_key is None:
        return None
    if secret_key is None or server_key is None:
        raise ValueError("give both secret_key and server_key, or neither")
    keys = Keys(_read_key(secret_key, ".pub"), _read_key(server_key, ".key"))
    if not isinstance(secret_key, bytes) and os.stat(secret_key).st_mode & stat.S_IROTH:
        warnings.warn(f"every user of this machine can read the secret key {os.fspath(secret_key)}", stacklevel=3)
    return keys


def _read_key(key: Key, wrong: str) -> bytes:
    """wrong: the ending of the other key's file, as `saccade keygen` names it."""
    if not isinstance(key, bytes) and os.fspath(key).endswith(wrong):
        raise ValueError(f"{key} is by its name a {'public' if wrong == '.pub' else 'secret'} key: give the other one")
    text = key if isinstance(key, bytes) else pathlib.Path(key).read_bytes()
    if len(text.strip()) != 40:
        raise ValueError(f"{'the key' if isinstance(key, bytes) else key} is not a key: it has 40 characters")
    return text.strip()


class KeyWatch:
    """Tells whether the server refuses the key of a socket, which is yet to connect."""

    def __init__(self, socket: zmq.Socket[Any], keys: Keys | None) -> None:
        self._watched, self._refused = socket, False
        self._events: zmq.Socket[bytes] | None = None
        if keys:
            address = f"inproc://key-watch-{next(_WATCHES)}"
            socket.monitor(address, zmq.EVENT_HANDSHAKE_FAILED_AUTH)
            self._events = zmq.Context.shadow(socket.context.underlying).socket(zmq.PAIR)
            self._events.connect(address)

    def require(self) -> None:
        """Raises PermissionDenied where it does: libzmq then tries no more."""
        if self._events and not self._refused:
            self._refused = bool(self._events.poll(0))
        if self._refused:
            raise PermissionDenied(REFUSED_KEY, code="CODE_PERMISSION_DENIED", message=REFUSED_KEY)

    def close(self) -> None:
        if self._events:
            self._watched.disable_monitor()
            self._events.close(linger=0)
            self._events = None


def configure(socket: S, endpoint: str, keys: Keys | None, topics: tuple[str, ...]) -> S:
    """Sets the options of a DEALER or SUB socket, and connects it. It sends heartbeats to detect a lost peer."""
    socket.setsockopt(zmq.LINGER, 0)
    socket.setsockopt(zmq.IPV6, "[" in endpoint)  # else a name is looked up as IPv6 alone
    socket.setsockopt(zmq.MAXMSGSIZE, MOST_MESSAGE)
    # Credit bounds the queue of a DEALER. Heartbeats cut off a SUB with a full queue, and libzmq 4.3 may then end the
    # program (its issue 3937). So the queue of a SUB holds most of a minute.
    socket.setsockopt(zmq.RCVHWM, MOST_WAITING if topics else 0)
    socket.setsockopt(zmq.HEARTBEAT_IVL, 2000)
    socket.setsockopt(zmq.HEARTBEAT_TIMEOUT, 6000)
    for topic in topics:
        socket.setsockopt(zmq.SUBSCRIBE, topic.encode())
    try:
        if keys:
            socket.setsockopt(zmq.CURVE_SERVERKEY, keys.server_public)
            socket.setsockopt(zmq.CURVE_SECRETKEY, keys.secret)
            socket.setsockopt(zmq.CURVE_PUBLICKEY, zmq.curve_public(keys.secret))
        socket.connect(endpoint)
    except zmq.ZMQError as fault:
        socket.close()
        what = "is not an endpoint such as tcp://127.0.0.1:5770, or a key is malformed"
        raise ValueError(f"'{endpoint}' {what}") from fault
    return socket


def host_and_port(endpoint: str) -> tuple[str, int]:
    """Of an endpoint of TCP. Raises ValueError for another one."""
    host, _, port = endpoint.removeprefix("tcp://").rpartition(":")
    if not endpoint.startswith("tcp://"):
        raise ValueError(f"{endpoint} is not of TCP")
    return host.strip("[]"), int(port)


def name_in(endpoint: str) -> str | None:
    """The host in an endpoint of TCP, if it is a name that stands for addresses. Raises as host_and_port()."""
    host, _ = host_and_port(endpoint)
    return None if ":" in host or host.replace(".", "").isdecimal() else host


def endpoints_of(endpoint: str, found: Iterable[tuple[Any, ...]]) -> list[str]:
    """One for each address that getaddrinfo() has found for its host; the endpoint itself, if they are not several."""
    addresses = sorted({str(one[4][0]) for one in found})
    port = endpoint.rpartition(":")[2]
    return [f"tcp://{address}:{port}" for address in addresses] if len(addresses) > 1 else [endpoint]


def reachable_endpoint(announced: str, control_endpoint: str) -> str:
    """An endpoint that the server announced, with the host of the control endpoint in place of a wildcard."""
    scheme, _, address = announced.partition("://")
    host, _, port = address.rpartition(":")
    if scheme != "tcp" or host not in {"*", "0.0.0.0", "[::]"} or not control_endpoint.startswith("tcp://"):
        return announced
    return f"{control_endpoint.rpartition(':')[0]}:{port}"
