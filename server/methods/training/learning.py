"""Trains the network on crops of frames."""
import numpy as np

import network

LEAST_LIGHT = 0.02   # that counts in log light; 1 is the mean of a frame
EDGE = 64            # of a crop, pixels


def crops(data, rng, count):
    """Crops of frames, turned and mirrored, with other directions of normals."""
    batch = []
    for planes, truth, weight in (data[i] for i in rng.integers(len(data), size=count)):
        y, x = (rng.integers(size - EDGE + 1) for size in truth.shape)
        crop = np.concatenate([planes, truth[None], weight[None]])[:, y:y + EDGE, x:x + EDGE]
        if rng.integers(2):
            crop = crop[..., ::-1]
        crop = np.rot90(crop, rng.integers(4), (1, 2)).astype(np.float32)
        normal = crop[4:7][rng.permutation(3)]
        crop[4:7] = normal * rng.choice([-1, 1], (3, 1, 1))
        batch.append(crop)
    batch = np.stack(batch, 1)
    return batch[:network.PLANES], batch[-2:-1], batch[-1:]


def loss(light, truth, weight):
    """Mean difference of log light, nearly as an absolute value, and its gradient."""
    apart = np.log((LEAST_LIGHT + light) / (LEAST_LIGHT + truth))
    size = np.sqrt(apart * apart + 1e-4)
    share = weight / max(weight.sum(), 1)
    return float((size * share).sum()), share * apart / size / (LEAST_LIGHT + light)


class Adam:
    """Kingma and Ba 2015, with gradients of at most norm 1."""

    def __init__(self, p):
        self.p, self.step = p, 0
        self.mean = {name: np.zeros_like(v) for name, v in p.items()}
        self.square = {name: np.zeros_like(v) for name, v in p.items()}

    def take(self, gradients, rate):
        self.step += 1
        norm = np.sqrt(sum(float((g * g).sum()) for g in gradients.values()))
        for name, g in gradients.items():
            g = g / max(norm, 1)
            self.mean[name] += 0.1 * (g - self.mean[name])
            self.square[name] += 0.001 * (g * g - self.square[name])
            mean = self.mean[name] / (1 - 0.9 ** self.step)
            square = self.square[name] / (1 - 0.999 ** self.step)
            self.p[name] -= rate * mean / (np.sqrt(square) + 1e-8)


def train(data, steps, batch, seed, report=print):
    """The parameters after `steps`. Equal arguments give equal parameters."""
    rng, p = np.random.default_rng(seed), network.parameters(seed)
    adam, recent = Adam(p), []
    for step in range(steps):
        planes, truth, weight = crops(data, rng, batch)
        light, gradients = network.denoise(p, planes)
        value, g = loss(light, truth, weight)
        adam.take(gradients(g), 5e-3 * (1 - step / steps))
        recent.append(value)
        if (step + 1) % 100 == 0:
            report(f"step {step + 1} of {steps}: mean difference of log light {np.mean(recent):.4f}", flush=True)
            recent.clear()
    return p
