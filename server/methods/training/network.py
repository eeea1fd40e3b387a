"""Affinities of neural features, after Isik et al. 2021 (Interactive Monte Carlo denoising using affinity of neural
features): a small network gives each pixel features, and five filters weigh pixels by how alike these are.

Arrays are float32, (channels, pictures, height, width). Each function returns its result, and a function from the
gradient of the result to those of its inputs.
"""
import numpy as np

PLANES = 8    # of the input: light, 1, log light, albedo, normal (3), 1 / depth; see learned_onnx.cpp
GUIDES = 7    # the planes that the network sees: all but light
HIDDEN = 12
FEATURES = 4  # of a pixel, for each filter
SPACINGS = (1, 2, 4, 8, 16)  # of the taps of each filter, pixels
TAPS = [(y, x) for y in (-1, 0, 1) for x in (-1, 0, 1)]


def parameters(seed):
    """He's initial weights, and biases of 0."""
    rng = np.random.default_rng(seed)

    def weights(outputs, inputs, edge, gain):
        values = rng.normal(0, gain / np.sqrt(inputs * edge * edge), (outputs, inputs, edge, edge))
        return values.astype(np.float32)

    outputs = len(SPACINGS) * (FEATURES + 1)
    return {"w1": weights(HIDDEN, GUIDES, 3, 1.4), "b1": np.zeros(HIDDEN, np.float32),
            "w2": weights(HIDDEN, HIDDEN, 3, 1.4), "b2": np.zeros(HIDDEN, np.float32),
            "w3": weights(outputs, HIDDEN, 1, 0.5), "b3": np.zeros(outputs, np.float32)}


def padded(a, border):
    return np.pad(a, ((0, 0), (0, 0), (border, border), (border, border)))


def at_tap(a, tap, spacing, shape):
    """A view of padded pictures, moved by a tap."""
    y, x = (spacing * (1 + step) for step in tap)
    return a[..., y:y + shape[-2], x:x + shape[-1]]


def conv(a, w, b):
    """A convolution with zeros around the picture, of edge 1 or 3."""
    edge = w.shape[-1]
    border = padded(a, 1) if edge == 3 else a
    columns = np.concatenate([at_tap(border, tap, 1, a.shape) for tap in TAPS]) if edge == 3 else a
    flat = columns.reshape(len(columns), -1)
    matrix = w.transpose(0, 2, 3, 1).reshape(len(w), -1)
    out = (matrix @ flat + b[:, None]).reshape(len(w), *a.shape[1:])

    def back(g):
        g = g.reshape(len(w), -1)
        dw = (g @ flat.T).reshape(len(w), edge, edge, -1).transpose(0, 3, 1, 2)
        dcolumns = (matrix.T @ g).reshape(-1, *a.shape)
        if edge == 1:
            return dcolumns[0], dw, g.sum(1)
        dborder = np.zeros_like(border)
        for tap, part in zip(TAPS, dcolumns):
            at_tap(dborder, tap, 1, a.shape)[...] += part
        return dborder[..., 1:-1, 1:-1], dw, g.sum(1)

    return out, back


def relu(a):
    return np.maximum(a, 0), lambda g: g * (a > 0)


def affinity(light, features, spacing):
    """The mean of nine taps q of `light`, weighted by exp(-|f(p) - f(q)|^2 + c(q)). c is the last of `features`."""
    shape, f, inside = light.shape, features[:-1], np.ones_like(light)
    around = [padded(a, spacing) for a in (light, features, inside)]
    total, norm, taps = np.zeros_like(light), np.zeros_like(light), []
    for tap in TAPS:
        i, q, m = (at_tap(a, tap, spacing, shape) for a in around)
        apart = f - q[:-1]
        w = np.exp(q[-1:] - (apart * apart).sum(0, keepdims=True)) * m
        total += w * i
        norm += w
        taps.append((tap, i, apart, w))
    out = total / norm

    def back(g):
        dlight, dfeatures = (np.zeros_like(a) for a in around[:2])
        df = np.zeros_like(f)
        share = g / norm
        for tap, i, apart, w in taps:
            at_tap(dlight, tap, spacing, shape)[...] += w * share
            dlog = w * share * (i - out)
            dapart = 2 * apart * dlog
            df -= dapart
            at_tap(dfeatures, tap, spacing, shape)[...] += np.concatenate([dapart, dlog])
        inner = (..., slice(spacing, -spacing), slice(spacing, -spacing))
        dfeatures = dfeatures[inner]
        dfeatures[:-1] += df
        return dlight[inner], dfeatures

    return out, back


def denoise(p, planes):
    """Denoised light of `planes`, and a function from its gradient to those of the parameters `p`."""
    h1, back1 = conv(planes[1:], p["w1"], p["b1"])
    a1, cut1 = relu(h1)
    h2, back2 = conv(a1, p["w2"], p["b2"])
    a2, cut2 = relu(h2)
    features, back3 = conv(a2, p["w3"], p["b3"])
    light, filters = planes[:1], []
    for level, spacing in enumerate(SPACINGS):
        part = slice(level * (FEATURES + 1), (level + 1) * (FEATURES + 1))
        light, back = affinity(light, features[part], spacing)
        filters.append(back)

    def gradients(g):
        parts = []
        for back in reversed(filters):
            g, dfeatures = back(g)
            parts.insert(0, dfeatures)
        d2, dw3, db3 = back3(np.concatenate(parts))
        d1, dw2, db2 = back2(cut2(d2))
        _, dw1, db1 = back1(cut1(d1))
        return {"w1": dw1, "b1": db1, "w2": dw2, "b2": db2, "w3": dw3, "b3": db3}

    return light, gradients
