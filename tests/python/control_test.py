"""Requests to a control socket that a test plays: replies, refusals and silence."""
import pickle
import unittest

import saccade
from fake_server import FakeServer
from saccade.v1 import control_pb2


class Control(unittest.TestCase):
    def ask(self, script, call):
        server = FakeServer()
        server.run(script)
        try:
            with saccade.connect(server.control.endpoint) as client:
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

    def test_what_is_no_reply_is_told(self):
        for parts, text in (((b"a", b"b"), "not a control socket"), ((b"\xff",), "cannot be read")):
            def script(server, parts=parts):
                server.control.receive(control_pb2.Request)
                server.control.send(*parts)
            with self.subTest(text), self.assertRaisesRegex(saccade.SaccadeError, text):
                self.ask(script, saccade.Client.info)

    def test_a_silent_server_is_told(self):
        with self.assertRaisesRegex(saccade.NoAnswer, "no saccaded answers at tcp://127.0.0.1") as caught:
            self.ask(lambda server: server.control.receive(control_pb2.Request), saccade.Client.info)
        self.assertTrue(caught.exception.endpoint.startswith("tcp://127.0.0.1"))

    def test_a_malformed_address_is_told(self):
        with self.assertRaisesRegex(ValueError, "'render7' is not an endpoint"):
            saccade.connect("render7")


if __name__ == "__main__":
    unittest.main()
