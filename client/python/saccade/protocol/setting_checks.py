"""What each setting of a stream may be."""
from __future__ import annotations

import operator
import os
from collections.abc import Mapping
from typing import Any

import numpy as np

from saccade import rigid
from saccade.camera import Camera
from saccade.protocol.trajectory import POSE_FILES
from saccade.values import (MOST_U32, MOST_U64, Check, Invalid, amounts, check, flag, items, number,
                                     numbers_of, one_of, positive, several, text, whole)
from saccade.v1 import control_pb2 as c
from saccade.v1 import events_pb2, noise_pb2

IMU_NOISE = ("accelerometer_noise", "gyroscope_noise", "accelerometer_walk", "gyroscope_walk")
TRUTH = "the name of a truth channel, or (name, n) for every n-th frame, or a list of these"
TRAJECTORY = "a name of Client.scenes(), the path of a file of poses, or poses: float (n, 8), t x y z qx qy qz qw"
OWN, STILL = "own", "still"  # paths of objects
OBJECT = ("KIND:SPEED such as 'spin:90', 'own', 'still', the path of a file of poses, or poses: float (n, 8), "
          "t x y z qx qy qz qw")
PLACE = "a matrix (4, 4), or x y z, or x y z qx qy qz qw"
COEFFICIENTS = {"radtan": (4, 5), "equidistant": (4,)}


def size(value: Any) -> tuple[int, int]:
    try:
        width, height = map(operator.index, value)
        if width > 0 and height > 0 and not isinstance(value, (str, bytes)):
            return width, height
    except (TypeError, ValueError):
        pass
    raise Invalid(value, "(width, height), whole numbers from 1 on")


def per_sensor(value: Any) -> float | list[float]:
    """A sequence stands for one sensor per item."""
    valid = "a finite number, or a list of one for each sensor"
    if isinstance(value, (list, tuple, np.ndarray)) and len(value) > 0:
        return [number(item, valid) for item in items(value, valid)]
    return number(value, valid)


def distortion(value: Any) -> c.Distortion:
    valid = "('radtan', (k1, k2, p1, p2)), with k3 or not, or ('equidistant', (k1, k2, k3, k4))"
    pair = items(value, valid)
    if len(pair) != 2 or not isinstance(pair[0], str) or pair[0] not in COEFFICIENTS:
        raise Invalid(value, valid)
    numbers = numbers_of(valid, *COEFFICIENTS[pair[0]])(pair[1])
    return c.Distortion(model=one_of(c.DistortionModel)(pair[0]), coefficients=numbers)


def place(value: Any) -> rigid.Matrix:
    try:
        return rigid.from_numbers(value)
    except (TypeError, ValueError) as fault:
        why = f" ({fault})" if isinstance(fault, ValueError) else ""
        raise Invalid(value, PLACE + why) from None


def truth(value: Any) -> list[tuple[str, int]]:
    """Channels, and of how many frames they show one."""
    return [_channel(channel) for channel in ([value] if _is_channel(value) else items(value, TRUTH))]


def _is_channel(value: Any) -> bool:
    pair = isinstance(value, tuple) and len(value) == 2 and not isinstance(value[1], (str, tuple, list))
    return isinstance(value, str) or pair and isinstance(value[0], str)


def _channel(value: Any) -> tuple[str, int]:
    if not _is_channel(value):
        raise Invalid(value, TRUTH)
    name, every = (value, 1) if isinstance(value, str) else value
    return text(TRUTH)(name), whole(1, MOST_U32)(every)


def trajectory(value: Any) -> Any:
    return value if isinstance(value, (str, os.PathLike)) else _poses(value, TRAJECTORY)


def _poses(value: Any, valid: str) -> Any:
    try:
        poses = np.asarray(value, np.float64)
    except (TypeError, ValueError):
        raise Invalid(value, valid) from None
    if poses.ndim != 2 or poses.shape[1] != 8 or len(poses) == 0 or not np.isfinite(poses).all():
        raise Invalid(value, valid)
    return poses


def objects(value: Any) -> dict[str, Any]:
    """Paths by name: an ObjectSpeed, the path of a file, or poses."""
    if not isinstance(value, Mapping):
        raise Invalid(value, "paths by the name of an object, such as {'bunny': 'spin:90'}")
    return {text("the name of an object")(name): _object_path(name, path) for name, path in value.items()}


