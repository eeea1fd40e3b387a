"""One bag and one MCAP file of two cameras with two sensors each: ros_sensors_test.py SACCADE SACCADED FOLDER_FOR_NPM."""
import base64
import csv
import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

import event_columns
import npm_packages
from evt3_messages import Evt3

try:
    import rosbag
except ImportError as fault:
    event_columns.skip(fault)

SACCADE, SACCADED, NPM = sys.argv[1:4]
FREE = "tcp://127.0.0.1:*"
PACKAGES = ["@mcap/core@2.2.2", "@foxglove/rosmsg@5.0.5", "@foxglove/rosmsg2-serialization@3.1.0"]
RECORD = ["record", "cornell-box", "--motion", "truck:2px", "--size", "32x24", "--rate", "200", "--duration", "0.05",
          "--threshold", "0.1", "--threshold", "0.3", "--further-view", "0.2,0,0"]
TRUTH = ["--truth", "depth:2", "--truth", "pose", "--truth", "imu"]
EVENTS = ["/events", "/events_1", "_1/events", "_1/events_1"]  # by sensor
OTHERS = {f"{view}/{name}" for view in ("", "_1") for name in ("camera_info", "depth", "pose")} | {"/imu"}


class RosSensors(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        server = subprocess.Popen([SACCADED, "--control", FREE, "--data", FREE, "--broadcast", FREE, "--http", "off"],
                                  stdout=subprocess.PIPE, text=True)
        cls.addClassCleanup(server.communicate)
        cls.addClassCleanup(server.send_signal, signal.SIGTERM)
        cls.server = next(filter(None, (re.search(r"ready: control (\S+)", line) for line in server.stdout)))[1]
        cls.told = {name: cls.run_command(*RECORD, *TRUTH, "-o", cls.folder / name) for name in ("a.bag", "a.mcap")}
        cls.run_command(*RECORD, "-o", cls.folder / "a.csv")

    @classmethod
    def run_command(cls, *arguments):
        return subprocess.run([SACCADE, *arguments, "--control", cls.server], check=True, capture_output=True,
                              text=True, timeout=120).stdout

    def events(self, sensor):
        with (self.folder / f"a-{sensor}.csv").open(encoding="ascii", newline="") as file:
            events = [tuple(map(int, row)) for row in list(csv.reader(file))[1:]]
        self.assertGreater(len(events), 50)
        return events

    def expect_infos(self, messages, pictures, frame, name_of):
        self.assertEqual(len(messages), 6)
        self.assertEqual([stamp for stamp, _ in messages], pictures)
        self.assertEqual({name_of(message) for _, message in messages}, {frame})

    def test_a_bag_has_topics_of_each_sensor_and_view(self):
        with rosbag.Bag(str(self.folder / "a.bag")) as bag:
            self.assertEqual(set(bag.get_type_and_topic_info().topics), {"/dvs" + name for name in [*EVENTS, *OTHERS]})
            for sensor, topic in enumerate(EVENTS):
                messages = [message for _, message, _ in bag.read_messages("/dvs" + topic)]
                read = [(e.ts.to_nsec() // 1000, e.x, e.y, int(e.polarity)) for m in messages for e in m.events]
                self.assertEqual(read, self.events(sensor))
                self.assertEqual([message.header.seq for message in messages], list(range(len(messages))))
                self.assertEqual({message.header.frame_id for message in messages}, {["camera", "camera_1"][sensor // 2]})
            for space, frame in (("/dvs", "camera"), ("/dvs_1", "camera_1")):
                infos = [(m.header.stamp, m) for _, m, _ in bag.read_messages(space + "/camera_info")]
                pictures = [m.header.stamp for _, m, _ in bag.read_messages(space + "/depth")]
                self.expect_infos(infos, pictures, frame, lambda message: message.header.frame_id)
            left, right = (next(bag.read_messages(space + "/pose"))[1].pose.position for space in ("/dvs", "/dvs_1"))
            self.assertAlmostEqual((left.x - right.x)**2 + (left.y - right.y)**2 + (left.z - right.z)**2, 0.04)

    def test_an_mcap_file_has_topics_of_each_sensor_and_view(self):
        reason = npm_packages.missing(NPM, PACKAGES)
        if reason:
            self.skipTest(reason)
        script = pathlib.Path(__file__).with_name("read_truth_mcap.cjs")
        messages = json.loads(npm_packages.run(NPM, script, self.folder / "a.mcap"))["messages"]
        self.assertEqual(set(messages), {"/event_camera" + name for name in [*EVENTS, *OTHERS]})
        for sensor, topic in enumerate(EVENTS):
            decoder = Evt3()
            packets = [base64.b64decode(message["events"]) for message in messages["/event_camera" + topic]]
            self.assertEqual([event for packet in packets for event in decoder.decode(packet)], self.events(sensor))
        for space in ("/event_camera", "/event_camera_1"):
            self.assertEqual(len(messages[space + "/camera_info"]), 6)
            self.assertEqual([m["stamp_us"] for m in messages[space + "/camera_info"]],
                             [m["stamp_us"] for m in messages[space + "/depth"]])

    def test_each_sensor_has_its_description(self):
        for name in ("a.bag", "a.mcap"):
            self.assertIn(f"{self.folder / name}\n", self.told[name].replace("wrote ", ""))
            self.assertEqual(len(list(self.folder.glob(name + "*"))), 5)  # the file, and what is said of four sensors
            for sensor, part in enumerate(("", ".sensor1", ".sensor2", ".sensor3")):
                about = json.loads((self.folder / f"{name}{part}.json").read_text(encoding="utf-8"))
                self.assertEqual((about["sensor"], int(about["events"])), (sensor, len(self.events(sensor))))
                self.assertEqual([t["name"] for t in about["truth"]],
                                 [["depth", "pose", "imu"], [], ["depth", "pose"], []][sensor])

    def test_a_replay_of_any_sensor_gives_the_rig(self):
        told = self.run_command("replay", self.folder / "a.bag.sensor3.json", "-o", self.folder / "again.bag")
        self.assertIn("the events are those of the recording\n", told)
        self.assertEqual((self.folder / "again.bag").read_bytes(), (self.folder / "a.bag").read_bytes())
        told = self.run_command("replay", self.folder / "a.mcap.sensor3.json", "-o", self.folder / "again.csv")
        self.assertIn("the events are those of the recording\n", told)
        self.assertEqual((self.folder / "again.csv").read_bytes(), (self.folder / "a-3.csv").read_bytes())

    def test_a_replay_of_a_numbered_file_gives_the_rig(self):
        told = self.run_command("replay", self.folder / "a-2.csv.json", "-o", self.folder / "rig.mcap")
        self.assertNotIn("no description", told)
        for sensor in range(4):
            out = self.folder / f"rig{sensor}.csv"
            subprocess.run([SACCADE, "convert", self.folder / "rig.mcap", out, "--sensor", str(sensor)], check=True,
                           capture_output=True, timeout=60)
            self.assertEqual(out.read_bytes(), (self.folder / f"a-{sensor}.csv").read_bytes())

    def test_each_sensor_is_read_from_the_file(self):
        for name in ("a.bag", "a.mcap"):
            for sensor in range(4):
                out = self.folder / f"{name}{sensor}.csv"
                for command in (["convert", self.folder / name, out], ["verify", self.folder / name]):
                    subprocess.run([SACCADE, *command, "--sensor", str(sensor)], check=True, capture_output=True, timeout=60)
                self.assertEqual(out.read_bytes(), (self.folder / f"a-{sensor}.csv").read_bytes())
                about = json.loads(out.with_name(out.name + ".json").read_text(encoding="utf-8"))
                self.assertEqual(about["sensor"], sensor)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
