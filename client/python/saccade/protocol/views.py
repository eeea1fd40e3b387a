"""Makes the views of a request: its camera, and the further ones on the same body."""
from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from saccade import rigid
from saccade.camera import Camera
from saccade.protocol.setting_checks import checked
from saccade.readers.calibration import read_calibration
from saccade.v1 import control_pb2 as c

BY_CALIBRATION = ("fov_x_deg", "intrinsics", "distortion")


def with_calibration(settings: Mapping[str, Any]) -> Mapping[str, Any]:
    """The settings with those that their calibration stands for.

    Raises TypeError or ValueError for others beside it, FormatError for a file that is none, and OSError.
    """
    if "calibration" not in settings:
        return settings
    given = settings["calibration"]
    camera = given if isinstance(given, Camera) else read_calibration(given)
    for name in BY_CALIBRATION:
        if name in settings:
            raise TypeError(f"give either calibration or {name}")
    if settings.get("size", camera.size) != camera.size:
        raise ValueError(f"size: {settings['size']} is not that of the calibration, {camera.size}")
    known = {"size": camera.size, "intrinsics": camera.intrinsics, "distortion": camera.distortion,
             "T_body_camera": _in_scene_units(camera.T_body_camera, settings.get("metres_per_unit", 1))}
    return {**checked({name: value for name, value in known.items() if value is not None}), **settings}


def _in_scene_units(place: rigid.Matrix | None, metres_per_unit: float) -> rigid.Matrix | None:
    """Of a place in metres."""
    return None if place is None else rigid.scaled(place, 1 / metres_per_unit)


def make_view(settings: Mapping[str, Any]) -> c.View:
    width, height = settings["size"]
    view = c.View(width=width, height=height, fov_x_deg=settings.get("fov_x_deg"),
                  distortion=settings.get("distortion"))
    if "intrinsics" in settings:
        view.intrinsics.CopyFrom(c.Intrinsics(**dict(zip(("fx", "fy", "cx", "cy"), settings["intrinsics"]))))
    if "T_body_camera" in settings:
        view.body_camera.CopyFrom(rigid.to_message(settings["T_body_camera"]))
    return view


def make_further_views(settings: Mapping[str, Any]) -> list[c.View]:
    """Cameras like the first, at places in its axes."""
    views = []
    for place in settings.get("further_views", ()):
        first = settings.get("T_body_camera")
        views.append(make_view({**settings, "T_body_camera": place if first is None else first @ place}))
    return views
