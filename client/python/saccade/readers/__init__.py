"""Reads files of events: one module for each format, and the table of all.

The modules raise what their libraries do, and FormatError; open_file() makes one FormatError of it, with the path.
"""
from __future__ import annotations

import os
import pathlib
from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from saccade.errors import FormatError
from saccade.events import Events, concatenate
from saccade.readers import aedat4, dsec, npz, raw, text
from saccade.readers.columns import events_of
from saccade.readers.files import Place, find_files
from saccade.readers.recorded import within_recording

CHUNK = 1_000_000  # events
NONE = np.empty(0)

Chunks = Callable[[pathlib.Path, int], Iterator[Events]]
FORMATS: dict[str, Chunks] = {
    ".raw": raw.chunks,
    ".aedat4": aedat4.chunks,
    ".h5": dsec.chunks,
    ".npz": npz.chunks,
    ".csv": text.csv_chunks,
    ".txt": text.txt_chunks,
}


def open_file(path: str | os.PathLike[str], *, size: tuple[int, int] | None = None, sensor: int | None = None,
              chunk: int = CHUNK) -> Iterator[Events]:
    """The events of a file, piece by piece. The extension names the format:

    .raw: Prophesee RAW of EVT2 or EVT3. .aedat4: inivation AEDAT 4, which needs lz4 or zstandard if compressed.
    .h5: HDF5 as DSEC has it, which needs h5py. .npz: numpy arrays t (microseconds), x, y, p.
    .csv: lines t,x,y,p under a heading, t in microseconds. .txt: lines t x y p, t in seconds, under a line
        `width height` or none.
    sensor: of a recording with several, in one .h5 or in numbered files, of which any may be given; by default that of
        the file, or its first one.
    chunk: events of a piece; words of a RAW file, which hold about as many.
    size: width and height of the sensor, for files that do not tell them; others must agree.

    PATH.json beside the file, as `saccade record` writes it, tells the size and the camera, and when the recording
    began and ended: the first piece covers the time from there, and the last one up to there. Without it they begin
    with the first event and end with the last.

    Raises FormatError (a ValueError) for an unknown extension, faulty content, a pixel outside the size, times that
    run backwards, and a PATH.json of another recording; and OSError.
    """
    path = pathlib.Path(path)
    if path.suffix not in FORMATS:
        raise FormatError(f"{path}: the extension is not one of {', '.join(FORMATS)}")
    files = find_files(path)
    number = files.own if sensor is None else sensor
    place, about = files.sensor(number), files.sidecar(number)
    if about is not None and about.width:
        size = size or (about.width, about.height)
    chunks = _checked(place.path, _pieces(place, chunk), size, number)
    return within_recording(place.path, chunks, about, size) if about is not None and about.end_ns else chunks


def read(path: str | os.PathLike[str], *, size: tuple[int, int] | None = None, sensor: int | None = None) -> Events:
    """All events of a sensor in a file, as open_file() gives them in pieces, with their interval."""
    parts = list(open_file(path, size=size, sensor=sensor))
    return concatenate(parts) if parts else events_of(NONE, NONE, NONE, NONE, size)


def _pieces(place: Place, chunk: int) -> Iterator[Events]:
    if place.group:
        return dsec.chunks(place.path, chunk, place.group)
    return FORMATS[place.path.suffix](place.path, chunk)


def _checked(path: pathlib.Path, chunks: Iterator[Events], size: tuple[int, int] | None,
             sensor: int) -> Iterator[Events]:
    newest = None  # time of the last event of the chunk before
    try:
        for events in chunks:
            if size is not None and events.size not in (None, size):
                raise FormatError(f"the size is {events.size}, not {size}")
            events = replace(events, size=events.size or size, sensor=sensor)
            if len(events):
                _check(events, newest)
                newest = int(events.t[-1])
                yield events
    except ImportError:
        raise
    except Exception as fault:
        if isinstance(fault, OSError) and fault.errno:  # of the system; h5py raises others for content
            raise
        raise FormatError(f"{path}: {fault}") from fault


def _check(events: Events, newest: int | None) -> None:
    if (events.t[1:] < events.t[:-1]).any() or (newest is not None and events.t[0] < newest):
        raise FormatError("times run backwards")
    if events.size is not None and (events.x.max() >= events.size[0] or events.y.max() >= events.size[1]):
        raise FormatError(f"a pixel lies outside {events.size[0]}x{events.size[1]}")
