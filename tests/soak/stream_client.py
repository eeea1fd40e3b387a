"""A client that believes nothing: counts what it receives, and what is missing without a word."""
import itertools, zlib
import zmq
from saccade.v1 import control_pb2 as c, events_pb2 as e

CREDIT = 1 << 20


class Refused(Exception):
    pass


class Link:
    """Endpoints of a server, and the keys to it; none where it works without."""

    def __init__(self, control, http, secret=b"", server_key=b""):
        self.control, self.http, self.secret, self.server_key = control, http, secret, server_key
        self.known_topics = []  # of a stream that others may listen to
        info = self.call(zmq.Context.instance(), server_info=c.ServerInfo()).server_info
        self.data, self.broadcast = info.data_endpoint, info.broadcast_endpoint

    def connect(self, context, kind, endpoint, topics=(), name=b""):
        socket = context.socket(kind)
        socket.linger, socket.rcvtimeo, socket.heartbeat_ivl = 0, 20_000, 2000
        socket.rcvhwm = 0  # see proto/PROTOCOL.md, Credit
        if name: socket.routing_id = name
        if self.secret:
            socket.curve_secretkey, socket.curve_publickey = self.secret, zmq.curve_public(self.secret)
            socket.curve_serverkey = self.server_key
        for topic in topics: socket.subscribe(topic)
        socket.connect(endpoint)
        return socket

    def call(self, context, **what):
        with self.connect(context, zmq.DEALER, self.control) as socket:
            socket.send(c.Request(request_id=7, protocol_version=1, **what).SerializeToString())
            reply = c.Reply.FromString(socket.recv())
        if reply.status.code != c.CODE_OK: raise Refused(reply.status)
        return reply


class Tally:
    """Received packets, and those that were not: dropped (told by dropped_before), missed (a gap of seq in a broadcast,
    whose subscriber was too slow), lost (a gap where there must be none)."""

    def __init__(self):
        self.packets = self.events = self.dropped = self.missed = self.lost = self.faults = self.heartbeats = self.snapshots = 0
        self.suppressed = 0

    def __iadd__(self, other):
        for name, value in vars(other).items(): setattr(self, name, getattr(self, name) + value)
        return self

    def __str__(self):
        return ", ".join(f"{value} {name}" for name, value in vars(self).items())


class Stream:
    def __init__(self, link, request):
        self.link, self.context, self.tally, self.due, self.ended = link, zmq.Context(), Tally(), {}, 0
        self.opened = link.call(self.context, open_stream=request).open_stream
        self.sensors = len(request.sensors)
        self.broadcast = request.delivery == c.DELIVERY_BROADCAST
        if self.broadcast:
            self.socket = link.connect(self.context, zmq.SUB, link.broadcast, self.opened.topics)
            return
        self.socket = link.connect(self.context, zmq.DEALER, link.data)
        self.say(attach=dict(stream_id=self.opened.stream_id, token=self.opened.token))

    def say(self, **what):
        self.socket.send(e.DataRequest(**what).SerializeToString())

    def give(self, count):
        self.say(credit=dict(bytes=count))

    def receive(self, give_back=True):
        """One packet; False where none came in time."""
        try:
            head, payload = self.socket.recv_multipart()[-2:]
        except zmq.Again:
            return False
        header = e.PacketHeader.FromString(head)
        if header.kind == e.KIND_HEARTBEAT:
            self.tally.heartbeats += 1
            return True
        if header.kind == e.KIND_ERROR: raise Refused(payload.decode())
        if give_back and not self.broadcast:
            self.give(len(head) + len(payload))
            self.say(ack=dict(sensor=header.sensor, seq=header.seq))
        self.check(header, payload)
        return True

    def check(self, header, payload):
        tally = self.tally
        due_seq, due_event, due_t0 = self.due.get(header.sensor, (0, 0, header.t0_ns))
        gap = header.seq - due_seq
        tally.packets += 1
        tally.events += header.count
        tally.suppressed += header.suppressed
        tally.dropped += header.dropped_before
        untold = gap - header.dropped_before
        tally.missed += untold if self.broadcast else 0
        tally.lost += 0 if self.broadcast else untold
        tally.snapshots += header.kind == e.KIND_SNAPSHOT
        tally.faults += gap < 0 or zlib.crc32(payload) != header.crc32
        tally.faults += gap == 0 and (due_event, due_t0) != (header.first_event_index, header.t0_ns)
        self.due[header.sensor] = header.seq + 1, header.first_event_index + header.count, header.t1_ns
        self.ended += header.kind == e.KIND_END

    def receive_until(self, done):
        for _ in itertools.takewhile(lambda _: not done() and self.ended < self.sensors, itertools.count()):
            if not self.receive(): raise Refused("nothing came for 20 s")

    def info(self):
        streams = self.link.call(self.context, list_streams=c.ListStreams()).list_streams.streams
        return next(s for s in streams if s.stream_id == self.opened.stream_id)

    def vanish(self):
        self.context.destroy(linger=0)

    def close(self):
        try:
            self.link.call(self.context, close_stream=dict(stream_id=self.opened.stream_id, token=self.opened.token))
        finally:
            self.vanish()
