"""Truth channels in files, read by h5py, NumPy, rosbag and OpenImageIO: truth_files_test.py SACCADE SACCADED
FOLDER_FOR_NPM WRITE_TRUTH."""
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import event_columns
import npm_packages

try:
    import h5py
    import numpy as np
    import rosbag
    from geometry_msgs.msg import PoseStamped, TwistStamped
    from sensor_msgs.msg import CameraInfo, Image, Imu
except ImportError as fault:
    event_columns.skip(fault)
import truth_formula as formula

SACCADE, _, NPM, WRITE_TRUTH = sys.argv[1:5]
PACKAGES = ["@mcap/core@2.2.2", "@foxglove/rosmsg@5.0.5", "@foxglove/rosmsg2-serialization@3.1.0"]
IMAGE_TYPES = {"32FC1": "<f4", "32FC3": "<f4", "mono8": "u1", "mono16": "<u2", "8UC4": "u1", "32SC2": "<u4"}
TOPICS = {"frame": "/image_raw", "depth_view1": "_1/depth"}
FRAMES = {"pose": "world", "imu": "body", "depth_view1": "camera_1"}


def numbers(message):
    """The numbers of PoseStamped, TwistStamped and Imu as the channel has them; messages of ROS 1."""
    def xyz(vector):
        return [vector.x, vector.y, vector.z]
    if hasattr(message, "pose"):
        orientation = message.pose.orientation
        return xyz(message.pose.position) + xyz(orientation) + [orientation.w]
    if hasattr(message, "twist"):
        return xyz(message.twist.linear) + xyz(message.twist.angular)
    return xyz(message.linear_acceleration) + xyz(message.angular_velocity)


def picture(message, data):
    array = np.frombuffer(data, IMAGE_TYPES[message["encoding"]])
    return array.reshape(message["height"], message["width"], -1)


class TruthFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def written(self, name):
        subprocess.run([WRITE_TRUTH, self.folder / name], check=True, timeout=60)
        return self.folder / name

    def expect_rows(self, path, name):
        with path.open(encoding="ascii", newline="") as file:
            head, *rows = csv.reader(file)
        self.assertEqual(head, ["t_us"] + formula.CHANNELS[name][1])
        np.testing.assert_array_equal([int(row[0]) for row in rows], formula.times_us(name))
        np.testing.assert_array_equal(np.array([row[1:] for row in rows], float), formula.samples(name))

    def test_h5py_reads_a_group_for_each_channel(self):
        with h5py.File(self.written("a.h5")) as file:
            groups = {name: f"truth/{name}" for name in formula.CHANNELS} | {"depth_view1": "view_1/truth/depth"}
            self.assertEqual(set(file["truth"]), set(formula.CHANNELS) - {"depth_view1"})
            for name, (kind, planes) in formula.CHANNELS.items():
                channel = file[groups[name]]
                self.assertEqual(channel["data"].dtype, kind)
                np.testing.assert_array_equal(channel["data"][:], formula.samples(name))
                np.testing.assert_array_equal(channel["t"][:], formula.times_us(name))
                self.assertEqual(list(channel.attrs["planes"]), planes)
                self.assertEqual(channel.attrs["unit"], "unit of " + name)
                self.assertEqual(channel.attrs["description"], f"what {name} is")
                if name in formula.PICTURES:
                    exposures = np.stack([channel["exposure_begin"][:], channel["exposure_end"][:]], axis=1)
                    np.testing.assert_array_equal(exposures, formula.exposures_us(name))
            self.assertEqual(file["truth/flow/data"].chunks, (1, formula.HEIGHT, formula.WIDTH, 3))
            np.testing.assert_array_equal(file["events/t"][:], [t for t, *_ in formula.EVENTS])

    def test_numpy_reads_arrays_of_each_channel(self):
        with np.load(self.written("a.npz"), allow_pickle=False) as file:
            for name, (kind, _) in formula.CHANNELS.items():
                self.assertEqual(file[name].dtype, kind)
                np.testing.assert_array_equal(file[name], formula.samples(name))
                np.testing.assert_array_equal(file[name + "_t"], formula.times_us(name))
                if name in formula.PICTURES:
                    np.testing.assert_array_equal(file[name + "_exposure"], formula.exposures_us(name))
            np.testing.assert_array_equal(file["t"], [t for t, *_ in formula.EVENTS])

    def test_rosbag_reads_messages_of_each_channel(self):
        types = {"pose": PoseStamped, "velocity": TwistStamped, "imu": Imu}
        with rosbag.Bag(str(self.written("a.bag"))) as bag:
            topics = bag.get_type_and_topic_info().topics
            for name in formula.CHANNELS.keys() - {"other"}:
                topic = "/dvs" + TOPICS.get(name, "/" + name)
                ros_type = types.get(name, Image)
                self.assertEqual(topics[topic].msg_type, ros_type._type)
                messages = list(bag.read_messages(topic))
                self.assertEqual([m.header.seq for _, m, _ in messages], list(range(len(messages))))
                for (_, message, time), t_us in zip(messages, formula.times_us(name), strict=True):
                    self.assertEqual(time.to_nsec(), max(1, t_us * 1000))
                    self.assertEqual(message.header.stamp, time)
                    self.assertEqual(message._md5sum, ros_type._md5sum)  # made from the definition
                    self.assertEqual(message.header.frame_id, FRAMES.get(name, "camera"))
                if name in formula.ROWS:
                    read = [numbers(message) for _, message, _ in messages]
                else:
                    read = [picture({"encoding": m.encoding, "height": m.height, "width": m.width}, m.data)
                            for _, m, _ in messages]
                    self.assertEqual(messages[0][1].step * formula.HEIGHT, len(messages[0][1].data))
                np.testing.assert_array_equal(read, formula.samples(name))
            self.assertEqual(sum(len(m.events) for _, m, _ in bag.read_messages("/dvs/events")), len(formula.EVENTS))
            imu = next(bag.read_messages("/dvs/imu"))[1]
            self.assertEqual((imu.orientation.w, imu.orientation_covariance[0]), (1, -1))
        self.expect_rows(self.folder / "a.bag.truth" / "other.csv", "other")

    def test_mcap_core_reads_messages_of_each_channel(self):
        reason = npm_packages.missing(NPM, PACKAGES)
        if reason:
            self.skipTest(reason)
        script = pathlib.Path(__file__).with_name("read_truth_mcap.cjs")
        found = json.loads(npm_packages.run(NPM, script, self.written("a.mcap")))
        self.assertEqual(found["counts"], {t: len(m) for t, m in found["messages"].items()})
        for name in formula.CHANNELS.keys() - {"other"}:
            messages = found["messages"]["/event_camera" + TOPICS.get(name, "/" + name)]
            self.assertEqual([m["log_us"] for m in messages], formula.times_us(name).tolist())
            self.assertEqual([m["stamp_us"] for m in messages], formula.times_us(name).tolist())
            if name in formula.ROWS:
                read = [m["numbers"] for m in messages]
            else:
                read = [picture(m, bytes.fromhex(m["data"])) for m in messages]
            np.testing.assert_array_equal(read, formula.samples(name))
        self.expect_rows(self.folder / "a.mcap.truth" / "other.csv", "other")

    def test_a_bag_tells_the_camera_of_each_view_beside_its_pictures(self):
        with rosbag.Bag(str(self.written("a.bag"))) as bag:
            for topic, frame, picture_topic, lens in (("/dvs", "camera", "image_raw", formula.LENSES[0]),
                                                      ("/dvs_1", "camera_1", "depth", formula.LENSES[1])):
                infos = [m for _, m, _ in bag.read_messages(topic + "/camera_info")]
                pictures = [m for _, m, _ in bag.read_messages(topic + "/" + picture_topic)]
                self.assertEqual([m.header.stamp for m in infos], [m.header.stamp for m in pictures])
                self.assertEqual([m.header.seq for m in infos], [0, 1, 2, 3])
                for info in infos:
                    self.assertEqual((info._type, info._md5sum), (CameraInfo._type, CameraInfo._md5sum))
                    self.assertEqual((info.width, info.height, info.header.frame_id),
                                     (formula.WIDTH, formula.HEIGHT, frame))
                    self.assertEqual((info.distortion_model, list(info.D)), lens)
                    self.expect_matrices(info.K, info.R, info.P)
                    self.assertEqual((info.binning_x, info.roi.width, info.roi.do_rectify), (0, 0, False))

    def expect_matrices(self, k, r, p):
        self.assertEqual(list(k), formula.MATRIX)
        self.assertEqual(list(r), np.eye(3).ravel().tolist())
        np.testing.assert_array_equal(np.reshape(p, (3, 4)), np.c_[np.reshape(k, (3, 3)), np.zeros(3)])

    def test_an_mcap_file_tells_the_camera_of_each_view(self):
        reason = npm_packages.missing(NPM, PACKAGES)
        if reason:
            self.skipTest(reason)
        script = pathlib.Path(__file__).with_name("read_truth_mcap.cjs")
        messages = json.loads(npm_packages.run(NPM, script, self.written("a.mcap")))["messages"]
        for space, picture_name, lens in (("/event_camera", "image_raw", formula.LENSES[0]),
                                          ("/event_camera_1", "depth", formula.LENSES[1])):
            infos = messages[space + "/camera_info"]
            self.assertEqual([m["stamp_us"] for m in infos], [m["stamp_us"] for m in messages[f"{space}/{picture_name}"]])
            for info in infos:
                self.assertEqual((info["width"], info["height"]), (formula.WIDTH, formula.HEIGHT))
                self.assertEqual((info["camera"]["distortion_model"], info["camera"]["d"]), lens)
                self.expect_matrices(*(info["camera"][name] for name in "krp"))

    def test_an_interrupted_recording_has_what_arrived(self):
        for name in ("a.h5", "a.npz", "a.bag"):
            subprocess.run([WRITE_TRUTH, self.folder / name, "partial"], check=True, timeout=60)
        times, events = formula.times_us("depth"), [t for t, *_ in formula.EVENTS]
        with h5py.File(self.folder / "a.h5.partial") as file:
            np.testing.assert_array_equal(file["truth/depth/t"][:], times)
            np.testing.assert_array_equal(file["truth/pose/data"][:], formula.samples("pose"))
            np.testing.assert_array_equal(file["events/t"][:], events)
        with np.load(self.folder / "a.npz.partial", allow_pickle=False) as file:
            np.testing.assert_array_equal(file["depth"], formula.samples("depth"))
            np.testing.assert_array_equal(file["t"], events)
        with rosbag.Bag(str(self.folder / "a.bag.partial")) as bag:
            self.assertEqual(bag.get_message_count("/dvs/depth"), len(times))
            self.assertEqual(sum(len(m.events) for _, m, _ in bag.read_messages("/dvs/events")), len(events))

    def test_oiiotool_reads_pictures_of_a_folder(self):
        folder = pathlib.Path(str(self.written("a.csv")) + ".truth")
        for name in formula.ROWS:
            self.expect_rows(folder / (name + ".csv"), name)
        for name, (kind, planes) in formula.PICTURES.items():
            with (folder / name / "times.csv").open(encoding="ascii") as file:
                table = np.loadtxt(file, int, delimiter=",", skiprows=1)
            expected = np.column_stack([np.arange(4), formula.times_us(name), formula.exposures_us(name)])
            np.testing.assert_array_equal(table, expected)
            extension = ".png" if kind in ("u1", "u2") else ".exr"
            for index, sample in enumerate(formula.samples(name)):
                read = self.pixels(folder / name / f"{index:06}{extension}", planes)
                np.testing.assert_array_equal(read, sample)

    def pixels(self, path, planes):
        """(height, width, planes) as `oiiotool` prints them, a line for each pixel."""
        text = subprocess.run(["oiiotool", "--iconfig", "oiio:UnassociatedAlpha", "1", "--dumpdata", "-v", "--info", path], check=True, capture_output=True, text=True,
                              timeout=60).stdout
        channels = re.search(r"channel list: (.*)", text)[1].split(", ")
        lines = re.findall(r"Pixel \(\d+, \d+\): ([^(\n]*)", text)
        read = np.array([line.split() for line in lines], float).reshape(formula.HEIGHT, formula.WIDTH, -1)
        return read[..., [channels.index(plane) for plane in planes]] if path.suffix == ".exr" else read


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
