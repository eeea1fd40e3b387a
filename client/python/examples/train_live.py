"""Trains a tiny network on live streams: does the camera turn left or right?

    python3 train_live.py [STEPS]

No data set is stored: every batch is rendered for it. The server is that of $SACCADE_SERVER, or the one on this
machine.
"""
from __future__ import annotations

import random
import sys
from collections.abc import Iterator

import torch
from torch import nn
from torch.utils.data import DataLoader

import saccade
from saccade.dataset import StreamDataset

BINS, WINDOW_US, BATCH = 5, 20_000, 10


class Turns:
    """Streams of a camera that turns to either side, without end. Every worker draws the same ones."""

    def __iter__(self) -> Iterator[saccade.Settings]:
        rng = random.Random(1)
        while True:
            speed = rng.choice([-1, 1]) * rng.uniform(20, 60)  # degrees per second
            yield {"scene": "cornell-box", "motion": f"pan:{speed}", "turn_s": 0, "size": (64, 48), "rate_hz": 300,
                   "duration_s": 2 * WINDOW_US * 1e-6, "seed": rng.getrandbits(32)}


def sample(events: saccade.Events, settings: saccade.Settings) -> tuple[torch.Tensor, torch.Tensor]:
    turns_right = not settings["motion"].startswith("pan:-")
    return torch.from_numpy(events.voxel(BINS)), torch.tensor(float(turns_right))


def network() -> nn.Module:
    return nn.Sequential(nn.Conv2d(BINS, 16, 7, stride=2), nn.ReLU(), nn.Conv2d(16, 16, 5, stride=2), nn.ReLU(),
                         nn.AdaptiveAvgPool2d(1), nn.Flatten(), nn.Linear(16, 1), nn.Flatten(0))


def main() -> None:
    torch.manual_seed(1)
    steps = int((sys.argv[1:] or ["100"])[0])
    data = DataLoader(StreamDataset(Turns(), transform=sample, duration_us=WINDOW_US), batch_size=BATCH, num_workers=1)
    model, right = network(), 0
    optimizer = torch.optim.Adam(model.parameters(), 3e-3)
    for step, (voxels, labels) in zip(range(1, steps + 1), data):
        logits = model(voxels)
        loss = nn.functional.binary_cross_entropy_with_logits(logits, labels)
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
        right += int(((logits > 0) == (labels > 0)).sum())
        if step % 10 == 0:
            print(f"step {step}: loss {loss.item():.3f}, {right} of the last {10 * BATCH} right")
            right = 0


if __name__ == "__main__":
    main()
