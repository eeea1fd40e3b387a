"""A stream that this client has opened."""
from __future__ import annotations

from collections.abc import Sequence

from saccade.errors import StreamFault
from saccade.protocol.connection import BroadcastConnection, Connection
from saccade.protocol.control import DEADLINE_S, Control
from saccade.protocol.opening import OPEN_DEADLINE_S, Opening, Place
from saccade.protocol.servers import Servers
from saccade.protocol.sockets import reachable_endpoint
from saccade.protocol.steering import Objects, make_change, make_describe, make_push, make_steer
from saccade.v1 import control_pb2, recording_pb2, truth_pb2


class StreamHandle:
    def __init__(self, servers: Servers, place: Place, failover_s: float) -> None:
        """failover_s: as in RetryPolicy."""
        self.servers = servers
        self.closed = False
        self._place, self._failover_s = place, failover_s

    @classmethod
    async def open(cls, servers: Servers, request: control_pb2.OpenStream, failover_s: float) -> StreamHandle:
        """On the server with most room. Raises NoAnswer, Refused, or StreamFault for a reply that cannot be."""
        return cls(servers, await Opening(servers, request, None, OPEN_DEADLINE_S, failover_s).run(), failover_s)

    @property
    def opened(self) -> control_pb2.StreamOpened:
        return self._place.opened

    @property
    def control(self) -> Control:
        """Of the server that has the stream."""
        return self._place.control

    @property
    def server_gone(self) -> bool:
        """Whether other streams have found that its server is lost or has restarted."""
        return self.servers.is_gone(self.control.endpoint, self._place.server.epoch)

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
        """Opens the same LOSSLESS request again, on the same server, a restarted or another one, from these events on.

        Raises as open(), and then changes nothing. from_events: and samples.
        """
        request = control_pb2.OpenStream()
        request.CopyFrom(self.opened.resolved)
        firsts = iter(from_events)
        for sensor in request.sensors:
            sensor.from_event = next(firsts)
        for truth in request.truth:
            truth.from_sample = next(firsts)
        self._place = await Opening(self.servers, request, self._place, deadline_s, self._failover_s).run()

    async def connect(self, from_seqs: Sequence[int]) -> Connection | BroadcastConnection:
        """Connects to the stream as its delivery demands. Raises StreamFault if the server announces no endpoint."""
        network, keys = self.control.network, self.control.keys
        server = self._place.server
        announced = server.broadcast_endpoint if self.broadcast else server.data_endpoint
        address = reachable_endpoint(announced, self.control.endpoint)
        try:
            if self.broadcast:
                return BroadcastConnection(network, address, keys, self.opened.topics)
            return await Connection.attach(network, address, keys, self.opened, from_seqs)
        except ValueError as fault:
            raise StreamFault(f"the server announces an endpoint for packets that is none: {fault}") from fault

    async def info(self, deadline_s: float = DEADLINE_S) -> control_pb2.StreamInfo | None:
        """None if the server no longer has the stream."""
        reply = await self.control.call(control_pb2.Request(list_streams=control_pb2.ListStreams()), deadline_s)
        streams = reply.list_streams.streams
        return next((stream for stream in streams if stream.stream_id == self.opened.stream_id), None)

    async def picture(self) -> control_pb2.FramePicture:
        """The newest frame."""
        frame = control_pb2.GetFrame(stream_id=self.opened.stream_id, token=self.opened.token)
        return (await self.control.call(control_pb2.Request(get_frame=frame))).get_frame

    async def steer(self, pose: Sequence[float] | None, velocity: Sequence[float] | None,
                    objects: Objects | None) -> control_pb2.Steered:
        return (await self.control.call(make_steer(self.opened, pose, velocity, objects))).steer

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
        if not self.opened.resolved.timing.steerable:
            del request.objects[:]  # the server keeps no long paths
            request.objects.extend(self.opened.resolved.objects)
        return request

    def describe_maker(self, recording: recording_pb2.Recording) -> dict[str, truth_pb2.TruthInfo]:
        """Fills in who has made the events. Returns the truth channels of the server, by name."""
        recording.bake_digest = self.opened.bake_digest
        recording.server_version = self._place.server.version
        recording.instruction_set = self._place.server.instruction_set
        return {info.name: info for info in self._place.server.truth}

    async def close(self) -> None:
        """Ends the stream at its next frame: the packets up to there still come, and then END. Does not wait."""
        if not self.closed:
            self.closed = True
            await self._place.tell_close()
