"""Checks packets, in the order of "Checks of a receiver" in proto/PROTOCOL.md, and decodes them."""
from __future__ import annotations

import zlib
from dataclasses import dataclass

from google.protobuf.message import DecodeError

from saccade.errors import PacketFault
from saccade.events import Events
from saccade.protocol.codecs import CODECS, decompress
from saccade.protocol.columns import BYTES_PER_EVENT, BYTES_PER_PIXEL, Snapshot, read_columns, read_planes
from saccade.protocol.samples import Samples, check_truth, read_samples, truth_bytes
from saccade.v1 import events_pb2 as pb

MOST_EVENTS = 32768
MOST_SNAPSHOT_PIXELS = 4 << 20


@dataclass(frozen=True)
class Packet:
    """A checked packet. `content` is what its kind carries."""

    header: pb.PacketHeader
    content: Events | Snapshot | Samples | None = None


def read_header(head: bytes) -> pb.PacketHeader:
    try:
        header: pb.PacketHeader = pb.PacketHeader.FromString(head)
    except DecodeError as fault:
        raise PacketFault("the header cannot be read") from fault
    return header


def read_packet(head: bytes, payload: bytes) -> Packet:
    """Raises PacketFault for a packet that must not be used."""
    return decode_packet(read_header(head), payload)


def decode_packet(header: pb.PacketHeader, payload: bytes) -> Packet:
    """Raises PacketFault for a packet that must not be used. The payload of KIND_ERROR is a text, and no content."""
    _check_kind(header, len(payload))
    if zlib.crc32(payload) != header.crc32:
        raise PacketFault("crc32 does not match the payload")
    if header.kind == pb.KIND_EVENTS:
        size = BYTES_PER_EVENT[header.layout] * header.count
        return Packet(header, read_columns(header, decompress(header.codec, payload, size)))
    if header.kind == pb.KIND_SNAPSHOT:
        size = BYTES_PER_PIXEL * header.width * header.height
        return Packet(header, read_planes(header, decompress(header.codec, payload, size)))
    if header.kind == pb.KIND_TRUTH:
        return Packet(header, read_samples(header, decompress(header.codec, payload, truth_bytes(header))))
    return Packet(header)


def _check_kind(header: pb.PacketHeader, payload_bytes: int) -> None:
    if header.kind == pb.KIND_EVENTS:
        if header.count > MOST_EVENTS:
            raise PacketFault(f"count is above {MOST_EVENTS}")
        if header.dt_unit_ns == 0:
            raise PacketFault("dt_unit_ns is 0")
        _check_coding(header, *BYTES_PER_EVENT)
    elif header.kind == pb.KIND_SNAPSHOT:
        pixels = header.width * header.height
        if not 0 < pixels <= MOST_SNAPSHOT_PIXELS:
            raise PacketFault(f"{pixels} pixels: 1 to {MOST_SNAPSHOT_PIXELS} are valid")
        if header.count > 0:
            raise PacketFault("a snapshot carries no events")
        _check_coding(header, pb.LAYOUT_PLANES)
    elif header.kind == pb.KIND_TRUTH:
        check_truth(header)
        _check_codec(header)
    elif header.kind in (pb.KIND_HEARTBEAT, pb.KIND_END):
        if header.count > 0 or payload_bytes > 0:
            raise PacketFault("a packet of its kind carries no events")
    elif header.kind != pb.KIND_ERROR:
        raise PacketFault(f"kind {header.kind} is unknown")


def _check_coding(header: pb.PacketHeader, *layouts: int) -> None:
    if header.layout not in layouts:
        raise PacketFault(f"layout {header.layout} instead of {layouts[0]}")
    _check_codec(header)


def _check_codec(header: pb.PacketHeader) -> None:
    if header.codec not in CODECS:
        raise PacketFault(f"codec {header.codec} is unknown")
