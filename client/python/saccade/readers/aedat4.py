"""AEDAT 4 of inivation: a header table IOHE, then packets; those of the event stream hold a table EVTS.

Format: docs.inivation.com, "AEDAT 4.0". Times are as the file has them, often microseconds since 1970.
"""
from __future__ import annotations

import pathlib
import struct
import xml.etree.ElementTree as xml
from collections.abc import Callable, Iterator
from typing import BinaryIO, NamedTuple

import numpy as np

from saccade.errors import FormatError
from saccade.events import Events
from saccade.readers.columns import events_of
from saccade.readers.flatbuffer import Table
from saccade.windowing import windows

MAGIC = b"#!AER-DAT4.0\r\n"
EVENT = np.dtype([("t", "<i8"), ("x", "<i2"), ("y", "<i2"), ("on", "?"), ("padding", "V3")])


def _plain(body: bytes) -> bytes:
    return body


def _lz4(body: bytes) -> bytes:
    import lz4.frame
    return bytes(lz4.frame.decompress(body))


def _zstd(body: bytes) -> bytes:
    import zstandard
    return zstandard.ZstdDecompressor().decompressobj().decompress(body)


# NONE, LZ4, LZ4_HIGH, ZSTD, ZSTD_HIGH
COMPRESSIONS: list[Callable[[bytes], bytes]] = [_plain, _lz4, _lz4, _zstd, _zstd]


class Header(NamedTuple):
    decompress: Callable[[bytes], bytes]
    end: int  # of the packets, as position in the file; -1 where the recorder did not finish
    stream_id: int
    size: tuple[int, int]


def chunks(path: pathlib.Path, chunk: int) -> Iterator[Events]:
    with path.open("rb") as file:
        if file.read(len(MAGIC)) != MAGIC:
            raise FormatError("not an AEDAT 4.0 file")
        header = _read_header(file)
        yield from windows(_packets(file, header), count=chunk)


def _read_header(file: BinaryIO) -> Header:
    prefix = file.read(4)
    table = Table.root(prefix + file.read(struct.unpack("<I", prefix)[0]))
    compression = table.number(0, "i", 0)
    if not 0 <= compression < len(COMPRESSIONS):
        raise FormatError(f"compression {compression} is unknown")
    stream_id, size = _event_stream(xml.fromstring(table.text(2)))
    return Header(COMPRESSIONS[compression], table.number(1, "q", -1), stream_id, size)


def _event_stream(root: xml.Element) -> tuple[int, tuple[int, int]]:
    """Id and size of the one stream of events that the header describes."""
    nodes = root.findall(".//node[@name='outInfo']/node")
    streams = [node for node in nodes if _attribute(node, "typeIdentifier") == "EVTS"]
    if len(streams) != 1:
        raise FormatError(f"it holds {len(streams)} streams of events; one can be read")
    info = streams[0].find("node[@name='info']")
    if info is None:
        raise FormatError("the size of its stream is not there")
    return int(streams[0].attrib["name"]), (int(_attribute(info, "sizeX")), int(_attribute(info, "sizeY")))


def _attribute(node: xml.Element, key: str) -> str:
    return node.findtext(f"attr[@key='{key}']", "").strip()


def _packets(file: BinaryIO, header: Header) -> Iterator[Events]:
    """Those of the event stream."""
    while not 0 <= header.end <= file.tell() and (head := file.read(8)):
        stream_id, size = struct.unpack("<iI", head)
        body = file.read(size)
        if len(body) < size:
            raise FormatError("the file ends within a packet")
        if stream_id == header.stream_id:
            yield _events(header.decompress(body), header.size)


def _events(table: bytes, size: tuple[int, int]) -> Events:
    start, count = Table.root(table).vector(0)
    array = np.frombuffer(table, EVENT, count, start)
    return events_of(array["t"], array["x"], array["y"], array["on"], size)
