"""The example client in Python, run as it is against the server program."""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT, SACCADED, PROTOC = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
MISSING = [name for name in ("zmq", "numpy", "google") if importlib.util.find_spec(name) is None]


class BareClient(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        schema = [str(p) for p in sorted((ROOT / "proto/saccade/v1").glob("*.proto"))]
        subprocess.run([PROTOC, f"--python_out={self.folder}", "-I", str(ROOT / "proto"), *schema], check=True)

    def start(self, *flags):
        free = "tcp://127.0.0.1:*"
        self.server = subprocess.Popen(
            [SACCADED, "--control", free, "--data", free, "--broadcast", free, "--http", "off", "--threads", "1", *flags],
            stdout=subprocess.PIPE, text=True)
        self.addCleanup(self.stop)
        self.ports = self.awaitLine(r"ready: control \S+:(\d+) data \S+:(\d+)").groups()

    def stop(self):
        self.server.terminate()
        self.server.communicate(timeout=60)
        self.assertEqual(self.server.returncode, 0)

    def awaitLine(self, pattern):
        return next(filter(None, (re.search(pattern, line) for line in self.server.stdout)))

    def record(self, *keys, timeout=120):
        return subprocess.run([sys.executable, str(ROOT / "client/python/examples/bare_client.py"), *self.ports, *keys],
                              env={**os.environ, "PYTHONPATH": str(self.folder)}, capture_output=True, text=True,
                              timeout=timeout, check=False)

    def expectAll(self, done):
        self.assertEqual(done.returncode, 0, done.stderr)
        told = sum(int(re.match(r"(\d+) events from", line)[1]) for line in done.stdout.splitlines())
        self.assertEqual(told, int(self.awaitLine(r"ended after 50 frames: (\d+) events")[1]))
        self.assertGreater(told, 0)

    def test_it_records_a_stream_to_its_end(self):
        self.start()
        self.expectAll(self.record())

    def test_it_has_keys_for_a_server_that_wants_them(self):
        import zmq
        for name in ("server", "alice"):
            public, secret = zmq.curve_keypair()
            (self.folder / f"{name}.pub").write_bytes(public + b"\n")
            (self.folder / f"{name}.key").write_bytes(secret + b"\n")
        self.start("--secret-key", self.folder / "server.key", "--client-keys", self.folder / "alice.pub")
        self.expectAll(self.record(self.folder / "alice.key", self.folder / "server.pub"))
        self.expectFault(self.record(), "no reply from port " + self.ports[0])

    def expectFault(self, done, text):
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn(text, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_swapped_ports_are_told(self):
        self.start()
        self.ports = self.ports[::-1]
        self.expectFault(self.record(), "are the two ports swapped?")

    def test_a_wrong_data_port_is_told(self):
        self.start()
        self.ports = (self.ports[0], "1")
        self.expectFault(self.record(), "no packet from port 1")

    def test_missing_modules_are_named(self):
        self.start()
        (self.folder / "numpy.py").write_text("raise ImportError('no numpy')")
        self.expectFault(self.record(), "no numpy: see the head of this file")


if __name__ == "__main__":
    if MISSING:
        print("skipped: this Python has no", ", ".join(MISSING))
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
