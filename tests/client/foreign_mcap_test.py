"""MCAP files as drivers and rosbag2 write them, made here as mcap.dev/spec says, read by `saccade convert`:
foreign_mcap_test.py SACCADE."""
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import event_columns

try:
    import lz4.frame
    import zstandard
except ImportError as fault:
    event_columns.skip(fault)

SACCADE = sys.argv[1]
MAGIC = b"\x89MCAP0\r\n"
COMPRESS = {"": bytes, "lz4": lz4.frame.compress, "zstd": zstandard.ZstdCompressor().compress}
PACKET = "event_camera_msgs/msg/EventPacket"


def sized(content):
    return struct.pack("<I", len(content)) + content


def record(op, content):
    return struct.pack("<BQ", op, len(content)) + content


def describe(number, topic, kind, encoding=b"cdr"):
    """A schema and a channel of the same number."""
    return (record(3, struct.pack("<H", number) + sized(kind.encode()) + sized(b"ros2msg") + sized(b""))
            + record(4, struct.pack("<HH", number, number) + sized(topic.encode()) + sized(encoding) + sized(b"")))


def packet(words, encoding=b"evt3", stamp_s=1_700_000_000):
    """event_camera_msgs/EventPacket in CDR: fields at multiples of their sizes, counted after four bytes."""
    text = b"cam\0"
    head = struct.pack("<iII", stamp_s, 5, len(text)) + text + struct.pack("<II", 180, 240)
    head += bytes(-len(head) % 8) + struct.pack("<QQ", 1, 2) + struct.pack("<I", len(encoding) + 1) + encoding + b"\0\0"
    head += bytes(-len(head) % 4)
    return b"\0\1\0\0" + head + sized(struct.pack(f"<{len(words)}H", *words))


def message(channel, data):
    return record(5, struct.pack("<HIQQ", channel, 0, 0, 0) + data)


def chunk(records, compression=""):
    data = COMPRESS[compression](records)
    head = struct.pack("<QQQI", 0, 0, len(records), zlib.crc32(records)) + sized(compression.encode())
    return record(6, head + struct.pack("<Q", len(data)) + data)


END = record(15, bytes(4)) + record(2, bytes(20)) + MAGIC
HIGH = 0x8000
# The state of EVT3 goes on from packet to packet: time and row are told once.
STREAM = [[HIGH | 3, 0x6005, 0x0007, 0x2001], [0x2802, 0x6006, 0x2003], [HIGH | 4, 0x6000, 0x0008, 0x2004]]
EVENTS = [(3 * 4096 + 5, 1, 7, 0), (3 * 4096 + 5, 2, 7, 1), (3 * 4096 + 6, 3, 7, 0), (4 * 4096, 4, 8, 0)]


class ForeignMcap(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def convert(self, content, *options):
        (self.folder / "a.mcap").write_bytes(MAGIC + content)
        return subprocess.run([SACCADE, "convert", "--force", self.folder / "a.mcap", self.folder / "a.csv", *options],
                              capture_output=True, text=True, timeout=60, check=False)

    def read(self, content, *options):
        done = self.convert(content, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = (self.folder / "a.csv").read_text(encoding="ascii").splitlines()[1:]
        return [tuple(map(int, row.split(","))) for row in rows]

    def test_each_compression(self):
        header = record(1, sized(b"ros2") + sized(b"libmcap"))
        for compression in COMPRESS:
            chunks = chunk(describe(1, "/e", PACKET) + message(1, packet(STREAM[0])), compression)
            chunks += chunk(b"".join(message(1, packet(words)) for words in STREAM[1:]), compression)
            self.assertEqual(self.read(header + chunks + END), EVENTS)
            self.assertEqual(self.read(header + chunks), EVENTS)  # of a recorder that was killed

    def test_messages_without_chunks(self):
        self.assertEqual(self.read(describe(1, "/e", PACKET) + b"".join(message(1, packet(w)) for w in STREAM) + END),
                         EVENTS)

    def test_wraps_count_from_the_first_event(self):
        words = [[HIGH | 0xfff, 0x6000, 0x0007, 0x2001], [HIGH | 0, 0x6000, 0x0007, 0x2002]]
        events = self.read(describe(1, "/e", PACKET) + b"".join(message(1, packet(w)) for w in words) + END)
        self.assertEqual([t for t, *_ in events], [0xfff * 4096, 0x1000 * 4096])

    def test_topics_of_other_types_are_passed_over(self):
        content = describe(7, "/imu", "sensor_msgs/msg/Imu") + message(7, b"nothing that can be read")
        content += describe(2, "/r/e", PACKET) + describe(1, "/e", PACKET) + message(2, packet(STREAM[2]))
        content += b"".join(message(1, packet(words)) for words in STREAM) + END
        self.assertEqual(self.read(content), EVENTS[3:])
        self.assertEqual(self.read(content, "--sensor", "1"), EVENTS)
        self.assertEqual(self.read(content, "--topic", "/e"), EVENTS)
        told = self.convert(content).stderr
        self.assertIn("the events of /r/e are read; left out: /imu (sensor_msgs/msg/Imu), /e (--sensor 1)\n", told)

    def test_what_cannot_be_read_is_named(self):
        head = describe(1, "/e", PACKET)
        bad_crc = bytearray(chunk(head))
        bad_crc[-1] ^= 1
        for content, told in (
                (head + message(1, packet([], b"libcaer_cmp")), "the encoding 'libcaer_cmp'; evt3 can be read"),
                (head + message(1, b"\0\0\0\0" + packet([])[4:]), "not CDR, little-endian"),
                (head + message(3, packet([])), "a topic that it does not describe"),
                (describe(1, "/e", "dvs_msgs/msg/EventArray"), "its topics are /e (dvs_msgs/msg/EventArray)"),
                (describe(1, "/e", PACKET, b"json"), f"its topics are /e ({PACKET} in json)"),
                (bytes(bad_crc), "does not have the CRC that it tells"),
                (record(6, struct.pack("<QQQI", 0, 0, 0, 0) + sized(b"bz2") + bytes(8)), "compressed by 'bz2'")):
            done = self.convert(content + END)
            self.assertEqual(done.returncode, 1)
            self.assertIn(told, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
