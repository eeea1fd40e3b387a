"""Clients of several servers, played by the test: which one they choose, and what they do when it is lost."""
import asyncio
import contextlib
import logging
import os
import unittest
import unittest.mock

import saccade
import saccade.aio
from fake_server import FakeServer, packets_of
from saccade.protocol.network import AsyncNetwork, BlockingNetwork, run
from saccade.protocol.session import make_servers
from saccade.v1 import control_pb2

SETTINGS = {"scene": "room", "motion": "right", "size": (346, 260), "rate_hz": 1000, "delivery": "lossless"}
POLICY = saccade.RetryPolicy(retry_time_s=1, silence_s=0.4, failover_s=0.4)
LOOK_UP = "saccade.protocol.network.getaddrinfo"


def limits(**used):
    """Those of a server: 64 streams and 100 of any other, of which so many are used."""
    return [control_pb2.LimitInfo(name=name, value=64 if name == "streams" else 100, used=amount)
            for name, amount in used.items()] + [control_pb2.LimitInfo(name="queue", value=4)]


def tell(server):
    """Says what a server tells about itself, once."""
    server.answer_next("")


def tell_only(server):
    tell(server)
    assert not server.control.socket.poll(300), "another server has more room"


def give_whole(server):
    server.open("s1")
    server.attached()
    server.send(packets_of("s1"))


def give_half(server):
    """A stream of which the server sends half, and then nothing at all."""
    server.open("s1")
    server.attached()
    server.send(packets_of("s1")[:2])


def give_half_and_end(server):
    """The same, and then the server is gone."""
    give_half(server)
    server.control.socket.unbind(server.control.endpoint)


