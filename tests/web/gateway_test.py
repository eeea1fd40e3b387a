"""The WebSocket of the viewer among pages of other sites, too many pages, stalled ones and senders of nonsense.

Usage: gateway_test.py SACCADED SACCADE. Exit code 77: a module is absent."""
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.request

from viewed_server import Page, ViewedServer

SACCADED, SACCADE = sys.argv[1], sys.argv[2]
try:
    import websocket
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)

NONSENSE = ["", "{", "null", "[]", '"text"', "{}", '{"request": 3}', '{"request": {"requestId": "x"}}', '{"nothing": 1}',
            '{"attach": {"streamId": 7}}', '{"request": {"openStream": {"view": {"width": -1}}}}', "[" * 5000,
            '{"request":' * 2000, '{"subscribe": {"sensor": 1e99}}', "\0", '{"attach": {}, "subscribe": {}}']

DROPPED_BEFORE = re.compile(rb"\x65.{4}\x68", re.DOTALL)  # of PacketHeader: field 12, crc32, and the key of field 13


def wait_until(true, seconds=20):
    end = time.monotonic() + seconds
    while not true():
        if time.monotonic() > end:
            raise TimeoutError
        time.sleep(0.02)


def status_of_refusal(server, **options):
    """The status of HTTP with which the server refuses a page."""
    try:
        Page(server, **options).socket.close()
    except websocket.WebSocketBadStatusException as refusal:
        return refusal.status_code
    return 101


def closed(page, seconds):
    """Whether the server ends the connection of a page that has read nothing."""
    page.socket.sock.settimeout(seconds)
    try:
        while page.socket.sock.recv(1 << 16):
            pass
    except TimeoutError:
        return False
    except OSError:
        pass
    return True


def has_ipv6():
    try:
        with socket.socket(socket.AF_INET6) as probe:
            probe.bind(("::1", 0))
    except OSError:
        return False
    return True


