"""Reads dumps of `saccade-eval frames`. client/README.md says what they hold."""
import numpy as np
import OpenImageIO

ALBEDO_FLOOR, DARK, MOST, NEAREST = 1e-3, 1e-2, 1e4, 8  # as in learned_onnx.cpp


def read(path):
    """The channels of a picture by name."""
    picture = OpenImageIO.ImageBuf(str(path))
    pixels = picture.get_pixels(OpenImageIO.FLOAT)
    return {name: pixels[..., i] for i, name in enumerate(picture.spec().channelnames)}


def light_of(picture, features):
    """Illumination i = (I - E) / A, as demodulate() of server/filter."""
    return np.maximum(picture["Y"] - features["emission"], 0) / np.maximum(features["albedo"], ALBEDO_FLOOR)


def planes_of(light, features):
    """The planes of a frame, as learned_onnx.cpp makes them, and the scale of its light."""
    lit = features["albedo"] >= DARK
    scale = light[lit].mean() if lit.any() and light[lit].mean() > 0 else 1
    light = np.minimum(light / scale, MOST)
    near = 1 / features["Z"]
    normal = [features["normal." + axis] for axis in "xyz"]
    planes = [light, np.ones_like(light), np.log1p(10 * light), features["albedo"], *normal,
              np.minimum(near / near.mean(), NEAREST)]
    return np.stack(planes).astype(np.float32), scale


def frames(folder):
    """(planes, truth, weight) of each noisy frame: truth is light in the scale of the planes."""
    for truth in sorted((folder / "truth").glob("Iprev_*.exr")):
        for noisy in sorted(folder.glob("noisy*")):
            features = read(noisy / truth.name.replace("Iprev", "features"))
            planes, scale = planes_of(light_of(read(noisy / truth.name), features), features)
            yield planes, light_of(read(truth), features) / scale, features["albedo"] >= DARK
