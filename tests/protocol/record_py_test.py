"""The example client of the README, run as it stands against the server program."""
import importlib.util
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
            [SACCADED, "--control", free, "--data", free, "--broadcast", free, "--threads", "1"],
            stdout=subprocess.PIPE, text=True)
        self.control = next(m[1] for m in (re.search(r"ready: control (\S+)", line)
                                           for line in self.server.stdout) if m)

    def tearDown(self):
        self.server.terminate()
        self.server.communicate(timeout=60)
        self.assertEqual(self.server.returncode, 0)

    def test_it_records_a_stream_to_its_end(self):
        with tempfile.TemporaryDirectory() as folder:
            schema = [str(p) for p in sorted((ROOT / "proto/saccade/v1").glob("*.proto"))]
            subprocess.run([PROTOC, f"--python_out={folder}", "-I", str(ROOT / "proto"), *schema], check=True)
            done = subprocess.run([sys.executable, str(ROOT / "client/python/record.py"), self.control],
                                  cwd=folder, capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        *batches, last = done.stdout.splitlines()
        told = sum(int(re.match(r"(\d+) events from", line)[1]) for line in batches)
        self.assertEqual(last, f"{told} events in 0.1 s")
        self.assertGreater(told, 0)


if __name__ == "__main__":
    if MISSING:
        print("skipped: this Python has no", ", ".join(MISSING))
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
