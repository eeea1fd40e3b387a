"""Text files of one event per line, as `saccade record` writes them."""
from __future__ import annotations

import pathlib
import warnings
from collections.abc import Iterator
from typing import TextIO

import numpy as np

from saccade.errors import FormatError
from saccade.events import Events
from saccade.readers.columns import events_of

US_PER_S = 1e6


def csv_chunks(path: pathlib.Path, chunk: int) -> Iterator[Events]:
    """Lines `t,x,y,p`, whole microseconds, under a heading of these words; older files have `t_us`."""
    with path.open() as file:
        heading = file.readline().strip()
        if heading not in ("t,x,y,p", "t_us,x,y,p"):
            raise FormatError(f"the heading is '{heading[:40]}', not 't,x,y,p'")
        yield from _chunks(file, ",", chunk, 1.0, None)


def txt_chunks(path: pathlib.Path, chunk: int) -> Iterator[Events]:
    """Lines `t x y p` with t in seconds, under a line `width height` or none."""
    with path.open() as file:
        first = file.readline().split()
        size = None
        if len(first) == 2 and all(word.isdecimal() for word in first):
            size = int(first[0]), int(first[1])
        else:
            file.seek(0)
        yield from _chunks(file, None, chunk, US_PER_S, size)


def _chunks(file: TextIO, delimiter: str | None, chunk: int, us_per_unit: float,
            size: tuple[int, int] | None) -> Iterator[Events]:
    while True:
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "loadtxt: input contained no data")
            rows = np.loadtxt(file, np.float64, delimiter=delimiter, max_rows=chunk, ndmin=2)
        if rows.size == 0:
            return
        if rows.shape[1] != 4:
            raise FormatError(f"a line has {rows.shape[1]} numbers instead of 4")
        t, x, y, p = rows.T
        yield events_of(np.rint(t * us_per_unit), x, y, p, size)
