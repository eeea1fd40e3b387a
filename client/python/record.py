# Make the modules once, in the folder you start this from: protoc --python_out=. -I proto proto/saccade/v1/*.proto
import os, sys, zmq, numpy as np
sys.path.insert(0, os.getcwd())
from saccade.v1 import control_pb2 as c, events_pb2 as e

def connect(endpoint):
    socket = zmq.Context.instance().socket(zmq.DEALER)
    socket.connect(endpoint)
    return socket

def ask(**call):
    control.send(c.Request(request_id=1, protocol_version=1, **call).SerializeToString())
    reply = c.Reply.FromString(control.recv())
    assert reply.status.code == c.CODE_OK, f"{reply.status.field}: {reply.status.message}"
    return reply

control = connect(sys.argv[1] if len(sys.argv) > 1 else "tcp://127.0.0.1:5770")
data = connect(ask(server_info=c.ServerInfo()).server_info.data_endpoint)
stream = ask(open_stream=c.OpenStream(
    scene="cornell-box", trajectory=c.Trajectory(name="right"), view=c.View(width=64, height=48),
    timing=c.Timing(frame_rate_hz=500, duration_s=0.1), sensors=[c.Sensor(threshold=0.2, bias=1e-3)],
    delivery=c.DELIVERY_LOSSLESS)).open_stream
data.send(e.DataRequest(attach=e.Attach(stream_id=stream.stream_id, token=stream.token)).SerializeToString())
data.send(e.DataRequest(credit=e.Credit(bytes=4 << 20)).SerializeToString())
while True:
    head, payload = data.recv_multipart(copy=False)
    h = e.PacketHeader.FromString(head.bytes)
    if h.kind == e.KIND_ERROR: sys.exit(payload.bytes.decode())
    if h.kind == e.KIND_END: break
    if h.kind != e.KIND_EVENTS: continue
    data.send(e.DataRequest(credit=e.Credit(bytes=len(head) + len(payload))).SerializeToString())
    n, b = h.count, payload.buffer  # the columns, where they lie
    t = h.t0_ns + np.frombuffer(b, "<u4", n).astype(np.int64) * h.dt_unit_ns
    x, y = np.frombuffer(b, "<u2", n, 4 * n), np.frombuffer(b, "<u2", n, 6 * n)
    p = np.frombuffer(b, "u1", n, 8 * n)
    if n: print(f"{n} events from {t[0] / 1e9:.6f} s, {p.sum()} of them ON, mean x {x.mean():.1f}, y {y.mean():.1f}")
print(f"{h.first_event_index} events in {h.t1_ns / 1e9} s")
ask(close_stream=c.CloseStream(stream_id=stream.stream_id, token=stream.token))
