"""Streams whose frames the client in Python sends, with a real saccaded."""
import asyncio
import os
import pathlib
import struct
import subprocess
import tempfile
import unittest
import zlib

import numpy as np

import saccade
import saccade.aio
from saccaded import Server

SETTINGS = {"pushed": True, "size": (6, 4), "rate_hz": 100, "threshold": [0.1, 0.2], "bias": 1e-12}
STEP = 0.23  # of log brightness in each frame


def frame(index):
    """One pixel of it brightens."""
    picture = np.ones((4, 6))
    picture[2, 3] = np.exp(STEP * index)
    return picture


def png(picture):
    """A grey picture of whole numbers, see the specification of PNG."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    height, width = picture.shape
    rows = picture.astype(picture.dtype.newbyteorder(">"))
    lines = b"".join(b"\0" + row.tobytes() for row in rows)  # 0: no filter
    head = struct.pack(">IIBBBBB", width, height, 8 * picture.itemsize, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b"")


class Pushed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = cls.enterClassContext(Server())

    def setUp(self):
        self.client = self.enterContext(saccade.connect(self.server.address))

    def check_ramp(self, steps):
        for sensor, threshold in enumerate(SETTINGS["threshold"]):
            events = saccade.concatenate([step[sensor] for step in steps])
            self.assertEqual((events.t0, events.t1, events.camera), (0, 10_000 * len(steps), None))
            self.assertEqual({*zip(events.x, events.y, events.p)}, {(3, 2, True)})
            np.testing.assert_allclose(np.diff(events.t), threshold / STEP * 10_000, atol=2)
            self.assertLess(events.t1 - events.t[-1], threshold / STEP * 10_000)

    def test_a_push_gives_the_events_of_its_frame(self):
        with self.client.open(**SETTINGS) as stream:
            self.assertEqual(stream.push(frame(0)), [])
            self.check_ramp([stream.push(frame(i)) for i in range(1, 9)])
            stream.stop()
            self.assertEqual(list(stream), [])

    def test_a_push_gives_the_truth_of_its_frame(self):
        with self.client.open(**SETTINGS, truth=["intensity"]) as stream:
            stream.push(frame(0))
            self.assertEqual(stream.truth, [])
            for i in range(1, 4):
                stream.push(frame(i))
                expected = [0, 1] if i == 1 else [i]
                self.assertEqual([one.t for one in stream.truth], [10_000 * k for k in expected])
                for one, k in zip(stream.truth, expected):
                    np.testing.assert_allclose(one.data[..., 0], frame(k), rtol=1e-6)

    def test_whole_numbers_mean_what_they_mean_to_saccade_events(self):
        rng = np.random.default_rng(1)
        for kind, shape in ((np.uint8, (16, 16)), (np.uint16, (256, 256))):
            values = np.arange(np.prod(shape)).astype(kind)
            frames = [rng.permutation(values).reshape(shape) for _ in range(3)]
            with self.subTest(kind=kind), tempfile.TemporaryDirectory() as folder:
                from_files, light = self.events_of_files(pathlib.Path(folder), frames)
                size = shape[::-1]
                with self.client.open(pushed=True, size=size, rate_hz=100, threshold=0.5, truth=["intensity"]) as stream:
                    steps, truth = [], []
                    for one in frames:
                        steps += stream.push(one)
                        truth += stream.truth
                for i, one in enumerate(truth):
                    np.testing.assert_allclose(one.data[..., 0], light[i, ..., 0], rtol=2e-7)
                pushed = saccade.concatenate(steps)
                for column in "txyp":
                    np.testing.assert_array_equal(getattr(pushed, column), getattr(from_files, column))
                self.assertGreater(len(pushed), len(values))
                self.assertEqual(light.max(), 1)

    def events_of_files(self, folder, frames):
        """The events and the light of `saccade events`, from PNG files."""
        for i, one in enumerate(frames):
            (folder / f"{i}.png").write_bytes(png(one))
        file = folder / "out.npz"
        subprocess.run([os.environ["SACCADE"], "events", folder, "--rate", "100", "--threshold", "0.5", "--truth",
                        "intensity", "--control", self.server.address, "-o", file], check=True, stdout=subprocess.DEVNULL)
        return saccade.read(file), saccade.read_truth(file)["intensity"].data

    def test_what_is_no_frame_is_refused(self):
        with self.client.open(**SETTINGS) as stream:
            for wrong, text in ((frame(0).tolist(), "frames are numpy arrays .* not list"),
                                (frame(0).astype(int), "not int64"), (frame(0) > 0, "not bool")):
                with self.subTest(text), self.assertRaisesRegex(TypeError, text):
                    stream.push(wrong)

    def test_faults(self):
        with self.client.open(**SETTINGS) as stream:
            with self.assertRaisesRegex(ValueError, r"shape \(4, 6\), not \(6, 4\)"):
                stream.push(frame(0).T)
            with self.assertRaises(saccade.InvalidArgument) as caught:
                stream.push(-frame(0))
            self.assertEqual(caught.exception.field, "intensity[0]")
        for wrong in ({"scene": "cornell-box"}, {"motion": "still"}, {"spp": 2}):
            with self.subTest(**wrong), self.assertRaisesRegex(TypeError, "a pushed stream has no setting"):
                self.client.open(**SETTINGS, **wrong)
        with self.assertRaisesRegex(TypeError, "the setting 'scene' is missing"):
            self.client.open(size=(6, 4), rate_hz=100, motion="still")

    def test_asyncio(self):
        async def push():
            async with saccade.aio.connect(self.server.address) as client:
                async with await client.open(**SETTINGS) as stream:
                    return [await stream.push(frame(i)) for i in range(9)]
        self.check_ramp(asyncio.run(push())[1:])


if __name__ == "__main__":
    unittest.main()
