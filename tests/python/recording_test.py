"""Recordings with several sensors and cameras, written by `saccade record` and by Stream.save()."""
import importlib.util
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import saccade
from saccaded import Server, record

OPTIONS = ["--motion", "right", "--size", "32x24", "--rate", "500", "--duration", "0.06", "--threshold", "0.2,0.4",
           "--further-view", "0.1,0,0", "--truth", "depth:5,pose,imu", "--distortion", "radtan:-0.1,0.01,0,0"]
RIG = {"scene": "cornell-box", "motion": "right", "size": (32, 24), "rate_hz": 500, "threshold": [0.2, 0.4],
       "further_views": [(0.1, 0, 0)], "truth": [("depth", 5), "pose", "imu"]}
HAS_H5 = importlib.util.find_spec("h5py") is not None
FORMATS = ("npz", "h5") if HAS_H5 else ("npz",)


def rows(events):
    return np.stack([events.t, events.x, events.y, events.p])


def command(*arguments):
    done = subprocess.run([os.environ["SACCADE"], *map(str, arguments)], capture_output=True, text=True, check=False,
                          timeout=120)
    assert done.returncode == 0, done.stderr
    return done.stdout


class Rig(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = cls.enterClassContext(Server())
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        done = record(cls.server, cls.folder / "a.npz", *OPTIONS)
        assert done.returncode == 0, done.stderr
        cls.recorded = saccade.Recording(cls.folder / "a-0.npz")

    def expect_equal(self, recording, expected):
        self.assertEqual((recording.sensors, [recording.view_of(i) for i in range(4)]), ([0, 1, 2, 3], [0, 0, 1, 1]))
        for sensor in range(4):
            one, two = recording.events[sensor], expected.events[sensor]
            np.testing.assert_array_equal(rows(one), rows(two))
            self.assertEqual((one.sensor, one.t0, one.size), (sensor, 0, (32, 24)))
        for view in (0, 1):
            self.assertEqual(recording.truth[view].keys(), expected.truth[view].keys())
            for name, channel in expected.truth[view].items():
                last = channel.t <= recording.events[0].t1
                np.testing.assert_array_equal(recording.truth[view][name].t, channel.t[last])
                np.testing.assert_array_equal(recording.truth[view][name].data, channel.data[last])

    def test_any_file_of_a_recording_finds_all_of_it(self):
        for name in ("a.npz", "a-1.npz", "a-3.npz"):
            self.expect_equal(saccade.Recording(self.folder / name), self.recorded)
        self.assertEqual(saccade.read(self.folder / "a-3.npz").sensor, 3)
        np.testing.assert_array_equal(rows(saccade.read(self.folder / "a-3.npz", sensor=1)),
                                      rows(self.recorded.events[1]))
        depth = saccade.read_truth(self.folder / "a-1.npz", view=1)["depth"].data
        np.testing.assert_array_equal(depth, self.recorded.truth[1]["depth"].data)
        self.assertEqual((self.recorded.truth[0].keys(), self.recorded.truth[1].keys()),
                         ({"depth", "pose", "imu"}, {"depth", "pose"}))

    def test_windows_begin_where_the_recording_began(self):
        windows = [list(self.recorded.windows(duration_us=20_000, sensor=sensor)) for sensor in range(4)]
        for sensor, of_one in enumerate(windows):
            self.assertEqual([(w.t0, w.t1, w.sensor) for w in of_one],
                             [(t, t + 20_000, sensor) for t in (0, 20_000, 40_000)])
            np.testing.assert_array_equal(rows(saccade.concatenate(of_one)), rows(self.recorded.events[sensor]))
        self.assertGreater(self.recorded.events[0].t[0], 0)
        self.assertEqual([w.sensor for w in self.recorded.windows(count=10**6)], [0])

    def test_calibrations(self):
        focal = self.recorded.cameras[0].intrinsics[0]
        for view, camera in enumerate(self.recorded.cameras):
            np.testing.assert_allclose(camera.intrinsics, (focal, focal, 15.5, 11.5))
            self.assertEqual((camera.size, camera.distortion), ((32, 24), ("radtan", (-0.1, 0.01, 0, 0))))
            self.assertIs(type(self.recorded.events[2 * view].camera), saccade.Camera)
        np.testing.assert_array_equal(self.recorded.events[3].camera.T_body_camera[:3, 3], (0.1, 0, 0))
        fov = self.recorded.request.view.fov_x_deg
        np.testing.assert_allclose(focal, 16 / np.tan(np.radians(fov) / 2))

    @unittest.skipUnless(importlib.util.find_spec("yaml"), "yaml is not installed")
    def test_calibrations_that_the_command_writes_are_read(self):
        done = record(self.server, self.folder / "c.npz", *OPTIONS, "--write-calibration")
        self.assertEqual(done.returncode, 0, done.stderr)
        for view, camera in enumerate(saccade.Recording(self.folder / "c.npz").cameras):
            ros = self.folder / ("c.npz.camera_info.yaml" if view == 0 else "c.npz.cam1.camera_info.yaml")
            for found in (saccade.read_calibration(self.folder / "c.npz.kalibr.yaml", camera=view),
                          saccade.read_calibration(ros)):
                self.assertEqual((found.size, found.distortion), (camera.size, camera.distortion))
                np.testing.assert_allclose(found.intrinsics, camera.intrinsics)
            kalibr = saccade.read_calibration(self.folder / "c.npz.kalibr.yaml", camera=view)
            np.testing.assert_allclose(kalibr.T_body_camera[:3, 3], (0.1 * view, 0, 0))

    def test_poses_as_tum(self):
        self.recorded.save_tum(self.folder / "gt.txt", view=1)
        lines = [line.split() for line in (self.folder / "gt.txt").read_text().splitlines()]
        self.assertEqual([line[0] for line in lines[:3]], ["0.000000", "0.002000", "0.004000"])
        found, pose = np.array(lines, float), self.recorded.truth[1]["pose"]
        np.testing.assert_array_equal(found[:, 1:], pose.data)
        np.testing.assert_array_equal(found, self.recorded.poses(1))
        again = record(self.server, self.folder / "again.npz", "--force", "--trajectory", self.folder / "gt.txt",
                       *OPTIONS[2:8], "--threshold", "0.4")
        self.assertEqual(again.returncode, 0, again.stderr)

    def test_a_lockstep_run_of_a_rig_becomes_a_recording(self):
        with saccade.connect(self.server.address) as client:
            with client.open(**RIG, distortion=("radtan", (-0.1, 0.01, 0, 0)), clock="lockstep") as stream:
                items = []
                for pose in self.recorded.poses()[1:21]:
                    items += stream.step(pose[1:]) + stream.truth
                for kind in FORMATS:
                    stream.save(self.folder / f"loop.{kind}", items)
                stream.save(self.folder / "third.npz", [item for item in items if getattr(item, "sensor", 2) == 2
                                                        and getattr(item, "view", 1) == 1])
                with self.assertRaisesRegex(ValueError, "sensors 0, 1: save those of one, or of all 4"):
                    stream.save(self.folder / "b.npz", [i for i in items if getattr(i, "sensor", 0) < 2])
                with self.assertRaisesRegex(ValueError, "'depth' goes with the events of sensor 0, not with 3"):
                    stream.save(self.folder / "b.npz", [i for i in items if getattr(i, "sensor", 3) == 3])
        for kind in FORMATS:
            loop = saccade.Recording(self.folder / f"loop.{kind}")
            self.assertGreater(min(map(len, loop.events.values())), 50)
            for sensor, events in loop.events.items():
                self.assertEqual(rows(events).tolist(), rows(saccade.concatenate(
                    [i for i in items if isinstance(i, saccade.Events) and i.sensor == sensor])).tolist())
                self.assertEqual((events.t0, events.t1), (0, 40_000))
            np.testing.assert_allclose(loop.poses(), self.recorded.poses()[:21], atol=1e-9)
            np.testing.assert_allclose(loop.truth[1]["depth"].data, self.recorded.truth[1]["depth"].data[:5], rtol=1e-5)
        first, third = self.folder / "loop-0.npz", self.folder / "third.npz"
        self.assertIn("events are as recorded", command("verify", first))
        told = command("replay", f"{first}.json", "-o", self.folder / "again.npz", "--control", self.server.address)
        self.assertIn("the events are those of the recording", told)
        self.assertEqual((saccade.Recording(third).truth[1].keys(), saccade.Recording(third).truth[0]),
                         ({"depth", "pose"}, {}))
        self.assertEqual(saccade.read(third).sensor, 2)

    def test_rows_of_the_folder_of_truth(self):
        done = record(self.server, self.folder / "f.csv", *OPTIONS)
        self.assertEqual(done.returncode, 0, done.stderr)
        for sensor in range(4):
            self.assertTrue((self.folder / f"f-{sensor}.csv").exists())
        recording = saccade.Recording(self.folder / "f-3.csv")
        np.testing.assert_array_equal(recording.poses(1), self.recorded.poses(1))
        self.assertEqual(recording.truth[0]["imu"].planes, ("ax", "ay", "az", "gx", "gy", "gz"))

    def test_what_is_not_there_is_told(self):
        with self.assertRaisesRegex(saccade.FormatError, "no sensor 4; there are: 0, 1, 2, 3"):
            saccade.read(self.folder / "a-0.npz", sensor=4)
        with self.assertRaisesRegex(saccade.FormatError, "no view 2; there are: 0, 1"):
            saccade.read_truth(self.folder / "a-0.npz", view=2)
        with self.assertRaises(FileNotFoundError):
            saccade.Recording(self.folder / "none.npz").events
        alone = self.folder / "alone.csv"
        alone.write_text("t,x,y,p\n5,1,1,1\n")
        recording = saccade.Recording(alone)
        self.assertEqual((recording.sensors, recording.cameras, recording.request), ([0], [None], None))
        self.assertEqual((len(recording.events[0]), recording.truth), (1, {0: {}}))
        with self.assertRaisesRegex(saccade.FormatError, "view 0 has no truth channel 'pose'"):
            recording.poses()

    @unittest.skipUnless(HAS_H5, "h5py is not installed")
    def test_an_h5_of_a_rig_has_the_layout_of_dsec_for_each_sensor(self):
        import h5py
        with saccade.connect(self.server.address) as client:
            with client.open(**RIG, duration_s=0.02, labels=True) as stream:
                items = list(stream.samples())
                stream.save(self.folder / "rig.h5", items)
                stream.save(self.folder / "one.h5", [i for i in items if isinstance(i, saccade.Events) and i.sensor == 3])
                stream.save(self.folder / "right.h5", [i for i in items if getattr(i, "sensor", 2) == 2
                                                       and getattr(i, "view", 1) == 1])
        with h5py.File(self.folder / "rig.h5") as file:
            self.assertEqual(file.keys(), {"events", "ms_to_idx", "t_offset", "truth", "sensor_1", "sensor_2", "sensor_3",
                                           "view_1"})
            self.assertEqual((file["truth"].keys(), file["view_1/truth"].keys()),
                             ({"depth", "pose", "imu"}, {"depth", "pose"}))
            for sensor in range(4):
                group = file[f"sensor_{sensor}"] if sensor else file
                t, index = group["events/t"][:], group["ms_to_idx"][:]
                self.assertEqual((group.attrs["width"], group["events/height"][()], group["t_offset"][()]), (32, 24, 0))
                self.assertEqual(index.tolist(), [int((t < 1000 * m).sum()) for m in range(22)])
                self.assertEqual([group[f"events/{name}"].dtype for name in ("x", "y", "p", "t", "source")],
                                 ["u2", "u2", "u1", "u4", "u1"])
        described = [json.loads((self.folder / f"rig.h5{name}.json").read_text())
                     for name in ("", ".sensor1", ".sensor2", ".sensor3")]
        self.assertEqual([about.get("sensor", 0) for about in described], [0, 1, 2, 3])
        self.assertEqual([[one["name"] for one in about.get("truth", [])] for about in described],
                         [["depth", "pose", "imu"], [], ["depth", "pose"], []])
        np.testing.assert_array_equal(rows(saccade.read(self.folder / "rig.h5", sensor=3)),
                                      rows(saccade.read(self.folder / "one.h5")))
        right = saccade.Recording(self.folder / "right.h5")
        self.assertEqual((right.sensors, right.truth[0], right.truth[1].keys()), ([2], {}, {"depth", "pose"}))
        for name in ("", ".sensor1", ".sensor2", ".sensor3"):  # groups tell, too
            (self.folder / f"rig.h5{name}.json").unlink()
        self.assertGreater(len(saccade.read(self.folder / "rig.h5", sensor=3)), 10)
        with self.assertRaisesRegex(saccade.FormatError, "no group 'sensor_4'"):
            saccade.read(self.folder / "rig.h5", sensor=4)
        self.assertIn("events are as recorded", command("verify", self.folder / "one.h5"))


if __name__ == "__main__":
    unittest.main()
