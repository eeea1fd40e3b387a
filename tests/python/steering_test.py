"""Streams that the client in Python steers and changes, with a real saccaded."""
import asyncio
import json
import logging
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import saccade
import saccade.aio
from saccade import rigid
from fake_server import FakeServer, packet
from saccaded import Server
from saccade.v1 import events_pb2

SETTINGS = {"scene": "cornell-box", "motion": "still", "size": (48, 32), "rate_hz": 200, "threshold": 0.1}
STEPS = 10


def pose(step):
    """To the right of the scene's camera, which looks along +z."""
    return (2.78 - 0.02 * step, 2.73, -7.5, 0, 0, 1, 0)


def rows(events):
    return np.stack([events.t, events.x, events.y, events.p])


class Steering(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = cls.enterClassContext(Server())

    def setUp(self):
        self.client = self.enterContext(saccade.connect(self.server.address))

    def steps(self, **settings):
        """The events of STEPS steps, and the request that repeats them."""
        with self.client.open(**{**SETTINGS, "clock": "lockstep", **settings}) as stream:
            events = [stream.step(pose(i + 1)) for i in range(STEPS)]
            return events, stream.describe()

    def replayed(self, request):
        with self.client.open_request(request) as stream:
            return list(stream)

    def test_objects_go_where_they_are_told_and_events_tell_them(self):
        settings = {**SETTINGS, "clock": "lockstep", "objects": {"tall_block": "still"}, "object_ids": True,
                    "truth": "object_poses"}
        with self.client.open(**settings) as stream:
            events, places = [], []
            for i in range(STEPS):
                events += stream.step(objects={"tall_block": (3.7 - 0.03 * i, 1.65, 3.5, 0, 0, 0, 1)})
                places.append(stream.truth[-1].data[1])
            request, names = stream.describe(), stream.id_names.objects
        np.testing.assert_allclose(places, [3.7 - 0.03 * i for i in range(STEPS)])
        seen = saccade.concatenate(events)
        self.assertIn("tall_block", {names[number] for number in set(seen.object.tolist()) - {0}})
        again = saccade.concatenate(self.replayed(request))
        np.testing.assert_array_equal(rows(again), rows(seen))
        np.testing.assert_array_equal(again.object, seen.object)
        with tempfile.TemporaryDirectory() as folder:
            seen.save(pathlib.Path(folder) / "a.npz")
            read = saccade.read(pathlib.Path(folder) / "a.npz")
            np.testing.assert_array_equal(read.object, seen.object)

    def test_a_step_needs_something_to_steer(self):
        with self.client.open(**SETTINGS, clock="lockstep") as stream:
            with self.assertRaisesRegex(ValueError, "poses of objects"):
                stream.step()
            with self.assertRaisesRegex(saccade.NotFound, "no object 'tall_block'"):
                stream.step(objects={"tall_block": (0, 0, 0, 0, 0, 0, 1)})

    def test_a_step_gives_the_events_of_its_frame(self):
        events, request = self.steps(threshold=[0.1, 0.2])
        self.assertEqual([[(one.sensor, one.t0, one.t1) for one in step] for step in events],
                         [[(s, 5000 * i, 5000 * (i + 1)) for s in (0, 1)] for i in range(STEPS)])
        self.assertGreater(sum(len(step[0]) for step in events), sum(len(step[1]) for step in events))
        parts = self.replayed(request)
        for sensor in (0, 1):
            again = saccade.concatenate([part for part in parts if part.sensor == sensor])
            np.testing.assert_array_equal(rows(again), rows(saccade.concatenate([step[sensor] for step in events])))

    def test_a_step_gives_the_truth_of_its_frame(self):
        truth = ["pose", ("depth", 3)]
        with self.client.open(**SETTINGS, clock="lockstep", truth=truth) as stream:
            for i in range(1, STEPS + 1):
                stream.step(pose(i))
                poses = [one for one in stream.truth if one.name == "pose"]
                np.testing.assert_allclose(poses[-1].data, pose(i), atol=1e-6)
                self.assertEqual([one.t for one in poses], [0, 5000] if i == 1 else [5000 * i])
                depths = [one.t for one in stream.truth if one.name == "depth"]
                self.assertEqual(depths, [0] if i == 1 else [5000 * i] if i % 3 == 0 else [])

    def command(self, *arguments):
        done = subprocess.run([os.environ["SACCADE"], *arguments], capture_output=True, text=True, check=False,
                              timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_a_saved_stream_is_rendered_again(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        with self.client.open(**{**SETTINGS, "threshold": [0.1, 0.2]}, clock="lockstep", labels=True) as stream:
            steps = [stream.step(pose(i + 1))[1] for i in range(STEPS)]
            stream.change_sensor(1, threshold=0.15, noise={"shot_hz": 50})
            steps += [stream.step(pose(STEPS - i))[1] for i in range(STEPS)]
            first, whole = saccade.concatenate(steps[:STEPS + 5]), saccade.concatenate(steps)
            for path, events in (("first.npz", first), ("whole.npz", whole)):
                stream.save(folder / path, events)
            for path, text in (("a.raw", "does not end with .npz or .h5"), ("a.bag", "saccade replay FILE.json -o a.bag"),
                               ("a.mcap", "saccade replay FILE.json -o a.mcap")):
                with self.assertRaisesRegex(ValueError, text):
                    stream.save(folder / path, whole)
            for wrong, kind, text in (([], ValueError, "no Events"), ([1], TypeError, "not int"),
                                      (stream.truth, ValueError, "no Events")):
                with self.assertRaisesRegex(kind, text):
                    stream.save(folder / "a.npz", wrong)
        for path, events in (("first.npz", first), ("whole.npz", whole)):
            self.assertGreater(len(events), 500)
            self.assertIn(f"all {len(events)} events are as recorded", self.command("verify", folder / path))
            again = folder / ("again_" + path)
            told = self.command("replay", folder / f"{path}.json", "-o", again, "--control", self.server.address)
            self.assertIn("the events are those of the recording", told)
            for one in (saccade.read(folder / path), saccade.read(again)):
                np.testing.assert_array_equal(rows(one), rows(events))
                np.testing.assert_array_equal(one.source, events.source)
                np.testing.assert_array_equal(one.artefact, events.artefact)

    def test_velocities(self):
        with self.client.open(**SETTINGS, clock="lockstep") as stream:
            stream.step(pose(0))
            self.assertEqual(len(stream.step(velocity=[0] * 6)[0]), 0)
            self.assertGreater(len(stream.step(velocity=[4, 0, 0, 0, 0, 0])[0]), 0)
            keys = stream.describe().trajectory.keyframes.keys
            self.assertAlmostEqual(keys[3].position.x, 2.78 - 4 / 200, places=12)
            for wrong in ({}, {"pose": pose(0), "velocity": [0] * 6}, {"pose": [1, 2]}):
                with self.subTest(**wrong), self.assertRaises(ValueError):
                    stream.steer(**wrong)

    def test_signs_of_turns_and_where_a_stream_begins(self):
        right, down, forward = range(3)
        for turn, axis, towards, sign in (((0.5, 0, 0), forward, down, -1),  # up
                                          ((0, 0.5, 0), forward, right, 1),
                                          ((0, 0, 0.5), right, down, 1)):  # clockwise
            with self.client.open(**SETTINGS, clock="lockstep", truth="pose") as stream:
                stream.step(velocity=[0, 0, 0, *turn])
                before, after = (rigid.from_numbers(sample.data)[:3, :3] for sample in stream.truth)
                np.testing.assert_allclose(stream.truth[0].data[:3], pose(0)[:3], atol=1e-6)
            angle = 0.5 / SETTINGS["rate_hz"]
            self.assertAlmostEqual((before.T @ after)[towards, axis], sign * np.sin(angle), 9)

    def test_a_stream_that_runs_by_itself_is_steered(self):
        with self.client.open(**SETTINGS, steerable=True, duration_s=1) as stream:
            at = stream.steer(velocity=[1, 0, 0, 0, 0, 0])
            events = saccade.concatenate(list(stream))
            request = stream.describe()
        np.testing.assert_array_equal(events.t[events.t < at - 5000], [])
        self.assertGreater(len(events), 100)
        np.testing.assert_array_equal(rows(saccade.concatenate(self.replayed(request))), rows(events))

    def test_a_sensor_changes(self):
        changes = {"threshold": 0.3, "threshold_off": 0.3, "time_s": 0.022}
        with self.client.open(**SETTINGS, clock="lockstep") as stream:
            stream.step(pose(0))
            self.assertEqual(stream.change_sensor(**changes), 25_000)
            counts = [len(stream.step(pose(i + 1))[0]) for i in range(STEPS)]
            request = stream.describe()
        with self.client.open(**SETTINGS, clock="lockstep") as stream:
            plain = [len(stream.step(pose(i))[0]) for i in range(STEPS + 1)][1:]
        self.assertEqual(counts[:4], plain[:4])
        self.assertLess(sum(counts[4:]), sum(plain[4:]) / 2)
        self.assertEqual([(one.time_s, one.threshold) for one in request.sensors[0].changes], [(0.022, 0.3)])
        self.assertEqual(sum(map(len, self.replayed(request))), sum(counts))

    def test_the_noise_of_a_sensor_changes(self):
        with self.client.open(**SETTINGS, clock="lockstep", labels=True) as stream:
            before = stream.step(pose(0))[0]
            stream.change_sensor(noise={"shot_hz": 200})
            after = stream.step(pose(0))[0]
            with self.assertRaises(saccade.InvalidArgument) as caught:
                stream.change_sensor(noise={"mismatch": 0.1})
            with self.assertRaisesRegex(ValueError, "snow"):
                stream.change_sensor(noise={"snow": 1})
        self.assertEqual(int(before.source.sum()), 0)
        self.assertGreater(int(after.source.sum()), 50)
        self.assertEqual(caught.exception.field, "change.noise.mismatch")

    def test_only_streams_that_say_so_are_steered(self):
        with self.client.open(**SETTINGS, duration_s=1) as stream, self.assertRaises(saccade.InvalidArgument) as caught:
            stream.steer(pose(0))
        self.assertEqual(caught.exception.field, "stream_id")

    def test_a_saved_stream_tells_what_was_withheld(self):
        path = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory())) / "a.npz"

        async def save():
            async with saccade.aio.connect(self.server.address) as client:
                async with await client.open(**SETTINGS, refractory_s=0.02, clock="lockstep") as stream:
                    events = [(await stream.step(pose(i + 1)))[0] for i in range(STEPS)]
                    await stream.save(path, saccade.concatenate(events))
                    return stream.suppressed
        suppressed = asyncio.run(save())
        self.assertGreater(suppressed, 0)
        about = json.loads(path.with_name("a.npz.json").read_text(encoding="utf-8"))
        self.assertEqual(about["suppressed"], str(suppressed))
        self.assertEqual(about["instruction_set"], self.client.info().instruction_set)
        self.assertEqual(about["end_ns"], str(STEPS * 5_000_000))

    def test_asyncio(self):
        async def steps():
            async with saccade.aio.connect(self.server.address) as client:
                async with await client.open(**SETTINGS, clock="lockstep") as stream:
                    events = [(await stream.step(pose(i + 1)))[0] for i in range(STEPS)]
                    self.assertIn((await stream.info()).frames_done, (STEPS - 1, STEPS))  # it is counted after it is sent
                    return events, await stream.describe()
        events, request = asyncio.run(steps())
        np.testing.assert_array_equal(rows(saccade.concatenate(events)),
                                      rows(saccade.concatenate(self.replayed(request))))


class LostServer(unittest.TestCase):
    def test_a_steered_stream_is_not_opened_again(self):
        logging.getLogger("saccade").setLevel(logging.ERROR)

        def script(server):
            server.open("s1")
            server.attached()
            server.send([packet("s1", 0, 0, 0, 0, b"there is no such stream", count=0, kind=events_pb2.KIND_ERROR)])
        server = FakeServer()
        server.run(script)
        with saccade.connect(server.control.endpoint) as client, self.assertRaisesRegex(
                saccade.StreamFault, "there is no such stream; a stream that its client steers or pushes is not opened again"):
            with client.open(**SETTINGS, delivery="lossless", steerable=True) as stream:
                list(stream)
        server.join()


if __name__ == "__main__":
    unittest.main()
