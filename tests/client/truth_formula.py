"""What write_truth puts into a file, for tests that read it."""
import numpy as np

WIDTH, HEIGHT = 5, 3
PICTURES = {"depth": ("f4", ["z"]), "flow": ("f4", ["x", "y", "valid"]), "frame": ("u1", ["value"]),
            "frame16": ("u2", ["value"]), "colour": ("u1", ["r", "g", "b", "a"]), "ids": ("u4", ["object", "material"]),
            "depth_view1": ("f4", ["z"])}
ROWS = {"pose": ("f8", ["x", "y", "z", "qx", "qy", "qz", "qw"]), "velocity": ("f4", ["vx", "vy", "vz", "wx", "wy", "wz"]),
        "imu": ("f8", ["ax", "ay", "az", "gx", "gy", "gz"]), "other": ("u2", ["a", "b"])}
CHANNELS = {**PICTURES, **ROWS}
# Of views 0 and 1: the name of the lens, and its coefficients.
LENSES = [("plumb_bob", [-0.1, 0.02, 0.001, -0.002, 0]), ("equidistant", [-0.1, 0.02, 0.001, -0.002])]
MATRIX = [40, 0, 2.25, 0, 41, 1.5, 0, 0, 1]
EVENTS = [(10_000 * step + t, x, y, p) for step in range(4) for t, x, y, p in ((0, 1, 2, 1), (7_000, 4, 0, 0))]


def samples(name):
    """float64 (n, height, width, planes) of pictures, (n, planes) of rows."""
    planes = len(CHANNELS[name][1])
    if name in ROWS:
        return (40.0 * np.arange(40)[:, None] + np.arange(planes)) % 256
    flat = (40.0 * np.arange(4)[:, None] + np.arange(planes * HEIGHT * WIDTH)) % 256
    return flat.reshape(4, planes, HEIGHT, WIDTH).transpose(0, 2, 3, 1)


def times_us(name):
    return np.arange(40) * 1000 if name in ROWS else np.arange(4) * 10_000


def exposures_us(name):
    """(n, 2)"""
    end = times_us(name)
    return np.stack([np.maximum(end - 2000, 0), end], axis=1)
