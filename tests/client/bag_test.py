"""Bags of `saccade convert`, read by rosbag with the message classes that it makes from the bag itself, and by the
packages of Foxglove: bag_test.py SACCADE FOLDER_FOR_NPM."""
import importlib.util
import json
import pathlib
import re
import sys
import tempfile
import unittest

import event_files
import npm_packages

SACCADE, _, NPM = sys.argv[1:4]
if importlib.util.find_spec("rosbag") is None:
    print("skipped: this Python has no rosbag (package python3-rosbag)")
    sys.exit(77)
import genpy
import rosbag

PACKAGES = ["@foxglove/rosbag@0.4.1", "@foxglove/rosmsg@5.0.5", "@foxglove/rosmsg-serialization@2.0.4",
            "tslib@2.8.1"]  # the last one is needed, but not named by the one before
SCRIPT = pathlib.Path(__file__).with_name("read_bag.cjs")

MD5 = "5e8beee5a6c107e504c2e78903c224b8"  # of dvs_msgs/EventArray
INTERVAL_US = 5000  # of a message
MANY = [(1 + i // 3, i % 1280, i % 720, i % 2) for i in range(140_000)]  # in 47 ms, and over several chunks


def stamp_us(time):
    return time.to_nsec() / 1000


class Bag(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def convert(self, events, size=(1280, 720), most_bytes=None):
        event_files.write_csv(self.folder / "a.csv", events)
        return event_files.convert(SACCADE, self.folder / "a.csv", self.folder / "a.bag", size, most_bytes)

    def written(self, events, size=(1280, 720)):
        done = self.convert(events, size)
        self.assertEqual(done.returncode, 0, done.stderr)
        return rosbag.Bag(str(self.folder / "a.bag"))

    def events_of(self, bag):
        """All events, after the rules for each message are checked."""
        events, last = [], genpy.Time(0)
        for number, (topic, message, time) in enumerate(bag):
            self.assertEqual(topic, "/dvs/events")
            self.assertEqual(message.header.seq, number)
            self.assertEqual(message.header.stamp, time)
            self.assertGreaterEqual(time, last)
            last = time
            times = [event.ts.to_nsec() for event in message.events]
            self.assertEqual(time.to_nsec(), max(times[-1], 1))
            self.assertEqual(times[0] // (1000 * INTERVAL_US), times[-1] // (1000 * INTERVAL_US))
            events += [(e.ts.to_nsec() // 1000, e.x, e.y, int(e.polarity)) for e in message.events]
        return events

    def test_all_events_come_back_over_many_messages_and_chunks(self):
        with self.written(MANY) as bag:
            self.assertEqual(self.events_of(bag), MANY)
            self.assertEqual(bag.get_message_count(), 10)
            self.assertEqual(bag.get_end_time(), MANY[-1][0] / 1e6)
            self.assertGreater(bag._chunk_count, 1)
            self.assertLess(max(header.uncompressed_size for header in bag._chunk_headers.values()), 1_800_000)

    def test_another_reader_finds_the_same(self):
        reason = npm_packages.missing(NPM, PACKAGES)
        if reason:
            self.skipTest(reason)
        self.written(MANY).close()
        found = json.loads(npm_packages.run(NPM, SCRIPT, self.folder / "a.bag"))
        self.assertEqual((found["type"], found["md5sum"]), ("dvs_msgs/EventArray", MD5))
        self.assertEqual([tuple(event) for message in found["messages"] for event in message["events"]], MANY)
        for message in found["messages"]:
            self.assertEqual(message["time_us"], message["stamp_us"])
            self.assertEqual(message["stamp_us"], message["events"][-1][0])

    def test_the_definition_in_the_bag_is_that_of_the_type(self):
        with self.written([(7, 1, 2, 1)], (346, 260)) as bag:
            _, message, _ = next(bag.read_messages())
            self.assertEqual(message._type, "dvs_msgs/EventArray")
            self.assertEqual(message._md5sum, MD5)  # made from the definition
            self.assertEqual(bag.get_type_and_topic_info().topics["/dvs/events"].msg_type, "dvs_msgs/EventArray")
            self.assertEqual((message.width, message.height), (346, 260))
            self.assertEqual(message.header.frame_id, "camera")

    def test_an_interval_of_time_is_found_by_the_index(self):
        begin, end = genpy.Time(0, 20_000_000), genpy.Time(0, 30_000_000)
        with self.written(MANY) as bag:
            some = [message for _, message, _ in bag.read_messages(start_time=begin, end_time=end)]
            events = [event for message in some for event in message.events]
            self.assertEqual(len(events), sum(20_000 <= t < 30_000 for t, *_ in MANY))
            self.assertEqual(len(some), 2)

    def test_stamps_are_never_the_zero_that_means_no_time(self):
        with self.written([(0, 1, 2, 1)]) as bag:
            self.assertEqual(self.events_of(bag), [(0, 1, 2, 1)])
            self.assertEqual(bag.get_start_time(), 1e-9)

    def test_times_beyond_32_bits_of_microseconds(self):
        events = [(4_999, 0, 0, 1), (5_000, 1279, 719, 0), (4_300_000_000, 3, 4, 1), (4_294_967_295_999_999, 5, 6, 0)]
        with self.written(events) as bag:
            self.assertEqual(self.events_of(bag), events)
            self.assertEqual(bag.get_message_count(), 4)

    def test_times_that_ros_cannot_hold_are_refused(self):
        for time in (-1, 4_294_967_296_000_000):
            done = self.convert([(time, 1, 2, 1)])
            self.assertEqual(done.returncode, 1)
            self.assertIn("a bag holds times from 0 to 4294967295 s", done.stderr)

    def test_more_events_at_one_time_than_a_message_holds(self):
        events = [(9, i % 1280, i // 1280, 1) for i in range(150_000)]
        with self.written(events) as bag:
            self.assertEqual(self.events_of(bag), events)
            self.assertEqual(bag.get_message_count(), 3)

    def test_a_bag_without_events_opens(self):
        with self.written([]) as bag:
            self.assertEqual(bag.get_message_count(), 0)

    def test_each_message_of_events_has_its_camera_beside_it(self):
        for view, space, frame in ((0, "/dvs", "camera"), (1, "/dvs_1", "camera_1")):
            event_files.write_csv(self.folder / "a.csv", MANY)
            event_files.describe(SACCADE, self.folder / "a.csv", (1280, 720),
                                 event_files.rig_request((1280, 720), 50.5, view))
            done = event_files.convert(SACCADE, self.folder / "a.csv", self.folder / "a.bag", (1280, 720))
            self.assertEqual(done.returncode, 0, done.stderr)
            with rosbag.Bag(str(self.folder / "a.bag")) as bag:
                events = [message for _, message, _ in bag.read_messages(space + "/events")]
                infos = [message for _, message, _ in bag.read_messages(space + "/camera_info")]
                self.assertEqual(bag.get_message_count(), 20)
            self.assertEqual([m.header.stamp for m in infos], [m.header.stamp for m in events])
            self.assertEqual({m.header.frame_id for m in infos + events}, {frame})
            self.assertEqual((infos[9].width, infos[9].K[0], infos[9].distortion_model), (1280, 50.5, "plumb_bob"))

    def test_an_interrupted_bag_has_the_events_up_to_there(self):
        event_files.write_csv(self.folder / "a.csv", MANY)
        with open(self.folder / "a.csv", "a", encoding="ascii") as text:
            text.write("no event\n")
        done = event_files.convert(SACCADE, self.folder / "a.csv", self.folder / "a.bag", (1280, 720))
        self.assertEqual(done.returncode, 1)
        with rosbag.Bag(str(self.folder / "a.bag.partial")) as bag:
            read = self.events_of(bag)
        self.assertGreater(len(read), len(MANY) // 2)
        self.assertEqual(read, MANY[:len(read)])

    def test_a_full_disk_leaves_whole_chunks_with_their_index(self):
        done = self.convert(MANY, most_bytes=1_500_000)
        self.assertEqual(done.returncode, 1)
        told = re.search(r"a\.bag\.partial: File too large; (\d+) events are kept in \S+a\.bag\.partial$", done.stderr)
        self.assertTrue(told, done.stderr)
        with rosbag.Bag(str(self.folder / "a.bag.partial")) as bag:
            read = self.events_of(bag)
        self.assertGreater(len(read), 60_000)
        self.assertEqual(len(read), int(told[1]))
        self.assertEqual(read, MANY[:len(read)])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
