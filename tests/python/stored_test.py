"""saccade.Dataset: windows of the data set of a farm, their truth and their draws, and what is told of damage."""
import importlib.util
import itertools
import json
import os
import pathlib
import pickle
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np

import farm_set
import saccade
from saccade.stored import packing

DURATION_US, COUNT, SEQUENCES = 100_000, 400, 20


def rows(events):
    return np.stack([events.t, events.x, events.y, events.p])


class Stored(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.root = farm_set.make(cls.folder / "set", SEQUENCES, 3, COUNT, DURATION_US, ("npz", "h5"))

    def copy(self, name):
        return pathlib.Path(shutil.copytree(self.root, self.folder / name))

    def test_windows_of_time_are_those_of_the_recording(self):
        data = saccade.Dataset(self.root, window_s=0.03)
        self.assertEqual((len(data), data.plan.name), (SEQUENCES * 3, "drawn"))
        for number, window in enumerate(data):
            self.assertEqual((window.sequence.number, window.place), divmod(number, 3))
            expected = next(itertools.islice(window.sequence.recording.windows(duration_us=30_000), window.place, None))
            np.testing.assert_array_equal(rows(window.events), rows(expected))
            self.assertEqual((window.events.t0, window.events.t1, window.events.size, window.events.sensor),
                             (expected.t0, expected.t1, expected.size, 0))

    def test_windows_overlap_by_their_stride(self):
        data = saccade.Dataset(self.root, window_s=0.03, stride=0.0205)
        self.assertEqual(len(data), SEQUENCES * 4)
        for place in range(4):
            events = farm_set.events_of(1, COUNT, DURATION_US).slice(20_500 * place, 20_500 * place + 30_000)
            np.testing.assert_array_equal(rows(data[4 + place].events), rows(events))

    def test_windows_of_a_count(self):
        data = saccade.Dataset(self.root, count=150, stride=100)
        self.assertEqual(len(data), SEQUENCES * 3)
        whole = farm_set.events_of(19, COUNT, DURATION_US)
        np.testing.assert_array_equal(rows(data[-1].events), rows(whole[200:350]))
        self.assertEqual((data[-1].events.t0, data[-1].events.t1), (whole.t[200], whole.t[349] + 1))
        with self.assertRaises(IndexError):
            data[len(data)]

    def test_without_a_length_a_window_is_a_recording(self):
        data = saccade.Dataset(self.root)
        self.assertEqual(len(data), SEQUENCES)
        np.testing.assert_array_equal(rows(data[7].events), rows(farm_set.events_of(7, COUNT, DURATION_US)))
        self.assertEqual((data[7].events.t0, data[7].events.t1), (0, DURATION_US))
        self.assertEqual([len(saccade.Dataset(self.root, window_s=length)) for length in (0.1, 0.100001)], [SEQUENCES, 0])

    def test_truth_is_that_from_the_begin_of_a_window_to_its_end(self):
        for sensor in (0, 1):
            data = saccade.Dataset(self.root, window_s=0.025, sensor=sensor, truth=["depth", "pose"])
            window = data[4 * 5 + 1]
            self.assertEqual(window.truth["depth"].t.tolist(), [30_000, 40_000, 50_000])
            np.testing.assert_allclose(window.truth["depth"].data[-1], 5.05)
            self.assertEqual(window.truth["depth"].data.shape, (3, 48, 64, 1))
            self.assertEqual((window.truth["depth"].planes, window.truth["depth"].unit), (("depth",), "unit"))
            self.assertEqual((window.truth["pose"].data.shape, window.truth["pose"].exposure), ((3, 7), None))

    def test_a_sensor_a_split_and_the_draws(self):
        second = saccade.Dataset(self.root, sensor=1)
        np.testing.assert_array_equal(rows(second[3].events), rows(farm_set.events_of(3, COUNT, DURATION_US)[::2]))
        self.assertEqual(second[3].events.sensor, 1)
        found = {split: [window.sequence.number for window in saccade.Dataset(self.root, split=split)]
                 for split in farm_set.SPLITS}
        self.assertEqual((found["val"], found["test"], len(found["train"])), ([8, 18], [9, 19], 16))
        sequence = saccade.Dataset(self.root, split="test")[1].sequence
        self.assertEqual((sequence.split, sequence.shard, sequence.draws, sequence.options),
                         ("test", 2, {"speed": "9.5"}, ("scene", "--seed", "19")))

    def test_a_format_that_is_read_as_a_whole(self):
        root = farm_set.make(self.folder / "npz", 4, 1, COUNT, DURATION_US, ("npz",))
        for number, window in enumerate(saccade.Dataset(root, window_s=0.05, truth=["depth"])):
            expected = farm_set.events_of(number // 2, COUNT, DURATION_US).slice(window.events.t0, window.events.t1)
            np.testing.assert_array_equal(rows(window.events), rows(expected))
            self.assertEqual(window.truth["depth"].t.size, 6)
        self.assertEqual(len(saccade.Dataset(root, count=100)[1].events), 100)

    def test_recordings_of_many_chunks(self):
        root = farm_set.make(self.folder / "chunks", 1, 1, 5000, DURATION_US, chunk=512)
        data = saccade.Dataset(root, window_s=0.0101)
        whole = farm_set.events_of(0, 5000, DURATION_US)
        with mock.patch("saccade.stored.hdf5_column.unpack", side_effect=packing.unpack) as unpacked:
            for number in (5, 0, 8, 3, 4, 3, 1, 2, 6, 7):
                begin = 10_100 * number
                np.testing.assert_array_equal(rows(data[number].events), rows(whole.slice(begin, begin + 10_100)))
        self.assertEqual(unpacked.call_count, 4 * 9)  # four columns, of their 10 chunks those that windows need, each once
        np.testing.assert_array_equal(rows(saccade.Dataset(root, count=700)[2].events), rows(whole[1400:2100]))

    def test_times_from_an_epoch_long_ago_and_other_packing(self):
        import h5py
        root, offset = self.copy("epoch"), 10**13  # microseconds
        with h5py.File(root / "shards/00000/000000/events.h5", "r+") as file:
            file["t_offset"][()] = offset
            t = file["events/t"][:]
            del file["events/t"]
            file["events/t"] = t  # neither in chunks nor packed
        index = root / "shards/00000/index.jsonl"
        first, *others = index.read_text().splitlines()
        about = {**json.loads(first), "files": []}
        for recording in about["recordings"]:
            recording.update(begin_ns=str(offset * 1000), end_ns=str((offset + DURATION_US) * 1000))
        index.write_text("\n".join([json.dumps(about), *others, ""]))
        window = saccade.Dataset(root, window_s=0.03)[1]
        self.assertEqual(window.events.t0, offset + 30_000)
        expected = farm_set.events_of(0, COUNT, DURATION_US).slice(30_000, 60_000)
        np.testing.assert_array_equal(window.events.t, expected.t + offset)
        np.testing.assert_array_equal(window.events.x, expected.x)

    def test_a_transform_makes_the_item(self):
        data = saccade.Dataset(self.root, window_s=0.05, transform=lambda window: len(window.events))
        self.assertEqual(sum(data), SEQUENCES * COUNT)

    def test_columns_cannot_be_written(self):
        window = saccade.Dataset(self.root, window_s=0.05)[0]
        for name in "xyp":
            with self.assertRaises(ValueError):
                getattr(window.events, name)[:] = 0

    def test_a_pickled_object_and_a_forked_process_give_the_same(self):
        data = saccade.Dataset(self.root, window_s=0.05)
        expected = rows(data[9].events).tolist()
        self.assertEqual(rows(pickle.loads(pickle.dumps(data))[9].events).tolist(), expected)
        self.assertLess(len(pickle.dumps(data)), 2000)
        data[0]
        reader, writer = os.pipe()
        if (child := os.fork()) == 0:
            same = rows(data[9].events).tolist() == expected
            os.write(writer, b"%d" % (same and len(data._kept._open) == 1))  # nothing that its parent has opened
            os._exit(0)
        os.waitpid(child, 0)
        self.assertEqual(os.read(reader, 9), b"1")
        os.close(reader), os.close(writer)

    def test_wrong_arguments_are_told_with_what_is_valid(self):
        for options, text in [
                ({"split": "tset"}, "split: 'tset' is not one of train, val, test"),
                ({"sensor": 2}, "sensor: 2 is not one of 0, 1"),
                ({"truth": ["flow"]}, "truth: 'flow' is not one of depth, pose"),
                ({"window_s": 0}, "window_s: 0 is not a finite number above 0"),
                ({"window_s": 1e-9}, "window_s: 1e-09 is less than a microsecond"),
                ({"count": 0}, "count: 0 is not a whole number from 1"),
                ({"count": 5, "stride": 0.5}, "stride: 0.5 is not a whole number"),
                ({"count": 5, "window_s": 1}, "not both"), ({"stride": 1}, "stride goes with")]:
            with self.subTest(options), self.assertRaisesRegex(ValueError, text):
                saccade.Dataset(self.root, **options)

    def expect_told(self, text, root, number=0, **options):
        with self.assertRaises(saccade.FormatError) as told:
            saccade.Dataset(root, **options)[number]
        self.assertRegex(str(told.exception), text)
        self.assertRegex(str(told.exception), f"`saccade-farm [a-z]+ {root}")

    def test_damage_is_told_with_the_file_and_what_to_do(self):
        root = self.copy("damaged")
        (root / "shards/00000/000000/events.h5").unlink()
        self.expect_told("000000/events.h5: the file is missing", root)
        events = root / "shards/00000/000001/events.h5"
        events.write_bytes(events.read_bytes()[:-9])
        self.expect_told(r"000001/events.h5: it has \d+ bytes, not \d+", root, 1)
        lost = root / "shards/00000/000002/events.h5"
        lost.write_bytes(bytes(lost.stat().st_size))
        self.expect_told("000002/events.h5: .*file signature not found", root, 2)
        (root / "shards/00000/000003/events.h5.json").write_text("{")
        self.expect_told("000003/events.h5.json: .*property name", root, 3, truth=["depth"])

    def test_events_that_cannot_be_are_told(self):
        import h5py
        root = self.copy("wrong")
        index = root / "shards/00000/index.jsonl"
        lines = [{**json.loads(line), "files": []} for line in index.read_text().splitlines()]  # any size will do
        index.write_text("".join(json.dumps(line) + "\n" for line in lines))
        for number, (name, place, value, text) in enumerate([
                ("t", 0, 99_999, "times run backwards"), ("x", 5, 64, "a pixel is 64 or more"),
                ("y", 5, 48, "a pixel is 48 or more"), ("p", 5, 2, "a polarity is 2 or more")]):
            with h5py.File(root / f"shards/00000/{number:06}/events.h5", "r+") as file:
                file["events"][name][place] = value
            self.expect_told(f"{number:06}/events.h5: {text}", root, number)
        with h5py.File(root / "shards/00000/000004/events.h5", "r+") as file:
            file["events/x"].resize((399,))
        self.expect_told(r"000004/events.h5: events/x has \(399,\) values, not 400", root, 4)
        with h5py.File(root / "shards/00000/000005/events.h5", "r+") as file:
            del file["events/y"]
        self.expect_told("000005/events.h5: .*events/y|000005/events.h5: .*'y'", root, 5)

    def test_lists_that_are_missing_or_damaged(self):
        with self.assertRaisesRegex(saccade.FormatError, "nowhere/plan.json is missing: .* is no data set that"):
            saccade.Dataset(self.folder / "nowhere")
        root = self.copy("lists")
        index = root / "shards/00001/index.jsonl"
        lines = index.read_text()
        for bad in ("{\n", "[]\n", '{"number":"7"}\n', lines.replace('"shard":1', '"shard":2'),
                    lines.replace("events.h5", "../events.h5"), lines.replace('"width":64', '"width":"a"')):
            index.write_text(lines + bad)
            self.expect_told("00001/index.jsonl: line [0-9]+ is no sequence of shard 1", root)
        index.unlink()
        self.expect_told("00001/index.jsonl is missing: 2 of 3 shards are finished", root)
        self.assertEqual(len(saccade.Dataset(root, partial=True)), 13)
        (root / "plan.json").write_text("{")
        self.expect_told("plan.json: ", root)


class Index(unittest.TestCase):
    """With the lists of many sequences."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.root = farm_set.make_index(cls.folder / "set", 20_000, 4)

    def test_it_is_kept_in_the_folder_of_caches(self):
        before = sorted(self.root.rglob("*"))
        first = saccade.Dataset(self.root, window_s=0.05, cache=self.folder / "cache")
        kept = sorted(path.suffix for path in (self.folder / "cache").iterdir())
        self.assertEqual(kept, [".json", ".npy"])
        again = saccade.Dataset(self.root, window_s=0.05, cache=self.folder / "cache")
        self.assertIsInstance(again._index.rows, np.memmap)
        self.assertEqual((again._index.rows == first._index.rows).all(), True)
        self.assertEqual((len(again), sorted(self.root.rglob("*"))), (80_000, before))
        for path in (self.folder / "cache").glob("*.npy"):
            path.write_bytes(path.read_bytes()[:-1])
        self.assertEqual(len(saccade.Dataset(self.root, window_s=0.05, cache=self.folder / "cache")), 80_000)
        shard = self.root / "shards/00003/index.jsonl"
        shard.write_text("".join(shard.read_text().splitlines(True)[:-1]))
        self.assertEqual(len(saccade.Dataset(self.root, window_s=0.05, cache=self.folder / "cache")), 79_996)

    def test_a_sequence_takes_no_objects(self):
        import gc
        import sys
        data = saccade.Dataset(self.root, window_s=0.05, cache=self.folder / "none")
        seen, front = set(), [data.__dict__]
        while front:
            item = front.pop()
            if id(item) not in seen and not isinstance(item, type(sys)) and not isinstance(item, type):
                seen.add(id(item))
                front += gc.get_referents(item)
            if len(seen) > 5000:
                break
        self.assertLess(len(seen), 5000)


if __name__ == "__main__":
    if importlib.util.find_spec("h5py") is None:
        print("skipped: this Python has no h5py")
        sys.exit(77)
    unittest.main()
