"""A stream that this client has opened."""
from __future__ import annotations

from collections.abc import Sequence

from saccade.errors import StreamFault
from saccade.protocol.connection import BroadcastConnection, Connection
from saccade.protocol.control import DEADLINE_S, Control
from saccade.protocol.opened_check import check_opened
from saccade.protocol.sockets import reachable_endpoint
from saccade.protocol.steering import make_change, make_describe, make_push, make_steer
from saccade.v1 import control_pb2, recording_pb2, truth_pb2

OPEN_DEADLINE_S = 600.0  # a large scene takes long to load


class StreamHandle:
    def __init__(self, control: Control) -> None:
        self.control = control
        self.opened = control_pb2.StreamOpened()
        self.closed = False
        self._server = control_pb2.ServerDescription()

    @classmethod
    async def open(cls, control: Control, request: control_pb2.OpenStream) -> StreamHandle:
        """Raises NoAnswer, Refused, or StreamFault for a reply that cannot be."""
        handle = cls(control)
        await handle._open(request, OPEN_DEADLINE_S)
        return handle

    @property
    def broadcast(self) -> bool:
        return self.opened.resolved.delivery == control_pb2.DELIVERY_BROADCAST

    @property
    def own_frames(self) -> bool:
        """Whether only this client knows what the frames of its stream show."""
        return self.opened.resolved.pushed or self.opened.resolved.timing.steerable

    @property
    def lossless(self) -> bool:
        return self.opened.resolved.delivery == control_pb2.DELIVERY_LOSSLESS

    async def reopen(self, from_events: Sequence[int], deadline_s: float) -> None:
        """Opens the same LOSSLESS request again, on the same server or a restarted one, from these events and samples on.

        Raises as open(), and then changes nothing.
        """
        request = control_pb2.OpenStream()
        request.CopyFrom(self.opened.resolved)
        firsts = iter(from_events)
        for sensor in request.sensors:
            sensor.from_event = next(firsts)
        for truth in request.truth:
            truth.from_sample = next(firsts)
        await self._open(request, deadline_s)

    async def _open(self, request: control_pb2.OpenStream, deadline_s: float) -> None:
        # server_info first, with a short deadline: the long one is for a server that is there.
        info = control_pb2.Request(server_info=control_pb2.ServerInfo())
        self._server = (await self.control.call(info, DEADLINE_S)).server_info
        if self.opened.stream_id:
            await self._tell_close()
        reply = await self.control.call(control_pb2.Request(open_stream=request), deadline_s, watch=True)
        check_opened(reply.open_stream, request)
        self.opened = reply.open_stream

    async def connect(self, from_seqs: Sequence[int]) -> Connection | BroadcastConnection:
        """Connects to the stream as its delivery demands. Raises StreamFault if the server announces no endpoint."""
        network, keys = self.control.network, self.control.keys
        announced = self._server.broadcast_endpoint if self.broadcast else self._server.data_endpoint
        address = reachable_endpoint(announced, self.control.endpoint)
        try:
            if self.broadcast:
                return BroadcastConnection(network, address, keys, self.opened.topics)
            return await Connection.attach(network, address, keys, self.opened, from_seqs)
        except ValueError as fault:
            raise StreamFault(f"the server announces an endpoint for packets that is none: {fault}") from fault

    async def info(self) -> control_pb2.StreamInfo | None:
        """None if the server no longer has the stream."""
        reply = await self.control.call(control_pb2.Request(list_streams=control_pb2.ListStreams()))
        streams = reply.list_streams.streams
        return next((stream for stream in streams if stream.stream_id == self.opened.stream_id), None)

    async def picture(self) -> control_pb2.FramePicture:
        """The newest frame."""
        frame = control_pb2.GetFrame(stream_id=self.opened.stream_id, token=self.opened.token)
        return (await self.control.call(control_pb2.Request(get_frame=frame))).get_frame

    async def steer(self, pose: Sequence[float] | None, velocity: Sequence[float] | None) -> control_pb2.Steered:
        return (await self.control.call(make_steer(self.opened, pose, velocity))).steer

    async def push(self, intensity: bytes) -> control_pb2.FramePushed:
        return (await self.control.call(make_push(self.opened, intensity))).push_frame

    async def change_sensor(self, sensor: int, change: control_pb2.SensorChange) -> control_pb2.SensorChanged:
        """Notes the change in `opened`, so that a stream that is opened again has it, too."""
        changed = (await self.control.call(make_change(self.opened, sensor, change))).change_sensor
        change.time_s = changed.t_ns * 1e-9
        changes = self.opened.resolved.sensors[sensor].changes
        changes.append(change)
        changes.sort(key=lambda one: one.time_s)
        return changed

    async def describe(self) -> control_pb2.OpenStream:
        request = (await self.control.call(make_describe(self.opened))).describe_stream.request
        if not request.HasField("trajectory"):
            request.trajectory.CopyFrom(self.opened.resolved.trajectory)
        return request

    def describe_maker(self, recording: recording_pb2.Recording) -> dict[str, truth_pb2.TruthInfo]:
        """Fills in who has made the events. Returns the truth channels of the server, by name."""
        recording.bake_digest = self.opened.bake_digest
        recording.server_version = self._server.version
        recording.instruction_set = self._server.instruction_set
        return {info.name: info for info in self._server.truth}

    async def close(self) -> None:
        """Ends the stream at its next frame: the packets up to there still come, and then END. Does not wait."""
        if not self.closed:
            self.closed = True
            await self._tell_close()

    async def _tell_close(self) -> None:
        close = control_pb2.CloseStream(stream_id=self.opened.stream_id, token=self.opened.token)
        await self.control.tell(control_pb2.Request(close_stream=close))
