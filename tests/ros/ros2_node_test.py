"""The node of ROS 2 with a real saccaded, and with stand-ins for the packages of ROS. The reference is
`saccade record`.
"""
import os
import pathlib
import py_compile
import sys
import tempfile
import types
import unittest

import numpy as np

SOURCE = pathlib.Path(os.environ["SOURCE"])
PACKAGE = SOURCE / "client/ros2/saccade_bridge"
sys.path += [str(SOURCE / "tests/python"), str(SOURCE / "tests/client"), str(PACKAGE)]
from evt3_messages import Evt3
from saccaded import Server, record

PARAMETERS = {"scene": "cornell-box", "motion": "right", "width": 64, "height": 48, "rate_hz": 500.0, "duration_s": 0.1,
              "threshold": 0.2, "fov_x_deg": 90.0, "stream_time": True}
OPTIONS = ["--motion", "right", "--size", "64x48", "--rate", "500", "--duration", "0.1", "--threshold", "0.2",
           "--fov", "90"]

NOW_NS = 7_000_000_123


def make_header():
    return types.SimpleNamespace(frame_id="", stamp=types.SimpleNamespace(sec=0, nanosec=0))


class Message:
    """A message refuses fields that its type does not have, as those of ROS 2 do."""

    def __init__(self, **values):
        self.header = make_header()
        for name, value in values.items():
            setattr(self, name, value)

    def __setattr__(self, name, value):
        if name not in self.FIELDS:
            raise AttributeError(name)
        super().__setattr__(name, value)


class EventPacket(Message):
    FIELDS = {"header", "height", "width", "seq", "time_base", "encoding", "is_bigendian", "events"}


class CameraInfo(Message):
    FIELDS = {"header", "height", "width", "distortion_model", "d", "k", "r", "p", "binning_x", "binning_y", "roi"}


class FakeNode:
    """Keeps what is published, by topic. `given` are the parameters of the command line."""

    given, published = {}, {}

    def __init__(self, name):
        self.name, self.declared = name, {}

    def declare_parameter(self, name, default):
        assert type(self.given.get(name, default)) is type(default), name  # rclpy insists on it
        self.declared[name] = self.given.get(name, default)

    def get_parameter(self, name):
        return types.SimpleNamespace(value=self.declared[name])

    def create_publisher(self, message_class, topic, queue):
        assert queue > 0
        messages = self.published.setdefault(topic.replace("~", "/" + self.name), [])

        def publish(message):
            assert isinstance(message, message_class)
            messages.append(message)
        return types.SimpleNamespace(publish=publish, get_subscription_count=lambda: 1)

    def get_clock(self):
        return types.SimpleNamespace(now=lambda: types.SimpleNamespace(nanoseconds=NOW_NS))

    def get_logger(self):
        return types.SimpleNamespace(warning=self.log, fatal=self.log)

    def log(self, text):
        self.published.setdefault("log", []).append(text)

    def destroy_node(self):
        pass


def module(name, **contents):
    sys.modules[name] = types.ModuleType(name)
    sys.modules[name].__dict__.update(contents)


module("rclpy", init=lambda: None, ok=lambda: True, try_shutdown=lambda: None, spin_once=lambda node, timeout_sec: None)
module("rclpy.node", Node=FakeNode)
module("rclpy.executors", ExternalShutdownException=type("ExternalShutdownException", (Exception,), {}))
for package, message in (("event_camera_msgs", EventPacket), ("sensor_msgs", CameraInfo)):
    module(package)
    module(package + ".msg", **{message.__name__: message})
from saccade import Losses
from saccade_bridge import node, stream_source


def time_us(message):
    return message.header.stamp.sec * 1_000_000 + message.header.stamp.nanosec / 1000


class Ros2Node(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = cls.enterClassContext(Server())
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        done = record(cls.server, folder / "reference.csv", *OPTIONS)
        assert done.returncode == 0, done.stderr
        cls.reference = np.loadtxt(folder / "reference.csv", np.int64, delimiter=",", skiprows=1)

    def published(self, **parameters):
        FakeNode.given, FakeNode.published = {**PARAMETERS, "server": self.server.address, **parameters}, {}
        node.main()
        return FakeNode.published

    def test_packets_have_the_events_of_a_recording(self):
        packets = self.published()["/event_camera/events"]
        receiver = Evt3()
        parts = [receiver.decode(packet.events.tobytes()) for packet in packets]
        self.assertGreater(len(self.reference), 1000)
        np.testing.assert_array_equal([event for part in parts for event in part], self.reference)
        for number, (packet, part) in enumerate(zip(packets, parts)):
            self.assertEqual((packet.seq, packet.encoding, packet.width, packet.height), (number, "evt3", 64, 48))
            self.assertEqual([word >> 4 for word in packet.events[1:6:2]], [8, 6, 0])
            self.assertEqual(time_us(packet), part[0][0])

    def test_the_camera_is_a_pinhole(self):
        published = self.published()
        infos, packets = published["/event_camera/camera_info"], published["/event_camera/events"]
        self.assertEqual([time_us(info) for info in infos], [time_us(packet) for packet in packets])
        np.testing.assert_allclose(infos[0].k, [32, 0, 31.5, 0, 32, 23.5, 0, 0, 1])  # 64 / (2 tan 45 degrees)
        np.testing.assert_allclose(infos[0].p, [32, 0, 31.5, 0, 0, 32, 23.5, 0, 0, 0, 1, 0])
        self.assertEqual((infos[0].width, infos[0].height, infos[0].header.frame_id), (64, 48, "camera"))

    def test_packets_without_events_tell_the_time(self):
        packets = self.published(motion="pan:0.000001", threshold=10.0)["/event_camera/events"]
        receiver = Evt3()
        self.assertGreater(len(packets), 10)
        for packet in packets:
            self.assertEqual(receiver.decode(packet.events.tobytes()), [])
            self.assertEqual(receiver.high, time_us(packet) // 4096 * 4096)

    def test_objects_move_before_a_camera_that_stands(self):
        self.assertGreater(len(self.published(motion="still", objects="tall_block=spin:360")["/event_camera/events"]), 0)
        with self.assertRaisesRegex(ValueError, "NAME=PATH"):
            stream_source.objects_of("tall_block")

    def test_stamps_begin_at_the_time_of_ros(self):
        packets = self.published(stream_time=False)["/event_camera/events"]
        first_us = self.reference[0, 0]
        self.assertEqual(time_us(packets[0]), NOW_NS / 1000 + first_us)
        self.assertEqual(Evt3().decode(packets[0].events.tobytes())[0][0], first_us)

    def test_losses_are_told_once(self):
        told, stream = [], types.SimpleNamespace(losses=Losses())
        watch = stream_source.LossWatch(stream, told.append)
        for losses in (Losses(), Losses(1, 2, 30), Losses(1, 2, 30), Losses(2, 5, 70)):
            stream.losses = losses
            watch.check()
        self.assertEqual(told, [f"{lost} were lost so far" for lost in ("2 packets with 30 events",
                                                                        "5 packets with 70 events")])

    def test_a_refusal_is_told(self):
        with self.assertRaises(SystemExit):
            self.published(scene="none")
        self.assertIn("scene", FakeNode.published["log"][0])

    def test_every_file_compiles(self):
        with tempfile.TemporaryDirectory() as folder:
            for path in PACKAGE.rglob("*.py"):
                py_compile.compile(str(path), cfile=folder + "/compiled", doraise=True)


if __name__ == "__main__":
    unittest.main()
