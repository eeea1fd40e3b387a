"""The message that settings make."""
import os
import pathlib
import tempfile
import unittest
import warnings

import numpy as np

from saccade.protocol.request import make_request
from saccade.protocol.sockets import reachable_endpoint, read_keys
from saccade.v1 import control_pb2 as c
from saccade.v1 import events_pb2, noise_pb2
from saccade.v1.truth_pb2 import Imu, Truth

NEEDED = {"scene": "room", "size": (6, 4), "rate_hz": 100, "motion": "right"}


class Request(unittest.TestCase):
    def test_what_is_unset_is_left_to_the_server(self):
        made = make_request(NEEDED)
        view, timing, path = c.View(width=6, height=4), c.Timing(frame_rate_hz=100), c.Trajectory(name="right")
        self.assertEqual(made, c.OpenStream(scene="room", view=view, timing=timing, trajectory=path, method=c.Method(),
                                            quality=c.Quality(), sensors=[c.Sensor()]))

    def test_without_a_rate_the_server_chooses_it(self):
        made = make_request({"scene": "room", "size": (6, 4), "motion": "right", "max_rate_hz": 2000}).timing
        self.assertEqual(made, c.Timing(max_rate_hz=2000))
        with self.assertRaisesRegex(TypeError, "'rate_hz' is missing"):
            make_request({"pushed": True, "size": (6, 4)})

    def test_every_setting_has_its_field(self):
        made = make_request({**NEEDED, "motion": "shake:-3px", "turn_s": 0, "motion_seed": 9,
                             "start": (1, 2, 3, 0, 0.5, 0, 1), "duration_s": 2,
                             "interval_px": 0.5, "max_rate_hz": 2000, "finest_px": 0.1,
                             "speed": 0.5, "fov_x_deg": 40, "animation": "Run", "clock": "paced", "delivery": "live", "codec": "zstd",
                             "seed": 5, "threshold": [0.1, 0.2], "threshold_off": 0.3, "bias": 1e-4,
                             "refractory_s": 1e-3, "cutoff_hz": 2, "model": "probabilistic",
                             "start_level": "zero", "reconstruction": "direct",
                             "max_events_per_pixel_frame": 4, "max_events_per_frame": 7, "preset": "davis346",
                             "labels": True, "object_ids": True, "max_artefact_odds": 0.3,
                             "noise": {"leak_hz": 0.5}, "method": "svgf", "spp": 4,
                             "params": {"alpha": 0.5}, "bounces": 1, "jitter": True, "monochrome": True,
                             "bake_error": 0.1, "disable": ["masks"], "budget_ms": 5, "max_false_rate": 0.25,
                             "max_event_change": 0.5})
        sensor = dict(threshold_off=0.3, bias=1e-4, refractory_s=1e-3, cutoff_hz=2, model=c.EVENT_MODEL_PROBABILISTIC,
                      start_level=c.START_LEVEL_ZERO, reconstruction=c.RECONSTRUCTION_DIRECT, max_events_per_pixel_frame=4, max_events_per_frame=7,
                      labels=True, object_ids=True, max_artefact_odds=0.3,
                      preset="davis346", noise=noise_pb2.Noise(leak_hz=0.5))
        self.assertEqual(made, c.OpenStream(
            scene="room", animation="Run", view=c.View(width=6, height=4, fov_x_deg=40),
            trajectory=c.Trajectory(motion=c.Motion(
                kind=c.MOTION_KIND_SHAKE, px_per_frame=-3, turn_s=0, seed=9, start=c.RigidTransform(
                    position=c.Vector3(x=1, y=2, z=3), rotation=c.Quaternion(y=0.5, w=1)))),
            timing=c.Timing(frame_rate_hz=100, duration_s=2, clock=c.CLOCK_PACED, speed=0.5, interval_px=0.5,
                            max_rate_hz=2000, refinement=c.Refinement(finest_px=0.1)),
            method=c.Method(name="svgf", spp=4, params={"alpha": 0.5}),
            quality=c.Quality(bounces=1, jitter=True, monochrome=True, bake_error=0.1, disabled_features=["masks"],
                              budget_ms=5, max_false_rate=0.25, max_event_change=0.5),
            sensors=[c.Sensor(threshold=0.1, **sensor), c.Sensor(threshold=0.2, **sensor)],
            delivery=c.DELIVERY_LIVE, codec=events_pb2.CODEC_ZSTD, seed=5))

    def test_objects_move_as_the_scene_says_or_stand(self):
        own, still = make_request({**NEEDED, "objects": {"bunny": "own", "lamp": "still"}}).objects
        self.assertEqual((own.path.WhichOneof("path"), still.path.WhichOneof("path")), ("own", "still"))

    def test_objects_move_by_a_motion_by_poses_or_by_a_file(self):
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
            file.write("0 1 2 3 0 0 0 1\n")
            file.flush()
            made = make_request({**NEEDED, "objects": {"bunny": "spin:-90", "lamp": [[0.5, 1, 2, 3, 0, 0, 0, 1]],
                                                       "box": pathlib.Path(file.name), "cup": file.name}}).objects
        key = c.Keyframe(time_s=0.5, position=c.Vector3(x=1, y=2, z=3), rotation=c.Quaternion(w=1))
        text = c.ObjectPath(csv="0 1 2 3 0 0 0 1\n")
        self.assertEqual([*made], [
            c.ObjectMotion(name="bunny", path=c.ObjectPath(motion=c.ObjectSpeed(kind=c.OBJECT_MOTION_KIND_SPIN,
                                                                                speed=-90))),
            c.ObjectMotion(name="lamp", path=c.ObjectPath(keyframes=c.Keyframes(keys=[key]))),
            c.ObjectMotion(name="box", path=text), c.ObjectMotion(name="cup", path=text)])

    def test_one_truth_channel_needs_no_list(self):
        self.assertEqual([truth.name for truth in make_request({**NEEDED, "truth": "depth"}).truth], ["depth"])
        made = make_request({**NEEDED, "truth": ["pose", ("depth", 5)]}).truth
        self.assertEqual([(truth.name, truth.every) for truth in made], [("pose", 1), ("depth", 5)])
        made = make_request({**NEEDED, "truth": ("depth", 5)}).truth
        self.assertEqual([(truth.name, truth.every) for truth in made], [("depth", 5)])

    def test_every_camera_has_the_truth_and_the_body_has_the_imu(self):
        made = make_request({**NEEDED, "further_views": [(1, 0, 0)], "truth": [("depth", 3), "imu"], "imu_rate_hz": 100,
                             "metres_per_unit": 0.1, "gravity": (0, 0, -9.81),
                             "imu_noise": {"gyroscope_noise": 1e-3, "accelerometer_walk": 2e-3}}).truth
        imu = Imu(rate_hz=100, metres_per_unit=0.1, gravity=c.Vector3(z=-9.81), gyroscope_noise=1e-3,
                  accelerometer_walk=2e-3)
        self.assertEqual([*made], [Truth(name="depth", every=3), Truth(name="depth", every=3, view=1),
                                   Truth(name="imu", every=1, imu=imu)])
        for wrong in ({"gravity": (0, 0, 0)}, {"imu_noise": {"gyroscope_noise": 1}}):
            with self.assertRaisesRegex(TypeError, f"{next(iter(wrong))} goes with the truth channel 'imu'"):
                make_request({**NEEDED, "truth": "pose", **wrong})

    def test_the_place_of_the_camera_on_its_body(self):
        turned = np.array([[0, 0, 1, 0.1], [1, 0, 0, 0.2], [0, 1, 0, 0.3], [0, 0, 0, 1]])
        for place in (turned, turned.tolist(), (0.1, 0.2, 0.3, 0.5, 0.5, 0.5, 0.5)):
            view = make_request({**NEEDED, "T_body_camera": place}).view.body_camera
            self.assertEqual(view.position, c.Vector3(x=0.1, y=0.2, z=0.3))
            np.testing.assert_allclose([view.rotation.x, view.rotation.y, view.rotation.z, view.rotation.w], 0.5)
        second = make_request({**NEEDED, "T_body_camera": turned, "further_views": [(1, 0, 0)]}).further_views[0]
        self.assertEqual(second.body_camera.position, c.Vector3(x=0.1, y=1.2, z=0.3))  # its x is the body's y
        self.assertEqual(make_request({**NEEDED, "T_body_camera": (1, 2, 3)}).view.body_camera,
                         c.RigidTransform(position=c.Vector3(x=1, y=2, z=3)))

    def test_where_0_means_unset_0_is_refused(self):
        for name in ("spp", "speed", "max_events_per_pixel_frame", "max_events_per_frame"):
            with self.assertRaisesRegex(ValueError, f"{name}: 0 "):
                make_request({**NEEDED, name: 0})
        with self.assertRaisesRegex(ValueError, "truth: 0 is not a whole number from 1"):
            make_request({**NEEDED, "truth": [("depth", 0)]})
        self.assertEqual(make_request({**NEEDED, "seed": 0, "bounces": 0, "duration_s": 0}).quality.bounces, 0)

    def test_a_size_has_two_whole_numbers(self):
        for size in (60, (60,), (60.5, 45), "60x45", None, (1, 2, 3)):
            with self.subTest(size), self.assertRaisesRegex(ValueError, r"^size: .* is not \(width, height\)"):
                make_request({**NEEDED, "size": size})
        self.assertEqual(make_request({**NEEDED, "size": np.array([6, 4])}).view, c.View(width=6, height=4))

    def test_cameras(self):
        made = make_request({**NEEDED, "intrinsics": (5, 6, 2, 1), "distortion": ("equidistant", [1, 2, 3, 4])}).view
        lens = c.Distortion(model=c.DISTORTION_MODEL_EQUIDISTANT, coefficients=[1, 2, 3, 4])
        self.assertEqual(made, c.View(width=6, height=4, intrinsics=c.Intrinsics(fx=5, fy=6, cx=2, cy=1),
                                      distortion=lens))
        with self.assertRaisesRegex(ValueError, "distortion: .*'thin_prism'.* is not .'radtan'.*'equidistant'"):
            make_request({**NEEDED, "distortion": ("thin_prism", [0] * 4)})

    def test_further_views_have_sensors_of_their_own(self):
        made = make_request({**NEEDED, "fov_x_deg": 40, "threshold": [0.1, 0.2],
                             "further_views": [(1, 2, 3), (0, 0, 0, 0, 1, 0, 1)]})
        self.assertEqual(made.further_views[0], c.View(width=6, height=4, fov_x_deg=40, body_camera=c.RigidTransform(
            position=c.Vector3(x=1, y=2, z=3))))
        turned = made.further_views[1].body_camera.rotation
        np.testing.assert_allclose([turned.x, turned.y, turned.z, turned.w], [0, 0.5**0.5, 0, 0.5**0.5], atol=1e-15)
        self.assertEqual([(s.view, s.threshold) for s in made.sensors],
                         [(view, threshold) for view in range(3) for threshold in (0.1, 0.2)])
        with self.assertRaisesRegex(ValueError, "further_views"):
            make_request({**NEEDED, "further_views": [(1, 2)]})

    def test_trajectories(self):
        def path(trajectory):
            needed = {name: value for name, value in NEEDED.items() if name != "motion"}
            return make_request({**needed, "trajectory": trajectory}).trajectory
        self.assertEqual(path("orbit"), c.Trajectory(name="orbit"))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "path.csv"
            file.write_text("0 0 0 0 0 0 0 1\n")
            self.assertEqual(path(file).csv, "0 0 0 0 0 0 0 1\n")
            self.assertEqual(path(str(file)), path(file))
        key = path(np.arange(16).reshape(2, 8)).keyframes.keys[1]
        self.assertEqual(key, c.Keyframe(time_s=8, position=c.Vector3(x=9, y=10, z=11),
                                         rotation=c.Quaternion(x=12, y=13, z=14, w=15)))
        self.assertEqual(make_request({**NEEDED, "motion": "pan:2"}).trajectory.motion.speed, 2)
        roam = make_request({**NEEDED, "motion": "roam:2px", "clearance": 0.25}).trajectory.motion
        self.assertEqual(roam, c.Motion(kind=c.MOTION_KIND_ROAM, px_per_frame=2, clearance=0.25))

    def test_faults_are_named(self):
        faults = [(TypeError, "did you mean 'rate_hz'", {"rate": 5}), (TypeError, "either", {"trajectory": "a"}),
                  (TypeError, "turn_s goes with", {"turn_s": 1}),
                  (TypeError, "start goes with", {"start": (1, 2, 3)}),
                  *[(TypeError, "clearance goes with a motion roam", {"motion": motion, "clearance": 1})
                    for motion in ("right", "pan:2")],
                  *[(ValueError, "^start: .* is not x y z", {"motion": "pan:2", "start": start})
                    for start in ((1, 2), 5, "123456", "abc", ())],
                  (ValueError, "pan, tilt", {"motion": "jump:5"}),
                  (ValueError, "KIND:SPEED", {"motion": "pan:fast"}),
                  (ValueError, "mismatch, photoreceptor_hz", {"noise": {"leak": 1}}),
                  (ValueError, "lossless, live", {"delivery": "slow"}),
                  (ValueError, "2 values for 3", {"threshold": [1, 2], "bias": [1, 2, 3]})]
        for kind, text, wrong in faults:
            with self.subTest(text), self.assertRaisesRegex(kind, text):
                make_request({**NEEDED, **wrong})
        with self.assertRaisesRegex(TypeError, "'size' is missing"):
            make_request({"scene": "room", "rate_hz": 5})
        with self.assertRaisesRegex(ValueError, r"\(n, 8\)"):
            make_request({"scene": "room", "size": (1, 1), "rate_hz": 5, "trajectory": np.zeros((3, 7))})


