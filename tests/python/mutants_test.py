"""Packets and files with bytes changed at random: each is read, or refused by its own exception and no other."""
import os
import pathlib
import random
import struct
import tempfile
import unittest
import warnings
import zlib

import numpy as np

import aedat4_test
import saccade
from saccade.protocol.packets import read_packet
from saccade.v1 import events_pb2

VECTORS = sorted((pathlib.Path(os.environ["SOURCE"]) / "tests/wire/data").glob("*.bin"))
T, X, Y, P = np.arange(50) * 10, np.arange(50) % 9, np.arange(50) % 5, np.arange(50) % 2


def rows(pattern):
    return "".join(pattern.format(*row) for row in zip(T, X, Y, P)).encode()


def files(folder):
    """A good file of each format; those of optional libraries only where they are installed."""
    (folder / "a.csv").write_bytes(b"t_us,x,y,p\n" + rows("{},{},{},{}\n"))
    (folder / "a.txt").write_bytes(b"9 5\n" + rows("{} {} {} {}\n"))
    np.savez_compressed(folder / "a.npz", t=T, x=X, y=Y, p=P, width=9, height=5)
    words = [word for i in range(50) for word in (0x8000, 0x6000 | i, 0x0003, 0x2000 | i, 0x3000, 0x4007)]
    (folder / "a.raw").write_bytes(b"% evt 3.0\n% end\n" + struct.pack(f"<{len(words)}H", *words))
    try:
        import flatbuffers  # writes AEDAT4
        import h5py
    except ImportError:
        return
    events = [tuple(map(int, row)) for row in zip(T, X, Y, P)]
    content = aedat4_test.header(0, -1, aedat4_test.CAMERA) + aedat4_test.packet(events, aedat4_test.plain)
    (folder / "a.aedat4").write_bytes(content)
    with h5py.File(folder / "a.h5", "w") as file:
        for name, values in zip("txyp", (T, X, Y, P)):
            file.create_dataset(f"events/{name}", data=values, chunks=True, compression="gzip")


class Mutants(unittest.TestCase):
    def setUp(self):
        self.random = random.Random(5)
        warnings.simplefilter("ignore")

    def mutant(self, content):
        cut = self.random.randint(1, len(content)) if self.random.random() < 0.2 else len(content)
        changed = bytearray(content[:cut])
        for _ in range(self.random.randint(1, 4)):
            changed[self.random.randrange(len(changed))] = self.random.randrange(256)
        return bytes(changed)

    def test_packets(self):
        outcomes = set()
        for path in VECTORS:
            content = path.read_bytes()
            size = 4 + struct.unpack_from("<I", content)[0]
            header = events_pb2.PacketHeader.FromString(content[4:size])
            for _ in range(100):
                payload = self.mutant(content[size:] or b"\0")
                header.crc32 = zlib.crc32(payload)
                head = header.SerializeToString()
                try:
                    read_packet(self.mutant(head) if self.random.random() < 0.5 else head, payload)
                    outcomes.add("read")
                except saccade.PacketFault:
                    outcomes.add("refused")
        self.assertEqual(outcomes, {"read", "refused"})

    def test_files(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            files(folder)
            for path in sorted(folder.iterdir()):
                self.assertGreaterEqual(len(saccade.read(path)), 50)
                self.check(path, path.read_bytes())

    def check(self, path, content):
        refused = 0
        for _ in range(100):
            path.write_bytes(self.mutant(content))
            with self.subTest(path.suffix):
                try:
                    saccade.read(path)
                except saccade.FormatError:
                    refused += 1
        self.assertGreater(refused, 0, path)


if __name__ == "__main__":
    unittest.main()
