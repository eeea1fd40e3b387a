#!/usr/bin/env python3
"""Writes tests/wire/data: packets spelled out byte by byte, independent of the encoder under test.

Usage: make_golden.py FOLDER_OF_PB2_MODULES, made by
    protoc --python_out=FOLDER -I proto proto/saccade/v1/*.proto
Each vector is NAME.bin (u32 size of the header | header | payload, little-endian) and NAME.json (its meaning).
"""
import json, pathlib, struct, sys, zlib, zstandard

sys.path.insert(0, sys.argv[1])
from saccade.v1 import events_pb2 as pb

FOLDER = pathlib.Path(__file__).parent / "data"


def write(name, header, payload, events, valid=True, pixels=()):
    head = pb.PacketHeader(**{"stream_id": "golden", "epoch": 7, "crc32": zlib.crc32(payload), **header})
    head = head.SerializeToString()
    (FOLDER / f"{name}.bin").write_bytes(struct.pack("<I", len(head)) + head + payload)
    meaning = {"valid": valid, "header": header, "events_t_ns_x_y_p": events, "pixels": pixels}
    (FOLDER / f"{name}.json").write_text(json.dumps(meaning) + "\n")


columns = dict(layout=pb.LAYOUT_COLUMNS, codec=pb.CODEC_NONE, dt_unit_ns=1000, width=346, height=260)
three = (
    b"\x00\x00\x00\x00" b"\x2c\x01\x00\x00" b"\xcf\x07\x00\x00"  # dt: 0, 300, 1999 us after t0
    b"\x03\x00" b"\x59\x01" b"\x00\x00"  # x: 3, 345, 0
    b"\x04\x00" b"\x03\x01" b"\x00\x00"  # y: 4, 259, 0
    b"\x01" b"\x00" b"\x01"  # p: ON, OFF, ON
)
three_header = dict(sensor=1, seq=5, first_event_index=40, t0_ns=2_000_000, t1_ns=4_000_000, frame=1, count=3,
                    kind=pb.KIND_EVENTS, **columns)
three_events = [[2_000_000, 3, 4, 1], [2_300_000, 345, 259, 0], [3_999_000, 0, 0, 1]]

write("three_events", three_header, three, three_events)
write("nothing_happened", {**three_header, "seq": 6, "first_event_index": 43, "count": 0}, b"", [])
write("end", {**three_header, "seq": 7, "t0_ns": 4_000_000, "count": 0, "kind": pb.KIND_END}, b"", [])
write("end_of_a_drained_server", {**three_header, "seq": 7, "t0_ns": 4_000_000, "count": 0, "kind": pb.KIND_END,
                                  "end_reason": pb.END_REASON_DRAINING}, b"", [])
zstd = zstandard.ZstdCompressor().compress
write("zstd", {**three_header, "codec": pb.CODEC_ZSTD}, zstd(three), three_events)
snapshot = {**three_header, "seq": 0, "first_event_index": 0, "t1_ns": 2_000_000, "count": 0, "kind": pb.KIND_SNAPSHOT,
            "layout": pb.LAYOUT_PLANES, "width": 2, "height": 1}
planes = (
    b"\x00\x00\x80\xbf" b"\x00\x00\x00\x40"  # L: -1, 2
    b"\x00\x00\x60\xbf" b"\x00\x00\xf0\x3f"  # reference: -0.875, 1.875
)
levels = [[-1, -0.875], [2, 1.875]]
write("snapshot", snapshot, planes, [], pixels=levels)
write("snapshot_zstd", {**snapshot, "codec": pb.CODEC_ZSTD}, zstd(planes), [], pixels=levels)
write("dropped_and_suppressed", {**three_header, "dropped_before": 2, "suppressed": 9}, three, three_events)
write("bad_crc", {**three_header, "crc32": 1}, three, [], valid=False)
write("bad_size", three_header, three[:-1], [], valid=False)
write("bad_pixel", {**three_header, "width": 345}, three, [], valid=False)
write("bad_polarity", three_header, three[:-1] + b"\x02", [], valid=False)
write("bad_order", three_header, three[8:12] + three[4:8] + three[:4] + three[12:], [], valid=False)
write("bad_zstd", {**three_header, "codec": pb.CODEC_ZSTD}, zstd(three)[:-1], [], valid=False)
write("bad_zstd_size", {**three_header, "codec": pb.CODEC_ZSTD}, zstd(three + b"\x01"), [], valid=False)
write("bad_snapshot_size", {**snapshot, "height": 2}, planes, [], valid=False)
write("bad_layout", {**three_header, "layout": 77}, three, [], valid=False)