class Sockets(unittest.TestCase):
    def test_a_wildcard_is_the_host_of_the_control_socket(self):
        self.assertEqual(reachable_endpoint("tcp://0.0.0.0:5771", "tcp://render7:5770"), "tcp://render7:5771")
        self.assertEqual(reachable_endpoint("tcp://10.0.0.1:5771", "tcp://render7:5770"), "tcp://10.0.0.1:5771")
        self.assertEqual(reachable_endpoint("ipc://data", "tcp://render7:5770"), "ipc://data")

    def test_keys_come_in_pairs_of_40_characters(self):
        key = b"k" * 40
        self.assertIsNone(read_keys(None, None))
        self.assertEqual(read_keys(key, key + b"\n"), (key, key))
        for pair in ((key, None), (None, key), (key, b"short")):
            with self.assertRaises(ValueError):
                read_keys(*pair)

    def test_a_secret_key_that_all_may_read_is_warned_about(self):
        with tempfile.NamedTemporaryFile() as file, tempfile.NamedTemporaryFile() as public:
            for each in (file, public):
                each.write(b"k" * 40)
                each.flush()
            os.chmod(public.name, 0o644)
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                read_keys(file.name, public.name)
            os.chmod(file.name, 0o604)
            with self.assertWarnsRegex(UserWarning, file.name):
                read_keys(file.name, public.name)

    def test_a_key_of_the_wrong_kind_is_refused(self):
        with self.assertRaisesRegex(ValueError, "alice.pub is by its name a public key"):
            read_keys("alice.pub", "server.pub")
        with self.assertRaisesRegex(ValueError, "server.key is by its name a secret key"):
            read_keys(b"k" * 40, "server.key")


if __name__ == "__main__":
    unittest.main()
