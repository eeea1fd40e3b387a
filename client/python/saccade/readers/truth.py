"""Reads the truth channels of files, and the names of ids."""
from __future__ import annotations

import os
import pathlib
from typing import Any

import numpy as np

from saccade.errors import FormatError
from saccade.readers.sidecar import read_sidecar, sidecar_of
from saccade.truth import IdNames, TruthArrays


def read_truth(path: str | os.PathLike[str]) -> dict[str, TruthArrays]:
    """The truth channels of an .h5 or .npz file, by name; empty for a file without any.

    A recording with several sensors of a camera keeps its truth in the file of the first one, such as a-0.h5. It is read
    from there for the others, such as a-1.h5.

    Raises FormatError for another extension and for faulty content, and OSError.
    """
    path = pathlib.Path(path)
    if path.suffix not in (".h5", ".npz"):
        raise FormatError(f"{path}: truth channels are read from .h5 and .npz; see {path.name}.truth for others")
    path = _with_truth(path)
    try:
        channels = _of_hdf5(path) if path.suffix == ".h5" else _of_npz(path)
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


def _with_truth(path: pathlib.Path) -> pathlib.Path:
    """The file of the first sensor of the same view, where PATH.json tells of several; else the path itself."""
    about = sidecar_of(path)
    if about is None or not about.request.truth or about.sensor >= len(about.request.sensors):
        return path
    views = [sensor.view for sensor in about.request.sensors]
    first, own = views.index(views[about.sensor]), f"-{about.sensor}"
    return path.with_stem(path.stem.removesuffix(own) + f"-{first}") if path.stem.endswith(own) else path


def read_id_names(path: str | os.PathLike[str]) -> IdNames:
    """The names of the numbers in the channel ids of a recording, from PATH.json; empty without this channel.

    Raises FormatError for a file that is no such description, and OSError.
    """
    return IdNames.of(read_sidecar(path).id_names)


def _of_hdf5(path: pathlib.Path) -> dict[str, TruthArrays]:
    import h5py
    with h5py.File(path, "r") as file:
        groups = file["truth"].items() if "truth" in file else ()
        return {name: _of_group(group) for name, group in groups}


def _of_group(group: Any) -> TruthArrays:
    exposure = None
    if "exposure_begin" in group:
        exposure = np.stack([group["exposure_begin"][:], group["exposure_end"][:]], axis=1)
    planes = tuple(map(str, group.attrs.get("planes", ())))
    return TruthArrays(group["t"][:], group["data"][:], exposure, planes, str(group.attrs.get("unit", "")),
                       str(group.attrs.get("description", "")))


def _of_npz(path: pathlib.Path) -> dict[str, TruthArrays]:
    """A channel NAME has the arrays NAME, NAME_t, and NAME_exposure if it is of pictures."""
    with np.load(path, allow_pickle=False) as file:
        names = [name for name in file.files if name + "_t" in file.files]
        return {name: TruthArrays(file[name + "_t"], file[name],
                                  file[name + "_exposure"] if name + "_exposure" in file.files else None)
                for name in names}
