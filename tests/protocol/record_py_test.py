"""The example client of the README, run as it stands against the server program."""
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


class RecordPy(unittest.TestCase):
    def setUp(self):
        free = "tcp://127.0.0.1:*"
        self.server = subprocess.Popen(
            [SACCADED, "--control", free, "--data", free, "--broadcast", free, "--http", "off", "--threads", "1"],
            stdout=subprocess.PIPE, text=True)
        self.ports = self.awaitLine(r"ready: control \S+:(\d+) data \S+:(\d+)").groups()

    def tearDown(self):
        self.server.terminate()
        self.server.communicate(timeout=60)
        self.assertEqual(self.server.returncode, 0)

    def awaitLine(self, pattern):
        return next(filter(None, (re.search(pattern, line) for line in self.server.stdout)))

    def test_it_records_a_stream_to_its_end(self):
        with tempfile.TemporaryDirectory() as folder:
            schema = [str(p) for p in sorted((ROOT / "proto/saccade/v1").glob("*.proto"))]
            subprocess.run([PROTOC, f"--python_out={folder}", "-I", str(ROOT / "proto"), *schema], check=True)
            done = subprocess.run([sys.executable, str(ROOT / "client/python/record.py"), *self.ports],
                                  env={**os.environ, "PYTHONPATH": folder}, capture_output=True, text=True,
                                  timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        told = sum(int(re.match(r"(\d+) events from", line)[1]) for line in done.stdout.splitlines())
        self.assertEqual(told, int(self.awaitLine(r"ended after 50 frames: (\d+) events")[1]))
        self.assertGreater(told, 0)


class Source(unittest.TestCase):
    def test_it_has_fifteen_lines_of_code(self):
        code = [line for line in (ROOT / "client/python/record.py").read_text().splitlines()
                if line.strip() and not line.strip().startswith("#")]
        self.assertLessEqual(len(code), 15)


if __name__ == "__main__":
    if MISSING:
        print("skipped: this Python has no", ", ".join(MISSING))
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
