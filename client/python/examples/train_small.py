"""Trains a small model on a data set of saccade-farm: how fast does the image move? It needs numpy and h5py alone.

    python3 train_small.py DATASET [EPOCHS]

TRAINING.md makes the data set. The model sees windows of 40 ms. It learns the mean optical flow at their end, from the
correlation of the events of one fifth of a window with those of the next ones.
"""
from __future__ import annotations

import sys

import numpy as np
from numpy.typing import NDArray

import saccade

WINDOW_S, SLICES, REACH, BATCH, HIDDEN = 0.04, 5, 4, 16, 32
Floats = NDArray[np.float64]
Item = tuple[Floats, Floats]


def sample(window: saccade.Window) -> Item:
    """What the model sees, and what it learns: x and y in pixels per frame."""
    flow = window.truth["flow_forward"].data[-1]
    seen = flow[flow[..., 2] > 0]  # where the next frame shows the surface, too
    return correlations(window.events), seen[:, :2].mean(axis=0).astype(np.float64)


def correlations(events: saccade.Events) -> Floats:
    """Of the events of a slice of time with those one and two slices later, for shifts of up to REACH pixels."""
    times = np.linspace(events.t0, events.t1, SLICES + 1).astype(int)
    counts = [events.slice(t0, t1).frame() for t0, t1 in zip(times.tolist(), times[1:].tolist())]
    spectra = np.fft.rfft2([on - off for off, on in counts])
    shifts = np.arange(-REACH, REACH + 1)
    found = []
    for lag in (1, 2):
        surface = np.fft.irfft2((spectra[:-lag].conj() * spectra[lag:]).sum(axis=0))
        near = surface[np.ix_(shifts, shifts)]
        found.append(near.ravel() / (np.abs(near).max() + 1))
    return np.concatenate(found)


class Model:
    """A perceptron with one hidden layer, which Adam trains."""

    def __init__(self, inputs: int, outputs: int, seed: int = 1) -> None:
        rng = np.random.default_rng(seed)
        self.weights: list[Floats] = [rng.normal(0, inputs**-0.5, (inputs, HIDDEN)), np.zeros(HIDDEN),
                                      rng.normal(0, HIDDEN**-0.5, (HIDDEN, outputs)), np.zeros(outputs)]
        self.moments = [(np.zeros_like(weight), np.zeros_like(weight)) for weight in self.weights]
        self.steps = 0

    def predict(self, inputs: Floats) -> Floats:
        into, bias, out, offset = self.weights
        predicted: Floats = np.tanh(inputs @ into + bias) @ out + offset
        return predicted

    def step(self, inputs: Floats, targets: Floats, rate: float = 3e-3) -> None:
        into, bias, out, _ = self.weights
        hidden = np.tanh(inputs @ into + bias)
        error = (self.predict(inputs) - targets) * (2 / len(inputs))
        back = error @ out.T * (1 - hidden**2)
        self.steps += 1
        slopes = [inputs.T @ back, back.sum(axis=0), hidden.T @ error, error.sum(axis=0)]
        for weight, slope, (mean, square) in zip(self.weights, slopes, self.moments):
            mean += 0.1 * (slope - mean)
            square += 0.001 * (slope**2 - square)
            scale = np.sqrt(square / (1 - 0.999**self.steps)) + 1e-8
            weight -= rate * mean / (1 - 0.9**self.steps) / scale


def together(items: list[Item]) -> Item:
    return np.stack([inputs for inputs, _ in items]), np.stack([target for _, target in items])


def windows_of(path: str, split: str) -> saccade.Dataset:
    return saccade.Dataset(path, split=split, window_s=WINDOW_S, truth=["flow_forward"], transform=sample)


def error_of(predicted: Floats, targets: Floats) -> float:
    """The mean length of the error."""
    return float(np.linalg.norm(predicted - targets, axis=1).mean())


def main() -> None:
    path, epochs = sys.argv[1], int((sys.argv[2:] or ["20"])[0])
    data, check, test = (windows_of(path, split) for split in ("train", "val", "test"))
    known, (inputs, targets) = together(list(check)), together(list(test))
    mean = together(list(data))[1].mean(axis=0)
    order, model = data.order(seed=1), Model(inputs.shape[1], targets.shape[1])
    for epoch in range(epochs):
        order.set_epoch(epoch)
        numbers = list(order)
        for first in range(0, len(numbers), BATCH):
            model.step(*together([data[number] for number in numbers[first : first + BATCH]]))
        if (epoch + 1) % 5 == 0:
            print(f"epoch {epoch + 1}: error {error_of(model.predict(known[0]), known[1]):.3f} pixels per frame (val)")
    print(f"test: {len(targets)} windows, error {error_of(model.predict(inputs), targets):.3f} pixels per frame, "
          f"and {error_of(mean[None], targets):.3f} of a model that knows the mean alone")


if __name__ == "__main__":
    main()
