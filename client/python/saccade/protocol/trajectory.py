"""Makes the Trajectory message from the settings `trajectory` and `motion`."""
from __future__ import annotations

import math
import os
import pathlib
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.v1 import control_pb2 as c
from saccade.v1.geometry_pb2 import Quaternion, RigidTransform, Vector3

POSE_FILES = (".csv", ".txt")


def make_trajectory(settings: Mapping[str, Any]) -> c.Trajectory:
    """Of checked settings.

    Raises ValueError for a faulty one, TypeError for none or two, and OSError for a file that cannot be read.
    """
    if ("trajectory" in settings) == ("motion" in settings):
        raise TypeError("give either trajectory or motion")
    moving = ":" in settings.get("motion", "")
    for name in ("turn_s", "motion_seed", "start"):
        if name in settings and not moving:
            raise TypeError(f"{name} goes with a motion KIND:SPEED, such as 'pan:-15'")
    if "clearance" in settings and not settings.get("motion", "").startswith("roam:"):
        raise TypeError("clearance goes with a motion roam:SPEED, such as 'roam:1px'")
    if moving:
        return c.Trajectory(motion=_motion(settings))
    if "motion" in settings:
        return c.Trajectory(name=settings["motion"])
    path = settings["trajectory"]
    if not isinstance(path, (str, os.PathLike)):
        return c.Trajectory(keyframes=make_keyframes(path))
    if isinstance(path, str) and not path.endswith(POSE_FILES):
        return c.Trajectory(name=path)
    return c.Trajectory(csv=read_poses("trajectory", path))


def read_poses(setting: str, path: str | os.PathLike[str]) -> str:
    """The text of a file. Raises OSError, and ValueError for one that is no text."""
    try:
        return pathlib.Path(path).read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise ValueError(f"{setting}: {os.fspath(path)} is not a text of poses") from None


def _motion(settings: Mapping[str, Any]) -> c.Motion:
    kind, _, speed = settings["motion"].partition(":")
    prefix = "MOTION_KIND_"
    known = {name.removeprefix(prefix).lower(): value for name, value in c.MotionKind.items() if value != 0}
    if kind not in known:
        raise ValueError(f"motion: '{kind}' is not one of {', '.join(known)}")
    motion = c.Motion(kind=known[kind], seed=settings.get("motion_seed", 0))
    try:
        number = float(speed.removesuffix("px"))
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise ValueError(f"motion: '{settings['motion']}' is not KIND:SPEED, such as 'pan:-15'")
    if speed.endswith("px"):
        motion.px_per_frame = number
    else:
        motion.speed = number
    if "turn_s" in settings:
        motion.turn_s = settings["turn_s"]
    if "clearance" in settings:
        motion.clearance = settings["clearance"]
    if "start" in settings:
        motion.start.CopyFrom(_pose(settings["start"]))
    return motion


def _pose(numbers: list[float]) -> RigidTransform:
    """Of x y z, which sets no rotation, or x y z qx qy qz qw."""
    rotation = Quaternion(**dict(zip("xyzw", numbers[3:]))) if len(numbers) > 3 else None
    return RigidTransform(position=Vector3(**dict(zip("xyz", numbers))), rotation=rotation)


def make_keyframes(poses: NDArray[np.float64]) -> c.Keyframes:
    """Of poses (n, 8)."""
    rows: Any = poses.tolist()  # lists of eight floats; stubs of numpy do not know how deep
    return c.Keyframes(keys=[c.Keyframe(time_s=row[0], position=Vector3(x=row[1], y=row[2], z=row[3]),
                                        rotation=Quaternion(x=row[4], y=row[5], z=row[6], w=row[7])) for row in rows])
