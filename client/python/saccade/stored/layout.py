"""Where the files of a data set are, and what its plan says."""
from __future__ import annotations

import contextlib
import pathlib
from collections.abc import Iterator

from google.protobuf.json_format import Parse, ParseError

from saccade.errors import FormatError
from saccade.v1 import dataset_pb2


def index_of(root: pathlib.Path, shard: int) -> pathlib.Path:
    """The list of the sequences of a shard, one a line."""
    return root / "shards" / f"{shard:05}" / "index.jsonl"


def folder_of(root: pathlib.Path, shard: int, number: int) -> pathlib.Path:
    return root / "shards" / f"{shard:05}" / f"{number:06}"


class Damaged(FormatError):
    """It names the file, and what to do."""


def damaged(root: pathlib.Path, path: pathlib.Path, why: object) -> Damaged:
    """The error for a file of a data set."""
    return Damaged(f"{path}: {why}. `saccade-farm verify {root}` names all that is damaged or missing")


@contextlib.contextmanager
def naming(root: pathlib.Path, path: pathlib.Path) -> Iterator[None]:
    """Makes the error for a file of all that reading it raises, but for errors of the system, such as no memory."""
    try:
        yield
    except (ImportError, MemoryError, Damaged):
        raise
    except OSError as fault:
        if fault.errno and not isinstance(fault, FileNotFoundError):
            raise
        raise damaged(root, path, fault) from fault
    except Exception as fault:
        raise damaged(root, path, fault) from fault


def read_plan(root: pathlib.Path) -> dataset_pb2.DataSetPlan:
    """Raises FormatError where the folder is no data set."""
    path = root / "plan.json"
    try:
        plan = dataset_pb2.DataSetPlan()
        Parse(path.read_text(encoding="utf-8"), plan, ignore_unknown_fields=True)
    except (FileNotFoundError, NotADirectoryError):
        raise FormatError(f"{path} is missing: {root} is no data set that `saccade-farm plan` has made") from None
    except (ParseError, UnicodeDecodeError) as fault:
        raise damaged(root, path, fault) from fault
    return plan


def finished_shards(root: pathlib.Path, plan: dataset_pb2.DataSetPlan, partial: bool) -> list[int]:
    """Those whose sequences are all there. Raises FormatError where others are missing, but for `partial`."""
    found = [shard for shard in range(plan.shards) if index_of(root, shard).exists()]
    if found and (partial or len(found) == plan.shards):
        return found
    missing = min(set(range(plan.shards)).difference(found), default=0)
    hint = "; partial=True reads the shards that are finished" if found else ""
    raise FormatError(f"{index_of(root, missing)} is missing: {len(found)} of {plan.shards} shards are finished. "
                      f"`saccade-farm run {root}` makes the others{hint}")
