#!/usr/bin/python3
"""Measures how long a scene of many triangles takes to open, and its memory, on one core:
    tests/bench/open_speed.py [--build build/release] [--triangles 1000000]
It makes a wavy floor, as PLY and as binary glTF, each with and without normals. `read` is the reading of the file, and
`open` is that, the tree for rays, and a picture of 16x16 pixels. Both are CPU seconds and the most memory of
saccade-eval as a whole, the program and its libraries included: `start` is what it takes without a scene.
"""
import argparse
import array
import json
import math
import os
import struct
import sys
import tempfile
from pathlib import Path

MIB = 1 << 20


def wavy_floor(triangles):
    """Positions, normals and indices of an n x n grid, as flat arrays."""
    n = max(2, math.isqrt(triangles // 2) + 1)
    positions, normals, indices = array.array("f"), array.array("f"), array.array("I")
    for j in range(n):
        for i in range(n):
            x, z = 10 * i / n, 10 * j / n
            positions.extend((x, 0.2 * math.sin(x) * math.cos(z), z))
            slope_x, slope_z = 0.2 * math.cos(x) * math.cos(z), -0.2 * math.sin(x) * math.sin(z)
            length = math.sqrt(1 + slope_x**2 + slope_z**2)
            normals.extend((-slope_x / length, 1 / length, -slope_z / length))
    for j in range(n - 1):
        for i in range(n - 1):
            a = j * n + i
            indices.extend((a, a + n, a + 1, a + 1, a + n, a + n + 1))
    return positions, normals, indices


def write_ply(path, positions, normals, indices):
    columns = "xyz" if normals is None else ["x", "y", "z", "nx", "ny", "nz"]
    head = "".join(f"property float {name}\n" for name in columns)
    count, faces = len(positions) // 3, len(indices) // 3
    with open(path, "wb") as out:
        out.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {count}\n{head}element face {faces}\n"
                  "property list uchar int vertex_indices\nend_header\n".encode())
        for i in range(count):
            out.write(positions[3 * i:3 * i + 3].tobytes() + (b"" if normals is None else normals[3 * i:3 * i + 3].tobytes()))
        for i in range(faces):
            out.write(b"\x03" + indices[3 * i:3 * i + 3].tobytes())


def write_glb(path, positions, normals, indices):
    parts = [(positions, "VEC3", 5126), (indices, "SCALAR", 5125)] + ([] if normals is None else [(normals, "VEC3", 5126)])
    views, accessors, binary = [], [], b""
    for values, kind, component in parts:
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": 4 * len(values)})
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "type": kind,
                          "count": len(values) // (3 if kind == "VEC3" else 1)})
        binary += values.tobytes()
    accessors[0].update(min=[0, -1, 0], max=[10, 1, 10])
    attributes = {"POSITION": 0, **({} if normals is None else {"NORMAL": 2})}
    text = json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                       "meshes": [{"primitives": [{"attributes": attributes, "indices": 1}]}], "bufferViews": views,
                       "accessors": accessors, "buffers": [{"byteLength": len(binary)}]}).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as out:
        out.write(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(binary), len(text), 0x4E4F534A) + text)
        out.write(struct.pack("<II", len(binary), 0x004E4942) + binary)


def measure(command):
    """CPU seconds, and MiB of memory at most, of a command on one core."""
    child = os.fork()
    if child == 0:
        os.sched_setaffinity(0, [min(os.sched_getaffinity(0))])
        nothing = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nothing, 1), os.dup2(nothing, 2)
        os.execv(command[0], list(map(str, command)))
    _, status, used = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"{' '.join(map(str, command))} failed")
    return used.ru_utime + used.ru_stime, used.ru_maxrss * 1024 / MIB


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--build", type=Path, default="build/release")
    p.add_argument("--triangles", type=int, default=1_000_000)
    a = p.parse_args()
    program = str(a.build / "bin/saccade-eval")
    positions, normals, indices = wavy_floor(a.triangles)
    print(f"{len(indices) // 3} triangles, {len(positions) // 3} vertices")
    print("| file | MB | read, s | read, MiB | open, s | open, MiB |\n|---|---|---|---|---|---|")
    print("| start | | {:.2f} | {:.0f} | | |".format(*measure([program, "--version"])))
    with tempfile.TemporaryDirectory() as folder:
        for name, write in (("scene.ply", write_ply), ("scene.glb", write_glb)):
            for given in (None, normals):
                path = Path(folder) / name
                write(path, positions, given, indices)
                read, opened = measure([program, "scene", path]), measure(
                    [program, "render", path, "--size", "16x16", "--spp", "1", "-o", f"{folder}/out.exr"])
                what = f"{name}, {'with' if given else 'without'} normals"
                print("| {} | {:.0f} | {:.2f} | {:.0f} | {:.2f} | {:.0f} |".format(
                    what, path.stat().st_size / 1e6, *read, *opened), flush=True)


if __name__ == "__main__":
    main()
