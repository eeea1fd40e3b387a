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


def truth(payload, **fields):
    """By default one picture of 2 x 2 pixels and two planes of u8."""
    return packet(payload, **{"kind": pb.KIND_TRUTH, "layout": pb.LAYOUT_PICTURE, "element": pb.ELEMENT_U8, "planes": 2,
                              **fields})


def row_truth(times, numbers, **fields):
    payload = struct.pack(f"<{len(times)}I{len(numbers)}H", *times, *numbers)
    return truth(payload, **{"layout": pb.LAYOUT_ROWS, "element": pb.ELEMENT_U16, "count": len(times), "t1_ns": 9000,
                             **fields})


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

    def test_labels_stand_behind_the_columns(self):
        columns = struct.pack("<IIHHHHBB", 0, 1, 0, 1, 0, 0, 1, 0)
        labelled = {"count": 2, "layout": pb.LAYOUT_LABELLED_COLUMNS, "t1_ns": 5000, "width": 2}
        content = read_packet(*packet(columns + bytes([0, 1, 51, 0]), **labelled)).content
        self.assertEqual((content.source.tolist(), content.artefact.tolist()), ([0, 1], [51, 0]))
        self.assertEqual(content[1:].source.tolist(), [1])
        self.assertEqual(saccade.concatenate([content[:1], content[1:]]).artefact.tolist(), [51, 0])
        self.assertIsNone(read_packet(*packet()).content.source)
        with self.assertRaisesRegex(saccade.PacketFault, "source"):
            read_packet(*packet(columns + bytes([0, 9, 0, 0]), **labelled))

    def test_objects_stand_behind_all_other_columns(self):
        columns = struct.pack("<IIHHHHBB", 0, 1, 0, 1, 0, 0, 1, 0)
        objects, common = struct.pack("<II", 7, 1 << 20), {"count": 2, "t1_ns": 5000, "width": 2}
        content = read_packet(*packet(columns + objects, layout=pb.LAYOUT_OBJECT_COLUMNS, **common)).content
        self.assertEqual(content.object.tolist(), [7, 1 << 20])
        self.assertIsNone(content.source)
        both = read_packet(*packet(columns + bytes([0, 1, 51, 0]) + objects, layout=pb.LAYOUT_LABELLED_OBJECT_COLUMNS,
                                   **common)).content
        self.assertEqual((both.source.tolist(), both.object.tolist()), ([0, 1], [7, 1 << 20]))
        self.assertEqual(saccade.concatenate([both[:1], both[1:]]).object.tolist(), [7, 1 << 20])
        self.assertIsNone(read_packet(*packet()).content.object)

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

    def test_a_picture_of_truth_has_its_planes_innermost(self):
        samples = read_packet(*truth(bytes(range(8)), exposure_begin_ns=500_000, exposure_end_ns=900_000)).content
        self.assertEqual(samples.data.tolist(), [[[[0, 4], [1, 5]], [[2, 6], [3, 7]]]])
        self.assertEqual((samples.t.tolist(), samples.exposure), ([1], (500, 900)))

    def test_rows_of_truth_have_a_time_each(self):
        samples = read_packet(*row_truth([0, 6, 6], range(6), t0_ns=3000)).content
        self.assertEqual((samples.t.tolist(), samples.exposure), ([3, 9, 9], None))
        self.assertEqual(samples.data.tolist(), [[0, 1], [2, 3], [4, 5]])
        self.assertEqual(samples.after(2).data.tolist(), [[4, 5]])
        self.assertEqual(samples.after(2).t.tolist(), [9])

    def test_truth_that_breaks_a_rule(self):
        faults = {
            "element 77": truth(bytes(8), element=77),
            "layout 1 of a truth": truth(bytes(8), layout=pb.LAYOUT_COLUMNS),
            "5 planes: 1 to 4": truth(bytes(20), planes=5),
            "0 planes": truth(b"", planes=0),
            "one picture": truth(bytes(16), count=2),
            "0 pixels": truth(b"", width=0),
            "runs backwards": truth(bytes(8), t0_ns=2000),
            "codec 77": truth(bytes(8), codec=77),
            "17 planes: 1 to 16": row_truth([0], range(17), planes=17),
            "above 32768": row_truth([], [], count=32769),
            "dt_unit_ns is 0": row_truth([0], range(2), dt_unit_ns=0),
            "times that run backwards": row_truth([1, 0], range(4)),
            "outside the packet's interval": row_truth([10], range(2)),
            "7 bytes instead of 8": truth(bytes(7)),
        }
        for text, (head, payload) in faults.items():
            with self.subTest(text), self.assertRaisesRegex(saccade.PacketFault, text):
                read_packet(head, payload)

    def test_events_of_one_time_may_fill_an_empty_interval(self):
        self.assertEqual(len(read_packet(*packet(t1_ns=0)).content), 1)


if __name__ == "__main__":
    unittest.main()
