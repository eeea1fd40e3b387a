"""Rigid transforms as matrices, float64 (4, 4), and as the messages have them."""
from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.v1.geometry_pb2 import Quaternion, RigidTransform, Vector3

Matrix = NDArray[np.float64]
ROUNDING = 1e-3  # of a rotation that is written with few digits


def from_numbers(numbers: Any) -> Matrix:
    """Of x y z, of x y z and a quaternion x y z w of any length, or of a matrix (4, 4). Raises ValueError else."""
    given = np.asarray(numbers, np.float64)
    if not np.isfinite(given).all():
        raise ValueError("a number is not finite")
    if given.shape == (4, 4):
        return _checked(given)
    matrix = np.eye(4)
    if given.shape == (7,):
        matrix[:3, :3] = _rotation(given[3:])
    elif given.shape != (3,):
        raise ValueError(f"the shape {given.shape} is none of a transform")
    matrix[:3, 3] = given[:3]
    return matrix


def _checked(matrix: Matrix) -> Matrix:
    rotation = matrix[:3, :3]
    square = np.abs(rotation @ rotation.T - np.eye(3)).max() < ROUNDING and np.linalg.det(rotation) > 0
    if not square or not np.array_equal(matrix[3], [0, 0, 0, 1]):
        raise ValueError("the matrix is no rotation with a translation")
    return matrix


def _rotation(quaternion: NDArray[np.float64]) -> Matrix:
    length = np.linalg.norm(quaternion)
    if length < 1e-6:
        raise ValueError("the quaternion has no length")
    x, y, z, w = quaternion / length
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def _quaternion(rotation: Matrix) -> NDArray[np.float64]:
    """x y z w of the nearest rotation (Bar-Itzhack, Journal of Guidance 2000)."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation
    lower = np.array([[xx - yy - zz, 0, 0, 0], [xy + yx, yy - xx - zz, 0, 0], [xz + zx, yz + zy, zz - xx - yy, 0],
                      [zy - yz, xz - zx, yx - xy, xx + yy + zz]])
    found: NDArray[np.float64] = np.linalg.eigh(lower)[1][:, -1]
    return (found if found[3] >= 0 else -found) + 0.0  # without -0


def to_message(matrix: Matrix) -> RigidTransform:
    """The rotation is unset where there is none."""
    x, y, z = matrix[:3, 3].tolist()
    message = RigidTransform(position=Vector3(x=x, y=y, z=z))
    if not np.array_equal(matrix[:3, :3], np.eye(3)):
        qx, qy, qz, qw = _quaternion(matrix[:3, :3]).tolist()
        message.rotation.CopyFrom(Quaternion(x=qx, y=qy, z=qz, w=qw))
    return message


def from_message(message: RigidTransform) -> Matrix:
    p, q = message.position, message.rotation
    rotation = (q.x, q.y, q.z, q.w) if message.HasField("rotation") else (0, 0, 0, 1)
    return from_numbers([p.x, p.y, p.z, *rotation])


def inverse(matrix: Matrix) -> Matrix:
    result = np.eye(4)
    result[:3, :3] = matrix[:3, :3].T
    result[:3, 3] = -matrix[:3, :3].T @ matrix[:3, 3]
    return result


def scaled(matrix: Matrix, scale: float) -> Matrix:
    """The same with lengths in another unit."""
    result = matrix.copy()
    result[:3, 3] *= scale
    return result
