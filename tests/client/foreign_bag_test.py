"""Bags that rosbag wrote, read by `saccade convert`: foreign_bag_test.py SACCADE."""
import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest

import event_files

SACCADE = sys.argv[1]
if importlib.util.find_spec("rosbag") is None:
    print("skipped: this Python has no rosbag (package python3-rosbag)")
    sys.exit(77)
import genpy
import rosbag
from std_msgs.msg import Header

EPOCH_S = 1_500_000_000
EVENTS = [(7 * i, i % 240, i % 180, i % 2) for i in range(60_000)]  # microseconds after that


class ForeignBag(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        event_files.write_csv(cls.folder / "a.csv", [(1, 0, 0, 1)])
        event_files.convert(SACCADE, cls.folder / "a.csv", cls.folder / "a.bag", (240, 180)).check_returncode()
        with rosbag.Bag(str(cls.folder / "a.bag")) as bag:  # rosbag makes the classes of messages from it
            message = next(bag.read_messages())[1]
        cls.array, cls.event = type(message), type(message.events[0])

    def message(self, events, nanoseconds=0):
        message = self.array(width=240, height=180)
        for t, x, y, p in events:
            one = self.event(x=x, y=y, polarity=bool(p))
            one.ts = genpy.Time(EPOCH_S + t // 10**6, t % 10**6 * 1000 + nanoseconds)
            message.events.append(one)
        message.header.stamp = message.events[-1].ts
        return message

    def write(self, topics=("/davis/left/events",), nanoseconds=0, **options):
        """The messages of each topic by turns, with other messages between."""
        path = self.folder / "b.bag"
        with rosbag.Bag(str(path), "w", chunk_threshold=100_000, **options) as bag:
            for begin in range(0, len(EVENTS), 10_000):
                for number, topic in enumerate(topics):
                    message = self.message(EVENTS[begin + number:begin + 10_000], nanoseconds)
                    bag.write(topic, message, message.header.stamp)
                    bag.write("/imu", Header(), message.header.stamp)
        return path

    def read(self, path, *options):
        done = subprocess.run([SACCADE, "convert", "--force", path, self.folder / "out.csv", *options],
                              capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = (self.folder / "out.csv").read_text(encoding="ascii").splitlines()[1:]
        return [tuple(map(int, row.split(","))) for row in rows], done.stderr

    def expected(self, number=0):
        return [(EPOCH_S * 10**6 + t, x, y, p) for begin in range(0, len(EVENTS), 10_000)
                for t, x, y, p in EVENTS[begin + number:begin + 10_000]]

    def test_chunks_of_each_compression_that_is_known(self):
        for compression in ("none", "lz4"):
            events, told = self.read(self.write(compression=compression))
            self.assertEqual(events, self.expected())
            self.assertIn("b.bag: the events of /davis/left/events are read; left out: /imu (std_msgs/Header)", told)

    def test_bz2_is_refused_with_a_way_out(self):
        done = subprocess.run([SACCADE, "convert", self.write(compression="bz2"), self.folder / "no.csv"],
                              capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"b\.bag: the record at byte \d+ is compressed by bz2, which cannot be read here; "
                                      "`rosbag decompress` rewrites the bag\n$")

    def test_one_of_several_topics(self):
        path = self.write(("/left/events", "/right/events"))
        for number, options in ((0, ()), (1, ("--sensor", "1")), (1, ("--topic", "/right/events"))):
            events, told = self.read(path, *options)
            self.assertEqual(events, self.expected(number))
            other = ("/right/events (--sensor 1)", "/left/events (--sensor 0)")[number]
            self.assertIn(f"left out: {other}", told.replace("/imu (std_msgs/Header), ", ""))

    def test_nanoseconds_are_cut(self):
        self.assertEqual(self.read(self.write(nanoseconds=999))[0], self.expected())

    def test_a_bag_without_index_is_read(self):
        path = self.write()
        whole = path.read_bytes()
        with rosbag.Bag(str(path)) as bag:
            index = bag._index_data_pos
        place = whole.index(b"index_pos=") + len(b"index_pos=")
        path.write_bytes(whole[:place] + bytes(8) + whole[place + 8:index])
        self.assertEqual(self.read(path)[0], self.expected())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
