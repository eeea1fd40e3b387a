"""The training of the method `learned`: training_test.py LEARNED_DENOISER_TEST."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "server" / "methods" / "training"))
import learning  # noqa: E402
import network  # noqa: E402
import onnx_file  # noqa: E402

PROGRAM = sys.argv[1]


def frame(rng):
    """Two walls, one twice as bright as the other, under noise that is a quarter of the light."""
    truth = np.ones((64, 64), np.float32)
    truth[:, 32:] = 2
    light = truth * (1 + 0.25 * rng.uniform(-1.7, 1.7, truth.shape))
    planes = np.zeros((network.PLANES, 64, 64), np.float32)
    planes[0], planes[1], planes[2] = light, 1, np.log1p(10 * light)
    planes[4, :, :32], planes[5, :, 32:] = 1, 1
    return planes, truth, np.ones_like(truth)


class Training(unittest.TestCase):
    def test_gradients_are_those_of_differences(self):
        rng = np.random.default_rng(1)
        p = {name: v.astype(float) + rng.normal(0, 0.1, v.shape) for name, v in network.parameters(3).items()}
        planes, truth = rng.random((network.PLANES, 2, 20, 24)), rng.random((1, 2, 20, 24))
        planes[1] = 1

        def value():
            return learning.loss(network.denoise(p, planes)[0], truth, np.ones_like(truth))[0]

        light, gradients = network.denoise(p, planes)
        found = gradients(learning.loss(light, truth, np.ones_like(truth))[1])
        for name in p:
            at = tuple(rng.integers(size) for size in p[name].shape)
            before, step = p[name][at], 1e-6
            p[name][at] = before + step
            above = value()
            p[name][at] = before - step
            below = value()
            p[name][at] = before
            self.assertAlmostEqual(found[name][at], (above - below) / (2 * step), delta=1e-7, msg=name)

    def test_light_that_is_the_same_everywhere_stays(self):
        planes = np.random.default_rng(2).random((network.PLANES, 1, 40, 30)).astype(np.float32)
        planes[0], planes[1] = 3, 1
        light, _ = network.denoise(network.parameters(0), planes)
        np.testing.assert_allclose(light, 3, rtol=1e-5)

    def test_training_takes_noise_away_and_keeps_an_edge(self):
        rng = np.random.default_rng(4)
        p = learning.train([frame(rng) for _ in range(4)], 40, 1, 0)
        planes, truth, _ = frame(rng)
        light = network.denoise(p, planes[:, None])[0][0, 0]
        self.assertLess(np.abs(light - truth).mean(), 0.25 * np.abs(planes[0] - truth).mean())
        again = learning.train([frame(np.random.default_rng(5))], 2, 1, 7)
        same = learning.train([frame(np.random.default_rng(5))], 2, 1, 7)
        for name in again:
            np.testing.assert_array_equal(again[name], same[name])

    def test_onnx_runtime_runs_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "network.onnx")
            file.write_bytes(onnx_file.model(network.parameters(0)))
            run = subprocess.run([PROGRAM, "--gtest_filter=*/learned"], capture_output=True, text=True, check=False,
                                 env={**os.environ, "SACCADE_LEARNED_MODEL": str(file)})
        if "without ONNX Runtime" in run.stdout:
            self.skipTest("the program was built without ONNX Runtime")
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertNotIn("SKIPPED", run.stdout)

    def test_protoc_reads_the_file(self):
        model = onnx_file.model(network.parameters(0))
        read = subprocess.run(["protoc", "--decode_raw"], input=model, capture_output=True, check=True).stdout.decode()
        self.assertEqual(read.count('4: "Conv"'), 3 + 3 * len(network.SPACINGS))
        self.assertIn('2: "saccade"', read)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
