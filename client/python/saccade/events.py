"""Events as columns of numpy arrays."""
from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from saccade import conversions, representations
from saccade.camera import Camera

if TYPE_CHECKING:
    import torch


LABELS = ("source", "artefact")
# Columns that not all events have, and their types.
FACTS: dict[str, type[Any]] = {"source": np.uint8, "artefact": np.uint8, "object": np.uint32}


@dataclass(frozen=True, eq=False, repr=False)
class Events:
    """The events of one sensor in an interval of time, in time order. len() is their number, and may be 0.

    t: int64 (n), microseconds, not decreasing. Stream time is 0 at the first frame.
    x, y: uint16 (n), pixels from the left and from the top.
    p: bool (n), True is ON (brighter), False is OFF (darker).
    size: width and height of the sensor in pixels; None where a file does not tell it.
    interval: (t0, t1), the events cover the microseconds t0 <= t < t1. By default from the first to the last event.
    sensor: index of the sensor in its stream.
    source: uint8 (n), 0 is the scene, 1 is noise of the sensor; None without the setting labels.
    artefact: uint8 (n), 255 times the odds that the event is an error of rendering; None likewise.
    object: uint32 (n), the number in the channel ids of what the pixel shows; None without the setting object_ids.
    camera: the calibration; None where it is not known, as of a file without FILE.json.

    x, y and p of a stream are read-only views of the received packet. Raises ValueError for columns of unequal length.
    """

    t: NDArray[np.int64]
    x: NDArray[np.uint16]
    y: NDArray[np.uint16]
    p: NDArray[np.bool_]
    size: tuple[int, int] | None = None
    interval: tuple[int, int] | None = None
    sensor: int = 0
    source: NDArray[np.uint8] | None = None
    artefact: NDArray[np.uint8] | None = None
    object: NDArray[np.uint32] | None = None
    camera: Camera | None = None

    def __post_init__(self) -> None:
        for name, dtype in (("t", np.int64), ("x", np.uint16), ("y", np.uint16), ("p", np.bool_)):
            object.__setattr__(self, name, np.asarray(getattr(self, name), dtype))
        for fact in self.facts().values():
            if fact.shape != self.t.shape:
                raise ValueError("labels must have the length of t")
        if not self.t.shape == self.x.shape == self.y.shape == self.p.shape == (self.t.size,):
            raise ValueError("t, x, y and p must be columns of one length")

    @property
    def t0(self) -> int:
        """Begin of the interval in microseconds; 0 where neither an interval nor an event is there."""
        if self.interval is not None:
            return self.interval[0]
        return int(self.t[0]) if len(self) else 0

    @property
    def t1(self) -> int:
        """End of the interval in microseconds, exclusive."""
        if self.interval is not None:
            return self.interval[1]
        return int(self.t[-1]) + 1 if len(self) else 0

    def __len__(self) -> int:
        return int(self.t.size)

    def __repr__(self) -> str:
        return f"Events({len(self)} in [{self.t0}, {self.t1}) us, size={self.size}, sensor={self.sensor})"

    def __getitem__(self, which: slice | NDArray[Any]) -> Events:
        """The events of a slice, a mask, or an array of increasing indices. They cover the same interval."""
        if not isinstance(which, (slice, np.ndarray)):
            raise TypeError("index Events with a slice or an array; for one event, index its columns")
        facts: dict[str, Any] = {name: fact[which] for name, fact in self.facts().items()}
        return replace(self, t=self.t[which], x=self.x[which], y=self.y[which], p=self.p[which],
                       interval=(self.t0, self.t1), **facts)

    def facts(self) -> dict[str, NDArray[Any]]:
        """Those of the columns source, artefact and object that these events have, by name."""
        return {name: column for name in FACTS if (column := getattr(self, name)) is not None}

    def slice(self, t0: int, t1: int) -> Events:
        """The events with t0 <= t < t1, in microseconds. They cover [t0, t1)."""
        first, last = np.searchsorted(self.t, [t0, t1])
        return replace(self[first:last], interval=(t0, t1))

    def windows(self, *, duration_us: int | None = None, count: int | None = None) -> Iterator[Events]:
        """Windows of fixed duration or of a fixed number of events: see saccade.windows()."""
        from saccade.windowing import windows
        return windows([self], duration_us=duration_us, count=count)

    def frame(self) -> NDArray[np.int32]:
        """Numbers of events per pixel, int32 (2, height, width): [0] counts OFF, [1] counts ON events."""
        return representations.frame(self)

    def voxel(self, bins: int) -> NDArray[np.float32]:
        """Voxel grid, float32 (bins, height, width): polarities +1 and -1, spread bilinearly over time.

        The first event falls into the first bin, the last event into the last bin (Zhu et al., CVPR 2019).
        Raises ValueError for less than 2 bins.
        """
        return representations.voxel(self, bins)

    def time_surface(self, tau_us: float, at_us: int | None = None) -> NDArray[np.float32]:
        """exp((t - at) / tau) of the last event of each pixel and polarity, float32 (2, height, width).

        [0] is of OFF, [1] of ON events; 0 where no event came. tau_us: positive, microseconds. at_us: by default the
        end of the interval (Lagorce et al., PAMI 2017). Events after at_us are left out.
        """
        return representations.time_surface(self, tau_us, self.t1 if at_us is None else at_us)

    def to_tonic(self) -> NDArray[np.void]:
        """A structured array with x (int16), y (int16), t (int64, microseconds), p (bool), as tonic has it."""
        return conversions.to_tonic(self)

    def to_torch(self) -> dict[str, torch.Tensor]:
        """Copies as tensors: t (int64, microseconds), x and y (int16), p (bool). Raises ImportError without torch."""
        return conversions.to_torch(self)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a compressed .npz with t, x, y, p, width, height, labels and objects, which saccade.read() reads.

        Raises ValueError for another extension, and where the size is unknown.
        """
        if not os.fspath(path).endswith(".npz"):
            raise ValueError(f"{os.fspath(path)} does not end with .npz, which alone is written; "
                             "`saccade convert` makes other formats of it")
        from saccade.writers.npz import write_npz
        write_npz(path, self)


def seen_by(events: Events, camera: Camera | None) -> Events:
    """Sets the camera of Events that nobody else has yet; a copy for each packet would cost more than its events."""
    object.__setattr__(events, "camera", camera)
    return events


def concatenate(parts: Sequence[Events]) -> Events:
    """One Events of all parts, which follow each other in time and are of one sensor.

    Raises TypeError for other parts, and ValueError for no parts, for parts of different sensors or sizes, and for parts out of time order.
    """
    if isinstance(parts, Events) or not all(isinstance(part, Events) for part in parts):
        raise TypeError("concatenate() takes a list of Events")
    if not parts:
        raise ValueError("concatenate() needs at least one part")
    first, last = parts[0], parts[-1]
    if any((part.size, part.sensor) != (first.size, first.sensor) for part in parts):
        raise ValueError("the parts are of different sensors or sizes")
    filled = [part for part in parts if len(part)]
    if any(one.t[-1] > two.t[0] for one, two in zip(filled, filled[1:])):
        raise ValueError("the parts are not in time order")
    t, x, y, p = (np.concatenate([getattr(part, name) for part in parts]) for name in "txyp")
    facts = {name: np.concatenate([getattr(part, name) for part in parts]) for name in FACTS
             if all(getattr(part, name) is not None for part in parts)}
    return Events(t, x, y, p, first.size, (first.t0, last.t1), first.sensor, **facts, camera=first.camera)
