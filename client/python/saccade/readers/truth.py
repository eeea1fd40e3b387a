"""Reads the truth channels of files, and the names of ids."""
from __future__ import annotations

import os
import pathlib
from typing import Any

import numpy as np
from google.protobuf.json_format import Parse, ParseError

from saccade.errors import FormatError
from saccade.truth import IdNames, TruthArrays
from saccade.v1 import recording_pb2


def read_truth(path: str | os.PathLike[str]) -> dict[str, TruthArrays]:
    """The truth channels of an .h5 or .npz file, by name; empty for a file without any.

    Raises FormatError for another extension and for faulty content, and OSError.
    """
    path = pathlib.Path(path)
    if path.suffix not in (".h5", ".npz"):
        raise FormatError(f"{path}: truth channels are read from .h5 and .npz; see {path.name}.truth for others")
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


def read_id_names(path: str | os.PathLike[str]) -> IdNames:
    """The names of the numbers in the channel ids of a recording, from PATH.json; empty without this channel.

    Raises FormatError for a file that is no such description, and OSError.
    """
    file = pathlib.Path(f"{os.fspath(path)}.json")
    try:
        recording = Parse(file.read_text(encoding="utf-8"), recording_pb2.Recording())
    except (ParseError, UnicodeDecodeError) as fault:
        raise FormatError(f"{file}: {fault}") from fault
    return IdNames.of(recording.id_names)


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
