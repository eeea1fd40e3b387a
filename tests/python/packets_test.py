"""The packets of tests/wire/data, good and bad, and others that break one rule each."""
import json
import os
import pathlib
import struct
import unittest
import zlib

import zstandard

import saccade
from saccade.protocol.packets import read_packet
from saccade.v1 import events_pb2 as pb

VECTORS = sorted((pathlib.Path(os.environ["SOURCE"]) / "tests/wire/data").glob("*.bin"))


def packet(payload=b"\0" * 9, **fields):
    header = pb.PacketHeader(**{"kind": pb.KIND_EVENTS, "layout": pb.LAYOUT_COLUMNS, "codec": pb.CODEC_NONE, "count": 1,
                                "dt_unit_ns": 1000, "width": 2, "height": 2, "t1_ns": 1000,
                                "crc32": zlib.crc32(payload), **fields})
    return header.SerializeToString(), payload


class Packets(unittest.TestCase):
    def test_the_golden_packets(self):
        self.assertGreaterEqual(len(VECTORS), 17)
        for path in VECTORS:
            with self.subTest(path.name):
                self.check(path.read_bytes(), json.loads(path.with_suffix(".json").read_text()))

    def check(self, data, meaning):
        size = 4 + struct.unpack_from("<I", data)[0]
        if not meaning["valid"]:
            with self.assertRaises(saccade.PacketFault):
                read_packet(data[4:size], data[size:])
            return
        content = read_packet(data[4:size], data[size:]).content
        if isinstance(content, saccade.Snapshot):
            pixels = zip(content.brightness.ravel().tolist(), content.reference.ravel().tolist())
            self.assertEqual([list(pixel) for pixel in pixels], meaning["pixels"])
        elif content is not None:
            columns = (column.tolist() for column in (content.t, content.x, content.y, content.p))
            found = [list(event) for event in zip(*columns)]
            self.assertEqual(found, [[t // 1000, x, y, p] for t, x, y, p in meaning["events_t_ns_x_y_p"]])
            self.assertEqual(content.sensor, meaning["header"]["sensor"])

    def test_columns_are_views_of_the_payload(self):
        content = read_packet(*packet()).content
        for column in (content.x, content.y, content.p):
            self.assertIsNotNone(column.base)
            self.assertTrue(column.flags.aligned)
            self.assertFalse(column.flags.writeable)

    def test_rules_that_no_golden_packet_breaks(self):
        late = struct.pack("<IHHB", 1, 0, 0, 1)
        faults = {
            "header cannot be read": (b"\xff", b""),
            "is unknown": packet(kind=77),
            "codec 77": packet(codec=77),
            "dt_unit_ns is 0": packet(dt_unit_ns=0),
            "count is above": packet(count=32769),
            "carries no events": packet(kind=pb.KIND_HEARTBEAT),
            "runs backwards": packet(b"", count=0, t0_ns=2000, crc32=0),
            "outside the packet's interval": packet(late),
            "is to hold 1000000 bytes": packet(zstandard.compress(bytes(1_000_000)), codec=pb.CODEC_ZSTD),
            "0 pixels": packet(b"", kind=pb.KIND_SNAPSHOT, layout=pb.LAYOUT_PLANES, count=0, width=0),
        }
        for text, (head, payload) in faults.items():
            with self.subTest(text), self.assertRaisesRegex(saccade.PacketFault, text):
                read_packet(head, payload)

    def test_events_of_one_time_may_fill_an_empty_interval(self):
        self.assertEqual(len(read_packet(*packet(t1_ns=0)).content), 1)


if __name__ == "__main__":
    unittest.main()
