"""A Dataset with torch's DataLoader and its workers."""
import collections
import importlib.util
import pathlib
import sys
import tempfile
import unittest

import farm_set
import saccade


def key(window):
    return window.sequence.number, window.place, len(window.events)


class Loader(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.data = saccade.Dataset(farm_set.make(folder, 20, 3, 200, 100_000), window_s=0.02, transform=key)
        cls.all = list(cls.data)

    def load(self, data, workers, **options):
        from torch.utils.data import DataLoader
        loader = DataLoader(data, batch_size=4, num_workers=workers, collate_fn=list, **options)
        return [item for batch in loader for item in batch]

    def test_the_order_is_a_sampler(self):
        order = self.data.order(seed=1)
        expected = [self.data[number] for number in order]
        for workers in (0, 2):
            self.assertEqual(self.load(self.data, workers, sampler=order), expected)
        order.load_state_dict(order.state_dict(given=12))
        self.assertEqual(self.load(self.data, 2, sampler=order), expected[12:])

    def test_workers_take_parts_of_the_order(self):
        from saccade.dataset import StoredDataset
        order = self.data.order(seed=1)
        stored = StoredDataset(self.data, order)
        self.assertEqual(self.load(stored, 0), [self.data[number] for number in order])
        self.assertEqual(sorted(self.load(stored, 2)), sorted(self.all))
        self.assertEqual(len(stored), len(self.all))
        first = self.load(stored, 0)
        order.set_epoch(1)
        self.assertNotEqual(self.load(stored, 0), first)

    def test_workers_that_are_spawned_read_the_index_anew(self):
        order = self.data.order(seed=1)
        found = self.load(self.data, 1, sampler=order, multiprocessing_context="spawn")
        self.assertEqual(found, [self.data[number] for number in order])

    def test_the_state_of_a_part(self):
        from saccade.dataset import StoredDataset
        stored = StoredDataset(self.data, self.data.order(seed=1))
        items = iter(stored)
        had = [next(items) for _ in range(7)]
        again = StoredDataset(self.data, self.data.order(seed=2))
        again.load_state_dict(stored.state_dict())
        self.assertEqual(had + list(again), [self.data[number] for number in self.data.order(seed=1)])

    def test_damage_comes_out_of_the_workers(self):
        from torch.utils.data import DataLoader
        with tempfile.TemporaryDirectory() as folder:
            root = farm_set.make(folder, 2, 1)
            (root / "shards/00000/000001/events.h5").unlink()
            with self.assertRaisesRegex(saccade.FormatError, "000001/events.h5: the file is missing"):
                list(DataLoader(saccade.Dataset(root, transform=key), num_workers=1, collate_fn=list))


if __name__ == "__main__":
    if any(importlib.util.find_spec(name) is None for name in ("torch", "h5py")):
        print("skipped: this Python has no torch or no h5py")
        sys.exit(77)
    unittest.main()
