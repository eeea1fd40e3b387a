"""Events: columns, slices, concatenation, windows, and the forms of other libraries."""
import pathlib
import tempfile
import unittest

import numpy as np

import saccade


def events(times, sensor=0, **more):
    t = np.array(times, np.int64)
    return saccade.Events(t, t % 7, t % 5, t % 2 == 1, (7, 5), sensor=sensor, **more)


class Columns(unittest.TestCase):
    def test_they_have_the_types_that_are_told(self):
        made = events([1, 2])
        self.assertEqual([getattr(made, name).dtype.str for name in "txyp"], ["<i8", "<u2", "<u2", "|b1"])
        self.assertEqual((len(made), made.t0, made.t1), (2, 1, 3))

    def test_unequal_columns_are_refused(self):
        with self.assertRaises(ValueError):
            saccade.Events(np.arange(2), np.arange(2), np.arange(3), np.arange(2) > 0)

    def test_no_events_are_events_too(self):
        none = events([], interval=(5, 9))
        self.assertEqual((len(none), none.t0, none.t1), (0, 5, 9))
        self.assertEqual(none.voxel(3).sum(), 0)
        self.assertEqual(none.frame().shape, (2, 5, 7))
        self.assertEqual(len(none.slice(6, 7)), 0)

    def test_a_mask_selects(self):
        made = events([1, 2, 3, 4])
        self.assertEqual(made[made.p].t.tolist(), [1, 3])
        self.assertEqual(made[1:3].t.tolist(), [2, 3])
        self.assertEqual(made[1:3].t0, 1, "the interval stays")
        with self.assertRaises(TypeError):
            made[1]

    def test_a_slice_of_time_has_its_begin_and_not_its_end(self):
        part = events([1, 2, 2, 3, 4]).slice(2, 4)
        self.assertEqual(part.t.tolist(), [2, 2, 3])
        self.assertEqual((part.t0, part.t1), (2, 4))

    def test_concatenation(self):
        both = saccade.concatenate([events([1, 2], interval=(0, 5)), events([], interval=(5, 6)), events([6])])
        self.assertEqual(both.t.tolist(), [1, 2, 6])
        self.assertEqual((both.t0, both.t1, both.size), (0, 7, (7, 5)))
        for wrong in ([], [events([3]), events([2])], [events([1]), events([2], sensor=1)]):
            with self.assertRaises(ValueError):
                saccade.concatenate(wrong)
        for wrong in (events([1]), [1], [None]):
            with self.assertRaisesRegex(TypeError, "a list of Events"):
                saccade.concatenate(wrong)

    def test_a_file_is_what_its_name_says(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.h5", "a.raw", "a.bag", "a"):
                with self.assertRaisesRegex(ValueError, f"{name} does not end with .npz.*saccade convert"):
                    events([1]).save(pathlib.Path(folder) / name)
            self.assertEqual(list(pathlib.Path(folder).iterdir()), [])

    def test_what_is_saved_is_read(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.npz"
            events([1, 2, 9]).save(path)
            again = saccade.read(path)
        self.assertEqual((again.t.tolist(), again.x.tolist(), again.y.tolist(), again.p.tolist(), again.size),
                         ([1, 2, 9], [1, 2, 2], [1, 2, 4], [True, False, True], (7, 5)))

    def test_tonic(self):
        array = events([8]).to_tonic()
        self.assertEqual(array.dtype, np.dtype([("x", "<i2"), ("y", "<i2"), ("t", "<i8"), ("p", "?")]))
        self.assertEqual(array.tolist(), [(1, 3, 8, False)])


class Windows(unittest.TestCase):
    PARTS = [events([0, 3], interval=(0, 5)), events([], interval=(5, 10)), events([10, 11, 29], interval=(10, 30)),
             events([30], interval=(30, 34))]

    def test_of_fixed_duration_also_without_events(self):
        cut = list(saccade.windows(self.PARTS, duration_us=10))
        self.assertEqual([(w.t0, w.t1, w.t.tolist()) for w in cut],
                         [(0, 10, [0, 3]), (10, 20, [10, 11]), (20, 30, [29]), (30, 34, [30])])

    def test_of_fixed_count(self):
        cut = list(saccade.windows(self.PARTS, count=4))
        self.assertEqual([(w.t0, w.t1, w.t.tolist()) for w in cut], [(0, 12, [0, 3, 10, 11]), (29, 34, [29, 30])])
        self.assertEqual([len(w) for w in events([1, 1, 1, 2]).windows(count=2)], [2, 2])

    def test_a_window_comes_as_soon_as_it_is_complete(self):
        def live():
            yield events([0, 3], interval=(0, 10))
            self.fail("the window was complete")
        self.assertEqual(next(saccade.windows(live(), duration_us=10)).t.tolist(), [0, 3])

    def test_sensors_are_cut_apart(self):
        parts = [events([1], 0, interval=(0, 4)), events([2], 1, interval=(0, 4)), events([5], 1, interval=(4, 8))]
        cut = list(saccade.windows(parts, duration_us=8))
        self.assertEqual([(w.sensor, w.t.tolist()) for w in cut], [(1, [2, 5]), (0, [1])])

    def test_one_of_both_is_needed(self):
        for wrong in ({}, {"duration_us": 1, "count": 1}, {"count": 0}, {"duration_us": "5"}, {"count": 2.5},
                      {"duration_us": -1}):
            with self.assertRaises(ValueError):
                saccade.windows(self.PARTS, **wrong)


if __name__ == "__main__":
    unittest.main()
