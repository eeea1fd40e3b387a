"""Truth channels from a real saccaded, and from files. The reference is the client in C++, `saccade record`."""
import asyncio
import pathlib
import tempfile
import unittest

import numpy as np

import saccade
import saccade.aio
from saccaded import Server, record

SETTINGS = {"scene": "cornell-box", "motion": "right", "size": (32, 24), "rate_hz": 500, "duration_s": 0.06,
            "threshold": 0.2}
OPTIONS = ["--motion", "right", "--size", "32x24", "--rate", "500", "--duration", "0.06", "--threshold", "0.2",
           "--truth", "depth:5", "--truth", "pose"]
CHANNELS = [("depth", 5), "pose"]


class OneServer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = cls.enterClassContext(Server())
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))

    def setUp(self):
        self.client = self.enterContext(saccade.connect(self.server.address))

    def recorded(self, name):
        done = record(self.server, self.folder / name, "--force", *OPTIONS)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / name

    def expect(self, channels, name, samples):
        np.testing.assert_array_equal(channels[name].t, [sample.t for sample in samples])
        np.testing.assert_array_equal(channels[name].data, [sample.data for sample in samples])

    def test_samples_are_those_of_the_client_in_cpp(self):
        for codec in ("none", "zstd"):
            with self.client.open(**SETTINGS, truth=CHANNELS, codec=codec) as stream:
                items = list(stream.samples())
            truth = [item for item in items if isinstance(item, saccade.Truth)]
            depth, pose = ([sample for sample in truth if sample.channel == channel] for channel in (0, 1))
            self.assertEqual([sample.t for sample in depth], list(range(0, 60_001, 10_000)))
            self.assertEqual([sample.t for sample in pose], list(range(0, 60_001, 2_000)))
            self.assertEqual((depth[0].data.shape, depth[0].data.dtype), ((24, 32, 1), np.float32))
            self.assertEqual((depth[0].name, depth[0].exposure, pose[0].name), ("depth", None, "pose"))
            self.assertEqual({sample.view for sample in truth}, {0})
            self.assertFalse(depth[0].data.flags.writeable)
            for file in ("a.npz", "a.h5"):
                channels = saccade.read_truth(self.recorded(file))
                self.assertEqual(channels.keys(), {"depth", "pose"})
                self.expect(channels, "depth", depth)
                self.expect(channels, "pose", pose)

    def test_the_files_of_all_sensors_of_a_camera_have_its_truth(self):
        for kind in ("h5", "npz"):
            done = record(self.server, self.folder / f"two.{kind}", "--force", *OPTIONS, "--threshold", "0.4",
                          "--further-view", "0.1,0,0")
            self.assertEqual(done.returncode, 0, done.stderr)
            left, right = (saccade.read_truth(self.folder / f"two.{kind}", view=view) for view in (0, 1))
            self.assertEqual((left.keys(), right.keys()), ({"depth", "pose"}, {"depth", "pose"}))
            self.assertTrue((left["depth"].data != right["depth"].data).any())
        for sensor, truth in ((1, left), (3, right)):
            found = saccade.read_truth(self.folder / f"two-{sensor}.npz")
            self.assertEqual(found.keys(), {"depth", "pose"})
            np.testing.assert_array_equal(found["depth"].data, truth["depth"].data)

    def test_a_sample_tells_its_camera(self):
        with self.client.open(**SETTINGS, further_views=[(0.1, 0, 0)], truth=["depth", "imu"]) as stream:
            truth = [item for item in stream.samples() if isinstance(item, saccade.Truth)]
        self.assertEqual({(sample.name, sample.view, sample.channel) for sample in truth},
                         {("depth", 0, 0), ("depth", 1, 1), ("imu", None, 2)})

    def test_the_imu_is_set(self):
        imu = {"imu_rate_hz": 1000, "metres_per_unit": 0.1, "gravity": (0, 0, -9.81), "imu_noise": {"gyroscope_noise": 1e-2}}
        with self.client.open(**{**SETTINGS, "motion": "still"}, truth="imu", **imu) as stream:
            resolved = stream.resolved.truth[0].imu
            rows = np.array([item.data for item in stream.samples() if isinstance(item, saccade.Truth)])
        self.assertEqual((resolved.metres_per_unit, resolved.gravity.z, resolved.gyroscope_noise), (0.1, -9.81, 1e-2))
        self.assertEqual(len(rows), 60)  # of 60 ms
        np.testing.assert_allclose(np.linalg.norm(rows[:, :3], axis=1), 9.81, rtol=1e-9)
        expected = 1e-2 * 1000**0.5  # the standard deviation of one sample
        self.assertLess(abs(rows[:, 3:].std() / expected - 1), 0.3)

    def test_files_tell_what_the_server_says(self):
        depth = saccade.read_truth(self.recorded("b.h5"))["depth"]
        info = next(channel for channel in self.client.info().truth if channel.name == "depth")
        self.assertEqual((depth.planes, depth.unit, depth.description), (tuple(info.planes), info.unit, info.description))
        np.testing.assert_array_equal(depth.exposure, np.zeros((7, 2)))

    def test_numbers_of_ids_have_names(self):
        with self.client.open(**SETTINGS, truth=["ids"]) as stream:
            names = stream.id_names
            ids = next(item.data for item in stream.samples() if isinstance(item, saccade.Truth))
        pairs = {(names.objects[o], names.materials[m]) for o, m in ids.reshape(-1, 2)}
        self.assertLessEqual({("floor", "white"), ("left_wall", "red"), ("right_wall", "green")}, pairs)
        done = record(self.server, self.folder / "ids.csv", *OPTIONS, "--truth", "ids:9")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(saccade.read_id_names(self.folder / "ids.csv"), names)
        with self.client.open(**SETTINGS) as stream:
            self.assertEqual(stream.id_names, saccade.IdNames({}, {}))
        (self.folder / "bad.csv.json").write_text("{", encoding="utf-8")
        with self.assertRaisesRegex(saccade.FormatError, "bad.csv.json"):
            saccade.read_id_names(self.folder / "bad.csv")

    def test_iteration_gives_the_events_alone(self):
        with self.client.open(**SETTINGS) as stream:
            without = saccade.concatenate(list(stream))
        with self.client.open(**SETTINGS, truth=CHANNELS) as stream:
            beside = saccade.concatenate(list(stream))
        np.testing.assert_array_equal(beside.t, without.t)
        np.testing.assert_array_equal(beside.x, without.x)
        whole = saccade.read(self.recorded("c.h5"))
        np.testing.assert_array_equal(whole.t, without.t)

    def test_asyncio(self):
        async def receive():
            async with saccade.aio.connect(self.server.address) as client:
                async with await client.open(**SETTINGS, truth=["pose"]) as stream:
                    return [item async for item in stream.samples()]
        items = asyncio.run(receive())
        self.assertEqual(sum(isinstance(item, saccade.Truth) for item in items), 31)
        self.assertTrue(any(isinstance(item, saccade.Events) for item in items))

    def test_an_unknown_channel_is_refused(self):
        with self.assertRaisesRegex(saccade.InvalidArgument, "there are: depth"):
            self.client.open(**SETTINGS, truth=["dept"])


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_other_formats_and_content_are_refused(self):
        with self.assertRaisesRegex(saccade.FormatError, "not one of .raw, "):
            saccade.read_truth(self.folder / "a.bag")
        for missing in ("a.csv", "a.npz", "a.h5"):
            with self.assertRaisesRegex(FileNotFoundError, missing):
                saccade.read_truth(self.folder / missing)
        np.savez(self.folder / "a.npz", depth=np.zeros((3, 2, 2, 1)), depth_t=np.zeros(2))
        with self.assertRaisesRegex(saccade.FormatError, "depth has 3 samples, but 2 times"):
            saccade.read_truth(self.folder / "a.npz")
        np.savez(self.folder / "b.npz", t=np.zeros(2))
        self.assertEqual(saccade.read_truth(self.folder / "b.npz"), {})


if __name__ == "__main__":
    unittest.main()
