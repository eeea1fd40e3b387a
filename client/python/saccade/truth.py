"""Samples of truth channels: what the renderer and the path know exactly."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.v1 import truth_pb2

OF_BODY = "imu"  # the channel of the body; the others are of a camera


@dataclass(frozen=True, eq=False)
class Truth:
    """One sample of a truth channel of a stream.

    name: of the channel; Client.info().truth describes all channels and names their planes.
    t: microseconds of stream time.
    data: a picture (height, width, planes), or a row (planes); a read-only view of the received packet.
    exposure: begin and end in microseconds of a picture that was exposed, else None.
    channel: index into `truth` of the request.
    view: the number of its camera, as further_views counts them from 1; None of the body, whose channel is imu.
    """

    name: str
    t: int
    data: NDArray[Any]
    exposure: tuple[int, int] | None
    channel: int
    view: int | None


@dataclass(frozen=True)
class IdNames:
    """The names of the shapes and materials in the channel ids, by number. A server names the first 4096 of each."""

    objects: dict[int, str]
    materials: dict[int, str]

    @classmethod
    def of(cls, names: truth_pb2.IdNames) -> IdNames:
        return cls(dict(enumerate(names.objects, 1)), dict(enumerate(names.materials, 1)))


@dataclass(frozen=True, eq=False)
class TruthArrays:
    """All samples of a truth channel in a file.

    t: int64 (n), microseconds. data: (n, height, width, planes) of pictures, (n, planes) of rows.
    exposure: int64 (n, 2), begin and end in microseconds, of pictures; 0 where a picture was not exposed. None of rows.
    planes, unit, description: as the server describes them; empty where the file does not tell them, as .npz.
    """

    t: NDArray[np.int64]
    data: NDArray[Any]
    exposure: NDArray[np.int64] | None
    planes: tuple[str, ...] = ()
    unit: str = ""
    description: str = ""
