"""AEDAT 4 as its public description has it, in the library `flatbuffers` of another author.

Field numbers are those of the schemas in the repository neuromorphicsystems/aedat, folder flatbuffers; the table of
packets is from dv-processing, data/FileDataTable. Nothing here comes from the .fbs files of Saccade.
"""
import struct
import xml.etree.ElementTree

import flatbuffers
import flatbuffers.encode
import flatbuffers.number_types as numbers
import flatbuffers.packer
import flatbuffers.table
import lz4.frame
import numpy
import zstandard

MAGIC = b"#!AER-DAT4.0\r\n"
NONE, LZ4, LZ4_HIGH, ZSTD, ZSTD_HIGH = range(5)
EVENT = numpy.dtype([("t", "<i8"), ("x", "<i2"), ("y", "<i2"), ("on", "?"), ("pad", "V3")])


def pack(data, compression):
    if compression in (LZ4, LZ4_HIGH):
        return lz4.frame.compress(data, compression_level=9 if compression == LZ4_HIGH else 0, store_size=False)
    return zstandard.compress(data) if compression in (ZSTD, ZSTD_HIGH) else data


def unpack(data, compression):
    if compression in (LZ4, LZ4_HIGH):
        return lz4.frame.decompress(data)
    return zstandard.ZstdDecompressor().decompressobj().decompress(data) if compression in (ZSTD, ZSTD_HIGH) else data


class Table:
    """A root table after its size, read by field numbers."""

    def __init__(self, data, identifier):
        (size,) = struct.unpack_from("<I", data)
        assert size == len(data) - 4, (size, len(data))
        assert data[8:12] == identifier, data[8:12]
        root = 4 + flatbuffers.encode.Get(flatbuffers.packer.uoffset, data, 4)
        self.table = flatbuffers.table.Table(data, root)

    def at(self, field):
        """The place of a field; 0: it is absent."""
        offset = self.table.Offset(4 + 2 * field)
        return offset and self.table.Pos + offset

    def number(self, field, flags, default=0):
        return self.table.Get(flags, self.at(field)) if self.at(field) else default

    def text(self, field):
        return self.table.String(self.at(field)).decode()

    def vector(self, field):
        """Place and length."""
        offset = self.at(field) - self.table.Pos
        return self.table.Vector(offset), self.table.VectorLen(offset)


def read_header(data):
    """Compression, position of the packet table, XML, and the size in bytes, from bytes that begin with the size."""
    (size,) = struct.unpack_from("<I", data)
    header = Table(data[:4 + size], b"IOHE")
    assert header.at(0) and header.at(1), "a default is left out, so the header cannot be written again in place"
    return header.number(0, numbers.Int32Flags), header.number(1, numbers.Int64Flags), header.text(2), 4 + size


def read_events(body):
    packet = Table(body, b"EVTS")
    start, count = packet.vector(0)
    assert start % 8 == 0, "events are not aligned"
    return numpy.frombuffer(body, EVENT, count, start)


def read_table(body):
    """(offset, stream, size, elements, first time, last time) of each packet."""
    table = Table(body, b"FTAB")
    if not table.at(0):
        return []
    start, count = table.vector(0)
    rows = []
    for i in range(count):
        row = Table.__new__(Table)
        row.table = flatbuffers.table.Table(body, table.table.Indirect(start + 4 * i))
        stream, size = struct.unpack_from("<ii", body, row.at(1))
        rows.append((row.number(0, numbers.Int64Flags), stream, size,
                     *(row.number(field, numbers.Int64Flags) for field in (2, 3, 4))))
    return rows


def attributes(node):
    """Key: (type, text) of a node of the XML."""
    return {a.get("key"): (a.get("type"), a.text) for a in node.findall("attr")}


def check_info(info, path):
    """Holds the XML against what dv-processing asks for; returns the attributes of stream 0 and of its info."""
    assert info.startswith("<dv"), "the first child of the document is another"
    dv = xml.etree.ElementTree.fromstring(info)
    assert dv.tag == "dv" and dv.get("version") == "2.0"
    (root,) = dv.findall("node")
    assert (root.get("name"), root.get("path")) == ("outInfo", path)
    (stream,) = root.findall("node")
    assert (stream.get("name"), stream.get("path")) == ("0", path + "0/")
    (about,) = stream.findall("node")
    assert (about.get("name"), about.get("path")) == ("info", path + "0/info/")
    named, told = attributes(stream), attributes(about)
    assert named["originalOutputName"] == ("string", "events")
    assert named["typeIdentifier"] == ("string", "EVTS")
    assert named["originalModuleName"][0] == "string" and named["originalModuleName"][1]
    model, serial = told["source"][1].split("_")
    assert told["source"][0] == "string" and model == "Saccade" and len(serial) == 8
    assert told["sizeX"][0] == told["sizeY"][0] == "int"
    return named, told


def make_header(compression, info, position=-1):
    builder = flatbuffers.Builder(1024)
    builder.ForceDefaults(True)
    text = builder.CreateString(info)
    builder.StartObject(3)
    builder.PrependInt64Slot(1, position, -1)
    builder.PrependUOffsetTRelativeSlot(2, text, 0)
    builder.PrependInt32Slot(0, compression, 0)
    builder.FinishSizePrefixed(builder.EndObject(), b"IOHE")
    return bytes(builder.Output())


def make_info(*streams):
    """Of (number, type, size) each."""
    nodes = "".join(
        f'<node name="{number}" path="/{number}/"><attr key="originalOutputName" type="string">{kind}</attr>'
        f'<attr key="typeIdentifier" type="string">{kind}</attr><node name="info" path="/{number}/info/">'
        f'<attr key="sizeX" type="int">{size[0]}</attr><attr key="sizeY" type="int">{size[1]}</attr></node></node>'
        for number, kind, size in streams)
    return f'<dv version="2.0"><node name="outInfo" path="/">{nodes}</node></dv>'


def make_packet(stream, events, compression, identifier=b"EVTS"):
    """Of (t, x, y, on) each."""
    builder = flatbuffers.Builder(1024)
    builder.StartVector(16, len(events), 8)
    for t, x, y, on in reversed(events):
        builder.Prep(8, 16)
        builder.Pad(3)
        builder.PrependBool(on)
        builder.PrependInt16(y)
        builder.PrependInt16(x)
        builder.PrependInt64(t)
    vector = builder.EndVector()
    builder.StartObject(1)
    builder.PrependUOffsetTRelativeSlot(0, vector, 0)
    builder.FinishSizePrefixed(builder.EndObject(), identifier)
    body = pack(bytes(builder.Output()), compression)
    return struct.pack("<ii", stream, len(body)) + body
