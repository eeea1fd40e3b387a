"""A whole client without the package saccade, to see the protocol or to port it: records a short stream and prints it.

Once:  pip install pyzmq numpy protobuf
       protoc --python_out=. -I proto proto/saccade/v1/*.proto
Then:  PYTHONPATH=. python3 bare_client.py [CONTROL_PORT DATA_PORT [SECRET_KEY_FILE SERVER_PUBLIC_KEY_FILE]]
"""
import sys

try:
    import numpy as np
    import zmq
    from saccade.v1 import control_pb2, events_pb2
except ImportError as missing:
    sys.exit(f"{missing}: see the head of this file. It was run by {sys.executable}.")

CREDIT = 4 << 20  # bytes that the server may send ahead
TIMEOUT_MS = 10_000  # heartbeats come every second


def connect(port, keys):
    socket = zmq.Context.instance().socket(zmq.DEALER)
    socket.rcvhwm = 0  # no limit of its own: credit bounds what waits
    socket.linger = 1000
    socket.rcvtimeo = TIMEOUT_MS
    if keys:  # for a server that wants them
        secret, server_public = (open(file, "rb").read().strip() for file in keys)
        socket.curve_secretkey = secret
        socket.curve_publickey = zmq.curve_public(secret)
        socket.curve_serverkey = server_public
    socket.connect(f"tcp://127.0.0.1:{port}")
    return socket


def open_stream(control):
    request = control_pb2.Request(protocol_version=1)
    stream = request.open_stream
    stream.scene = "cornell-box"
    stream.trajectory.name = "right"
    stream.view.width, stream.view.height = 64, 48
    stream.timing.frame_rate_hz = 500
    stream.timing.duration_s = 0.1
    stream.sensors.add().threshold = 0.2
    control.send(request.SerializeToString())
    answer = control.recv_multipart()
    if len(answer) != 1:
        sys.exit("the control port does not answer as one: are the two ports swapped?")
    reply = control_pb2.Reply.FromString(answer[0])
    if reply.status.code != control_pb2.CODE_OK:
        sys.exit(f"{reply.status.field}: {reply.status.message}")
    return reply.open_stream


def attach(data, stream):
    request = events_pb2.DataRequest()
    request.attach.stream_id = stream.stream_id
    request.attach.token = stream.token
    data.send(request.SerializeToString())
    give_credit(data, CREDIT)


def give_credit(data, size):
    request = events_pb2.DataRequest()
    request.credit.bytes = size
    data.send(request.SerializeToString())


def packets(data):
    """Yields the header and the columns of each packet of events."""
    while True:
        head, payload = data.recv_multipart()
        header = events_pb2.PacketHeader.FromString(head)
        if header.kind == events_pb2.KIND_ERROR:
            sys.exit(payload.decode())
        if header.kind == events_pb2.KIND_END:
            return
        give_credit(data, len(head) + len(payload))
        if header.count > 0:
            yield header, *columns(payload, header.count)


def columns(payload, count):
    """The columns of a payload without compression: 9 bytes an event, read in place."""
    dt = np.frombuffer(payload, "<u4", count)
    x = np.frombuffer(payload, "<u2", count, offset=4 * count)
    y = np.frombuffer(payload, "<u2", count, offset=6 * count)
    p = np.frombuffer(payload, "u1", count, offset=8 * count)  # 1 ON, 0 OFF
    return dt, x, y, p


def main():
    control_port, data_port = sys.argv[1:3] or (5770, 5771)
    keys = sys.argv[3:5]
    waiting_for = f"reply from port {control_port}: is saccaded running, is that its control port, has it other keys?"
    try:
        stream = open_stream(connect(control_port, keys))
        waiting_for = f"packet from port {data_port}: is that the data port of saccaded?"
        data = connect(data_port, keys)
        attach(data, stream)
        for header, dt, x, y, p in packets(data):
            first_ns = header.t0_ns + int(dt[0]) * header.dt_unit_ns
            print(f"{header.count} events from {first_ns} ns on, the first at {x[0]},{y[0]}; {p.sum()} are ON")
    except zmq.Again:
        sys.exit(f"no {waiting_for}")


if __name__ == "__main__":
    main()
