"""MCAP files of `saccade convert`, read by the packages of Foxglove: mcap_test.py SACCADE FOLDER_FOR_NPM."""
import base64
import json
import pathlib
import re
import sys
import tempfile
import unittest

import event_files
import npm_packages
from evt3_messages import Evt3

SACCADE, _, NPM = sys.argv[1:4]
PACKAGES = ["@mcap/core@2.2.2", "@foxglove/rosmsg@5.0.5", "@foxglove/rosmsg2-serialization@3.1.0"]
SCRIPT = pathlib.Path(__file__).with_name("read_mcap.cjs")
BY_TOPIC = pathlib.Path(__file__).with_name("read_truth_mcap.cjs")

INTERVAL_US = 5000
MANY = [(1 + i // 3, i * 7 % 1280, i % 720, i // 20 % 2) for i in range(220_000)]  # over several chunks
EDGES = [(t, x, 5, 1) for t in range(0, 30_000, 700) for x in range(60)]  # whole parts of rows


class Mcap(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def convert(self, events, size, most_bytes=None):
        event_files.write_csv(self.folder / "a.csv", events)
        return event_files.convert(SACCADE, self.folder / "a.csv", self.folder / "a.mcap", size, most_bytes)

    def read(self, name, *interval):
        found = json.loads(npm_packages.run(NPM, SCRIPT, self.folder / name, *map(str, interval)))
        self.assertTrue(found["streamed"]["done"])
        if not interval:
            self.assertEqual(found["indexed"]["messages"], found["streamed"]["messages"])
        return found["indexed"], found["streamed"]["kinds"]

    def written(self, events, size=(1280, 720)):
        done = self.convert(events, size)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.read("a.mcap")[0]

    def events_of(self, file):
        """All events, after the rules for each message are checked."""
        events, receiver, last_ns = [], Evt3(), 0
        for number, message in enumerate(file["messages"]):
            payload = base64.b64decode(message["events"])
            self.assertEqual((message["sequence"], message["seq"]), (number, number))
            self.assertEqual([word >> 4 for word in payload[1:6:2]], [8, 6, 0][:len(payload) // 2])
            some = receiver.decode(payload)
            self.assertEqual(message["publish_ns"], message["log_ns"])
            self.assertGreaterEqual(message["log_ns"], last_ns)
            last_ns = message["log_ns"]
            begin_ns = message["header"]["stamp"]["sec"] * 10**9 + message["header"]["stamp"]["nanosec"]
            if some:
                self.assertEqual((begin_ns, last_ns), (some[0][0] * 1000, some[-1][0] * 1000))
                self.assertEqual(some[0][0] // INTERVAL_US, some[-1][0] // INTERVAL_US)
            events += some
        return events

    def test_all_events_come_back_over_many_messages_and_chunks(self):
        file = self.written(MANY)
        self.assertEqual(self.events_of(file), MANY)
        self.assertGreater(file["chunks"], 1)
        self.assertEqual(file["counts"], [[1, 15]])
        self.assertEqual(file["statistics"], {
            "type": "Statistics", "messageCount": 15, "schemaCount": 1, "channelCount": 1, "attachmentCount": 0,
            "metadataCount": 0, "chunkCount": file["chunks"], "messageStartTime": file["messages"][0]["log_ns"],
            "messageEndTime": MANY[-1][0] * 1000})

    def test_the_summary_has_its_groups_where_it_says(self):
        groups = self.written(MANY)["groups"]
        self.assertEqual([group["op"] for group in groups], [3, 4, 11, 8])  # schemas, channels, statistics, chunks
        self.assertEqual([group["op"] for group in groups], [group["opThere"] for group in groups])
        self.assertEqual([group["end"] for group in groups][:-1], [group["begin"] for group in groups][1:])

    def test_vectors_lie_within_the_row_and_save_bytes(self):
        for width in (60, 61, 1280):
            file = self.written(EDGES, (width, 720))
            self.assertEqual(self.events_of(file), EDGES)
            self.assertLess(sum(len(message["events"]) for message in file["messages"]) * 3 / 4, len(EDGES))

    def test_the_channel_is_one_of_ros_2(self):
        file = self.written([(7, 1, 2, 1)], (346, 260))
        self.assertEqual(file["profile"], "ros2")
        self.assertEqual(file["schemas"], [{"name": "event_camera_msgs/msg/EventPacket", "encoding": "ros2msg"}])
        channel = file["channels"][0]
        self.assertEqual((channel["topic"], channel["messageEncoding"], channel["metadata"]),
                         ("/event_camera/events", "cdr", {"offered_qos_profiles": ""}))
        message = file["messages"][0]
        self.assertEqual((message["width"], message["height"], message["encoding"]), (346, 260, "evt3"))
        self.assertEqual((message["time_base"], message["is_bigendian"]), (0, False))
        self.assertEqual(message["header"]["frame_id"], "camera")

    def test_an_interval_of_time_is_found_by_the_index(self):
        self.convert(MANY, (1280, 720))
        file, _ = self.read("a.mcap", 20_000_000, 29_999_999)
        self.assertEqual(self.events_of_messages(file["messages"]),
                         [event for event in MANY if 20_000 <= event[0] < 30_000])

    def events_of_messages(self, messages):
        receiver = Evt3()
        return [event for message in messages for event in receiver.decode(base64.b64decode(message["events"]))]

    def test_a_lost_message_costs_only_itself(self):
        messages = self.written(MANY)["messages"]
        lost = len(self.events_of_messages(messages[:5])), len(self.events_of_messages(messages[:6]))
        self.assertEqual(self.events_of_messages(messages[:5] + messages[6:]), MANY[:lost[0]] + MANY[lost[1]:])

    def test_silence_longer_than_the_wrap_of_evt3(self):
        events = [(5, 1, 2, 1), (60_000_000, 3, 4, 0), (4_300_000_000, 5, 6, 1)]
        file = self.written(events)
        self.assertEqual(self.events_of(file), events)
        times = [message["log_ns"] for message in file["messages"]]
        self.assertLessEqual(max(b - a for a, b in zip(times, times[1:])), 8 * 10**9)

    def test_times_that_ros_cannot_hold_are_refused(self):
        for time in (-1, 2_147_483_648_000_000):
            done = self.convert([(time, 1, 2, 1)], (4, 3))
            self.assertEqual(done.returncode, 1)
            self.assertIn("ROS 2 holds times from 0 to 2147483647 s", done.stderr)

    def test_images_that_evt3_cannot_hold_are_refused(self):
        self.assertEqual(self.events_of(self.written([(1, 2047, 2047, 1)], (2048, 2048))), [(1, 2047, 2047, 1)])
        for size in ((2049, 3), (3, 2049)):
            done = self.convert([], size)
            self.assertEqual(done.returncode, 2)
            self.assertIn("at most 2048x2048 pixels", done.stderr)

    def test_a_file_without_events_opens(self):
        file = self.written([])
        self.assertEqual((file["messages"], file["chunks"], file["statistics"]["messageCount"]), ([], 0, 0))

    def test_each_message_of_events_has_its_camera_beside_it(self):
        for view, space in ((0, "/event_camera"), (1, "/event_camera_1")):
            event_files.write_csv(self.folder / "a.csv", MANY)
            event_files.describe(SACCADE, self.folder / "a.csv", (1280, 720),
                                 event_files.rig_request((1280, 720), 50.5, view))
            done = event_files.convert(SACCADE, self.folder / "a.csv", self.folder / "a.mcap", (1280, 720))
            self.assertEqual(done.returncode, 0, done.stderr)
            found = json.loads(npm_packages.run(NPM, BY_TOPIC, self.folder / "a.mcap"))["messages"]
            events, infos = found[space + "/events"], found[space + "/camera_info"]
            self.assertEqual(len(infos), 15)
            self.assertEqual([(m["stamp_us"], m["log_us"]) for m in infos], [(m["stamp_us"], m["log_us"]) for m in events])
            self.assertEqual((infos[9]["width"], infos[9]["camera"]["k"][0]), (1280, 50.5))

    def test_an_interrupted_file_has_the_events_up_to_there(self):
        event_files.write_csv(self.folder / "a.csv", MANY)
        with open(self.folder / "a.csv", "a", encoding="ascii") as text:
            text.write("no event\n")
        done = event_files.convert(SACCADE, self.folder / "a.csv", self.folder / "a.mcap", (1280, 720))
        self.assertEqual(done.returncode, 1)
        self.expect_a_part()

    def test_a_full_disk_leaves_whole_chunks_with_their_index(self):
        done = self.convert(MANY, (1280, 720), most_bytes=900_000)
        self.assertEqual(done.returncode, 1)
        told = re.search(r"a\.mcap\.partial: File too large; (\d+) events are kept in \S+a\.mcap\.partial$", done.stderr)
        self.assertTrue(told, done.stderr)
        self.assertEqual(self.expect_a_part(), int(told[1]))

    def expect_a_part(self):
        """Returns the number of events."""
        read = self.events_of(self.read("a.mcap.partial")[0])
        self.assertGreater(len(read), 100_000)
        self.assertEqual(read, MANY[:len(read)])
        return len(read)


if __name__ == "__main__":
    reason = npm_packages.missing(NPM, PACKAGES)
    if reason:
        print("skipped:", reason)
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
