"""Reads the truth channels of files, and the names of ids."""
from __future__ import annotations

import os
import pathlib
from typing import Any

import numpy as np

from saccade.errors import FormatError
from saccade.readers import FORMATS
from saccade.readers.files import find_files
from saccade.readers.sidecar import read_sidecar
from saccade.truth import IdNames, TruthArrays


def read_truth(path: str | os.PathLike[str], *, view: int | None = None) -> dict[str, TruthArrays]:
    """The truth channels of a camera in a recording, by name; empty without any.

    path: an .h5 or .npz file. Of a file of another format they are in the folder FILE.truth: its rows are read, such as
        poses. Its pictures are files of their own, and left out here.
    view: the number of the camera; by default that of the file's sensor, or of its first one. The sensors of a camera
        share its truth, so it may be in the file of another one: read_truth("a-1.h5") finds it in a-0.h5.

    Raises FormatError for an unknown extension, a view that is not there and faulty content, and OSError.
    """
    files = find_files(path)
    number = files.view_of(files.own) if view is None else view
    place = files.truth(number)
    if place is None:
        return {}
    path = place.path
    if path.suffix not in FORMATS:
        raise FormatError(f"{path}: the extension is not one of {', '.join(FORMATS)}")
    path.stat()  # raises OSError for a file that is not there
    try:
        if path.suffix == ".h5":
            channels = _of_hdf5(path, [place.group] if place.group else [f"view_{number}/", ""])
        else:
            channels = _of_npz(path) if path.suffix == ".npz" else _of_folder(path.with_name(path.name + ".truth"))
    except ImportError:
        raise
    except Exception as fault:
        if isinstance(fault, OSError) and fault.errno:
            raise
        raise FormatError(f"{path}: {fault}") from fault
    for name, channel in channels.items():
        if channel.t.shape != channel.data.shape[:1]:
            raise FormatError(f"{path}: {name} has {len(channel.data)} samples, but {len(channel.t)} times")
    return channels


def read_id_names(path: str | os.PathLike[str]) -> IdNames:
    """The names of the numbers in the channel ids of a recording, from PATH.json; empty without this channel.

    Raises FormatError for a file that is no such description, and OSError.
    """
    return IdNames.of(read_sidecar(path).id_names)


def _of_hdf5(path: pathlib.Path, groups: list[str]) -> dict[str, TruthArrays]:
    """From the first of the groups that has truth."""
    import h5py
    with h5py.File(path, "r") as file:
        found: Any = next((file[group + "truth"] for group in groups if group + "truth" in file), {})
        return {name: _of_group(group) for name, group in found.items()}


def _of_group(group: Any) -> TruthArrays:
    exposure = None
    if "exposure_begin" in group:
        exposure = np.stack([group["exposure_begin"][:], group["exposure_end"][:]], axis=1)
    planes = tuple(map(str, group.attrs.get("planes", ())))
    return TruthArrays(group["t"][:], group["data"][:], exposure, planes, str(group.attrs.get("unit", "")),
                       str(group.attrs.get("description", "")))


def _of_folder(folder: pathlib.Path) -> dict[str, TruthArrays]:
    """Channels of rows: NAME.csv, with the time in microseconds and the planes under their names."""
    channels = {}
    for path in sorted(folder.glob("*.csv")):
        with path.open(encoding="utf-8") as file:
            planes = file.readline().strip().split(",")[1:]
            rows = np.loadtxt(file, np.float64, delimiter=",", ndmin=2).reshape(-1, 1 + len(planes))
        channels[path.stem] = TruthArrays(rows[:, 0].astype(np.int64), rows[:, 1:], None, tuple(planes))
    return channels


def _of_npz(path: pathlib.Path) -> dict[str, TruthArrays]:
    """A channel NAME has the arrays NAME, NAME_t, and NAME_exposure if it is of pictures."""
    with np.load(path, allow_pickle=False) as file:
        names = [name for name in file.files if name + "_t" in file.files]
        return {name: TruthArrays(file[name + "_t"], file[name],
                                  file[name + "_exposure"] if name + "_exposure" in file.files else None)
                for name in names}
