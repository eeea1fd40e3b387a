"""A recorded rig against its calibration: the depth of one camera, taken to the other by the files of DSEC and Kalibr,
is the depth that the other sees. rig_files_test.py SACCADE SACCADED."""
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

import event_columns

try:
    import h5py
    import numpy as np
    import yaml
except ImportError as fault:
    event_columns.skip(fault)

SACCADE, SACCADED = sys.argv[1:3]
FREE = "tcp://127.0.0.1:*"
INTRINSICS = [60, 62, 30.5, 25]
RECORD = ["record", "cornell-box", "--trajectory", "right", "--size", "64x48", "--rate", "100", "--duration", "0.02",
          "--intrinsics", "60,62,30.5,25", "--further-view", "0.2,0.1,-0.05,0.02,-0.06,0.1,1", "--truth", "depth",
          "--truth", "pose", "--truth", "imu", "--write-calibration"]


def matrix(intrinsics):
    fx, fy, cx, cy = intrinsics
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])


def pose(row):
    """T_world_camera of x y z qx qy qz qw."""
    x, y, z, w = row[3:]
    rotation = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                         [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                         [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
    return np.block([[rotation, np.reshape(row[:3], (3, 1))], [np.zeros((1, 3)), np.ones((1, 1))]])


class RigFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.path = cls.folder / "a.h5"
        server = subprocess.Popen([SACCADED, "--control", FREE, "--data", FREE, "--broadcast", FREE, "--http", "off"],
                                  stdout=subprocess.PIPE, text=True)
        cls.addClassCleanup(server.communicate)
        cls.addClassCleanup(server.send_signal, signal.SIGTERM)
        ready = next(filter(None, (re.search(r"ready: control (\S+)", line) for line in server.stdout)))
        cls.control = ["--control", ready[1]]
        cls.run_command(*RECORD, *cls.control, "-o", cls.path)

    @classmethod
    def run_command(cls, *arguments):
        return subprocess.run([SACCADE, *arguments], check=True, capture_output=True, text=True, timeout=120).stdout

    def truth(self, view, channel):
        with h5py.File(self.path) as file:
            return file[("/truth/", "/view_1/truth/")[view] + channel]["data"][0]

    def yaml(self, ending):
        return yaml.safe_load(pathlib.Path(f"{self.path}.{ending}").read_text(encoding="ascii"))

    def events(self, path, group):
        with h5py.File(path) as file:
            sensor = file[group]
            self.assertEqual((sensor.attrs["width"], sensor["events/height"][()], sensor["t_offset"][()]), (64, 48, 0))
            index = sensor["ms_to_idx"][:]
            columns = [sensor["events"][name][:] for name in "txyp"]
            np.testing.assert_array_equal(index, np.searchsorted(columns[0], 1000 * np.arange(index.size)))
            return np.stack([column.astype(np.int64) for column in columns])

    def test_one_file_has_dsec_of_each_sensor(self):
        names = {path.name for path in self.folder.glob("a*") if "yaml" not in path.name and "again" not in path.name}
        self.assertEqual(names, {"a.h5", "a.h5.json", "a.h5.sensor1.json"})
        with h5py.File(self.path) as file:
            self.assertEqual(set(file), {"events", "ms_to_idx", "t_offset", "truth", "sensor_1", "view_1"})
            self.assertEqual(set(file["truth"]), {"depth", "pose", "imu"})
            self.assertEqual(set(file["view_1/truth"]), {"depth", "pose"})
        for sensor, group in enumerate(("/", "/sensor_1")):
            out = self.folder / f"out{sensor}.csv"
            self.run_command("convert", self.path, out, "--sensor", str(sensor))
            rows = np.loadtxt(out, np.int64, delimiter=",", skiprows=1)
            self.assertGreater(len(rows), 50)
            np.testing.assert_array_equal(self.events(self.path, group), rows.T)
            self.assertIn("are as recorded", self.run_command("verify", self.path, "--sensor", str(sensor)))

    def test_one_replay_of_either_sensor_gives_the_rig(self):
        for name in ("a.h5.json", "a.h5.sensor1.json"):
            again = self.folder / "again.h5"
            told = self.run_command("replay", self.folder / name, "--force", "-o", again, *self.control)
            self.assertIn("the events are those of the recording\n", told)
            self.assertNotIn("no description", told)
            for group in ("/", "/sensor_1"):
                np.testing.assert_array_equal(self.events(again, group), self.events(self.path, group))
            with h5py.File(again) as file:
                np.testing.assert_array_equal(file["/view_1/truth/depth/data"][0], self.truth(1, "depth"))

    def test_depth_goes_from_camera_to_camera(self):
        dsec = self.yaml("cam_to_cam.yaml")
        self.assertEqual(dsec["intrinsics"]["cam1"]["camera_matrix"], INTRINSICS)
        left, right = (matrix(dsec["intrinsics"][name]["camera_matrix"]) for name in ("camRect0", "camRect1"))
        depth = self.truth(0, "depth")[..., 0]
        v, u = np.indices(depth.shape)
        points = np.linalg.inv(left) @ np.stack([u, v, np.ones_like(u)]).reshape(3, -1) * depth.ravel()
        moved = (np.array(dsec["extrinsics"]["T_10"]) @ np.vstack([points, np.ones(points.shape[1])]))[:3]
        column, row = np.rint((right @ moved)[:2] / moved[2]).astype(int)
        seen = (column >= 0) & (column < 64) & (row >= 0) & (row < 48) & (depth.ravel() < 1e3)
        self.assertGreater(seen.sum(), 1500)
        error = np.abs(self.truth(1, "depth")[row[seen], column[seen], 0] / moved[2][seen] - 1)
        self.assertLess(np.median(error), 0.01)  # within half a pixel; 0.04 without the translation
        self.assertLess(np.mean(error > 0.03), 0.1)  # what the other camera does not see

    def test_transforms_are_those_between_the_poses(self):
        kalibr = self.yaml("kalibr.yaml")
        left, right = (pose(self.truth(sensor, "pose")) for sensor in (0, 1))
        between = np.linalg.inv(right) @ left
        np.testing.assert_allclose(kalibr["cam1"]["T_cn_cnm1"], between, atol=1e-9)
        np.testing.assert_allclose(kalibr["cam1"]["T_cam_imu"], between, atol=1e-9)  # camera 0 is in the body's axes
        np.testing.assert_allclose(kalibr["cam0"]["T_cam_imu"], np.eye(4), atol=1e-12)

    def test_files_are_yaml_of_numbers(self):
        self.assertEqual(self.yaml("camera_info.yaml")["camera_matrix"]["data"], matrix(INTRINSICS).ravel().tolist())
        self.assertEqual(self.yaml("cam1.camera_info.yaml")["camera_name"], "cam1")
        imu = self.yaml("imu.yaml")
        self.assertEqual((imu["rostopic"], imu["update_rate"]), ("/dvs/imu", 200))
        for noise in ("accelerometer_noise_density", "accelerometer_random_walk", "gyroscope_noise_density",
                      "gyroscope_random_walk"):
            self.assertTrue(0 < imu[noise] < 1e-5, noise)  # there is none, and Kalibr refuses 0


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
