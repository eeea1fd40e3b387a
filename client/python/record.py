# A whole client. Make its modules once: protoc --python_out=. -I proto proto/saccade/v1/*.proto
# Then: PYTHONPATH=. python3 client/python/record.py [CONTROL_PORT DATA_PORT [SECRET_KEY_FILE SERVER_PUBLIC_KEY_FILE]]
import sys, zmq, numpy as np, saccade.v1.control_pb2 as c, saccade.v1.events_pb2 as e

control, data = (zmq.Context.instance().socket(zmq.DEALER) for _ in range(2))
for s, port in zip((control, data), sys.argv[1:3] or (5770, 5771)):
    if keys := [open(file, "rb").read().strip() for file in sys.argv[3:]]:  # for a server that wants them
        s.curve_secretkey, s.curve_publickey, s.curve_serverkey = keys[0], zmq.curve_public(keys[0]), keys[1]
    s.rcvhwm = 0  # credit bounds what waits
    s.connect(f"tcp://127.0.0.1:{port}")
control.send(c.Request(protocol_version=1, open_stream=c.OpenStream(
    scene="cornell-box", trajectory=dict(name="right"), view=dict(width=64, height=48),
    timing=dict(frame_rate_hz=500, duration_s=0.1), sensors=[dict(threshold=0.2)])).SerializeToString())
if (reply := c.Reply.FromString(control.recv())).status.code != c.CODE_OK: sys.exit(str(reply.status))
stream = reply.open_stream
data.send(e.DataRequest(attach=dict(stream_id=stream.stream_id, token=stream.token)).SerializeToString())
data.send(e.DataRequest(credit=dict(bytes=4 << 20)).SerializeToString())
while (h := e.PacketHeader.FromString(data.recv())).kind not in (e.KIND_END, e.KIND_ERROR):
    # The columns, where they lie in the payload. An event's time is h.t0_ns + dt * h.dt_unit_ns.
    dt, (x, y), p = np.ndarray((), f"({h.count},)<u4, (2,{h.count})<u2, ({h.count},)u1", data.recv())[()]
    data.send(e.DataRequest(credit=dict(bytes=h.ByteSize() + 9 * h.count)).SerializeToString())
    if h.count: print(f"{h.count} events from {h.t0_ns} ns + {dt[0]} us, at {x[0]},{y[0]}; {p.sum()} ON")
sys.exit(data.recv().decode() or None)  # an ERROR says why, an END says nothing
