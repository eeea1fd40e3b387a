"""FILE.json, which `saccade record` writes beside FILE."""
from __future__ import annotations

import os
import pathlib

from google.protobuf.json_format import Parse, ParseError

from saccade.errors import FormatError
from saccade.v1 import recording_pb2


def read_sidecar(path: str | os.PathLike[str]) -> recording_pb2.Recording:
    """What PATH.json says of PATH. Raises FormatError for a file that is no such description, and OSError."""
    file = pathlib.Path(f"{os.fspath(path)}.json")
    try:
        about = recording_pb2.Recording()
        Parse(file.read_text(encoding="utf-8"), about)
    except (ParseError, UnicodeDecodeError) as fault:
        raise FormatError(f"{file}: {fault}") from fault
    return about


def sidecar_of(path: str | os.PathLike[str]) -> recording_pb2.Recording | None:
    """The same; None where there is no PATH.json."""
    try:
        return read_sidecar(path)
    except FileNotFoundError:
        return None
