"""The torch data set, with a real saccaded and with workers."""
import importlib.util
import sys
import unittest

import saccade
from saccaded import Server

MOTIONS = [{"scene": "cornell-box", "motion": f"pan:{speed}", "turn_s": 0, "size": (32, 24), "rate_hz": 500,
            "duration_s": 0.02} for speed in (20, -20, 40, -40)]


def sample(events, settings):
    return settings["motion"], events.t0, len(events)


class DataSet(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.address = cls.enterClassContext(Server()).address

    def load(self, workers, requests=MOTIONS, **options):
        from torch.utils.data import DataLoader
        from saccade.dataset import StreamDataset
        data = StreamDataset(requests, **{"address": self.address, **options})
        return list(DataLoader(data, batch_size=None, num_workers=workers))

    def test_workers_share_the_requests(self):
        alone = self.load(0, transform=sample, duration_us=10_000)
        self.assertEqual([(motion, t0) for motion, t0, _ in alone],
                         [(settings["motion"], t0) for settings in MOTIONS for t0 in (0, 10_000)])
        self.assertGreater(sum(count for *_, count in alone), 0)
        self.assertEqual(sorted(self.load(2, transform=sample, duration_us=10_000)), sorted(alone))

    def test_samples_are_tensors_by_default(self):
        import torch
        samples = self.load(1, count=50)
        self.assertEqual({name: column.dtype for name, column in samples[0].items()},
                         {"t": torch.int64, "x": torch.int16, "y": torch.int16, "p": torch.bool})
        self.assertEqual(len(samples[0]["t"]), 50)
        packets = self.load(0, transform=sample)
        self.assertEqual(sum(count for *_, count in packets), sum(len(columns["t"]) for columns in samples))

    def test_several_servers_share_the_requests_and_one_may_be_lost(self):
        alone = self.load(0, transform=sample)
        with Server("--limit-streams", "1") as small, Server() as lost:
            lost.kill()
            found = self.load(2, transform=sample, address=[lost.address, small.address, self.address])
        self.assertEqual(sorted(found), sorted(alone))

    def test_a_refusal_comes_out_of_the_workers(self):
        for workers in (0, 1):
            with self.assertRaisesRegex(saccade.NotFound, "no scene is named 'nowhere'"):
                self.load(workers, [{**MOTIONS[0], "scene": "nowhere"}])


if __name__ == "__main__":
    if importlib.util.find_spec("torch") is None:
        print("skipped: this Python has no torch")
        sys.exit(77)
    unittest.main()
