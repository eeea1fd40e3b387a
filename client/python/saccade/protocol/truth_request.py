"""Makes the truth channels of a request."""
from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from saccade.truth import OF_BODY
from saccade.v1.geometry_pb2 import Vector3
from saccade.v1.truth_pb2 import Imu, Truth

OF_IMU = {"imu_rate_hz": "rate_hz", "metres_per_unit": "metres_per_unit"}


def make_truth(settings: Mapping[str, Any]) -> list[Truth]:
    """Each channel of every view; the IMU once. Raises TypeError for settings of an IMU without it."""
    channels = settings.get("truth", ())
    imu = _imu(settings)
    if imu.ListFields() and OF_BODY not in (name for name, _ in channels):
        given = next(name for name in (*OF_IMU, "gravity", "imu_noise") if name in settings)
        raise TypeError(f"{given} goes with the truth channel 'imu'")
    views = 1 + len(settings.get("further_views", ()))
    return [Truth(name=name, every=every, view=view, imu=imu if name == OF_BODY and imu.ListFields() else None)
            for name, every in channels for view in range(1 if name == OF_BODY else views)]


def _imu(settings: Mapping[str, Any]) -> Imu:
    imu = Imu(**{field: settings[name] for name, field in OF_IMU.items() if name in settings},
              **settings.get("imu_noise", {}))
    if "gravity" in settings:
        imu.gravity.CopyFrom(Vector3(**dict(zip("xyz", settings["gravity"]))))
    return imu
