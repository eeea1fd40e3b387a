#!/usr/bin/env python3
"""Reads tests/wire/data with nothing but protobuf, struct, zlib and zstandard, and compares with the .json beside each.

Usage: read_golden.py FOLDER_OF_PB2_MODULES. Exit code 77: a module is absent.
"""
import json, pathlib, struct, sys, zlib

sys.path.insert(0, sys.argv[1])
try:
    import zstandard
    from saccade.v1 import events_pb2 as pb
except ImportError as error:
    print(error)
    sys.exit(77)


def unpack(header, payload, size):
    assert zlib.crc32(payload) == header.crc32, "crc"
    if header.codec == pb.CODEC_ZSTD:
        try:
            payload = zstandard.ZstdDecompressor().decompress(payload, max_output_size=size)
        except zstandard.ZstdError as fault:
            raise AssertionError(fault)
    assert len(payload) == size, "size"
    return payload


def read_pixels(header, payload):
    n = header.width * header.height
    assert header.layout == pb.LAYOUT_PLANES, "layout"
    payload = unpack(header, payload, 8 * n)
    return [list(pixel) for pixel in zip(*(struct.unpack_from(f"<{n}f", payload, 4 * n * i) for i in (0, 1)))]


def read_events(header, payload):
    n = header.count
    if header.kind == pb.KIND_END: return []
    assert header.layout == pb.LAYOUT_COLUMNS, "layout"
    payload = unpack(header, payload, 9 * n)
    dt, x, y, p = (struct.unpack_from(f"<{n}{c}", payload, at * n) for c, at in zip("IHHB", (0, 4, 6, 8)))
    assert all(v < header.width for v in x) and all(v < header.height for v in y), "pixel"
    assert all(v < 2 for v in p) and list(dt) == sorted(dt), "polarity or order"
    return [list(event) for event in zip((header.t0_ns + d * header.dt_unit_ns for d in dt), x, y, p)]


vectors = sorted((pathlib.Path(__file__).parent / "data").glob("*.bin"))
assert len(vectors) >= 17, "vectors are missing"
for path in vectors:
    data, meaning = path.read_bytes(), json.loads(path.with_suffix(".json").read_text())
    size = struct.unpack_from("<I", data)[0]
    header = pb.PacketHeader.FromString(data[4:4 + size])
    for field, value in meaning["header"].items():
        assert getattr(header, field) == value, (path.name, field)
    try:
        snapshot = header.kind == pb.KIND_SNAPSHOT
        content = (read_pixels if snapshot else read_events)(header, data[4 + size:])
    except AssertionError as fault:
        assert not meaning["valid"], (path.name, fault)
    else:
        assert meaning["valid"] and content == meaning["pixels" if snapshot else "events_t_ns_x_y_p"], path.name
print(f"{len(vectors)} vectors read")