class SeveralServers(unittest.TestCase):
    def setUp(self):
        logging.getLogger("saccade").setLevel(logging.ERROR)

    @contextlib.contextmanager
    def client(self, *plays, described=({}, {})):
        """A client of a server for each of the plays."""
        servers = [FakeServer(**one) for one in described]
        for server, play in zip(servers, plays):
            server.run(play)
        try:
            with saccade.connect([server.control.endpoint for server in servers], retry=POLICY) as client:
                yield client, servers
        finally:
            for server in servers:
                server.join()

    def expect_whole(self, stream):
        self.assertEqual([t // 1000 for events in stream for t in events.t.tolist()], list(range(20)))
        self.assertEqual((stream.suppressed, stream.losses), (20, saccade.Losses()))

    def test_a_stream_is_opened_where_there_is_most_room(self):
        for full, free in (({"streams": 32}, {"streams": 31}),  # the nearest limit counts
                           ({"streams": 1, "memory": 60}, {"streams": 30, "memory": 50}),
                           *[({"streams": 3, "memory": 50}, {"streams": 2, "memory": 50})] * 3):  # not by chance
            described = ({"limits": limits(**full)}, {"limits": limits(**free)})
            with self.subTest(full), self.client(tell_only, give_whole, described=described) as (client, servers):
                with client.open(**SETTINGS) as stream:
                    self.assertEqual(stream.address, servers[1].control.endpoint)
                    self.expect_whole(stream)

    def test_a_server_that_has_no_room_is_passed_over(self):
        def refuse(server):
            tell(server)
            request = server.control.receive(control_pb2.Request)
            server.refuse(request, control_pb2.CODE_RESOURCE_EXHAUSTED, limit="cpu", message="limit cpu: none is left")
        described = ({"limits": limits(streams=0)}, {"limits": limits(streams=9)})
        with self.client(refuse, give_whole, described=described) as (client, _), client.open(**SETTINGS) as stream:
            self.expect_whole(stream)
        with self.client(refuse, refuse) as (client, _), self.assertRaisesRegex(saccade.LimitExceeded, "none is left"):
            client.open(**SETTINGS)

    def test_a_request_that_is_wrong_is_not_asked_again(self):
        def refuse(server):
            tell(server)
            server.refuse(server.control.receive(control_pb2.Request), control_pb2.CODE_NOT_FOUND, field="scene")
        described = ({"limits": limits(streams=0)}, {"limits": limits(streams=9)})
        with self.client(refuse, tell_only, described=described) as (client, _), self.assertRaises(saccade.NotFound):
            client.open(**SETTINGS)

    def lose(self, second, first=give_half, described=None, **settings):
        """Events of a stream that is opened on the first server, which then falls silent."""
        described = described or ({"limits": limits(streams=0)}, {"limits": limits(streams=9)})

        def tell_and_play(server):
            tell(server)
            second(server)
        with self.client(first, tell_and_play, described=described) as (client, servers):
            with client.open(**{**SETTINGS, **settings}) as stream:
                self.assertEqual(stream.address, servers[0].control.endpoint)
                self.expect_whole(stream)
                self.assertEqual(stream.address, servers[1].control.endpoint)

    def test_a_stream_of_a_lost_server_goes_on_at_another(self):
        def go_on(server):
            self.assertEqual(server.open("s2").sensors[0].from_event, 10)
            self.assertEqual(server.attached().stream_id, "s2")
            server.send(packets_of("s2")[2:])
        with self.assertLogs("saccade") as logged:
            self.lose(go_on)
        self.assertRegex(logged.output[-1], "the stream was opened again at tcp://")

    def test_a_server_that_refuses_connections_is_not_waited_for(self):
        def go_on(server):
            server.open("s2")
            server.attached()
            server.send(packets_of("s2")[2:])
        with unittest.mock.patch("saccade.protocol.handle.StreamHandle.info") as info:
            self.lose(go_on, first=give_half_and_end)
        info.assert_not_called()

    def test_which_endpoints_refuse_connections(self):
        server = FakeServer()
        for network in (BlockingNetwork(), AsyncNetwork()):
            for endpoint, refuses in (("tcp://127.0.0.1:1", True), ("tcp://localhost:1", True), ("ipc:///tmp/a", False),
                                      ("tcp://name.invalid:1", False), (server.control.endpoint, False)):
                with self.subTest(endpoint):
                    self.assertEqual(asyncio.run(network.refuses(endpoint)), refuses)
        server.run(lambda _: None)
        server.join()

    def test_a_stream_that_a_stopping_server_ended_goes_on_at_another(self):
        def drain(server):
            server.open("s1")
            server.attached()
            server.send(packets_of("s1", 8, 4))
            tell(server)
            close = server.control.receive(control_pb2.Request)
            self.assertEqual(close.close_stream.stream_id, "s1")
            request = server.control.receive(control_pb2.Request)
            server.refuse(request, control_pb2.CODE_UNAVAILABLE, message="the server is stopping")

        def go_on(server):
            self.assertEqual(server.open("s2").sensors[0].from_event, 8)
            server.attached()
            server.send(packets_of("s2")[1:])
        self.lose(go_on, first=drain)

    def test_a_server_of_another_kind_is_refused_by_name(self):
        def tell_often(server):
            while server.control.socket.poll(1200):
                tell(server)
        for first, second, text in ((("1", "avx512"), ("1", "avx2"), "is saccaded 1 with avx2, and .* 1 with avx512"),
                                    (("2", "avx2"), ("3", "avx2"), "is saccaded 3 with avx2, and .* 2 with avx2")):
            described = [{"version": version, "instruction_set": instructions, "limits": limits(streams=i)}
                         for i, (version, instructions) in enumerate((first, second))]
            with self.subTest(text), self.assertRaisesRegex(saccade.Unavailable, text):
                self.lose(tell_often, described=described)

    def test_a_live_stream_stays_with_its_server(self):
        with self.assertRaisesRegex(saccade.StreamFault, "the connection to the server is lost"):
            self.lose(lambda server: None, delivery="live")

    def test_the_form_for_asyncio_is_the_same(self):
        def go_on(server):
            tell(server)
            server.open("s2")
            server.attached()
            server.send(packets_of("s2")[2:])

        async def receive(addresses):
            async with saccade.aio.connect(addresses, retry=POLICY) as client:
                async with await client.open(**SETTINGS) as stream:
                    return [t // 1000 async for events in stream for t in events.t.tolist()]
        described = ({"limits": limits(streams=0)}, {"limits": limits(streams=9)})
        with self.client(give_half, go_on, described=described) as (_, servers):
            times = asyncio.run(receive([server.control.endpoint for server in servers]))
        self.assertEqual(times, list(range(20)))


class Addresses(unittest.TestCase):
    def endpoints(self, address=None):
        servers = make_servers(BlockingNetwork(), address, None, None)
        try:
            return run(servers.endpoints())
        finally:
            servers.close()

    def test_a_list_and_a_text_with_commas_are_the_same(self):
        two = ["tcp://127.0.0.1:1", "tcp://127.0.0.1:2"]
        self.assertEqual(self.endpoints(two), two)
        self.assertEqual(self.endpoints(two * 2), two)
        self.assertEqual(self.endpoints(", ".join(two)), two)
        with unittest.mock.patch.dict(os.environ, SACCADE_SERVER=",".join(two)):
            self.assertEqual(self.endpoints(), two)
        for wrong in (5, [5], [two[0], None]):
            with self.subTest(wrong), self.assertRaisesRegex(TypeError, "an address is a text such as"):
                self.endpoints(wrong)
        with self.assertRaisesRegex(ValueError, "'' is not an endpoint"):
            self.endpoints(two[0] + ",")

    def test_a_name_with_several_addresses_is_several_servers(self):
        found = [(2, 1, 6, "", (address, 0)) for address in ("10.0.0.2", "10.0.0.1", "10.0.0.2")]
        with unittest.mock.patch(LOOK_UP, return_value=found) as look_up:
            self.assertEqual(self.endpoints("tcp://farm.test:7"), ["tcp://10.0.0.1:7", "tcp://10.0.0.2:7"])
            self.assertEqual(look_up.call_args.args[0], "farm.test")
        with unittest.mock.patch(LOOK_UP, return_value=found[:1]):  # the library looks it up again when it connects
            self.assertEqual(self.endpoints("tcp://farm.test:7"), ["tcp://farm.test:7"])
        with unittest.mock.patch(LOOK_UP) as look_up:
            for plain in ("tcp://10.0.0.1:7", "tcp://[::1]:7", "ipc:///tmp/a.sock"):
                self.assertEqual(self.endpoints(plain), [plain])
            look_up.assert_not_called()

    def test_servers_that_come_later_are_found(self):
        found = [(2, 1, 6, "", (f"10.0.0.{i}", 0)) for i in range(3)]
        servers = make_servers(BlockingNetwork(), "tcp://farm.test:7", None, None)
        self.addCleanup(servers.close)
        with unittest.mock.patch("saccade.protocol.servers.KNOWN_S", 0), unittest.mock.patch(LOOK_UP) as look_up:
            for answer, count in ((found[:1], 1), (found, 3), (OSError, 3), (found[:2], 2)):
                look_up.side_effect = [answer]
                self.assertEqual(len(run(servers.endpoints())), count)

    def test_asyncio_looks_names_up_too(self):
        self.assertEqual(asyncio.run(AsyncNetwork().resolve("tcp://localhost:7")), ["tcp://localhost:7"])
        self.assertEqual(asyncio.run(AsyncNetwork().resolve("tcp://name.invalid:7")), [])


if __name__ == "__main__":
    unittest.main()
