"""Makes the calls that control a running stream."""
from __future__ import annotations

from collections.abc import Mapping, Sequence

from saccade.values import MOST_U32, check, numbers_of, whole
from saccade.v1 import control_pb2 as c
from saccade.v1.geometry_pb2 import Quaternion, Vector3

POSE = numbers_of("x y z qx qy qz qw, finite numbers", 7)
VELOCITY = numbers_of("vx vy vz wx wy wz, finite numbers", 6)


Objects = Mapping[str, Sequence[float]]


def make_steer(opened: c.StreamOpened, pose: Sequence[float] | None, velocity: Sequence[float] | None,
               objects: Objects | None) -> c.Request:
    """Raises ValueError unless there is something to steer, with the right number of values."""
    if pose is not None and velocity is not None or pose is None and velocity is None and not objects:
        raise ValueError("give a pose or a velocity, or poses of objects")
    call = c.Steer(stream_id=opened.stream_id, token=opened.token)
    if pose is not None:
        call.pose.CopyFrom(_pose("pose", pose))
    for name, of_object in (objects or {}).items():
        call.objects.add(name=name, pose=_pose(f"objects.{name}", of_object))
    if velocity is not None:
        x, y, z, wx, wy, wz = check("velocity", velocity, VELOCITY)
        call.velocity.CopyFrom(c.CameraVelocity(linear=Vector3(x=x, y=y, z=z), angular=Vector3(x=wx, y=wy, z=wz)))
    return c.Request(steer=call)


def _pose(name: str, pose: Sequence[float]) -> c.CameraPose:
    x, y, z, qx, qy, qz, qw = check(name, pose, POSE)
    return c.CameraPose(position=Vector3(x=x, y=y, z=z), rotation=Quaternion(x=qx, y=qy, z=qz, w=qw))


def make_push(opened: c.StreamOpened, intensity: bytes) -> c.Request:
    return c.Request(push_frame=c.PushFrame(stream_id=opened.stream_id, token=opened.token, intensity=intensity))


def make_change(opened: c.StreamOpened, sensor: int, change: c.SensorChange) -> c.Request:
    number = check("sensor", sensor, whole(0, MOST_U32))
    return c.Request(change_sensor=c.ChangeSensor(stream_id=opened.stream_id, token=opened.token, sensor=number,
                                                  change=change))


def make_describe(opened: c.StreamOpened) -> c.Request:
    return c.Request(describe_stream=c.DescribeStream(stream_id=opened.stream_id, token=opened.token))


