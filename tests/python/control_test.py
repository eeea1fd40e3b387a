"""Requests to a control socket that a test plays: replies, refusals and silence."""
import pickle
import unittest

import saccade
from fake_server import FakeServer
from saccade.protocol.control import MOST_UNKNOWN
from saccade.v1 import control_pb2


class Control(unittest.TestCase):
    def ask(self, script, call):
        server = FakeServer()
        server.run(script)
        try:
            with saccade.connect(server.control.endpoint, retry=saccade.RetryPolicy(retry_time_s=0)) as client:
                return call(client)
        finally:
            server.join()

    def test_a_refusal_carries_what_the_server_says(self):
        def script(server):
            request = server.control.receive(control_pb2.Request)
            status = control_pb2.Status(code=control_pb2.CODE_RESOURCE_EXHAUSTED, message="64 streams are open",
                                        field="sensors", limit="streams", retry_after_s=2.5)
            server.control.send(control_pb2.Reply(request_id=request.request_id, status=status).SerializeToString())
        with self.assertRaises(saccade.LimitExceeded) as caught:
            self.ask(script, saccade.Client.scenes)
        refused = caught.exception
        self.assertEqual((refused.code, refused.field, refused.message, refused.limit, refused.retry_after_s),
                         ("CODE_RESOURCE_EXHAUSTED", "sensors", "64 streams are open", "streams", 2.5))
        self.assertEqual(str(refused), "sensors: 64 streams are open (try again in 2.5 s)")
        again = pickle.loads(pickle.dumps(refused))
        self.assertEqual((type(again), str(again), again.limit), (saccade.LimitExceeded, str(refused), "streams"))

    def test_late_replies_to_other_requests_are_left_out(self):
        def script(server):
            request = server.control.receive(control_pb2.Request)
            server.control.send(control_pb2.Reply(request_id=99).SerializeToString())
            server.answer(request, server_info=control_pb2.ServerDescription(version="7"))
        self.assertEqual(self.ask(script, saccade.Client.info).version, "7")

    def test_what_a_server_does_while_it_opens_a_stream_is_logged(self):
        def script(server):
            server.answer(server.control.receive(control_pb2.Request), server_info=control_pb2.ServerDescription())
            open_stream = server.control.receive(control_pb2.Request)
            question = server.control.receive(control_pb2.Request)
            self.assertEqual(question.WhichOneof("call"), "list_streams")
            opening = [control_pb2.OpeningInfo(request_id=id, scene="room", doing="computing light ahead", done=0.34)
                       for id in (open_stream.request_id + 100, open_stream.request_id)]
            server.answer(question, list_streams=control_pb2.StreamList(opening=opening))
            status = control_pb2.Status(code=control_pb2.CODE_NOT_FOUND)
            server.control.send(control_pb2.Reply(request_id=open_stream.request_id, status=status).SerializeToString())
        with self.assertLogs("saccade") as logged, self.assertRaises(saccade.NotFound):
            self.ask(script, lambda client: client.open_request(control_pb2.OpenStream()))
        self.assertEqual(logged.output, ["WARNING:saccade:opening room: computing light ahead: 34 %"])

    def test_what_is_no_reply_is_told(self):
        for parts, text in (((b"a", b"b"), "not a control socket"), ((b"\xff",), "cannot be read")):
            def script(server, parts=parts):
                server.control.receive(control_pb2.Request)
                server.control.send(*parts)
            with self.subTest(text), self.assertRaisesRegex(saccade.SaccadeError, text):
                self.ask(script, saccade.Client.info)

    def test_a_refusal_without_words_is_told(self):
        for code, text in ((99, "refused with status 99"), (0, "refused with status 0")):
            def script(server, code=code):
                request = server.control.receive(control_pb2.Request)
                reply = control_pb2.Reply(request_id=request.request_id, status=control_pb2.Status(code=code))
                server.control.send(reply.SerializeToString())
            with self.subTest(text), self.assertRaisesRegex(saccade.Refused, f"^{text}, without a reason$") as caught:
                self.ask(script, saccade.Client.scenes)
            self.assertEqual(caught.exception.code, "CODE_99" if code == 99 else "CODE_UNSPECIFIED")

    def test_a_reply_without_a_result_is_told(self):
        for result in ({}, {"list_streams": control_pb2.StreamList()}):
            def script(server, result=result):
                server.answer(server.control.receive(control_pb2.Request), **result)
            with self.subTest(result), self.assertRaisesRegex(saccade.SaccadeError, "without the result of the call"):
                self.ask(script, saccade.Client.info)

    def test_a_server_that_no_longer_knows_the_opening_is_told(self):
        def script(server):
            server.answer(server.control.receive(control_pb2.Request), server_info=control_pb2.ServerDescription())
            server.control.receive(control_pb2.Request)
            for _ in range(MOST_UNKNOWN):
                server.answer(server.control.receive(control_pb2.Request), list_streams=control_pb2.StreamList())
        with self.assertRaisesRegex(saccade.Unavailable, "has restarted"):
            self.ask(script, lambda client: client.open_request(control_pb2.OpenStream()))

    def test_a_silent_server_is_told(self):
        with self.assertRaisesRegex(saccade.NoAnswer, "no saccaded answers at tcp://127.0.0.1") as caught:
            self.ask(lambda server: server.control.receive(control_pb2.Request), saccade.Client.info)
        self.assertTrue(caught.exception.endpoint.startswith("tcp://127.0.0.1"))

    def test_a_malformed_address_is_told(self):
        with self.assertRaisesRegex(ValueError, "'render7' is not an endpoint"):
            saccade.connect("render7")


if __name__ == "__main__":
    unittest.main()