def _object_path(name: str, value: Any) -> Any:
    try:
        if isinstance(value, os.PathLike) or isinstance(value, str) and value.endswith(POSE_FILES):
            return value
        if isinstance(value, str) and value in (OWN, STILL):
            return value
        return _object_speed(value) if isinstance(value, str) else _poses(value, OBJECT)
    except Invalid as wrong:
        raise Invalid(wrong.value, wrong.valid, f".{name}") from None


def _object_speed(value: str) -> c.ObjectSpeed:
    kind, _, speed = value.partition(":")
    try:
        return c.ObjectSpeed(kind=one_of(c.ObjectMotionKind)(kind), speed=number(float(speed)))
    except (ValueError, Invalid):
        kinds = ", ".join(word.removeprefix("OBJECT_MOTION_KIND_").lower() for word in c.ObjectMotionKind.keys()[1:])
        raise Invalid(value, f"{OBJECT}; KIND is one of {kinds}") from None


def calibration(value: Any) -> Any:
    if isinstance(value, (str, os.PathLike, Camera)):
        return value
    raise Invalid(value, "the path of a calibration, or a saccade.Camera")


count = whole(1, MOST_U32)
OF_SENSORS: dict[str, Check] = {name: per_sensor for name in ("threshold", "threshold_off", "bias", "refractory_s",
                                                              "cutoff_hz")}
SETTINGS: dict[str, Check] = {
    **OF_SENSORS, "size": size, "distortion": distortion, "truth": truth, "trajectory": trajectory, "objects": objects,
    "calibration": calibration, "T_body_camera": place, "further_views": several(f"a list of {PLACE}", place),
    "scene": text("the name of a scene, one of Client.scenes()"),
    "animation": text("the name of an animation, one of the scene in Client.scenes()"), "method": text("the name of a method"),
    "motion": text("KIND:SPEED such as 'pan:-15', or a name such as 'right'"), "preset": text("the name of a camera"),
    "disable": several("a list of scene features", text("the name of a scene feature")),
    "intrinsics": numbers_of("(fx, fy, cx, cy), finite numbers", 4),
    "start": numbers_of("x y z, or x y z qx qy qz qw, finite numbers", 3, 7),
    "gravity": numbers_of("(x, y, z), finite numbers", 3),
    "noise": amounts("amounts by name, such as {'leak_hz': 0.1}", list(noise_pb2.Noise.DESCRIPTOR.fields_by_name)),
    "imu_noise": amounts("amounts by name, such as {'gyroscope_noise': 1e-3}", IMU_NOISE),
    "params": amounts("numbers by the name of a parameter, such as {'alpha': 0.2}"),
    "clock": one_of(c.Clock), "delivery": one_of(c.Delivery), "codec": one_of(events_pb2.Codec),
    "model": one_of(c.EventModel), "start_level": one_of(c.StartLevel),
    "reconstruction": one_of(c.Reconstruction),
    **dict.fromkeys(("pushed", "steerable", "packet_per_frame", "until_path_ends", "labels", "object_ids", "jitter",
                     "monochrome"),
                    flag),
    **dict.fromkeys(("interval_px", "max_rate_hz", "finest_px", "turn_s", "clearance", "duration_s", "fov_x_deg",
                     "max_artefact_odds", "bake_error", "budget_ms", "max_false_rate", "max_event_change", "metres_per_unit"), number),
    **dict.fromkeys(("rate_hz", "speed", "imu_rate_hz"), positive), "seed": whole(0, MOST_U64), "motion_seed": whole(0, MOST_U64),
    "spp": count, "max_events_per_pixel_frame": count, "max_events_per_frame": whole(1, MOST_U64),
    "bounces": whole(0, MOST_U32),
}
CHANGES: dict[str, Check] = {"time_s": number, "noise": SETTINGS["noise"],
                             **dict.fromkeys(("threshold", "threshold_off", "bias"), number)}


def checked(settings: Mapping[str, Any], rules: Mapping[str, Check] = SETTINGS) -> dict[str, Any]:
    """The settings as the messages take them. Raises ValueError for a value of a wrong kind."""
    return {name: check(name, value, rules[name]) for name, value in settings.items()}