class Gateway(unittest.TestCase):
    def serve(self, *flags, **options):
        server = ViewedServer(SACCADED, *flags, **options)
        self.addCleanup(lambda: self.assertEqual(server.stop(), 0))
        return server

    def page(self, server, **options):
        page = Page(server, **options)
        self.addCleanup(page.socket.close)
        return page

    def test_pages_of_other_sites_are_refused(self):
        server = self.serve()
        port = server.http.rsplit(":", 1)[1]
        self.assertEqual(status_of_refusal(server), 101)
        for origin in ("http://evil.example", f"http://evil.example:{port}", server.http + "0", "null"):
            self.assertEqual(status_of_refusal(server, origin=origin), 403, origin)
        # A name of another site that resolves to this machine.
        self.assertEqual(status_of_refusal(server, origin=f"http://evil.example:{port}", host=f"evil.example:{port}"), 403)
        self.assertEqual(status_of_refusal(server, origin=f"http://localhost:{port}", host=f"localhost:{port}"), 101)
        self.assertEqual(status_of_refusal(server, suppress_origin=True), 403)

    def test_one_viewer_too_many_is_refused_until_another_leaves(self):
        server = self.serve("--limit-viewers", "2")
        first, _ = self.page(server), self.page(server)
        with urllib.request.urlopen(server.http + "/metrics") as metrics:
            self.assertIn(b"\nsaccade_viewers 2\n", metrics.read())
        self.assertEqual(status_of_refusal(server), 503)
        with self.assertRaises(urllib.error.HTTPError) as refusal:
            urllib.request.urlopen(server.http + "/viewer")
        self.assertIn(b"limit viewers", refusal.exception.read())
        first.socket.close()
        wait_until(lambda: status_of_refusal(server) == 101)

    def test_every_address_of_loopback_has_a_viewer_and_clients(self):
        for host in ("localhost", "[::1]"):
            if host == "[::1]" and not has_ipv6():
                continue
            with self.subTest(host):
                server = self.serve(tcp=f"tcp://{host}:0", http=f"http://{host}:0")
                page = self.page(server)
                page.attach(page.open())
                self.assertGreater(len(page.packet()), 50)
                broadcast = page.open(delivery="DELIVERY_BROADCAST")
                page.send({"subscribe": {"streamId": broadcast["streamId"]}})
                while broadcast["streamId"].encode() not in page.packet():
                    pass
                control = f"tcp://{host}:{server.control.rsplit(':', 1)[1]}"
                done = subprocess.run([SACCADE, "info", "--control", control], capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_nonsense_is_answered_and_harms_nobody(self):
        server = self.serve()
        page = self.page(server)
        for text in NONSENSE:
            page.socket.send(text)
            self.assertNotEqual(page.reply()["status"]["code"], "CODE_OK", text)
        self.assertEqual(page.call("listStreams")["status"]["code"], "CODE_OK")

    def test_frames_that_are_none_end_their_connection_alone(self):
        server = self.serve()
        other = self.page(server)
        for send in (lambda p: p.socket.send_binary(b"x"), lambda p: p.socket.send("x" * 70000),
                     lambda p: p.socket.sock.sendall(b"\xff" * 1000), lambda p: p.socket.sock.sendall(b"\x81\x01x"),
                     lambda p: p.socket.send(b"\xff", websocket.ABNF.OPCODE_TEXT), lambda p: p.socket.sock.close()):
            page = Page(server)
            send(page)
            if page.socket.sock.fileno() >= 0:
                self.assertTrue(closed(page, 10))
                page.socket.sock.close()
        self.assertEqual(other.call("listStreams")["status"]["code"], "CODE_OK")

    def test_a_stalled_viewer_is_cut_while_another_goes_on(self):
        server = self.serve()
        good = self.page(server)
        good.attach(good.open())
        stalled = self.page(server, sockopt=[(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)])
        for _ in range(3):
            stalled.attach(stalled.open(width=256, threshold=0.01))
        begin, packets = time.monotonic(), 0
        while len(good.streams()) > 1:  # until the streams of the stalled viewer are closed
            good.packets.clear()
            good.packet()
            packets += 1
            self.assertLess(time.monotonic() - begin, 20)  # sooner than a silent one
        self.assertGreater(packets, 20)
        self.assertTrue(closed(stalled, 1))

    def test_a_slow_viewer_loses_packets_which_are_counted(self):
        server = self.serve("--limit-queue", "0.0625")
        slow = self.page(server, sockopt=[(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)])
        good = self.page(server)
        slow.attach(slow.open(width=256, threshold=0.01))
        questions = 0
        while good.call("listStreams")["listStreams"]["streams"][0]["droppedPackets"] == "0":
            questions += 1
            if questions % 500 == 0:
                slow.packet()  # so seldom that it is slow, and so often that it is not cut off
        while not DROPPED_BEFORE.search(slow.packet()[:120]):
            pass

    def test_requests_without_end_are_refused(self):
        page = self.page(self.serve())
        request = '{"request": {"requestId": "1", "protocolVersion": 1, "listScenes": {}}}'
        page.socket.sock.sendall(500 * websocket.ABNF.create_frame(request, websocket.ABNF.OPCODE_TEXT).format())
        codes = {page.reply()["status"]["code"] for _ in range(500)}
        self.assertEqual(codes, {"CODE_OK", "CODE_RESOURCE_EXHAUSTED"})

    def test_streams_end_with_their_page(self):
        server = self.serve()
        leaver, stayer = Page(server), self.page(server)
        leaver.attach(leaver.open())
        leaver.packet()
        leaver.socket.sock.close()  # without a word
        wait_until(lambda: not stayer.streams())

    def test_keys_admit_no_page_without_a_key_of_its_own(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("server", "viewer"):
                subprocess.run([SACCADE, "keygen", name], cwd=folder, check=True, capture_output=True)
            path = pathlib.Path(folder)
            keys = ["--secret-key", path / "server.key", "--client-keys", path / "viewer.pub"]
            closed_server = self.serve(*keys)
            self.assertEqual(closed_server.url, "off")
            self.assertEqual(status_of_refusal(closed_server), 404)
            page = self.page(self.serve(*keys, "--viewer-key", path / "viewer.key"))
            page.attach(page.open())
            self.assertGreater(len(page.packet()), 50)
            for wrong in (["--viewer", "on"], ["--viewer-key", path / "server.key"]):
                with self.assertRaises(RuntimeError):
                    ViewedServer(SACCADED, *keys, *wrong)

    def test_other_machines_are_served_only_if_asked(self):
        self.assertEqual(self.serve(http="http://0.0.0.0:0").url, "off")
        self.assertNotEqual(self.serve("--viewer", "on", http="http://0.0.0.0:0").url, "off")
        self.assertEqual(self.serve("--viewer", "off").url, "off")
        with self.assertRaises(RuntimeError):
            ViewedServer(SACCADED, "--viewer", "on", http="off")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
