"""Reads the payloads of truth channels as numpy arrays."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from saccade.errors import PacketFault
from saccade.protocol.columns import NS_PER_US
from saccade.v1 import events_pb2 as pb

MOST_ROWS = 32768
MOST_PLANES = {pb.LAYOUT_PICTURE: 4, pb.LAYOUT_ROWS: 16}
MOST_PIXELS = 4 << 20
TYPES = {pb.ELEMENT_F32: "<f4", pb.ELEMENT_F64: "<f8", pb.ELEMENT_U8: "u1", pb.ELEMENT_U16: "<u2", pb.ELEMENT_U32: "<u4"}
BYTES_PER_TIME = 4  # of a row


@dataclass(frozen=True)
class Samples:
    """The samples of one packet.

    t: int64 (n), microseconds. data: (n, height, width, planes) of pictures, (n, planes) of rows; a view of the packet.
    exposure: begin and end in microseconds; None of rows, and of pictures that were not exposed.
    """

    t: NDArray[np.int64]
    data: NDArray[Any]
    exposure: tuple[int, int] | None = None

    def after(self, known: int) -> Samples:
        """Without the first `known`."""
        return Samples(self.t[known:], self.data[known:], self.exposure)


def check_truth(header: pb.PacketHeader) -> None:
    """Raises PacketFault for a header of no truth channel."""
    if header.element not in TYPES:
        raise PacketFault(f"element {header.element} is unknown")
    if header.layout not in MOST_PLANES:
        raise PacketFault(f"layout {header.layout} of a truth channel")
    if not 0 < header.planes <= MOST_PLANES[header.layout]:
        raise PacketFault(f"{header.planes} planes: 1 to {MOST_PLANES[header.layout]} are valid")
    if not 0 <= header.t0_ns <= header.t1_ns:
        raise PacketFault("an interval that runs backwards")
    if header.layout == pb.LAYOUT_PICTURE:
        if header.count > 1:
            raise PacketFault("a packet carries one picture")
        if not 0 < header.width * header.height <= MOST_PIXELS:
            raise PacketFault(f"{header.width * header.height} pixels of a picture")
    elif header.count > MOST_ROWS:
        raise PacketFault(f"count is above {MOST_ROWS}")
    elif header.dt_unit_ns == 0:
        raise PacketFault("dt_unit_ns is 0")


def truth_bytes(header: pb.PacketHeader) -> int:
    """Bytes of the payload, after check_truth()."""
    plane = np.dtype(TYPES[header.element]).itemsize * header.planes
    if header.layout == pb.LAYOUT_PICTURE:
        return int(header.count * plane * header.width * header.height)
    return int(header.count * (BYTES_PER_TIME + plane))


def read_samples(header: pb.PacketHeader, payload: bytes) -> Samples:
    """The samples of a payload of truth_bytes(). Raises PacketFault for a bad time."""
    n, kind = header.count, TYPES[header.element]
    if header.layout == pb.LAYOUT_PICTURE:
        planes = np.frombuffer(payload, kind).reshape(n, header.planes, header.height, header.width)
        exposed = header.exposure_end_ns > header.exposure_begin_ns
        exposure = (header.exposure_begin_ns // NS_PER_US, header.exposure_end_ns // NS_PER_US) if exposed else None
        return Samples(np.full(n, header.t1_ns // NS_PER_US, np.int64), planes.transpose(0, 2, 3, 1), exposure)
    after_ns = np.frombuffer(payload, "<u4", n).astype(np.int64) * header.dt_unit_ns
    if (after_ns[1:] < after_ns[:-1]).any():
        raise PacketFault("times that run backwards")
    if n > 0 and after_ns[-1] > header.t1_ns - header.t0_ns:
        raise PacketFault("a time outside the packet's interval")
    rows = np.frombuffer(payload, kind, n * header.planes, offset=BYTES_PER_TIME * n)
    return Samples((header.t0_ns + after_ns) // NS_PER_US, rows.reshape(n, header.planes))
