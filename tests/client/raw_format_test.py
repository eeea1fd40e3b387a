"""The RAW files of `saccade convert` against a decoder of another author's description, and its reader against
files as cameras write them: `raw_format_test.py SACCADE`.
"""
import json
import os
import random
import struct
import subprocess
import sys
import tempfile
import unittest

from evt_decoder import decode_evt2, decode_evt3

SACCADE = sys.argv[1]
DECODERS = {"evt3": decode_evt3, "evt2": decode_evt2}
WRAP_EVT2_US = 1 << 34


def edge_events(width, height, count, seed=1):
    """Events in time order of a bright edge that moves to the right: whole parts of rows fire at once."""
    draw = random.Random(seed)
    events, t_us = [], 0
    while len(events) < count:
        t_us += draw.choice([0, 1, 3, 40, 900])
        for _ in range(draw.randrange(3)):
            y, p, x = draw.randrange(height), draw.randrange(2), draw.randrange(width)
            for _ in range(draw.choice([1, 2, 6, 60])):
                events.append((t_us, x, y, p))
                x += draw.choice([1, 1, 1, 2, 9])
                if x >= width:
                    break
    return events[:count]


class RawFormat(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def at(self, name):
        return os.path.join(self.folder, name)

    def convert(self, *arguments):
        return subprocess.run([SACCADE, "convert", "--force", *arguments], capture_output=True, text=True, check=False)

    def write_csv(self, events):
        with open(self.at("in.csv"), "w", encoding="ascii") as file:
            file.write("t,x,y,p\n" + "".join("%d,%d,%d,%d\n" % event for event in events))

    def encode(self, events, width, height, name):
        """The bytes of the RAW file of these events."""
        self.write_csv(events)
        done = self.convert(self.at("in.csv"), self.at("out.raw"), "--size", f"{width}x{height}", "--format", name)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.at("out.raw"), "rb") as file:
            return file.read()

    def read_back(self):
        done = self.convert(self.at("out.raw"), self.at("back.csv"))
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.at("back.csv"), encoding="ascii") as file:
            return [tuple(map(int, line.split(","))) for line in file.readlines()[1:]]

    def check(self, events, width, height):
        """Encodes the events in each encoding, and decodes them."""
        for name, decode in DECODERS.items():
            with self.subTest(name):
                data = self.encode(events, width, height, name)
                keys, decoded, until_us = decode(data)
                self.assertEqual(decoded, events)
                self.assertEqual(keys["geometry"], f"{width}x{height}")
                self.assertGreaterEqual(until_us, events[-1][0] - 4095 if events else 0)

    def test_edges_that_move(self):
        for width, height in ((346, 260), (1280, 720), (2048, 2048), (33, 3), (31, 2)):
            with self.subTest(width=width):
                self.check(edge_events(width, height, 5000), width, height)

    def test_no_event_and_one(self):
        self.check([], 346, 260)
        self.check([(0, 0, 0, 0)], 346, 260)
        self.check([(70_000_000, 345, 259, 1)], 346, 260)

    def test_all_steps_of_time_in_silence_and_over_wraps(self):
        wrap = 1 << 24  # us, of EVT3
        self.check([(5, 1, 1, 1), (40_000_005, 2, 1, 1), (40_000_005, 3, 1, 0)], 346, 260)
        self.check([(wrap * k + d, 7, 9, 1) for k in range(1, 6) for d in (-4097, -4096, -1, 0, 1, 4095, 4096)], 346, 260)
        self.check([(0, 1, 1, 1), (75 * 60 * 1_000_000, 1, 1, 0)], 346, 260)

    def test_a_full_row_is_vectors_up_to_its_right_end(self):
        for width in (346, 1280):
            events = [(100, x, 7, 1) for x in range(width)]
            data = self.encode(events, width, 260, "evt3")
            self.assertEqual(decode_evt3(data)[1], events)
            words = len(data.split(b"% end\n")[1]) // 2
            self.assertLessEqual(words, 3 + 4 * (width // 32 + 1))

    def test_events_at_one_time_keep_their_order(self):
        columns = [9, 8, 10, 11, 12, 13, 14, 14, 15, 16, 17, 18, 2, 50, 82, 83, 84, 85, 86]
        self.check([(9, x, y, p) for y in (7, 3) for p in (1, 0) for x in columns], 346, 260)

    def test_evt2_beyond_its_34_bits(self):
        events = [(WRAP_EVT2_US * k + d, 3, 2, 1) for k in (1, 2, 5) for d in (-65, -1, 0, 64)]
        _, decoded, _ = decode_evt2(self.encode(events, 346, 260, "evt2"))
        self.assertEqual(decoded, events)

    def test_the_header_says_that_events_are_simulated_where_they_are(self):
        self.assertNotIn("simulator", decode_evt3(self.encode([], 346, 260, "evt3"))[0])
        with open(self.at("out.raw.json"), encoding="ascii") as file:
            recording = json.load(file)
        recording.update(end_ns="20000000000", request={"scene": "cornell-box"})
        with open(self.at("in.csv.json"), "w", encoding="ascii") as file:
            json.dump(recording, file)
        keys, _, until_us = decode_evt3(self.encode([], 346, 260, "evt3"))
        self.assertEqual((keys["serial_number"], keys["simulator"]), ("simulated", "Saccade"))
        self.assertEqual(until_us, 20_000_000 // 4096 * 4096)

    def test_what_the_formats_cannot_hold_is_refused(self):
        self.write_csv([(-5, 1, 1, 1)])
        for name in DECODERS:
            for size in ("2049x4", "4x2049"):
                done = self.convert(self.at("in.csv"), self.at("new.raw"), "--size", size, "--format", name)
                self.assertEqual(done.returncode, 2)
                self.assertIn(f"at most 2048x2048 pixels, not {size}", done.stderr)
            done = self.convert(self.at("in.csv"), self.at("new.raw"), "--size", "4x4", "--format", name)
            self.assertEqual(done.returncode, 1)
            self.assertIn("no times before 0, as -5 us is", done.stderr)
        self.write_csv([(1_700_000_000_000_000, 1, 1, 1)])
        done = self.convert(self.at("in.csv"), self.at("new.raw"), "--size", "4x4")
        self.assertEqual(done.returncode, 1)
        self.assertIn("at most 24 hours", done.stderr)
        self.assertFalse(os.path.exists(self.at("new.raw")))

    def read_words(self, header, form, words):
        with open(self.at("out.raw"), "wb") as file:
            file.write(header.encode() + struct.pack(f"<{len(words)}{form}", *words))
        return self.read_back()

    def test_evt3_as_a_camera_writes_it(self):
        header = ("% camera_integrator_name Prophesee\n% date 2023-03-29 16:37:46\n% evt 3.0\n"
                  "% format EVT3;height=720;width=1280\n% geometry 1280x720\n% system_ID 49\n% end\n")
        # Events before the first TIME_HIGH and ADDR_Y; a TIME_HIGH that is repeated; a trigger; a count of events, in four
        # words; the row of a second camera; and vectors that stop short, and that go on without a base.
        words = [0x2009, 0x8002, 0x2009, 0x0003, 0x6010, 0x2805, 0x8002, 0x2806, 0xA101, 0xE014, 0xF001, 0xF000, 0x7000,
                 0x8003, 0x6001, 0x0802, 0x34F0, 0x4801, 0x4001, 0x5000, 0x3C00, 0x4000, 0x4000, 0x5081, 0x4003]
        events = [(2 * 4096 + 16, 5, 3, 1), (2 * 4096 + 16, 6, 3, 1), (3 * 4096 + 1, 1264, 2, 0),
                  (3 * 4096 + 1, 1275, 2, 0), (3 * 4096 + 1, 1276, 2, 0), (3 * 4096 + 1, 1048, 2, 1),
                  (3 * 4096 + 1, 1055, 2, 1), (3 * 4096 + 1, 1056, 2, 1), (3 * 4096 + 1, 1057, 2, 1)]
        self.assertEqual(self.read_words(header, "H", words), events)

    def test_evt2_as_a_camera_writes_it(self):
        header = "% date 2019-01-01 00:00:00\n% evt 2.0\n% format EVT2;width=640;height=480\n% end\n"
        words = [1 << 28 | 9, 8 << 28 | 3, 8 << 28 | 3, 1 << 28 | 63 << 22 | 639 << 11 | 479, 0xA << 28 | 1, 0xE << 28, 0xF << 28,
                 8 << 28 | 0xFFFFFFF, 5 << 22, 8 << 28, 2 << 22 | 1 << 11]
        events = [(3 * 64 + 63, 639, 479, 1), (WRAP_EVT2_US - 64 + 5, 0, 0, 0), (WRAP_EVT2_US + 2, 1, 0, 0)]
        self.assertEqual(self.read_words(header, "I", words), events)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
