"""Makes the calls that control a running stream."""
from __future__ import annotations

from collections.abc import Sequence

from saccade.v1 import control_pb2 as c
from saccade.v1.geometry_pb2 import Quaternion, Vector3


def make_steer(opened: c.StreamOpened, pose: Sequence[float] | None, velocity: Sequence[float] | None) -> c.Request:
    """Raises ValueError unless one of the two is given, with the right number of values."""
    if (pose is None) == (velocity is None):
        raise ValueError("give a pose or a velocity")
    call = c.Steer(stream_id=opened.stream_id, token=opened.token)
    if pose is not None:
        x, y, z, qx, qy, qz, qw = _numbers("pose", pose, 7)
        call.pose.CopyFrom(c.CameraPose(position=Vector3(x=x, y=y, z=z),
                                        rotation=Quaternion(x=qx, y=qy, z=qz, w=qw)))
    if velocity is not None:
        x, y, z, wx, wy, wz = _numbers("velocity", velocity, 6)
        call.velocity.CopyFrom(c.CameraVelocity(linear=Vector3(x=x, y=y, z=z), angular=Vector3(x=wx, y=wy, z=wz)))
    return c.Request(steer=call)


def make_push(opened: c.StreamOpened, intensity: bytes) -> c.Request:
    return c.Request(push_frame=c.PushFrame(stream_id=opened.stream_id, token=opened.token, intensity=intensity))


def make_change(opened: c.StreamOpened, sensor: int, change: c.SensorChange) -> c.Request:
    return c.Request(change_sensor=c.ChangeSensor(stream_id=opened.stream_id, token=opened.token, sensor=sensor,
                                                  change=change))


def make_describe(opened: c.StreamOpened) -> c.Request:
    return c.Request(describe_stream=c.DescribeStream(stream_id=opened.stream_id, token=opened.token))


def _numbers(name: str, values: Sequence[float], count: int) -> list[float]:
    numbers = [float(value) for value in values]
    if len(numbers) != count:
        raise ValueError(f"a {name} has {count} values, not {len(numbers)}")
    return numbers
