"""A sequence of a data set: what the recipe has drawn for it, and where its files are."""
from __future__ import annotations

import json
import pathlib
from dataclasses import dataclass
from typing import Any

from saccade.recording import Recording
from saccade.stored.index import BAD_LINE
from saccade.stored.layout import damaged, folder_of, index_of


@dataclass(frozen=True)
class Sequence:
    """The contents of sequence.json.

    number: in the plan, from 0 on. split: such as "train".
    options: the words after `saccade record` that make it again. draws: the values of [draw] in the recipe, as text.
    path: the file of its events.
    """

    number: int
    shard: int
    split: str
    options: tuple[str, ...]
    draws: dict[str, str]
    path: pathlib.Path

    @property
    def recording(self) -> Recording:
        """All its sensors and cameras."""
        return Recording(self.path)


def read_sequence(root: pathlib.Path, shard: int, line: int, number: int, file: str) -> Sequence:
    """line: position in the list of the shard. Its files must be there, with the sizes that they had.

    Raises FormatError for those that are missing or damaged, and OSError.
    """
    path = index_of(root, shard)
    with path.open("rb") as lines:
        lines.seek(line)
        text = lines.readline()
    try:
        about = json.loads(text)
        if int(about.get("number", 0)) != number:
            raise ValueError("another sequence is there")
        found = Sequence(number, shard, about["split"], tuple(about.get("options", ())), dict(about.get("draws", {})),
                         folder_of(root, shard, number) / file)
        sizes = {item["name"]: int(item.get("bytes", 0)) for item in about.get("files", ())}
    except BAD_LINE as fault:
        raise damaged(root, path, f"sequence {number} is not at byte {line}: {fault!r}") from fault
    _check_size(root, found.path, sizes)
    return found


def _check_size(root: pathlib.Path, path: pathlib.Path, sizes: dict[str, Any]) -> None:
    try:
        size = path.stat().st_size
    except FileNotFoundError:
        raise damaged(root, path, "the file is missing") from None
    if size != sizes.get(path.name, size):
        raise damaged(root, path, f"it has {size} bytes, not {sizes[path.name]}")
