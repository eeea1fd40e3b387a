#!/usr/bin/env python3
"""Writes mosaic.png: 512 x 512 pixels that repeat, with detail from 128 pixels down to 2.

Needs nothing but Python. Each octave gives every square cell of its size a grey level of its own; the sum picks
one of 32 colours between a dark and a light stone, so that the picture has no seam and no plain region.
"""
import struct
import zlib
from pathlib import Path

EDGE = 512
OCTAVES = ((128, 0.30), (32, 0.30), (8, 0.25), (2, 0.15))  # cell edge in pixels, weight
DARK, LIGHT = (70, 52, 40), (238, 226, 205)  # sRGB
COLOURS = 32


def cell_level(size, x, y):
    """A number in [0, 1) that belongs to the cell."""
    v = (x // size * 0x9E3779B1 ^ y // size * 0x85EBCA6B ^ size * 0xC2B2AE35) & 0xFFFFFFFF
    for shift, factor in ((16, 0x7FEB352D), (15, 0x846CA68B)):
        v = (v ^ v >> shift) * factor & 0xFFFFFFFF
    return (v ^ v >> 16) / 2**32


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def main():
    rows = bytearray()
    for y in range(EDGE):
        rows.append(0)  # PNG filter: none
        rows.extend(
            int(COLOURS * sum(weight * cell_level(size, x, y) for size, weight in OCTAVES)) for x in range(EDGE)
        )
    palette = bytes(
        round(d + (l - d) * i / (COLOURS - 1)) for i in range(COLOURS) for d, l in zip(DARK, LIGHT)
    )
    header = struct.pack(">IIBBBBB", EDGE, EDGE, 8, 3, 0, 0, 0)  # 8-bit palette
    png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"PLTE", palette)
    png += chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b"")
    Path(__file__).with_name("mosaic.png").write_bytes(png)


if __name__ == "__main__":
    main()
