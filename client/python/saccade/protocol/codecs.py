"""Decompression of payloads: one function for each codec."""
from __future__ import annotations

from collections.abc import Callable

from saccade.errors import PacketFault
from saccade.v1 import events_pb2


def _none(payload: bytes, size: int) -> bytes:
    return payload


def _zstd(payload: bytes, size: int) -> bytes:
    import zstandard
    try:
        content = zstandard.frame_content_size(payload)
        if content not in (size, -1):  # -1: the frame does not tell it. Otherwise so much memory would be taken.
            raise PacketFault(f"the payload is to hold {content} bytes instead of {size}")
        return zstandard.ZstdDecompressor().decompress(payload, max_output_size=size)
    except zstandard.ZstdError as fault:
        raise PacketFault(f"the payload cannot be decompressed: {fault}") from fault


CODECS: dict[int, Callable[[bytes, int], bytes]] = {events_pb2.CODEC_NONE: _none, events_pb2.CODEC_ZSTD: _zstd}


def decompress(codec: int, payload: bytes, size: int) -> bytes:
    """The payload, of exactly `size` bytes. Raises PacketFault otherwise, and ImportError without zstandard."""
    raw = CODECS[codec](payload, size)
    if len(raw) != size:
        raise PacketFault(f"the payload holds {len(raw)} bytes instead of {size}")
    return raw
