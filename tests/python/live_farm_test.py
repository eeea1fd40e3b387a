"""Streams from three real servers that are killed in turn. live_farm.py is the same for minutes."""
import logging
import time
import unittest

import saccade
from live_farm import Farm, Trial, settings_of
from saccaded import Server

QUICK = saccade.RetryPolicy(silence_s=0.7, failover_s=0.7)


class LiveFarm(unittest.TestCase):
    def setUp(self):
        logging.getLogger("saccade").setLevel(logging.ERROR)

    def test_streams_survive_servers_that_are_killed(self):
        trial = Trial(streams=24, seconds=4)
        with Farm(3) as farm:
            trial.receive(farm, every=1, retry=QUICK)
        self.assertEqual(farm.killed, 3)
        self.assertGreater(trial.opened_again, 0)
        with Server() as server:
            wrong, count = trial.differing(server.address)
        self.assertEqual(wrong, [])
        self.assertGreater(count, 10_000)

    def test_streams_are_shared_out_and_a_server_that_comes_back_is_used(self):
        with Farm(2) as farm, saccade.connect(farm.addresses, retry=QUICK) as client:
            endless = settings_of(0, 0, clock="paced")

            def address_of_next():
                with client.open(**endless) as stream:
                    return stream.address
            streams = [self.enterContext(client.open(**endless)) for _ in range(4)]
            self.assertEqual(sorted(stream.address for stream in streams), sorted(farm.addresses * 2))
            farm.kill_next()
            self.assertEqual({address_of_next() for _ in range(2)}, {farm.addresses[1]})
            farm.restart()
            until = time.monotonic() + 20
            while address_of_next() != farm.addresses[0]:
                self.assertLess(time.monotonic(), until)


if __name__ == "__main__":
    unittest.main()
