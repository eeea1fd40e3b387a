"""RAW files: word by word, as the manual of the encodings describes them."""
import pathlib
import struct
import tempfile
import unittest
import warnings

import numpy as np

import saccade
from saccade.readers.evt2 import Evt2Decoder
from saccade.readers.evt3 import Evt3Decoder

HEADER = b"% date 2026-11-22 05:00:00\n% evt 3.0\n% format EVT3;height=720;width=1280\n% geometry 1280x720\n% end\n"


def evt3_one_by_one(words):
    """A plain state machine: the reference."""
    high = low = y = base = polarity = None
    before, epoch, events = 0, 0, []
    for word in words:
        kind, value = word >> 12, word & 0xFFF
        if kind == 8:
            epoch += value < before - 2048
            before, high = value, value + 4096 * epoch
        elif kind == 6:
            low = value
        elif kind == 0:
            y = value & 0x7FF
        elif kind == 3:
            base, polarity = value & 0x7FF, value >> 11
        elif kind in (2, 4, 5):
            xs = [value & 0x7FF] if kind == 2 else []
            if kind != 2 and base is not None:
                width = 12 if kind == 4 else 8
                xs = [base + bit for bit in range(width) if value >> bit & 1]
                base += width
            if None not in (high, low, y):
                events += [(high * 4096 + low, x, y, bool(value >> 11 if kind == 2 else polarity)) for x in xs]
    return events


def rows(columns):
    return list(zip(*(column.tolist() for column in columns)))


class Evt3(unittest.TestCase):
    def test_words_written_by_hand(self):
        words = [0x8000, 0x6064, 0x0003, 0x2805, 0x300A, 0x4801, 0x4000, 0x5082, 0x6065, 0x2007]
        expected = [(100, 5, 3, True), (100, 10, 3, False), (100, 21, 3, False), (100, 35, 3, False),
                    (100, 41, 3, False), (101, 7, 3, False)]
        self.assertEqual(rows(Evt3Decoder().decode(np.array(words, np.uint16))), expected)

    def test_any_words_in_blocks_of_any_length(self):
        rng = np.random.default_rng(1)
        warnings.simplefilter("ignore")
        for _ in range(50):
            kinds = rng.choice([0, 2, 3, 4, 5, 6, 7, 8, 10, 14, 15], 300)
            words = (kinds << 12 | rng.integers(0, 4096, 300)).astype(np.uint16)
            words[kinds == 3] &= 0xF8FF  # a base that leaves room for vectors
            decoder, found = Evt3Decoder(), []
            for block in np.split(words, np.sort(rng.integers(0, 300, 5))):
                found += rows(decoder.decode(block))
            self.assertEqual(found, evt3_one_by_one(words.tolist()))
            self.assertTrue(found)

    def test_events_before_time_and_place_are_counted(self):
        with self.assertWarnsRegex(UserWarning, "^2 words"):
            found = Evt3Decoder().decode(np.array([0x2001, 0x4001, 0x8000, 0x6000, 0x0000, 0x2001], np.uint16))
        self.assertEqual(rows(found), [(0, 1, 0, False)])


class Evt2(unittest.TestCase):
    def test_times_go_on_beyond_a_wrap_and_from_block_to_block(self):
        def high(t):
            return 8 << 28 | t >> 6 & 0xFFFFFFF

        def event(t, x, y, p):
            return p << 28 | (t & 63) << 22 | x << 11 | y

        wrap = 1 << 34
        expected = [(70, 5, 3, True), (wrap - 1, 2047, 1, False), (wrap + 65, 0, 2047, True)]
        words = [0xA0000000]  # a trigger
        for t, x, y, p in expected:
            words += [high(t), event(t, x, y, p)]
        decoder = Evt2Decoder()
        blocks = [np.array(words[:4], np.uint32), np.array(words[4:], np.uint32)]
        self.assertEqual([row for block in blocks for row in rows(decoder.decode(block))], expected)


class RawFile(unittest.TestCase):
    def read(self, content, **more):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.raw"
            path.write_bytes(content)
            return saccade.read(path, **more)

    def test_the_header_tells_encoding_and_size(self):
        body = struct.pack("<4H", 0x8000, 0x6001, 0x0000, 0x2004)
        self.assertEqual(self.read(HEADER + body).size, (1280, 720))
        self.assertEqual(self.read(b"% evt 3.0\n" + body).x.tolist(), [4])
        self.assertEqual(self.read(b"% evt 2.0\n% end\n" + struct.pack("<2I", 8 << 28, 1 << 28)).p.tolist(), [True])

    def test_faults_are_told(self):
        for content, text in ((b"% evt 4.0\n% end\n", "'EVT4'"), (b"no header", "'EVT\\?'"),
                              (HEADER + b"\0", "within a word"),
                              (HEADER + struct.pack("<4H", 0x8000, 0x6001, 0x0000, 0x2000 + 1280), "outside 1280x720"),
                              (HEADER + struct.pack("<6H", 0x8000, 0x6001, 0, 0x2000, 0x6000, 0x2000), "backwards")):
            with self.subTest(text), self.assertRaisesRegex(saccade.FormatError, text):
                self.read(content)


if __name__ == "__main__":
    unittest.main()
