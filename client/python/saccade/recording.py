"""A recording with all its sensors and cameras."""
from __future__ import annotations

import functools
import os
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from saccade.camera import Camera, cameras_of
from saccade.errors import FormatError
from saccade.events import Events
from saccade.readers import open_file, read
from saccade.readers.files import find_files
from saccade.readers.truth import read_id_names, read_truth
from saccade.truth import IdNames, TruthArrays
from saccade.v1 import control_pb2
from saccade.windowing import windows

US_PER_S = 1e6


class Recording:
    """All that `saccade record` or Stream.save() has written, on the clock of the recording.

    path: any of its files of events, such as a.h5, or a-0.npz or a-1.npz of numbered ones. FILE.json beside it tells of
        the others. Without that the file is a recording of one sensor, whose camera is not known.
    Files are read when they are asked for. Raises FormatError for faulty content, and OSError.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self._files = find_files(path)

    @property
    def request(self) -> control_pb2.OpenStream | None:
        """What the recording was made of, with all defaults filled in; None where that is not known."""
        about = self._files.about
        return about.request if about is not None and about.HasField("request") else None

    @property
    def sensors(self) -> list[int]:
        """The numbers of the sensors whose events are there."""
        return list(self._files.sensors)

    def view_of(self, sensor: int) -> int:
        """The number of the camera of a sensor."""
        return self._files.view_of(sensor)

    @functools.cached_property
    def cameras(self) -> list[Camera | None]:
        """The calibration of each camera, by view; None where it is not known."""
        try:
            return cameras_of(self.request) if self.request is not None else [None]
        except ValueError as fault:
            raise FormatError(f"{self._files.path}.json: {fault}") from fault

    @functools.cached_property
    def events(self) -> dict[int, Events]:
        """All events, by sensor. They begin where the recording began, and end where it ended."""
        return {sensor: read(self._files.path, sensor=sensor) for sensor in self.sensors}

    @functools.cached_property
    def truth(self) -> dict[int, dict[str, TruthArrays]]:
        """The truth channels, by view and name; the IMU of the body is with camera 0. See saccade.read_truth()."""
        return {view: read_truth(self._files.path, view=view) for view in self._files.views}

    @property
    def id_names(self) -> IdNames:
        """The names of the numbers in the truth channel ids: see saccade.read_id_names()."""
        return read_id_names(self._files.path)

    def windows(self, *, duration_us: int | None = None, count: int | None = None, sensor: int | None = None
                ) -> Iterator[Events]:
        """Windows of a sensor, by default the first: see saccade.windows(). The file is read piece by piece.

        Windows of a duration begin where the recording began, so those of all sensors have the same times.
        """
        number = self.sensors[0] if sensor is None else sensor
        return windows(open_file(self._files.path, sensor=number), duration_us=duration_us, count=count)

    def poses(self, view: int = 0) -> NDArray[np.float64]:
        """T_world_camera at each frame, (n, 8): time in seconds, x y z, and the quaternion x y z w.

        The setting `trajectory` takes them. Raises FormatError for a recording without the truth channel pose.
        """
        channels = self.truth.get(view, {})
        if "pose" not in channels:
            raise FormatError(f"{self._files.path}: view {view} has no truth channel 'pose': record with --truth pose")
        pose = channels["pose"]
        return np.column_stack([pose.t / US_PER_S, pose.data])

    def save_tum(self, path: str | os.PathLike[str], view: int = 0) -> None:
        """Writes poses() as TUM text, lines `t x y z qx qy qz qw`, such as evo reads. Raises OSError too."""
        np.savetxt(path, self.poses(view), fmt=["%.6f"] + ["%.17g"] * 7)
