"""The calibration of a camera."""
from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from saccade import rigid
from saccade.v1 import control_pb2 as c

Lens = tuple[str, tuple[float, ...]]
MODELS = {c.DISTORTION_MODEL_RADTAN: "radtan", c.DISTORTION_MODEL_EQUIDISTANT: "equidistant"}


@dataclass(frozen=True, eq=False)
class Camera:
    """The calibration of a camera.

    size: width and height in pixels.
    intrinsics: fx, fy, cx, cy in pixels, where the centre of the top left pixel is (0, 0), as in OpenCV.
    distortion: ("radtan", (k1, k2, p1, p2)), with k3 or not, or ("equidistant", (k1, k2, k3, k4)), or None.
    T_body_camera: float64 (4, 4), takes points from the axes of the camera to those of its body; None where the camera
        is the body. Lengths are scene units.
    """

    size: tuple[int, int]
    intrinsics: tuple[float, float, float, float]
    distortion: Lens | None = None
    T_body_camera: NDArray[np.float64] | None = None

    @property
    def matrix(self) -> NDArray[np.float64]:
        """The camera matrix of OpenCV, float64 (3, 3)."""
        fx, fy, cx, cy = self.intrinsics
        return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])

    @classmethod
    def of(cls, view: c.View) -> Camera | None:
        """Of the view of a `resolved` request; None of frames that a client pushes, whose camera is not known.

        Raises ValueError for a field of view or a place that cannot be.
        """
        if not view.HasField("intrinsics") and not view.HasField("fov_x_deg"):
            return None
        if not view.HasField("intrinsics") and not 0 < view.fov_x_deg < 180:
            raise ValueError(f"a field of view of {view.fov_x_deg} degrees")
        lens = None
        if view.HasField("distortion"):
            lens = MODELS.get(view.distortion.model, "unknown"), tuple(view.distortion.coefficients)
        place = rigid.from_message(view.body_camera) if view.HasField("body_camera") else None
        return cls((view.width, view.height), _intrinsics(view), lens, place)


def cameras_of(request: c.OpenStream) -> list[Camera | None]:
    """By view. Raises ValueError as Camera.of()."""
    return [Camera.of(view) for view in (request.view, *request.further_views)]


def _intrinsics(view: c.View) -> tuple[float, float, float, float]:
    if view.HasField("intrinsics"):
        k = view.intrinsics
        return k.fx, k.fy, k.cx, k.cy
    focal = view.width / 2 / math.tan(math.radians(view.fov_x_deg) / 2)
    return focal, focal, (view.width - 1) / 2, (view.height - 1) / 2
