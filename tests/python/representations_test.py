"""Frames, voxel grids and time surfaces against their formulas, event by event."""
import math
import unittest

import numpy as np

import saccade

RNG = np.random.default_rng(3)
WIDTH, HEIGHT, COUNT = 6, 4, 500
EVENTS = saccade.Events(np.sort(RNG.integers(1000, 51000, COUNT)), RNG.integers(0, WIDTH, COUNT),
                        RNG.integers(0, HEIGHT, COUNT), RNG.integers(0, 2, COUNT) == 1, (WIDTH, HEIGHT))


def one_by_one():
    return zip(EVENTS.t.tolist(), EVENTS.x.tolist(), EVENTS.y.tolist(), EVENTS.p.tolist())


class Representations(unittest.TestCase):
    def test_a_frame_counts(self):
        expected = np.zeros((2, HEIGHT, WIDTH), int)
        for _, x, y, p in one_by_one():
            expected[int(p), y, x] += 1
        np.testing.assert_array_equal(EVENTS.frame(), expected)

    def test_a_voxel_grid_is_bilinear_in_time(self):
        bins = 5
        expected = np.zeros((bins, HEIGHT, WIDTH))
        first, last = EVENTS.t[0], EVENTS.t[-1]
        for t, x, y, p in one_by_one():
            at = (bins - 1) * (t - first) / (last - first)
            for b in range(bins):
                expected[b, y, x] += (1 if p else -1) * max(0, 1 - abs(b - at))
        grid = EVENTS.voxel(bins)
        self.assertEqual(grid.dtype, np.float32)
        np.testing.assert_allclose(grid, expected, atol=1e-5)

    def test_events_of_one_time_fall_into_the_first_bin(self):
        twice = saccade.Events(np.array([7, 7]), np.array([1, 1]), np.array([0, 0]), np.array([True, True]), (2, 1))
        grid = twice.voxel(3)
        np.testing.assert_array_equal(grid, [[[0, 2]], [[0, 0]], [[0, 0]]])

    def test_a_time_surface_decays_from_the_last_event(self):
        at, tau = int(EVENTS.t[COUNT // 2]), 4000.0
        expected = np.zeros((2, HEIGHT, WIDTH))
        for t, x, y, p in one_by_one():
            if t <= at:
                expected[int(p), y, x] = math.exp((t - at) / tau)
        np.testing.assert_allclose(EVENTS.time_surface(tau, at), expected, rtol=1e-6)
        newest = EVENTS.p[-1] * 1, EVENTS.y[-1], EVENTS.x[-1]
        self.assertAlmostEqual(EVENTS.time_surface(tau)[newest], math.exp(-1 / tau), 6)

    def test_faulty_settings_are_refused(self):
        unsized = saccade.Events(EVENTS.t, EVENTS.x, EVENTS.y, EVENTS.p)
        for text, call in (("bins: 1 is not a whole number from 2", lambda: EVENTS.voxel(1)),
                           ("bins: '5' is not", lambda: EVENTS.voxel("5")),
                           ("tau_us: 0 is not a finite number above 0", lambda: EVENTS.time_surface(0)),
                           ("size of the sensor is unknown", unsized.frame)):
            with self.assertRaisesRegex(ValueError, text):
                call()


if __name__ == "__main__":
    unittest.main()
