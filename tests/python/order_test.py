"""The order in which a Dataset's windows are drawn: shuffled by shard, divided among processes, resumed anywhere."""
import pathlib
import tempfile
import unittest

import numpy as np

import farm_set
import saccade
from saccade.stored.mixing import mix

SEQUENCES, SHARDS, PLACES = 3000, 7, 4


class Order(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.data = saccade.Dataset(farm_set.make_index(cls.folder / "set", SEQUENCES, SHARDS), window_s=0.05)
        cls.all = list(range(SEQUENCES * PLACES))

    def shards_of(self, numbers):
        return [farm_set.shard_of(number // PLACES, SEQUENCES, SHARDS) for number in numbers]

    def test_a_pass_has_each_window_once_and_is_drawn_by_seed_and_epoch(self):
        order = self.data.order(seed=3)
        first = list(order)
        self.assertEqual((sorted(first), len(order)), (self.all, len(self.all)))
        self.assertEqual(list(self.data.order(seed=3)), first)
        self.assertEqual(list(order), first)
        order.set_epoch(1)
        for other in (list(order), list(self.data.order(seed=4)), self.all):
            self.assertLess(np.mean(np.array(other) == first), 0.01)
        self.assertEqual(list(self.data.order(shuffle=False)), self.all)

    def test_shards_come_one_after_the_other_and_in_another_order(self):
        shards = self.shards_of(self.data.order(seed=3))
        changes = [shards[0], *(two for one, two in zip(shards, shards[1:]) if one != two)]
        self.assertEqual(sorted(changes), list(range(SHARDS)))
        self.assertNotEqual(changes, sorted(changes))

    def test_windows_of_few_sequences_are_mixed(self):
        places = np.array(list(self.data.order(seed=3))) // PLACES
        spans = [np.ptp(np.flatnonzero(places == sequence)) for sequence in range(0, SEQUENCES, 50)]
        self.assertLess(max(spans), 128 * PLACES)
        self.assertGreater(np.median(spans), 128)

    def test_large_sequences_are_mixed_by_their_memory(self):
        mixed = mix(np.random.default_rng(1), np.arange(0, 101, 10), np.full(10, 0.5)) // 10
        self.assertEqual(len(mixed), 100)
        for group in mixed.reshape(5, 20):
            self.assertEqual(len(set(group)), 2)
            self.assertGreater((group[1:] != group[:-1]).sum(), 3)

    def test_mixing_has_each_window_once_and_sequences_together(self):
        before = np.concatenate([[0], np.cumsum(np.arange(40) % 7)])
        mixed = mix(np.random.default_rng(1), before, np.full(40, 0.2))
        self.assertEqual(sorted(mixed), list(range(before[-1])))
        sequence = np.searchsorted(before, mixed, "right") - 1
        for number in set(sequence):
            self.assertLess(np.ptp(np.flatnonzero(sequence == number)), 5 * 6)

    def test_epochs_change_the_order_of_shards_and_that_within_them(self):
        order, shards, inside = self.data.order(seed=3), set(), set()
        for epoch in range(4):
            order.set_epoch(epoch)
            numbers = list(order)
            shards.add(tuple(dict.fromkeys(self.shards_of(numbers[::100]))))
            inside.add(tuple(number for number in numbers if number < 100))
        self.assertEqual((len(shards), len(inside)), (4, 4))

    def test_ranks_have_different_windows_and_equally_many(self):
        for world in (3, 7):
            ranks = [list(self.data.order(seed=5, rank=rank, world=world)) for rank in range(world)]
            self.assertEqual({len(rank) for rank in ranks}, {len(self.all) // world})
            self.assertEqual(len(set(sum(ranks, []))), len(self.all) // world * world)

    def test_the_parts_of_workers_are_the_whole(self):
        order = self.data.order(seed=5, rank=1, world=2)
        parts = [list(order.part(worker, 5)) for worker in range(5)]
        self.assertEqual(sum(parts, []), list(order))

    def test_it_goes_on_behind_any_window(self):
        for options in ({"seed": 6}, {"shuffle": False}, {"seed": 6, "rank": 2, "world": 3}):
            order = self.data.order(**options)
            order.set_epoch(2)
            whole = list(order)
            for given in (0, 1, 5000 % len(whole), len(whole) - 1, len(whole)):
                taken = iter(order)
                had = [next(taken) for _ in range(given)]
                again = self.data.order(**{**options, "seed": 9})
                again.load_state_dict(order.state_dict() if given else order.state_dict(given=0))
                self.assertEqual(had + list(again), whole)
                self.assertEqual(list(again), whole)

    def test_the_state_says_what_the_training_has_had(self):
        order = self.data.order(seed=6)
        whole = list(order)
        state = order.state_dict(given=100)
        again = self.data.order()
        again.load_state_dict(state)
        self.assertEqual(list(again), whole[100:])

    def test_a_state_of_another_order_is_refused(self):
        state = self.data.order().state_dict()
        for other in (saccade.Dataset(self.folder / "set", window_s=0.1).order(), self.data.order(rank=1, world=2),
                      self.data.order(shuffle=False)):
            with self.assertRaisesRegex(ValueError, "the state is of another"):
                other.load_state_dict(state)
        with self.assertRaisesRegex(ValueError, "given: -1"):
            self.data.order().load_state_dict({**state, "given": -1})
        with self.assertRaisesRegex(ValueError, "rank: 2 is not a whole number from 0 to 1"):
            self.data.order(rank=2, world=2)


class Files(unittest.TestCase):
    def test_a_shuffled_pass_opens_each_file_once(self):
        with tempfile.TemporaryDirectory() as folder:
            root = farm_set.make(folder, 150, 1, 50, 100_000)
            data = saccade.Dataset(root, window_s=0.01)
            opened, make = [], data._open
            data._open = lambda row: opened.append(row) or make(row)
            for number in data.order(seed=2):
                data[number]
            self.assertEqual(sorted(opened), list(range(150)))


if __name__ == "__main__":
    unittest.main()
