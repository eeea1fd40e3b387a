"""Finds the files of a recording from any of them: a file for each sensor, such as a-0.npz, or one for all."""
from __future__ import annotations

import itertools
import os
import pathlib
from dataclasses import dataclass, field

from saccade.errors import FormatError
from saccade.readers.sidecar import sidecar_of
from saccade.v1 import recording_pb2


@dataclass(frozen=True)
class Place:
    """Where a sensor or the truth of a view is. group: within an .h5, empty or such as "sensor_1/"."""

    path: pathlib.Path
    group: str = ""


@dataclass(frozen=True)
class RecordingFiles:
    """about: what FILE.json says of `path`. joint: all sensors are in one file. sensors: those that are there."""

    path: pathlib.Path
    about: recording_pb2.Recording | None
    joint: bool = False
    sensors: dict[int, Place] = field(default_factory=dict)

    @property
    def own(self) -> int:
        """The sensor of `path`, or its first one."""
        return self.about.sensor if self.about is not None else 0

    def sensor(self, number: int) -> Place:
        """Raises FormatError where it is not there."""
        if number in self.sensors:
            return self.sensors[number]
        if self.about is None and self.path.suffix == ".h5":  # its groups may be there without FILE.json
            return Place(self.path, f"sensor_{number}/")
        raise FormatError(f"{self.path}: there is no sensor {number}; there are: {', '.join(map(str, self.sensors))}")

    def sidecar(self, number: int) -> recording_pb2.Recording | None:
        """What FILE.json says of a sensor."""
        if self.joint and number > 0:
            return sidecar_of(f"{self.path}.sensor{number}")
        return sidecar_of(self.sensor(number).path)

    def view_of(self, sensor: int) -> int:
        return _views(self.about)[sensor] if sensor < len(_views(self.about)) else 0

    @property
    def views(self) -> list[int]:
        """The numbers of the cameras."""
        return list(range(1 + (len(self.about.request.further_views) if self.about is not None else 0)))

    def truth(self, view: int) -> Place | None:
        """Where the truth of a camera is; without a group, at the root or in /view_1 and so on. None: in no file here.

        Raises FormatError where there is no such camera.
        """
        if view not in self.views:
            raise FormatError(f"{self.path}: there is no view {view}; there are: {', '.join(map(str, self.views))}")
        group = f"view_{view}/" if view > 0 else ""
        if self.joint:
            return Place(self.path, group)
        views = _views(self.about)
        first = views.index(view) if view in views else None
        if first is not None and first in self.sensors:
            return Place(self.sensors[first].path)
        if view == self.view_of(self.own):
            return Place(self.path)
        return Place(next(iter(self.sensors.values())).path, group) if self.path.suffix == ".h5" else None


def find_files(path: str | os.PathLike[str]) -> RecordingFiles:
    """`path` may also be the name before it was numbered, such as a.npz. Raises FormatError for a bad FILE.json."""
    path = pathlib.Path(path)
    first = path.with_name(f"{path.stem}-0{path.suffix}")
    if not path.exists() and first.exists():
        path = first
    about = sidecar_of(path)
    own, count = (about.sensor, len(about.request.sensors)) if about is not None else (0, 1)
    if (joint := _described_together(path)) > 1:
        return RecordingFiles(path, about, True, {i: Place(path, f"sensor_{i}/" if i else "") for i in range(joint)})
    if count > 1 and path.stem.endswith(f"-{own}"):
        base = path.stem.removesuffix(f"-{own}")
        numbered = {i: Place(path.with_name(f"{base}-{i}{path.suffix}")) for i in range(count)}
        return RecordingFiles(path, about, False, {i: at for i, at in numbered.items() if i == own or at.path.exists()})
    return RecordingFiles(path, about, False, {own: Place(path)})


def _described_together(path: pathlib.Path) -> int:
    """How many sensors of one file have a description: FILE.json, FILE.sensor1.json, and so on."""
    return next(i for i in itertools.count(1) if not pathlib.Path(f"{path}.sensor{i}.json").exists())


def _views(about: recording_pb2.Recording | None) -> list[int]:
    """By sensor; empty where the request is not known."""
    return [sensor.view for sensor in about.request.sensors] if about is not None else []
