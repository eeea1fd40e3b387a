"""AEDAT4 files made with the FlatBuffers library, as the recorder of DV lays them out."""
import importlib.util
import pathlib
import struct
import sys
import tempfile
import unittest

import saccade

EVENTS = [(1700000000000005, 0, 1, True), (1700000000000007, 345, 259, False), (1700000000000009, 3, 3, True)]
STREAM = """
    <node name="{id}" path="/mainloop/Recorder/outInfo/{id}/">
        <attr key="compression" type="string">LZ4</attr>
        <attr key="typeIdentifier" type="string">{kind}</attr>
        <node name="info" path="/mainloop/Recorder/outInfo/{id}/info/">
            <attr key="sizeX" type="int">346</attr>
            <attr key="sizeY" type="int">260</attr>
        </node>
    </node>"""
XML = '<dv version="2.0"><node name="outInfo" path="/mainloop/Recorder/outInfo/">{}</node></dv>'
CAMERA = XML.format(STREAM.format(id=0, kind="FRME") + STREAM.format(id=1, kind="EVTS"))


def sized_buffer(identifier, fill):
    import flatbuffers
    builder = flatbuffers.Builder(0)
    builder.FinishSizePrefixed(fill(builder), identifier)
    return bytes(builder.Output())


def header(compression, table_at, xml):
    def fill(builder):
        text = builder.CreateString(xml)
        builder.StartObject(3)
        builder.PrependInt32Slot(0, compression, 0)
        builder.PrependInt64Slot(1, table_at, 0)
        builder.PrependUOffsetTRelativeSlot(2, text, 0)
        return builder.EndObject()
    return b"#!AER-DAT4.0\r\n" + sized_buffer(b"IOHE", fill)


def packet(events, compress, stream=1):
    def fill(builder):
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
        return builder.EndObject()
    body = compress(sized_buffer(b"EVTS", fill))
    return struct.pack("<ii", stream, len(body)) + body


def plain(body):
    return body


class Aedat4(unittest.TestCase):
    def read(self, content):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.aedat4"
            path.write_bytes(content)
            return saccade.read(path)

    def expect(self, content):
        found = self.read(content)
        rows = list(zip(found.t.tolist(), found.x.tolist(), found.y.tolist(), found.p.tolist()))
        self.assertEqual((rows, found.size), (EVENTS, (346, 260)))

    def test_every_compression(self):
        import lz4.frame
        import zstandard
        zstd = zstandard.ZstdCompressor(write_content_size=False).compress
        for number, compress in enumerate([plain, lz4.frame.compress, lz4.frame.compress, zstd, zstd]):
            with self.subTest(number):
                self.expect(header(number, -1, CAMERA) + packet(EVENTS[:2], compress) + packet(EVENTS[2:], compress))

    def test_other_streams_and_the_table_at_the_end_are_left_out(self):
        packets = packet(EVENTS, plain) + packet(EVENTS, plain, stream=0)
        end = len(header(0, 1 << 40, CAMERA)) + len(packets)
        self.expect(header(0, end, CAMERA) + packets + b"a table")

    def test_faults_are_told(self):
        whole = header(0, -1, CAMERA) + packet(EVENTS, plain)
        stereo = XML.format(STREAM.format(id=0, kind="EVTS") + STREAM.format(id=1, kind="EVTS"))
        faults = {
            "not an AEDAT": b"no",
            "within a packet": whole[:-1],
            "holds 2 streams": header(0, -1, stereo),
            "compression 9": header(9, -1, CAMERA),
            "unclosed token": header(0, -1, "<dv"),
            "buffer of at least": whole[:20],
            "at offset": whole[:-60] + b"\xff" * 60,
            "x lies outside": header(0, -1, CAMERA) + packet([(1, -2, 0, True)], plain),
        }
        for text, content in faults.items():
            with self.subTest(text), self.assertRaisesRegex(saccade.FormatError, text):
                self.read(content)


if __name__ == "__main__":
    missing = [name for name in ("flatbuffers", "lz4", "zstandard") if importlib.util.find_spec(name) is None]
    if missing:
        print("skipped: this Python has no", ", ".join(missing))
        sys.exit(77)
    unittest.main()
