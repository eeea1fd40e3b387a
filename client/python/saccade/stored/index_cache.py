"""Keeps the index of a large data set in the user's folder of caches. The data set itself stays as it is."""
from __future__ import annotations

import contextlib
import hashlib
import json
import os
import pathlib
import tempfile

import numpy as np

from saccade.stored.index import ROW, Index, build_index
from saccade.stored.layout import index_of

KEPT_FROM = 10_000  # rows; fewer are read in a tenth of a second
VERSION = b"1"      # of the files in the cache


def load_index(root: pathlib.Path, shards: list[int], cache: pathlib.Path | None = None) -> Index:
    """The index, of the cache if it is there: then it is mapped into memory, and processes share it.

    cache: a folder; by default `saccade` in $XDG_CACHE_HOME or ~/.cache. A folder that cannot be written is left alone.
    Raises as build_index().
    """
    folder = cache if cache is not None else _default_folder()
    key = folder / _key(root, shards)
    with contextlib.suppress(OSError, ValueError, KeyError, TypeError):
        return _read(key)
    index = build_index(root, shards)
    if len(index.rows) >= KEPT_FROM or cache is not None:
        with contextlib.suppress(OSError):
            _write(key, index)
            return _read(key)
    return index


def _default_folder() -> pathlib.Path:
    given = os.environ.get("XDG_CACHE_HOME", "")
    return (pathlib.Path(given) if os.path.isabs(given) else pathlib.Path("~/.cache").expanduser()) / "saccade"


def _key(root: pathlib.Path, shards: list[int]) -> str:
    """Of the plan, and of the size and time of each list; a farm writes a list once."""
    digest = hashlib.blake2b(VERSION + (root / "plan.json").read_bytes(), digest_size=20)
    for shard in shards:
        state = index_of(root, shard).stat()
        digest.update(b"%d %d %d\n" % (shard, state.st_size, state.st_mtime_ns))
    return digest.hexdigest()


def _read(key: pathlib.Path) -> Index:
    """Raises ValueError for a file that is none of these."""
    names = json.loads(key.with_suffix(".json").read_text(encoding="utf-8"))
    rows = np.load(key.with_suffix(".npy"), mmap_mode="r", allow_pickle=False)
    if rows.dtype != ROW or len(rows) != names.pop("rows"):
        raise ValueError("another index")
    return Index(rows, **names)


def _write(key: pathlib.Path, index: Index) -> None:
    key.parent.mkdir(parents=True, exist_ok=True)
    names = {"rows": len(index.rows), "splits": index.splits, "files": index.files, "truth": index.truth,
             "joint": index.joint}
    with tempfile.TemporaryDirectory(dir=key.parent) as made:
        rows, text = pathlib.Path(made, "rows.npy"), pathlib.Path(made, "names.json")
        np.save(rows, index.rows)
        text.write_text(json.dumps(names), encoding="utf-8")
        os.replace(rows, key.with_suffix(".npy"))
        os.replace(text, key.with_suffix(".json"))
