"""AEDAT 4 files of `saccade convert`, read and written by other authors' libraries."""
import importlib.util
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

SACCADE = sys.argv[1]
MISSING = [name for name in ("flatbuffers", "lz4", "numpy", "zstandard") if importlib.util.find_spec(name) is None]
if not MISSING:
    import aedat4


def some_events(count):
    random.seed(1)
    times = sorted(random.randrange(5 * 10**9) for _ in range(count))
    return [(t, random.randrange(1280), random.randrange(720), random.randrange(2)) for t in times]


class Aedat4(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def convert(self, name, other, *options):
        return subprocess.run([SACCADE, "convert", "--force", *options, self.folder / name, self.folder / other],
                              capture_output=True, text=True, check=True).stderr

    def written(self, events):
        rows = "".join(f"{t},{x},{y},{p}\n" for t, x, y, p in events)
        (self.folder / "a.csv").write_text("t,x,y,p\n" + rows)
        self.convert("a.csv", "a.aedat4", "--size", "1280x720")
        return (self.folder / "a.aedat4").read_bytes()

    def packets(self, data):
        """Those that the table names, and the events of each."""
        self.assertEqual(data[:14], aedat4.MAGIC)
        compression, position, _, size = aedat4.read_header(data[14:])
        self.assertEqual(compression, aedat4.LZ4)
        table = aedat4.read_table(aedat4.unpack(data[position:], compression))
        at = 14 + size
        contents = []
        for offset, stream, length, count, first, last in table:
            self.assertEqual(offset, at + 8)
            self.assertEqual(aedat4.struct.unpack_from("<ii", data, at), (stream, length))
            self.assertEqual(stream, 0)
            events = aedat4.read_events(aedat4.unpack(data[offset:offset + length], compression))
            self.assertEqual((len(events), events["t"][0], events["t"][-1]), (count, first, last))
            self.assertGreater(count, 0)
            self.assertLessEqual(last - first, 10_000)
            contents.append(events)
            at = offset + length
        self.assertEqual(at, position)
        return contents

    def test_another_library_reads_the_events_and_their_table(self):
        events = some_events(2000) + [(5 * 10**9, i % 1280, i % 720, i % 2) for i in range(70_000)]
        contents = self.packets(self.written(events))
        self.assertTrue([(t, x, y, int(on)) for part in contents for t, x, y, on, _ in part.tolist()] == events)
        self.assertTrue(all(pad == bytes(3) for part in contents for pad in part["pad"].tolist()))

    def test_a_file_without_events_has_a_table_without_packets(self):
        self.assertEqual(self.packets(self.written([])), [])

    def test_the_xml_says_what_dv_asks_for(self):
        _, _, info, _ = aedat4.read_header(self.written(some_events(5))[14:])
        named, told = aedat4.check_info(info, "/mainloop/Recorder/outInfo/")
        self.assertEqual(named["compression"], ("string", "LZ4"))
        self.assertEqual(named["typeDescription"], ("string", "Array of events (polarity ON/OFF)."))
        self.assertEqual((told["sizeX"][1], told["sizeY"][1]), ("1280", "720"))
        self.assertEqual(told["tsOffset"], ("long", "0"))

    def test_the_header_may_be_written_again_by_another_library(self):
        data = self.written(some_events(5))
        compression, position, info, size = aedat4.read_header(data[14:])
        self.assertEqual(aedat4.read_header(aedat4.make_header(compression, info, position))[:3],
                         (compression, position, info))
        # The number of 64 bits is aligned to the size before it, as the builder of FlatBuffers does.
        self.assertEqual(data[14:14 + size].index(aedat4.struct.pack("<q", position)) % 8, 0)

    def read(self, compression, parts, streams=((0, "EVTS", (1280, 720)),)):
        """What Saccade reads of packets that are given as (stream, events)."""
        data = aedat4.MAGIC + aedat4.make_header(compression, aedat4.make_info(*streams))
        for stream, events in parts:
            data += aedat4.make_packet(stream, events, compression, b"EVTS" if stream == 0 else b"FRME")
        (self.folder / "b.aedat4").write_bytes(data)
        note = self.convert("b.aedat4", "b.csv")
        lines = (self.folder / "b.csv").read_text().splitlines()[1:]
        return [tuple(map(int, line.split(","))) for line in lines], note

    def test_all_compressions_of_other_programs_are_read(self):
        events = some_events(9000)
        for compression in range(5):
            read, note = self.read(compression, [(0, events[:10]), (0, []), (0, events[10:])])
            self.assertTrue(read == events, compression)
            self.assertNotIn("left out", note)

    def test_times_since_1970_stay_as_they_are(self):
        events = [(1763900000000000 + t, 1, 2, 1) for t in range(3)]
        self.assertEqual(self.read(aedat4.LZ4, [(0, events)])[0], events)

    def test_other_streams_are_left_out_and_told(self):
        events = some_events(20)
        streams = ((2, "FRME", (4, 3)), (0, "EVTS", (1280, 720)), (1, "EVTS", (1280, 720)))
        read, note = self.read(aedat4.ZSTD, [(2, [(0, 0, 0, 0)]), (0, events), (1, [(0, 0, 0, 0)])], streams)
        self.assertEqual(read, events)
        self.assertIn("left out: stream 2 (FRME), stream 1 (EVTS)", note)


if __name__ == "__main__":
    if MISSING:
        print("skipped: this Python has no", ", ".join(MISSING))
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
