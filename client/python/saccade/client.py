"""The blocking client. A client and its streams belong to one thread."""
from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from types import TracebackType
from typing import TYPE_CHECKING

from saccade.events import Events
from saccade.frames import Frame
from saccade.protocol import session
from saccade.protocol.network import BlockingNetwork, run
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
    """A client of the server with its control socket at `address`, or of several servers. Does not wait for them.

    address: by default $SACCADE_SERVER, or else tcp://127.0.0.1:5770. Several stand in a list, or in a text with commas
        between them. A name with several addresses stands for a server at each.
    secret_key, server_key: for a server with keys. Files of your secret key and of the server's public key, as
        `saccade keygen` writes them, or the keys as bytes. By default $SACCADE_CLIENT_KEY and $SACCADE_SERVER_KEY.
    retry: how long streams wait for a server that is not up yet, and try to go on after a loss.
    Of several servers, a stream is opened on the one with most room. If that is lost, a LOSSLESS stream goes on at the
    same event on another one of equal version and instruction set, unless it is steered or pushed.
    Raises ValueError for a malformed address or key, and OSError for a key file that cannot be read.
    """
    return Client(address, secret_key, server_key, retry)


class Client:
    """Asks servers and opens streams. Made by saccade.connect(); a context manager that closes the connection.

    Its calls raise saccade.NoAnswer where no server answers within 3 s, and saccade.Refused. open() waits for a server
    as `retry` says.
    """

    def __init__(self, address: Address | None, secret_key: Key | None, server_key: Key | None,
                 retry: RetryPolicy) -> None:
        self._servers = session.make_servers(BlockingNetwork(), address, secret_key, server_key)
        self._retry = retry

    def scenes(self) -> list[control_pb2.SceneInfo]:
        """Those of the first server that answers, with name, description, trajectories, objects, animations, and why one is
        unavailable."""
        return run(session.scenes(self._servers))

    def info(self) -> control_pb2.ServerDescription:
        """Version, limits, methods with their parameters, and scene features of the first server that answers."""
        return run(session.info(self._servers))

    def open(self, **settings: Unpack[Settings]) -> Stream:
        """Opens a stream; saccade.Settings describes the settings. Waits until the scene is loaded.

        Logs every few seconds how far the server is, as "saccade".

        Raises TypeError or ValueError for a setting that cannot be, and InvalidArgument, NotFound, LimitExceeded or
        another Refused where the server does not take the request.
        """
        return Stream(run(session.open_subscription(self._servers, make_request(settings), self._retry)))

    def open_request(self, request: control_pb2.OpenStream) -> Stream:
        """Opens a stream by its message, such as the `resolved` of an earlier stream, which gives equal events."""
        return Stream(run(session.open_subscription(self._servers, request, self._retry)))

    def close(self) -> None:
        self._servers.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()


class Stream(StreamState):
    """An iterator over the events of all sensors, packet by packet, and a context manager that closes the stream.

    Each Events covers its interval, up to 5 ms, and may be empty: nothing happened then. The Events of one sensor
    follow each other without gaps, except for lost packets of LIVE and BROADCAST. Iteration ends after the last
    frame; a second one raises StreamFault. It reconnects after a loss by itself, and logs that as "saccade". It raises
    StreamFault if the stream cannot go on.

    suppressed: events that the sensors have withheld so far.
    snapshots: by sensor, the pixels where the events begin; only of streams that joined a running feed.
    truth: samples of the truth channels that came with the last step() or push(), up to its frame.
    """

    def __iter__(self) -> Self:
        self._require_more()
        return self

    def __next__(self) -> Events:
        events = run(self._next_events())
        if events is None:
            raise StopIteration
        return events

    def samples(self) -> Iterator[Events | Truth]:
        """The events as iteration gives them, and the samples of the truth channels, in the order of arrival.

        Iteration over the stream itself passes over the samples of truth.
        """
        self._require_more()
        while (item := run(self._next_item())) is not None:
            yield item

    def steer(self, pose: Sequence[float] | None = None, *, velocity: Sequence[float] | None = None,
              objects: Objects | None = None) -> int:
        """Sets the camera and objects from the next frame on; returns the time of that frame in microseconds.

        Each of them follows its path of the request before the first call that names it.

        pose: position x y z and quaternion x y z w of T_world_camera. velocity: linear in scene units and angular in
            radians, per second, along and about the camera's axes x right, y down, z forward. A positive wx turns it
            up, wy to the right, and wz clockwise. With neither, the camera goes on as before.
        objects: poses of T_world_object by name, of objects that the request names.
        Raises InvalidArgument if the stream is not steerable, and LimitExceeded if too many poses wait.
        """
        return run(self._steer(pose, velocity, objects))

    def step(self, pose: Sequence[float] | None = None, *, velocity: Sequence[float] | None = None,
             objects: Objects | None = None) -> list[Events]:
        """steer(), and waits for that frame. Returns the events since the last ones, by sensor. For "lockstep"."""
        return run(self._step(pose, velocity, objects))

    def push(self, frame: Frame) -> list[Events]:
        """Sends the next frame of a stream with pushed=True. Returns the events since the last one, by sensor.

        frame: luminance (height, width): float is linear and at least 0; uint8 and uint16 are sRGB, where white is the
            luminance 1. The first frame makes no events: the list is empty then.
        Raises TypeError and ValueError for another array, and InvalidArgument for a value that cannot be.
        """
        return run(self._push(frame))

    def change_sensor(self, sensor: int = 0, **change: Unpack[SensorSettings]) -> int:
        """Changes a sensor; returns from which microsecond on. saccade.SensorSettings describes the settings."""
        return run(self._change_sensor(sensor, change))

    def describe(self) -> control_pb2.OpenStream:
        """The request that repeats the stream, as it was steered and changed so far, with equal events."""
        return run(self._subscription.handle.describe())

    def save(self, path: str | os.PathLike[str], events: Items) -> None:
        """Writes events of one sensor or of all to PATH, an .npz or .h5, and to PATH.json what repeats them.

        events: Events from the begin of the stream up to any frame, and perhaps samples of truth, such as
            `list(stream.samples())`, or what step() and `stream.truth` gave, in one list.
        Of several sensors an .h5 holds all, and an .npz becomes a file for each: a-0.npz, a-1.npz.
        `saccade replay PATH.json` renders the stream again as it was steered and changed, and compares the events.
        Raises ValueError for another extension, for none or some of several sensors, ImportError for .h5 without h5py,
        and OSError.
        """
        run(self._save(path, events))

    def info(self) -> control_pb2.StreamInfo:
        """What list_streams{} tells: frames, events and losses so far, and CPU time. Raises StreamFault without any."""
        return run(self._info())

    def picture(self) -> Picture:
        """The newest frame. Raises Unavailable before the first one."""
        return run(self._take_picture())

    def stop(self) -> None:
        """Ends the stream at its next frame. Iteration still gives the events up to there."""
        run(self._subscription.handle.close())

    def close(self) -> None:
        """Ends the stream and its connection."""
        run(self._close_all())

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()
