"""Streams from three real servers that are killed in turn. live_farm.py is the same for minutes."""
import logging
import pathlib
import tempfile
import time
import unittest
import unittest.mock

import zmq

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
            trial.receive(farm, every=1, retry=QUICK, readers=2)
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

    def test_servers_of_one_name_with_keys_that_listen_on_all_addresses(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        pairs = {owner: zmq.curve_keypair() for owner in ("server", "alice")}
        for owner, (public, secret) in pairs.items():
            (folder / f"{owner}.pub").write_bytes(public)
            (folder / f"{owner}.key").write_bytes(secret)
            (folder / f"{owner}.key").chmod(0o600)
        flags = ["--secret-key", folder / "server.key", "--client-keys", folder / "alice.pub"]
        everywhere = ["tcp://0.0.0.0:0"] * 2  # as a pod does
        first = self.enterContext(Server(*flags, endpoints=["tcp://127.0.0.1:0", *everywhere]))
        port = first.address.rpartition(":")[2]
        self.enterContext(Server(*flags, endpoints=[f"tcp://127.0.0.2:{port}", *everywhere]))
        hosts = ("127.0.0.2", "127.0.0.1")
        answer = [(2, 1, 6, "", (host, 0)) for host in hosts]
        self.enterContext(unittest.mock.patch("saccade.protocol.network.getaddrinfo", return_value=answer))
        client = self.enterContext(saccade.connect(f"tcp://localhost:{port}", server_key=pairs["server"][0],
                                                   secret_key=pairs["alice"][1]))
        streams = [self.enterContext(client.open(**settings_of(i, 1))) for i in range(2)]
        self.assertEqual({stream.address for stream in streams}, {f"tcp://{host}:{port}" for host in hosts})
        for stream in streams:
            self.assertGreater(sum(map(len, stream)), 0)


if __name__ == "__main__":
    unittest.main()
