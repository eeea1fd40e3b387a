"""The node of ROS 1 with a master, a subscriber and a real saccaded. The reference is `saccade record`."""
import importlib.util
import os
import pathlib
import queue
import signal
import subprocess
import sys
import tempfile
import unittest

MISSING = [name for name in ("rospy", "rosmaster", "sensor_msgs") if importlib.util.find_spec(name) is None]
if MISSING:
    print("skipped: this Python has no", ", ".join(MISSING), "(packages python3-rospy, python3-rosmaster, "
          "python3-sensor-msgs)")
    sys.exit(77)
SCRATCH = tempfile.TemporaryDirectory()
os.environ.update(ROS_IP="127.0.0.1", ROS_LOG_DIR=SCRATCH.name, ROS_HOME=SCRATCH.name)
import genpy.dynamic
import numpy as np
import rosmaster.master
import rospy
from sensor_msgs.msg import CameraInfo

SOURCE = pathlib.Path(os.environ["SOURCE"])
sys.path.append(str(SOURCE / "tests/python"))
from saccaded import Server, record

NODE = SOURCE / "client/ros1/saccade_node.py"
PARAMETERS = {"scene": "cornell-box", "motion": "right", "width": 64, "height": 48, "rate_hz": 500, "duration_s": 0.1,
              "threshold": 0.2, "fov_x_deg": 90, "stream_time": "true",
              "wait_for_subscriber": "true"}  # all, because the master keeps what an earlier node had
OPTIONS = ["--motion", "right", "--size", "64x48", "--rate", "500", "--duration", "0.1", "--threshold", "0.2",
           "--fov", "90"]
MD5 = "5e8beee5a6c107e504c2e78903c224b8"  # of dvs_msgs/EventArray
MESSAGE_S, NODE_S = 60, 120  # limits


def row(event):
    return event.ts.to_nsec() // 1000, event.x, event.y, int(event.polarity)


class Ros1Node(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = cls.enterClassContext(Server())
        master = rosmaster.master.Master(0)  # on a free port
        master.start()
        cls.addClassCleanup(master.stop)
        os.environ["ROS_MASTER_URI"] = master.uri
        rospy.init_node("test", anonymous=True, disable_signals=True)
        cls.addClassCleanup(rospy.signal_shutdown, "the test is over")
        reference = pathlib.Path(SCRATCH.name) / "reference.csv"
        done = record(cls.server, reference, *OPTIONS)
        assert done.returncode == 0, done.stderr
        cls.reference = np.loadtxt(reference, np.int64, delimiter=",", skiprows=1)

    def start(self, **parameters):
        values = {**PARAMETERS, "server": self.server.address, **parameters}
        words = [f"_{name}:={value}" for name, value in values.items()]
        return subprocess.Popen([sys.executable, str(NODE), *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                text=True)

    def finish(self, node):
        """What the node has printed, and its exit code."""
        with node:
            self.addCleanup(node.kill)
            return node.communicate(timeout=NODE_S)[0], node.returncode

    def subscribe(self, topic, message_class):
        messages = queue.Queue()
        subscriber = rospy.Subscriber(topic, message_class, messages.put)
        self.addCleanup(subscriber.unregister)
        return messages

    def receive(self):
        """The messages of a run of the node, as a class made from the definition that it sends decodes them."""
        arrays = self.subscribe("/dvs/events", rospy.AnyMsg)
        text, code = self.finish(self.start())
        self.assertEqual(code, 0, text)
        messages, events = [], 0
        while events < len(self.reference):
            raw = arrays.get(timeout=MESSAGE_S)
            head = raw._connection_header
            self.assertEqual((head["type"], head["md5sum"]), ("dvs_msgs/EventArray", MD5))
            message = genpy.dynamic.generate_dynamic(head["type"], head["message_definition"])[head["type"]]()
            message.deserialize(raw._buff)
            messages.append(message)
            events += len(message.events)
        return messages

    def test_a_subscriber_gets_the_events_of_a_recording(self):
        messages = self.receive()
        self.assertGreater(len(self.reference), 1000)
        np.testing.assert_array_equal([row(event) for message in messages for event in message.events], self.reference)
        for message in messages:
            self.assertEqual((message.width, message.height, message.header.frame_id), (64, 48, "camera"))
            self.assertEqual(message.header.stamp, message.events[-1].ts)

    def test_a_late_subscriber_gets_the_camera_and_the_node_stops_with_ros(self):
        arrays = self.subscribe("/dvs/events", rospy.AnyMsg)
        node = self.start(duration_s=0)
        arrays.get(timeout=MESSAGE_S)
        info = self.subscribe("/dvs/camera_info", CameraInfo).get(timeout=MESSAGE_S)
        node.send_signal(signal.SIGINT)
        self.assertEqual(self.finish(node)[1], 0)
        self.assertEqual((info.width, info.height, info.distortion_model), (64, 48, "plumb_bob"))
        np.testing.assert_allclose(info.K, [32, 0, 31.5, 0, 32, 23.5, 0, 0, 1])  # 64 / (2 tan 45 degrees)
        np.testing.assert_allclose(info.P, [32, 0, 31.5, 0, 0, 32, 23.5, 0, 0, 0, 1, 0])

    def test_a_refusal_is_told(self):
        text, code = self.finish(self.start(scene="none", wait_for_subscriber="false"))
        self.assertEqual(code, 1)
        self.assertIn("scene", text)


if __name__ == "__main__":
    unittest.main()
