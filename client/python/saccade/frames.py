"""Frames of a video, as Stream.push() takes them."""
from __future__ import annotations

from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

Frame = Union[NDArray[np.floating[Any]], NDArray[np.uint8], NDArray[np.uint16]]
WHITE = {np.dtype(np.uint8): 255, np.dtype(np.uint16): 65535}


def luminance(frame: Frame, size: tuple[int, int]) -> NDArray[np.float32]:
    """Linear luminance, as `saccade events` reads it: uint8 and uint16 are sRGB with white 1, and floats are linear.

    Raises TypeError for what is no such array, and ValueError for another shape.
    """
    if not isinstance(frame, np.ndarray):
        raise TypeError(f"frames are numpy arrays of float, uint8 or uint16, not {type(frame).__name__}")
    width, height = size
    if frame.shape != (height, width):
        raise ValueError(f"a frame of this stream has the shape ({height}, {width}), not {frame.shape}")
    if np.issubdtype(frame.dtype, np.floating):
        return frame.astype("<f4")
    white = WHITE.get(frame.dtype.newbyteorder("="))
    if white is None:
        raise TypeError(f"frames are float (linear), or uint8 or uint16 (sRGB), not {frame.dtype}")
    return linear_from_srgb(np.multiply(frame, np.float32(1 / white), dtype=np.float32)).astype("<f4")


def linear_from_srgb(value: NDArray[np.float32]) -> NDArray[np.float32]:
    """The light of values from 0 to 1 (IEC 61966-2-1). Rounds as `saccade events` does."""
    dark = value / np.float32(12.92)
    base = (value + np.float32(0.055)) / np.float32(1.055)
    light = np.power(base.astype(np.float64), np.float64(np.float32(2.4))).astype(np.float32)
    return np.where(value <= np.float32(0.04045), dark, light)
