"""Prophesee RAW: lines `% key value`, then words of EVT2 or EVT3.

Header: docs.prophesee.ai/stable/data/file_formats/raw.html.
"""
from __future__ import annotations

import pathlib
import re
from collections.abc import Iterator
from typing import Any, BinaryIO, Protocol

import numpy as np
from numpy.typing import NDArray

from saccade.errors import FormatError
from saccade.events import Events
from saccade.readers.columns import Columns
from saccade.readers.evt2 import Evt2Decoder
from saccade.readers.evt3 import Evt3Decoder

Size = tuple[int, int]


class Decoder(Protocol):
    """Decodes one block of words after the other; its state goes on from block to block."""

    WORD: np.dtype[Any]

    def decode(self, words: NDArray[Any]) -> Columns: ...


DECODERS: dict[str, type[Evt2Decoder] | type[Evt3Decoder]] = {"EVT2": Evt2Decoder, "EVT3": Evt3Decoder}


def chunks(path: pathlib.Path, chunk: int) -> Iterator[Events]:
    with path.open("rb") as file:
        name, size = _read_header(file)
        decoder: Decoder = DECODERS[name]()
        while block := file.read(chunk * decoder.WORD.itemsize):
            if len(block) % decoder.WORD.itemsize:
                raise FormatError("the file ends within a word")
            yield Events(*decoder.decode(np.frombuffer(block, decoder.WORD)), size=size)


def _read_header(file: BinaryIO) -> tuple[str, Size | None]:
    """Leaves the file behind the header."""
    keys: dict[str, str] = {}
    while True:
        start = file.tell()
        line = file.readline()
        if not line.startswith(b"% "):
            file.seek(start)
            break
        key, _, value = line[2:].decode("ascii", "replace").strip().partition(" ")
        if key == "end":
            break
        keys[key] = value
    return _format(keys), _size(keys)


def _format(keys: dict[str, str]) -> str:
    """Of `% format EVT3;height=720;width=1280`, or of `% evt 3.0`."""
    name = keys.get("format", "").partition(";")[0].upper() or "EVT" + keys.get("evt", "?").removesuffix(".0")
    if name not in DECODERS:
        raise FormatError(f"the encoding is '{name}', not one of {', '.join(DECODERS)}")
    return name


def _size(keys: dict[str, str]) -> Size | None:
    if match := re.fullmatch(r"(\d+)x(\d+)", keys.get("geometry", "")):
        return int(match[1]), int(match[2])
    parts = dict(re.findall(r"(width|height)=(\d+)", keys.get("format", "")))
    return (int(parts["width"]), int(parts["height"])) if len(parts) == 2 else None
