"""Makes the calls that control a running stream."""
from __future__ import annotations

from collections.abc import Sequence

from saccade.values import MOST_U32, check, numbers_of, whole
from saccade.v1 import control_pb2 as c
from saccade.v1.geometry_pb2 import Quaternion, Vector3

POSE = numbers_of("x y z qx qy qz qw, finite numbers", 7)
VELOCITY = numbers_of("vx vy vz wx wy wz, finite numbers", 6)


def make_steer(opened: c.StreamOpened, pose: Sequence[float] | None, velocity: Sequence[float] | None) -> c.Request:
    """Raises ValueError unless one of the two is given, with the right number of values."""
    if (pose is None) == (velocity is None):
        raise ValueError("give a pose or a velocity")
    call = c.Steer(stream_id=opened.stream_id, token=opened.token)
    if pose is not None:
        x, y, z, qx, qy, qz, qw = check("pose", pose, POSE)
        call.pose.CopyFrom(c.CameraPose(position=Vector3(x=x, y=y, z=z),
                                        rotation=Quaternion(x=qx, y=qy, z=qz, w=qw)))
    if velocity is not None:
        x, y, z, wx, wy, wz = check("velocity", velocity, VELOCITY)
        call.velocity.CopyFrom(c.CameraVelocity(linear=Vector3(x=x, y=y, z=z), angular=Vector3(x=wx, y=wy, z=wz)))
    return c.Request(steer=call)


def make_push(opened: c.StreamOpened, intensity: bytes) -> c.Request:
    return c.Request(push_frame=c.PushFrame(stream_id=opened.stream_id, token=opened.token, intensity=intensity))


def make_change(opened: c.StreamOpened, sensor: int, change: c.SensorChange) -> c.Request:
    number = check("sensor", sensor, whole(0, MOST_U32))
    return c.Request(change_sensor=c.ChangeSensor(stream_id=opened.stream_id, token=opened.token, sensor=number,
                                                  change=change))


def make_describe(opened: c.StreamOpened) -> c.Request:
    return c.Request(describe_stream=c.DescribeStream(stream_id=opened.stream_id, token=opened.token))


