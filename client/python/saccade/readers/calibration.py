"""Reads the calibration of a camera: YAML as OpenCV, Kalibr and ROS write it."""
from __future__ import annotations

import math
import os
import pathlib
from collections.abc import Mapping
from typing import Any

import numpy as np

from saccade import rigid
from saccade.camera import Camera, Lens
from saccade.errors import FormatError

FORMATS = ("OpenCV's FileStorage (camera_matrix, distortion_coefficients, image_width), Kalibr's camchain (cam0), "
           "ROS's camera_info (camera_matrix, distortion_model, image_width)")
LENSES = {"radtan": "radtan", "plumb_bob": "radtan", "equidistant": "equidistant", "fisheye": "equidistant"}
COEFFICIENTS = {"radtan": (4, 5), "equidistant": (4,)}


def read_calibration(path: str | os.PathLike[str], *, camera: int = 0) -> Camera:
    """The camera of a YAML file of OpenCV, of Kalibr (a camchain) or of ROS (camera_info); the content tells which.

    camera: the number of the camera in a camchain: 1 is cam1. T_body_camera is the inverse of Kalibr's T_cam_imu, in
    metres: the body is the IMU. It is None where the file has none.
    Raises FormatError for another file or lens, ImportError without the module yaml, and OSError.
    """
    path = pathlib.Path(path)
    try:
        return _read(_parse(path), camera)
    except ValueError as fault:
        raise FormatError(f"{path}: {fault}") from fault


def _parse(path: pathlib.Path) -> Any:
    try:
        import yaml
    except ImportError:
        raise ImportError("calibrations need the module yaml: install python3-yaml, or with pip PyYAML") from None

    class Loader(yaml.SafeLoader):  # type: ignore[misc]  # yaml may be absent where types are checked
        """Reads matrices of OpenCV as mappings."""

    Loader.add_constructor("tag:yaml.org,2002:opencv-matrix", Loader.construct_yaml_map)
    text = path.read_text(encoding="utf-8")
    if text.startswith("%YAML:"):  # OpenCV's first line, which is no YAML
        text = text.partition("\n")[2]
    try:
        return yaml.load(text, Loader)
    except (yaml.YAMLError, RecursionError) as fault:
        raise FormatError(f"it is no YAML: {' '.join(str(fault).split())}") from fault


def _read(content: Any, camera: int) -> Camera:
    if isinstance(content, Mapping):
        if f"cam{camera}" in content and isinstance(content[f"cam{camera}"], Mapping):
            return _of_kalibr(content[f"cam{camera}"])
        if "cam0" in content:
            raise FormatError(f"there is no camera cam{camera}; there are: {', '.join(map(str, content))}")
        if "camera_matrix" in content and "distortion_coefficients" in content:
            return _of_opencv(content)
    raise FormatError(f"it is none of these: {FORMATS}")


def _of_kalibr(cam: Mapping[str, Any]) -> Camera:
    if cam.get("camera_model") != "pinhole":
        raise FormatError(f"the camera model '{cam.get('camera_model')}' is not pinhole")
    model = cam.get("distortion_model", "none")
    lens = None if model == "none" else _lens(model, _numbers(cam, "distortion_coeffs"))
    place = rigid.inverse(rigid.from_numbers(_numbers(cam, "T_cam_imu", 4, 4))) if "T_cam_imu" in cam else None
    return _camera(_numbers(cam, "resolution", 2), _numbers(cam, "intrinsics", 4), lens, place)


def _of_opencv(content: Mapping[str, Any]) -> Camera:
    """ROS's camera_info has the same names, and the model of its lens besides."""
    k = _numbers(_part(content, "camera_matrix"), "data", 3, 3)
    if k[0, 1] != 0 or k[1, 0] != 0:
        raise FormatError("camera_matrix has a skew, which cannot be rendered")
    fisheye = content.get("fisheye_model", 0) not in (0, False)
    model = content.get("distortion_model", "fisheye" if fisheye else "plumb_bob")
    lens = _lens(model, _numbers(_part(content, "distortion_coefficients"), "data"))
    size = np.concatenate([_numbers(content, "image_width", 1), _numbers(content, "image_height", 1)])
    return _camera(size, np.array([k[0, 0], k[1, 1], k[0, 2], k[1, 2]]), lens, None)


def _camera(size: rigid.Matrix, intrinsics: rigid.Matrix, lens: Lens | None, place: rigid.Matrix | None) -> Camera:
    width, height = size.tolist()
    fx, fy, cx, cy = intrinsics.tolist()
    if width != int(width) or height != int(height) or min(width, height) < 1:
        raise FormatError(f"the size {width:g} x {height:g} is none of a picture")
    return Camera((int(width), int(height)), (fx, fy, cx, cy), lens, place)


def _lens(model: Any, coefficients: rigid.Matrix) -> Lens:
    """A k3 of 0 is left out, and so are further coefficients of 0."""
    if not isinstance(model, str) or model not in LENSES:
        raise FormatError(f"the lens '{model}' is not one of {', '.join(LENSES)}")
    counts = COEFFICIENTS[LENSES[model]]
    numbers = coefficients.ravel().tolist()
    while len(numbers) > counts[0] and numbers[-1] == 0:
        del numbers[-1]
    if len(numbers) not in counts:
        needed = " or ".join(map(str, counts))
        raise FormatError(f"a lens {LENSES[model]} has {needed} coefficients, not {len(numbers)}")
    return LENSES[model], tuple(numbers)


def _part(content: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    if not isinstance(part := content[name], Mapping):
        raise FormatError(f"{name} is no matrix with rows, cols and data")
    return part


def _numbers(content: Mapping[str, Any], name: str, *shape: int) -> rigid.Matrix:
    """YAML 1.1 takes 1e-5 for a text. Without a shape it is a list of any length."""
    found = np.array(content.get(name), dtype=object)
    try:
        numbers = np.array([math.nan if isinstance(item, bool) else float(item) for item in found.ravel()])
        if np.isfinite(numbers).all():
            return numbers.reshape(shape or -1)
    except (ValueError, TypeError, OverflowError):
        pass
    count = {(): "a list of finite numbers", (1,): "a finite number"}.get(shape, f"{math.prod(shape)} finite numbers")
    raise FormatError(f"{name} is not {count}")
