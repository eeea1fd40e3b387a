"""Writes the events of a stream, its truth, and the descriptions beside them."""
from __future__ import annotations

import os
import pathlib
from collections.abc import Iterable, Mapping
from typing import Union

from saccade.events import Events, concatenate
from saccade.truth import Truth
from saccade.v1 import control_pb2, recording_pb2
from saccade.writers.description import describe_events, write_description
from saccade.writers.hdf5 import write_hdf5
from saccade.writers.npz import write_npz
from saccade.writers.truth import Channel, Described, gather_truth, sensor_of

Items = Union[Events, Iterable[Union[Events, Truth]]]
ROS = (".bag", ".mcap")


class Saved:
    """What is saved of a stream: the events of each sensor, and samples of truth.

    Raises ValueError for another extension and without events, and TypeError for other items.
    """

    def __init__(self, path: str | os.PathLike[str], items: Items) -> None:
        self.path = pathlib.Path(path)
        _check_extension(self.path)
        parts: dict[int, list[Events]] = {}
        self._samples: list[Truth] = []
        if not isinstance(items, (Events, Iterable)):
            raise TypeError(f"Events and Truth are saved, not {type(items).__name__}")
        for item in [items] if isinstance(items, Events) else items:
            if isinstance(item, Truth):
                self._samples.append(item)
            elif isinstance(item, Events):
                parts.setdefault(item.sensor, []).append(item)
            else:
                raise TypeError(f"Events and Truth are saved, not {type(item).__name__}")
        if not parts:
            raise ValueError("there are no Events to save")
        self.sensors = {sensor: concatenate(parts[sensor]) for sensor in sorted(parts)}
        self._abouts: dict[int, recording_pb2.Recording] = {}
        self._truth: dict[int, dict[str, Channel]] = {}  # by sensor

    def write(self, maker: recording_pb2.Recording, suppressed: Mapping[int, int], known: Described) -> None:
        """maker: what the descriptions of all sensors have in common. suppressed: events, by sensor.

        Raises ValueError where some sensors lack, and ImportError without h5py.
        """
        self._check_sensors(maker.request)
        for sensor, events in self.sensors.items():
            about = describe_events(events)
            about.MergeFrom(maker)
            about.suppressed = suppressed[sensor]
            self._abouts[sensor] = about
            self._truth[sensor] = gather_truth(self._samples, about, known) if self._samples else {}
        (self._write_hdf5 if self.path.suffix == ".h5" else self._write_npz)()

    def _check_sensors(self, request: control_pb2.OpenStream) -> None:
        count, given = len(request.sensors), ", ".join(map(str, self.sensors))
        if len(self.sensors) not in (1, count):
            raise ValueError(f"these are the events of the sensors {given}: save those of one, or of all {count}")
        for sample in self._samples:
            if (home := sensor_of(request, request.truth[sample.channel])) not in self.sensors:
                raise ValueError(f"the truth '{sample.name}' goes with the events of sensor {home}, not with {given}")

    def _write_hdf5(self) -> None:
        """Sensor k in the group sensor_k, or alone at the root, and the truth of view v in view_v."""
        alone = len(self.sensors) == 1
        sensors = {_group("sensor", 0 if alone else i): events for i, events in self.sensors.items()}
        truth = {f"{_group('view', channel.view)}/truth/{channel.name}": channel.arrays
                 for channels in self._truth.values() for channel in channels.values()}
        write_hdf5(self.path, sensors, truth)
        for sensor, about in self._abouts.items():
            number = "" if alone or sensor == 0 else f".sensor{sensor}"
            write_description(self.path.with_name(self.path.name + number), about)

    def _write_npz(self) -> None:
        """Numbered files, but for one sensor alone."""
        for sensor, events in self.sensors.items():
            number = "" if len(self.sensors) == 1 else f"-{sensor}"
            path = self.path.with_name(f"{self.path.stem}{number}.npz")
            write_npz(path, events, {name: channel.arrays for name, channel in self._truth[sensor].items()})
            write_description(path, self._abouts[sensor])


def _group(what: str, number: int) -> str:
    return f"/{what}_{number}" if number > 0 else "/"


def _check_extension(path: pathlib.Path) -> None:
    if path.suffix in ROS:
        raise ValueError(f"{path}: a stream is saved as .npz or .h5. Then `saccade replay FILE.json -o {path.name}` "
                         f"makes a file for ROS of all of it, or `saccade convert FILE {path.name}` of the events alone")
    if path.suffix not in (".npz", ".h5"):
        raise ValueError(f"{path} does not end with .npz or .h5, which are written; `saccade convert` makes other "
                         "formats of them")
