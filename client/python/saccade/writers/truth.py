"""The truth channels of a stream as arrays, under their names in files."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from saccade.protocol.samples import TYPES
from saccade.truth import Truth, TruthArrays
from saccade.v1 import control_pb2, events_pb2, recording_pb2, truth_pb2

Described = dict[str, truth_pb2.TruthInfo]  # by name, as the server tells


class Channel(NamedTuple):
    """name: among those of its view; an .h5 has it in the group of the view."""

    view: int
    name: str
    arrays: TruthArrays


def gather_truth(samples: Sequence[Truth], about: recording_pb2.Recording, known: Described) -> dict[str, Channel]:
    """The channels that belong to the sensor of `about`, by the names in recording.proto. Describes them there."""
    request = about.request
    own, names, channels = request.sensors[about.sensor].view, list[str](), dict[str, Channel]()
    for index, asked in enumerate(request.truth):
        if sensor_of(request, asked) != about.sensor:
            continue
        name = asked.name + ("" if asked.view == own else f"_view{asked.view}")
        number = f"_{names.count(name)}" if name in names else ""
        names.append(name)
        view = request.further_views[asked.view - 1] if asked.view else request.view
        arrays = _arrays([sample for sample in samples if sample.channel == index], known[asked.name], view)
        channels[name + number] = Channel(asked.view, asked.name + number, arrays)
        about.truth.add(name=name + number, info=known[asked.name], width=view.width, height=view.height,
                        samples=len(arrays.t))
    return channels


def sensor_of(request: control_pb2.OpenStream, asked: truth_pb2.Truth) -> int:
    """The first sensor of its view; 0 where there is none."""
    views = [sensor.view for sensor in request.sensors]
    return views.index(asked.view) if asked.view in views else 0


def _arrays(samples: list[Truth], info: truth_pb2.TruthInfo, view: control_pb2.View) -> TruthArrays:
    picture = info.layout == events_pb2.LAYOUT_PICTURE
    shape = ((view.height, view.width) if picture else ()) + (len(info.planes),)
    data: NDArray[Any] = np.empty((len(samples), *shape), TYPES[info.element])
    for row, sample in zip(data, samples):
        row[...] = sample.data
    exposure = np.array([sample.exposure or (0, 0) for sample in samples], np.int64).reshape(-1, 2) if picture else None
    times = np.array([sample.t for sample in samples], np.int64)
    return TruthArrays(times, data, exposure, tuple(info.planes), info.unit, info.description)
