"""The server's two sockets, played by a test, and packets to send from them."""
import threading
import zlib

import numpy as np
import zmq

from saccade.v1 import control_pb2, events_pb2

TIMEOUT_MS = 10_000
MS = 1_000_000  # ns


def payload_of(dt, x, y, p):
    columns = ((dt, "<u4"), (x, "<u2"), (y, "<u2"), (p, "u1"))
    return b"".join(np.asarray(column, dtype).tobytes() for column, dtype in columns)


def packet(stream, seq, first_event, t0_ns, t1_ns, payload=b"", **fields):
    """Header and payload; of KIND_EVENTS unless `fields` say otherwise."""
    return events_pb2.PacketHeader(**{
        "stream_id": stream, "seq": seq, "first_event_index": first_event, "t0_ns": t0_ns, "t1_ns": t1_ns,
        "count": len(payload) // 9, "dt_unit_ns": 1000, "layout": events_pb2.LAYOUT_COLUMNS,
        "codec": events_pb2.CODEC_NONE, "kind": events_pb2.KIND_EVENTS, "width": 346, "height": 260,
        "crc32": zlib.crc32(payload), "frame": t0_ns // MS, **fields}), payload


def packets_of(stream, until_ms=20, reason=events_pb2.END_REASON_FINISHED):
    """A stream of 1000 frames per second: an event and a withheld one each ms, cut every 5 ms; then END."""
    packets = []
    for t0 in range(0, until_ms, 5):
        times = range(t0, min(t0 + 5, until_ms))
        payload = payload_of([(t - t0) * 1000 for t in times], list(times), [2] * len(times), [1] * len(times))
        packets.append(packet(stream, len(packets), t0, t0 * MS, (times[-1] + 1) * MS, payload, suppressed=len(times)))
    packets.append(packet(stream, len(packets), until_ms, until_ms * MS, until_ms * MS, kind=events_pb2.KIND_END,
                          end_reason=reason))
    return packets


class Peer:
    """A ROUTER on a free port. Speaks to whoever spoke last."""

    def __init__(self, kind=zmq.ROUTER):
        self.socket = zmq.Context.instance().socket(kind)
        self.socket.linger, self.socket.rcvtimeo, self.socket.sndhwm = 0, TIMEOUT_MS, 0
        self.socket.bind("tcp://127.0.0.1:*")
        self.endpoint = self.socket.last_endpoint.decode()
        self.name = b""

    def receive(self, kind):
        self.name, body = self.socket.recv_multipart()
        return kind.FromString(body)

    def send(self, *parts):
        self.socket.send_multipart([self.name, *parts])

    def send_packet(self, header, payload):
        self.send(header.SerializeToString(), payload)


class FakeServer:
    """frames: of its streams. frames_done: those that list_streams tells; None: it knows of no stream.

    described: what server_info tells, besides its endpoints.
    """

    def __init__(self, frames=20, frames_done=None, **described):
        self.control, self.data, self.broadcast = Peer(), Peer(), Peer(zmq.XPUB)
        self.frames, self.frames_done, self.described, self.fault = frames, frames_done, described, None

    def answer(self, request, **result):
        status = control_pb2.Status(code=control_pb2.CODE_OK)
        reply = control_pb2.Reply(request_id=request.request_id, status=status, **result)
        self.control.send(reply.SerializeToString())

    def open(self, stream, epoch=0, lie=lambda opened: None):
        """Answers what is asked until a stream is opened, as `stream`. Returns its OpenStream.

        lie: changes the reply.
        """
        while (request := self.answer_next(stream, epoch, lie)) is None:
            pass
        return request

    def answer_next(self, stream, epoch=0, lie=lambda opened: None):
        """Answers one request. Returns the OpenStream where it was one."""
        request = self.control.receive(control_pb2.Request)
        call = request.WhichOneof("call")
        if call == "server_info":
            self.answer(request, server_info=control_pb2.ServerDescription(
                data_endpoint=self.data.endpoint, broadcast_endpoint=self.broadcast.endpoint, **self.described))
        elif call == "list_streams":
            self.list_streams(request)
        elif call == "open_stream":
            opened = control_pb2.StreamOpened(stream_id=stream, token="t", frames=self.frames, epoch=epoch,
                                              topics=[f"s/{stream}/0/"], resolved=request.open_stream)
            lie(opened)
            self.answer(request, open_stream=opened)
            return request.open_stream
        return None

    def refuse(self, request, code, **status):
        status = control_pb2.Status(code=code, **status)
        self.control.send(control_pb2.Reply(request_id=request.request_id, status=status).SerializeToString())

    def list_streams(self, request):
        infos = [control_pb2.StreamInfo(stream_id="s1", frames_done=self.frames_done)]
        self.answer(request, list_streams=control_pb2.StreamList(streams=infos if self.frames_done is not None else []))

    def attached(self):
        """The next Attach; other requests of the data socket are left out."""
        while True:
            request = self.data.receive(events_pb2.DataRequest)
            if request.HasField("attach"):
                return request.attach

    def send(self, packets, peer=None):
        for header, payload in packets:
            (peer or self.data).send_packet(header, payload)

    def publish(self, packets):
        """To the subscriber of a broadcast, once it is there."""
        self.broadcast.name = self.broadcast.name or self.broadcast.socket.recv()[1:]  # its topic
        self.send(packets, self.broadcast)

    def run(self, script):
        """Runs script(self) in a thread; join() raises what it raises."""
        def target():
            try:
                script(self)
            except BaseException as fault:  # pylint: disable=broad-except
                self.fault = fault
        self.thread = threading.Thread(target=target)
        self.thread.start()

    def join(self):
        self.thread.join()
        self.control.socket.close()
        self.data.socket.close()
        self.broadcast.socket.close()
        if self.fault:
            raise self.fault
