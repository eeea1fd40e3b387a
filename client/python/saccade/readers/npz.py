""".npz with the arrays t (microseconds), x, y, p, and the numbers width and height, as evutils and spikingjelly do.

Labels are the arrays source and artefact, and objects the array object.
"""
from __future__ import annotations

import pathlib
from collections.abc import Iterator

import numpy as np

from saccade.errors import FormatError
from saccade.events import Events
from saccade.readers.columns import events_of, fact_names


def chunks(path: pathlib.Path, chunk: int) -> Iterator[Events]:
    with np.load(path, allow_pickle=False) as file:
        missing = {"t", "x", "y", "p"} - set(file.files)
        if missing:
            raise FormatError(f"no array '{min(missing)}'")
        sized = {"width", "height"} <= set(file.files)
        size = (int(file["width"]), int(file["height"])) if sized else None
        columns = [file[name] for name in "txyp"]
        facts = {name: file[name] for name in fact_names(file.files)}
    t, x, y, p = columns
    for first in range(0, max(column.size for column in columns), chunk):
        part = slice(first, first + chunk)
        yield events_of(t[part], x[part], y[part], p[part], size,
                        {name: column[part] for name, column in facts.items()})
