"""Streams whose connection and server come and go as a test says."""
import asyncio
import logging
import unittest

import saccade
import saccade.aio
from fake_server import MS, FakeServer, packet, packets_of, payload_of
from saccade.protocol.connection import CREDIT, Connection
from saccade.protocol.network import run
from saccade.protocol.sequence import SequenceCheck
from saccade.v1 import control_pb2, events_pb2, truth_pb2

SETTINGS = {"scene": "room", "motion": "right", "size": (346, 260), "rate_hz": 1000, "delivery": "lossless"}
POLICY = saccade.RetryPolicy(retry_time_s=5, silence_s=0.4)


def send_error(server, text, stream=""):
    server.send([packet(stream, 0, 0, 0, 0, text.encode(), count=0, kind=events_pb2.KIND_ERROR)])


class Subscription(unittest.TestCase):
    def setUp(self):
        logging.getLogger("saccade").setLevel(logging.ERROR)

    def receive(self, script, policy=POLICY, frames_done=None, **settings):
        """Times in ms of all events of a stream, and the stream, while the server does `script`."""
        server = FakeServer(frames_done=frames_done)
        server.run(script)
        try:
            with saccade.connect(server.control.endpoint, retry=policy) as client:
                with client.open(**{**SETTINGS, **settings}) as stream:
                    times = [t // 1000 for events in stream for t in events.t.tolist()]
        finally:
            server.join()
        return times, stream

    def expect_whole(self, script, **settings):
        times, stream = self.receive(script, **settings)
        self.assertEqual(times, list(range(20)))
        self.assertEqual(stream.suppressed, 20)

    def test_a_stream_from_its_beginning_to_its_end(self):
        def script(server):
            request = server.open("s1")
            self.assertEqual((request.scene, request.delivery), ("room", control_pb2.DELIVERY_LOSSLESS))
            attach = server.attached()
            self.assertEqual((attach.stream_id, attach.token, list(attach.from_seqs)), ("s1", "t", [0]))
            self.assertEqual(server.data.receive(events_pb2.DataRequest).credit.bytes, CREDIT)
            server.send(packets_of("s1"))
            close = server.control.receive(control_pb2.Request).close_stream
            self.assertEqual((close.stream_id, close.token), ("s1", "t"))
        self.expect_whole(script)

    def test_used_credit_is_given_back_and_acknowledged(self):
        n, packets = 32768, 9

        def script(server):
            server.open("s1")
            server.attached()
            server.data.receive(events_pb2.DataRequest)
            payload = payload_of([0] * n, [0] * n, [0] * n, [0] * n)
            sent = [packet("s1", i, n * i, i * MS, (i + 1) * MS, payload) for i in range(packets)]
            server.send(sent)
            ack, credit = (server.data.receive(events_pb2.DataRequest) for _ in range(2))
            used = [header.ByteSize() + len(payload) for header, payload in sent]
            self.assertEqual(ack.ack.seq, 7)
            self.assertEqual(credit.credit.bytes, sum(used[:8]))
            end = packets * MS
            server.send([packet("s1", packets, n * packets, end, end, kind=events_pb2.KIND_END, frame=20)])
        with self.assertRaisesRegex(saccade.StreamFault, "ended the stream at frame 20"):  # after 9 of 20 frames
            self.receive(script)

    def test_after_silence_another_connection_goes_on(self):
        def script(server):
            server.open("s1")
            self.assertEqual(list(server.attached().from_seqs), [0])
            server.send(packets_of("s1")[:2])
            self.assertEqual(list(server.attached().from_seqs), [2])
            server.send(packets_of("s1")[1:])  # the first of them was under way already
        self.expect_whole(script)

    def test_a_server_that_knows_nothing_of_the_connection_is_asked_again(self):
        def script(server):
            server.open("s1")
            server.attached()
            server.send(packets_of("s1")[:2])
            send_error(server, "attach to a stream before giving credit")
            self.assertEqual(list(server.attached().from_seqs), [2])
            server.send(packets_of("s1")[2:])
        self.expect_whole(script)

    def test_a_lost_stream_is_opened_again_and_goes_on(self):
        def script(server):
            server.open("s1")
            server.attached()
            server.send(packets_of("s1")[:2])
            server.attached()  # and silence: the client asks for the stream, which is unknown
            self.assertEqual(server.open("s2").sensors[0].from_event, 10)
            self.assertEqual(server.attached().stream_id, "s2")
            server.send(packets_of("s2")[2:])
        self.expect_whole(script)

    def test_a_drained_stream_goes_on_within_its_last_packet(self):
        def script(server):
            server.open("s1")
            server.attached()
            server.send(packets_of("s1", 8, events_pb2.END_REASON_DRAINING))
            self.assertEqual(server.open("s2").sensors[0].from_event, 8)
            server.attached()
            server.send(packets_of("s2")[1:])  # the packet of 5 to 10 ms comes again, and longer
        self.expect_whole(script)

    def test_a_stream_that_comes_out_otherwise_is_a_fault(self):
        def script(server):
            server.open("s1")
            server.attached()
            server.send(packets_of("s1", 8, events_pb2.END_REASON_DRAINING))
            server.open("s2")
            server.attached()
            server.send(packets_of("s2")[3:])
        with self.assertRaisesRegex(saccade.StreamFault, "resume at event 8, not at 15"):
            self.receive(script)

    def test_no_retries_where_none_are_wanted(self):
        def script(server):
            server.open("s1")
            server.attached()
            server.send(packets_of("s1", 8, events_pb2.END_REASON_DRAINING))
        with self.assertRaisesRegex(saccade.StreamFault, "^the server has stopped and ended the stream at frame 8$"):
            self.receive(script, saccade.RetryPolicy(retry_time_s=0))

    def test_losses_of_live_are_counted_and_those_of_lossless_are_faults(self):
        def script(server):
            server.open("s1")
            server.attached()
            server.send(packets_of("s1")[:1] + packets_of("s1")[3:])
        times, stream = self.receive(script, delivery="live")
        self.assertEqual(times, [*range(5), *range(15, 20)])
        self.assertEqual(stream.losses, saccade.Losses(gaps=1, packets=2, events=10))
        with self.assertRaisesRegex(saccade.StreamFault, "LOSSLESS stream are missing"):
            self.receive(script)

    def test_missing_samples_of_truth_are_counted_apart(self):
        resolved = control_pb2.OpenStream(sensors=[control_pb2.Sensor()], truth=[truth_pb2.Truth()])
        check = SequenceCheck(resolved)
        for sensor, seq, first in ((0, 2, 70), (1, 3, 9)):
            check.add(events_pb2.PacketHeader(
                kind=events_pb2.KIND_TRUTH, sensor=sensor, seq=seq, first_event_index=first))
        self.assertEqual(check.losses, saccade.Losses(gaps=2, packets=5, events=70, samples=9))

    def test_losses_of_broadcast_are_counted(self):
        def script(server):
            server.open("s1")
            server.publish(packets_of("s1")[:1] + packets_of("s1")[2:4])
            server.list_streams(server.control.receive(control_pb2.Request))  # after silence; the socket stays
            server.publish(packets_of("s1")[4:])
        times, stream = self.receive(script, delivery="broadcast", frames_done=19)
        self.assertEqual(times, [*range(5), *range(10, 20)])
        self.assertEqual(stream.losses, saccade.Losses(gaps=1, packets=1, events=5))

    def test_a_lost_end_of_a_broadcast_is_told(self):
        def script(server):
            server.open("s1")
            server.publish(packets_of("s1")[:3])
            server.list_streams(server.control.receive(control_pb2.Request))
        with self.assertRaisesRegex(saccade.StreamFault, "the end of the stream was lost"):
            self.receive(script, delivery="broadcast", frames_done=20)

    def test_a_faulty_packet_is_never_used(self):
        def script(server):
            server.open("s1")
            server.attached()
            (header, payload), = packets_of("s1")[:1]
            server.send([(header, payload[:-1] + b"\2")])
        with self.assertRaisesRegex(saccade.PacketFault, "crc32"):
            self.receive(script)

    def test_packets_that_do_not_continue_are_a_fault(self):
        def script(server):
            server.open("s1")
            server.attached()
            server.send(packets_of("s1")[:1])
            server.send([packet("s1", 1, 6, 5 * MS, 6 * MS)])
        with self.assertRaisesRegex(saccade.StreamFault, "does not continue"):
            self.receive(script)

    def test_an_error_that_repeats_ends_the_stream(self):
        def script(server):
            for stream in ("s1", "s2"):
                server.open(stream)
                server.attached()
                send_error(server, "the scene has gone", stream)
            server.open("s3")
        with self.assertRaisesRegex(saccade.StreamFault, "^the scene has gone$"):
            self.receive(script)

    def test_any_number_of_restarts_is_survived(self):
        def script(server):
            for epoch in range(1, 5):
                server.open(f"s{epoch}", epoch)
                server.attached()
                send_error(server, "no stream of this name", f"s{epoch}")
            server.open("s5", 5)
            server.attached()
            server.send(packets_of("s5"))
        self.expect_whole(script)

    def test_a_server_that_never_comes_further_is_given_up(self):
        opened = []

        def script(server):
            while server.control.socket.poll(1500):  # silence of 0.4 s follows each time
                if server.answer_next(f"s{len(opened)}", epoch=len(opened)) is not None:
                    opened.append(True)
        with self.assertRaisesRegex(saccade.StreamFault, "the connection to the server is lost"):
            self.receive(script, saccade.RetryPolicy(retry_time_s=1, silence_s=0.4))
        self.assertGreater(len(opened), 1)

    def test_a_server_that_restarts_meanwhile_opens_the_stream_later(self):
        def script(server):
            for refused in ("server_info", "open_stream"):
                request = server.control.receive(control_pb2.Request)
                if refused == "open_stream":
                    server.answer(request, server_info=control_pb2.ServerDescription())
                    request = server.control.receive(control_pb2.Request)
                self.assertEqual(request.WhichOneof("call"), refused)
                status = control_pb2.Status(code=control_pb2.CODE_UNAVAILABLE, message="the server is stopping")
                reply = control_pb2.Reply(request_id=request.request_id, status=status)
                server.control.send(reply.SerializeToString())
            server.open("s1")
            server.attached()
            server.send(packets_of("s1"))
        self.expect_whole(script)

    def test_a_scene_that_cannot_be_opened_is_not_waited_for(self):
        def script(server):
            server.answer(server.control.receive(control_pb2.Request), server_info=control_pb2.ServerDescription())
            request = server.control.receive(control_pb2.Request)
            status = control_pb2.Status(code=control_pb2.CODE_UNAVAILABLE, message="is damaged", field="scene")
            server.control.send(control_pb2.Reply(request_id=request.request_id, status=status).SerializeToString())
        with self.assertRaisesRegex(saccade.Unavailable, "scene: is damaged"):
            self.receive(script)

    def test_replies_that_cannot_be_are_told(self):
        view = control_pb2.View(width=346, height=260)
        nowhere = control_pb2.View(fov_x_deg=40)
        nowhere.body_camera.rotation.SetInParent()  # all of it is 0
        lies = {
            "without stream_id": lambda o: o.ClearField("stream_id"),
            "0 sensors instead of 1": lambda o: o.resolved.ClearField("sensors"),
            "100001 sensors": lambda o: o.resolved.sensors.extend([control_pb2.Sensor()] * 100000),
            "1 truth instead of 0": lambda o: o.resolved.truth.add(name="depth"),
            "1 further_views": lambda o: o.resolved.further_views.append(view),
            "a channel of view 7 of 1": lambda o: setattr(o.resolved.sensors[0], "view", 7),
            "a view of 346x261": lambda o: setattr(o.resolved.view, "height", 261),
            "a field of view of nan degrees": lambda o: setattr(o.resolved.view, "fov_x_deg", float("nan")),
            "the quaternion has no length": lambda o: o.resolved.view.MergeFrom(nowhere),
            "frame_rate_hz is nan": lambda o: setattr(o.resolved.timing, "frame_rate_hz", float("nan")),
            "frame_rate_hz is 0": lambda o: setattr(o.resolved.timing, "frame_rate_hz", 0),
            "duration_s is inf": lambda o: setattr(o.resolved.timing, "duration_s", float("inf")),
            "delivery 99": lambda o: setattr(o.resolved, "delivery", 99),
            "delivery 0": lambda o: setattr(o.resolved, "delivery", 0),
        }
        for text, lie in lies.items():
            with self.subTest(text), self.assertRaisesRegex(saccade.StreamFault, text):
                self.receive(lambda server, lie=lie: server.open("s1", lie=lie))

    def test_an_endpoint_that_is_none_is_told(self):
        def script(server):
            server.data.endpoint = ""
            server.open("s1")
        with self.assertRaisesRegex(saccade.StreamFault, "announces an endpoint for packets that is none"):
            self.receive(script)

    def test_texts_of_a_server_command_no_terminal(self):
        def script(server):
            for stream in ("s1", "s2", "s3"):
                server.open(stream)
                if stream != "s3":
                    server.attached()
                    send_error(server, "gone\x1b[2J\n", stream)
        with self.assertLogs("saccade") as logged, self.assertRaises(saccade.StreamFault) as caught:
            self.receive(script)
        self.assertEqual(str(caught.exception), "gone\\u001b[2J\\n")
        self.assertFalse(any(ord(letter) < 32 for line in logged.output for letter in line))

    def test_what_is_sent_without_credit_is_a_fault(self):
        n, sent = 32768, []
        payload = payload_of([0] * n, [0] * n, [0] * n, [0] * n)

        class Flood:
            async def receive_waiting(self):
                header, body = packet("s1", len(sent), n * len(sent), 0, MS, payload)
                sent.append(len(body) + header.ByteSize())
                return [header.SerializeToString(), body]

            async def receive(self, timeout_s):
                return await self.receive_waiting()

        with self.assertRaisesRegex(saccade.PacketFault, "more than it has credit for"):
            run(Connection(Flood()).receive(1))
        self.assertLess(sum(sent[:-2]), CREDIT)  # the last but one may overdraw it
        self.assertGreaterEqual(sum(sent[:-1]), CREDIT)

    def test_heartbeats_without_end_take_no_memory(self):
        beats = [packet("s1", 0, 0, 0, t, kind=events_pb2.KIND_HEARTBEAT) for t in range(3000)]

        class Beats:
            async def receive_waiting(self):
                return [beats[0][0].SerializeToString(), beats.pop(0)[1]] if beats else None

            async def receive(self, timeout_s):
                return await self.receive_waiting()

        connection = Connection(Beats())
        received = []
        while (beat := run(connection.receive(0))) is not None:
            received.append(beat.header.t1_ns)
        self.assertEqual(received, [1024, 2049, 2999])

    def test_the_form_for_asyncio_is_the_same(self):
        def script(server):
            server.open("s1")
            server.attached()
            server.send(packets_of("s1")[:2])
            server.attached()
            server.send(packets_of("s1")[2:])

        async def receive(address):
            async with saccade.aio.connect(address, retry=POLICY) as client:
                async with await client.open(**SETTINGS) as stream:
                    return [t // 1000 async for events in stream for t in events.t.tolist()]
        server = FakeServer()
        server.run(script)
        times = asyncio.run(receive(server.control.endpoint))
        server.join()
        self.assertEqual(times, list(range(20)))


if __name__ == "__main__":
    unittest.main()
