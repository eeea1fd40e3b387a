"""Visitors who mean harm, each for a moment and within bounds: they must cost nobody else a packet. What they are
answered, or whether, is of no interest."""
import contextlib, random, struct, time
import zmq

import raw
from saccade.v1 import control_pb2 as c, events_pb2 as e
from stream_client import Tally
from visitors import request

STAY_S = 3


@contextlib.contextmanager
def peer(link, kind, endpoint):
    context = zmq.Context()
    try:
        socket = link.connect(context, kind, endpoint)
        socket.sndtimeo = socket.rcvtimeo = STAY_S * 1000
        yield socket
    finally:
        context.destroy(linger=500)


def ask(socket, number=1, **call):
    socket.send(c.Request(request_id=number, protocol_version=1, **call).SerializeToString())


def self_named(link, draw):
    """Names itself as ZeroMQ may name the next one, and asks for the packets of whoever had that name."""
    first = draw.choice([0x6b8b4567, 0xe43c9869]) + draw.randrange(2000)
    context = zmq.Context()
    for i in range(20):
        name = b"\0" + struct.pack(">I", (first + i) % 2**32)
        data, control = (link.connect(context, zmq.DEALER, end, name=name) for end in (link.data, link.control))
        data.send(e.DataRequest(credit=dict(bytes=1 << 20)).SerializeToString())
        ask(control, list_scenes=c.ListScenes())
    time.sleep(STAY_S)
    context.destroy(linger=0)


def user_messages(link, draw):
    """Messages on the broadcast socket that are no subscriptions, with subscriptions among them."""
    with peer(link, zmq.XSUB, link.broadcast) as socket:
        for i in range(5000): socket.send(b"\2" if i % 10 else b"\1s/" + draw.randbytes(8).hex().encode() + b"/0/")


def unsubscriber(link, draw):
    """Takes back what others have subscribed."""
    with peer(link, zmq.XSUB, link.broadcast) as socket:
        for _ in range(10):
            for topic in link.known_topics: socket.send(b"\0" + topic.encode())
        time.sleep(STAY_S)


def many_topics(link, draw):
    with peer(link, zmq.SUB, link.broadcast) as socket:
        for _ in range(5000): socket.subscribe(draw.randbytes(200))
        time.sleep(1)


def parse_bomb(link, draw):
    """A million sensors of two bytes each."""
    bomb = c.Request(request_id=1, protocol_version=1).SerializeToString()
    sensors = b"\x3a\0" * 1_000_000
    with peer(link, zmq.DEALER, link.control) as socket:
        socket.send(bomb + b"\x5a" + length(len(sensors)) + sensors)
        socket.recv()


def length(count):
    """A number as Protobuf writes it."""
    text = b""
    while count > 127: text, count = text + bytes([count & 127 | 128]), count >> 7
    return text + bytes([count])


def unread_replies(link, draw):
    with peer(link, zmq.DEALER, link.control) as socket:
        socket.rcvhwm = 1
        for i in range(300): ask(socket, i, server_info=c.ServerInfo())
        for i in range(20): ask(socket, i, close_stream=dict(stream_id="x" * 200_000))
        time.sleep(STAY_S)


def unread_pictures(link, draw):
    with peer(link, zmq.DEALER, link.control) as socket:
        opened = opened_by(socket, request(c.DELIVERY_LIVE, 1, duration_s=0.01))
        for i in range(50): ask(socket, i, get_frame=opened)
        time.sleep(STAY_S)


def ack_flood(link, draw):
    with peer(link, zmq.DEALER, link.control) as control, peer(link, zmq.DEALER, link.data) as data:
        opened = opened_by(control, request(c.DELIVERY_LOSSLESS, 1, duration_s=1))
        data.send(e.DataRequest(attach=opened).SerializeToString())
        data.send(e.DataRequest(credit=dict(bytes=1 << 20)).SerializeToString())
        for i in range(20_000): data.send(e.DataRequest(ack=dict(sensor=i % 2, seq=draw.randrange(100))).SerializeToString())


def opened_by(socket, what):
    ask(socket, 7, open_stream=what)
    opened = c.Reply.FromString(socket.recv()).open_stream
    return dict(stream_id=opened.stream_id, token=opened.token)


def abandoned_open(link, draw):
    """Asks for frames that take minutes each, and goes."""
    heavy = request(c.DELIVERY_LOSSLESS, draw.getrandbits(32))
    heavy.view.width = heavy.view.height = 128
    heavy.method.spp, heavy.quality.bounces = 1024, 8
    with peer(link, zmq.DEALER, link.control) as socket:
        ask(socket, open_stream=heavy)
        time.sleep(1)


def event_bomb(link, draw):
    """A sensor that fires at anything."""
    bomb = request(c.DELIVERY_LIVE, 1, duration_s=0.05)
    del bomb.sensors[1:]
    bomb.sensors[0].threshold, bomb.sensors[0].bias, bomb.sensors[0].max_events_per_pixel_frame = 1e-3, 1e-12, 65536
    with peer(link, zmq.DEALER, link.control) as control, peer(link, zmq.DEALER, link.data) as data:
        opened = opened_by(control, bomb)
        data.send(e.DataRequest(attach=opened).SerializeToString())
        time.sleep(STAY_S)
        ask(control, close_stream=opened)
        control.recv()


def trickling_http(link, draw):
    sockets = [raw.connect(link.http) for _ in range(16)]
    for socket in sockets: socket.sendall(b"POST /metrics HTTP/1.1\r\nContent-Length: 999999999\r\n\r\n")
    end = time.monotonic() + STAY_S
    while time.monotonic() < end:
        for socket in sockets: socket.send(b"x")
        time.sleep(0.1)


def silent(link, draw):
    """Connects everywhere and says nothing, or half a greeting."""
    ends = [raw.connect(end) for end in (link.control, link.data, link.broadcast, link.http) for _ in range(5)]
    for end in ends: end.sendall(raw.GREETING[:draw.randrange(len(raw.GREETING))])
    time.sleep(STAY_S)


def garbage(link, draw):
    """Greetings and handshakes with some bytes changed."""
    for _ in range(200):
        end = raw.connect(draw.choice((link.control, link.data, link.broadcast)))
        says = bytearray(raw.GREETING + raw.ready())
        for _ in range(draw.randrange(1, 9)): says[draw.randrange(len(says))] = draw.randrange(256)
        end.sendall(says[:64])
        end.settimeout(0.01)
        with contextlib.suppress(TimeoutError): end.recv(64)
        end.sendall(says[64:])
        end.close()


# Those below reach only a server without keys.
def endless_multipart(link, draw):
    end = raw.shake_hands(draw.choice((link.control, link.data)))
    for _ in range(64): end.sendall(raw.part(b"\2" * 60_000, more=True) * 4)


def endless_subscription(link, draw):
    end = raw.shake_hands(link.broadcast, b"SUB")
    for _ in range(64): end.sendall(raw.part(b"\2" * 250, more=True) * 400)


def much_metadata(link, draw):
    properties = b"".join(raw.property_(draw.randbytes(3).hex().encode(), b"") for _ in range(100_000))
    raw.shake_hands(link.control, properties=properties)
    time.sleep(1)


ANYWHERE = [self_named, user_messages, unsubscriber, many_topics, parse_bomb, unread_replies, unread_pictures, ack_flood,
            abandoned_open, event_bomb, trickling_http, silent, garbage]
WITHOUT_KEYS = [endless_multipart, endless_subscription, much_metadata]


def visit(kind, link, seed):
    with contextlib.suppress(OSError, zmq.ZMQError): kind(link, random.Random(seed))
    return Tally()
