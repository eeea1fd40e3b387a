"""FILE.json, which describes the file of events FILE, as `saccade record`, `verify` and `replay` have it."""
from __future__ import annotations

import hashlib
import pathlib

import numpy as np
from google.protobuf.json_format import MessageToJson

from saccade.events import Events
from saccade.protocol.columns import NS_PER_US
from saccade.representations import known_size
from saccade.v1 import recording_pb2

_EVENT = np.dtype([("t", "<i8"), ("x", "<u2"), ("y", "<u2"), ("p", "u1")])  # 13 bytes, as recording.proto says


def digest_of(events: Events) -> str:
    """That of recording.proto, in hexadecimal."""
    rows = np.empty(len(events), _EVENT)
    for name in "txyp":
        rows[name] = getattr(events, name)
    return hashlib.blake2b(rows.tobytes(), digest_size=32).hexdigest()


def describe_events(events: Events) -> recording_pb2.Recording:
    """All that the events themselves tell. Raises ValueError where their size is unknown."""
    width, height = known_size(events)
    return recording_pb2.Recording(width=width, height=height, begin_ns=events.t0 * NS_PER_US,
                                   end_ns=events.t1 * NS_PER_US, events=len(events), digest=digest_of(events),
                                   sensor=events.sensor, labels=events.source is not None,
                                   object_ids=events.object is not None)


def write_description(path: pathlib.Path, about: recording_pb2.Recording) -> None:
    """Writes PATH.json."""
    text = MessageToJson(about, preserving_proto_field_name=True) + "\n"
    path.with_name(path.name + ".json").write_text(text, encoding="utf-8")
