"""A stream as coroutines: what its blocking and its asyncio form share."""
from __future__ import annotations

import functools
import os
from collections import Counter, deque
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from saccade.camera import Camera, cameras_of
from saccade.errors import StreamFault
from saccade.events import Events, concatenate, seen_by
from saccade.frames import Frame, luminance
from saccade.protocol.columns import NS_PER_US, Snapshot
from saccade.protocol.request import make_sensor_change
from saccade.protocol.samples import Samples
from saccade.protocol.sequence import Losses
from saccade.protocol.steering import Objects
from saccade.protocol.subscription import Subscription, end_text
from saccade.settings import SensorSettings
from saccade.truth import OF_BODY, IdNames, Truth
from saccade.v1 import control_pb2, events_pb2, recording_pb2
from saccade.writers import Items, Saved


@dataclass(frozen=True)
class Picture:
    """The newest frame of a stream; float32 (height, width), row by row from the top.

    luminance: Rec. 709, in the units of the scene's lights, at the microsecond t1.
    brightness_change: of log brightness from t0 to t1.
    """

    t0: int
    t1: int
    luminance: NDArray[np.float32]
    brightness_change: NDArray[np.float32]


class StreamState:
    """What a stream knows besides its events; the base of saccade.Stream and saccade.aio.Stream."""

    def __init__(self, subscription: Subscription) -> None:
        self._subscription = subscription
        self._suppressed: Counter[int] = Counter()  # by sensor
        self.snapshots: dict[int, Snapshot] = {}
        self.truth: list[Truth] = []
        self._samples: deque[Truth] = deque()  # received, not given yet
        self._given = False  # whether an iteration has come to the end

    @property
    def opened(self) -> control_pb2.StreamOpened:
        """The server's reply: ids, number of frames, speed of the picture, what was chosen for a budget."""
        return self._subscription.handle.opened

    @property
    def address(self) -> str:
        """The control socket of the server that has the stream. With several servers it may become another one."""
        return self._subscription.handle.control.endpoint

    @property
    def resolved(self) -> control_pb2.OpenStream:
        """The request with all defaults filled in."""
        return self.opened.resolved

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        return self.resolved.view.width, self.resolved.view.height

    @functools.cached_property
    def cameras(self) -> list[Camera | None]:
        """The calibration of each view; None for frames that are pushed."""
        return cameras_of(self.resolved)

    @property
    def suppressed(self) -> int:
        """Events that the sensors have withheld so far."""
        return self._suppressed.total()

    @property
    def id_names(self) -> IdNames:
        """The names of the numbers in the truth channel ids; empty without this channel."""
        return IdNames.of(self.opened.id_names)

    @property
    def losses(self) -> Losses:
        """Packets of a LIVE or BROADCAST stream that were lost so far."""
        return self._subscription.sequence.losses

    async def _next_events(self) -> Events | None:
        """The next Events of any sensor, without the samples of truth before it; None at the end."""
        item = await self._next_item()
        while isinstance(item, Truth):
            item = await self._next_item()
        return item

    async def _next_item(self) -> Events | Truth | None:
        """What comes next of any sensor or truth channel; None after their end. Raises StreamFault if it came early."""
        while not self._samples and not self._subscription.sequence.all_ended():
            if (events := await self._receive()) is not None:
                return events
        self._given = not self._samples
        return None if self._given else self._samples.popleft()

    def _require_more(self) -> None:
        """Raises StreamFault where an iteration has given all there is: it would be taken for no events."""
        if self._given:
            raise StreamFault("the stream has ended, and its events were given; keep them in a list to use them again")

    async def _receive(self) -> Events | None:
        """The events of the next packet. What else it holds is kept."""
        packet = await self._subscription.receive()
        self._suppressed[packet.header.sensor] += packet.header.suppressed
        if isinstance(packet.content, Snapshot):
            self.snapshots[packet.header.sensor] = packet.content
        elif isinstance(packet.content, Samples):
            self._keep(packet.header.sensor - len(self.resolved.sensors), packet.content)
        elif packet.content is None and self._subscription.sequence.all_ended():
            self._check_whole(packet.header)
        if not isinstance(packet.content, Events):
            return None
        if packet.header.sensor >= len(self.resolved.sensors):
            raise StreamFault("a packet of events is of a truth channel")
        return seen_by(packet.content, self.cameras[self.resolved.sensors[packet.header.sensor].view])

    def _keep(self, channel: int, samples: Samples) -> None:
        if channel < 0:
            raise StreamFault("a packet of truth is of a sensor")
        asked = self.resolved.truth[channel]
        view = None if asked.name == OF_BODY else asked.view
        for t, data in zip(samples.t, samples.data):
            self._samples.append(Truth(asked.name, int(t), data, samples.exposure, channel, view))

    def _check_whole(self, end: events_pb2.PacketHeader) -> None:
        frames = self._subscription.sequence.end_ns() * 1e-9 * self.resolved.timing.frame_rate_hz
        if 0 < self.opened.frames - 0.5 > frames and not self._subscription.handle.closed:
            raise StreamFault(end_text(end))

    async def _steer(self, pose: Sequence[float] | None, velocity: Sequence[float] | None,
                     objects: Objects | None) -> int:
        steered = await self._subscription.handle.steer(pose, velocity, objects)
        return steered.t_ns // NS_PER_US

    async def _step(self, pose: Sequence[float] | None, velocity: Sequence[float] | None,
                    objects: Objects | None) -> list[Events]:
        return await self._frame_until(await self._subscription.handle.steer(pose, velocity, objects))

    async def _push(self, frame: Frame) -> list[Events]:
        pushed = await self._subscription.handle.push(luminance(frame, self.size).tobytes())
        return await self._frame_until(pushed) if pushed.frame > 0 else []

    async def _frame_until(self, asked: control_pb2.Steered | control_pb2.FramePushed) -> list[Events]:
        """The events up to a frame, by sensor. Its samples of truth go to self.truth."""
        parts: list[list[Events]] = [[] for _ in self.resolved.sensors]
        sequence = self._subscription.sequence
        while sequence.end_ns() < asked.t_ns:
            if sequence.all_ended():
                raise StreamFault("the stream has ended before the frame")
            if (events := await self._receive()) is not None:
                parts[events.sensor].append(events)
        self.truth = list(self._samples)
        self._samples.clear()
        return [concatenate(part) for part in parts]

    async def _change_sensor(self, sensor: int, change: SensorSettings) -> int:
        message = make_sensor_change(change)
        return (await self._subscription.handle.change_sensor(sensor, message)).t_ns // NS_PER_US

    async def _save(self, path: str | os.PathLike[str], events: Items) -> None:
        saved = Saved(path, events)
        maker = recording_pb2.Recording(lost_events=self.losses.events)
        if self.opened.HasField("id_names"):
            maker.id_names.CopyFrom(self.opened.id_names)
        maker.request.CopyFrom(await self._subscription.handle.describe())
        saved.write(maker, self._suppressed, self._subscription.handle.describe_maker(maker))

    async def _info(self) -> control_pb2.StreamInfo:
        info = await self._subscription.handle.info()
        if info is None:
            raise StreamFault("the server no longer knows the stream")
        return info

    async def _take_picture(self) -> Picture:
        frame = await self._subscription.handle.picture()
        planes = (np.frombuffer(plane, "<f4").reshape(frame.height, frame.width)
                  for plane in (frame.intensity, frame.brightness_change))
        return Picture(frame.t0_ns // NS_PER_US, frame.t1_ns // NS_PER_US, *planes)

    async def _close_all(self) -> None:
        self._subscription.close()
        await self._subscription.handle.close()
        self._subscription.handle.control.close()
