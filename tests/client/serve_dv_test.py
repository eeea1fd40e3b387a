"""`saccade serve-dv`, read by a client that is written from the protocol of dv-processing."""
import importlib.util
import itertools
import pathlib
import re
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

SACCADE, SACCADED = sys.argv[1:3]
MISSING = [name for name in ("flatbuffers", "lz4", "numpy", "zstandard") if importlib.util.find_spec(name) is None]
if not MISSING:
    import aedat4

FREE = "tcp://127.0.0.1:*"
SCENE = ["cornell-box", "--motion", "pan:20", "--size", "32x24"]


class Camera:
    """A port of serve-dv, as NetworkReader of dv-processing sees it."""

    def __init__(self, host, port, receive_buffer=None):
        self.socket = socket.socket()
        if receive_buffer:
            self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_buffer)
        self.socket.settimeout(60)
        self.socket.connect((host, int(port)))

    def take(self, size):
        """So many bytes, or fewer at the end."""
        data = b""
        while len(data) < size and (part := self.socket.recv(size - len(data))):
            data += part
        return data

    def read_header(self):
        size = self.take(4)
        self.compression, position, info, _ = aedat4.read_header(size + self.take(*struct.unpack("<I", size)))
        assert position == -1, position
        self.stream, self.info = aedat4.check_info(info, "/outInfo/")

    def packets(self):
        while head := self.take(8):
            stream, size = struct.unpack("<ii", head)
            assert stream == 0, stream
            body = self.take(size)
            assert len(body) == size, "the last packet is cut off"
            events = aedat4.read_events(aedat4.unpack(body, self.compression))
            assert len(events) > 0, "a packet is empty"
            yield events

    def events(self):
        return [(t, x, y, int(on)) for events in self.packets() for t, x, y, on, _ in events.tolist()]


class ServeDv(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.daemon = subprocess.Popen(
            [SACCADED, "--control", FREE, "--data", FREE, "--broadcast", FREE, "--http", "off"],
            stdout=subprocess.PIPE, text=True)
        self.addCleanup(self.end, self.daemon, signal.SIGTERM)
        ready = next(filter(None, (re.search(r"ready: control (\S+)", line) for line in self.daemon.stdout)))
        self.control = ["--control", ready[1]]

    def end(self, process, number):
        process.send_signal(number)
        told = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 0, told)
        return told

    def camera(self, host, port, receive_buffer=None):
        camera = Camera(host, port, receive_buffer)
        self.addCleanup(camera.socket.close)
        return camera

    def serve(self, *options, sensors=1):
        """The process, and host and port of each sensor."""
        process = subprocess.Popen([SACCADE, "serve-dv", *SCENE, *options, *self.control], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        found = filter(None, (re.match(r"sensor \d+: (\S+):(\d+)$", line) for line in process.stdout))
        return process, [match.groups() for match in itertools.islice(found, sensors)]

    def test_each_port_is_a_camera_with_the_events_that_record_writes(self):
        request = ["--rate", "200", "--duration", "1", "--threshold", "0.05,0.1"]
        subprocess.run([SACCADE, "record", *SCENE, *request, *self.control, "-o", self.folder / "a.csv"],
                       capture_output=True, check=True)
        process, ports = self.serve(*request, "--listen", "127.0.0.1:0", "--epoch", "1000", sensors=2)
        cameras = [self.camera(*port) for port in ports]
        for sensor, camera in enumerate(cameras):
            camera.read_header()
            self.assertEqual(camera.compression, aedat4.NONE)
            self.assertEqual(camera.stream["compression"], ("string", "NONE"))
            self.assertEqual(camera.info["source"][1], f"Saccade_{sensor:08}")
            self.assertEqual((camera.info["sizeX"][1], camera.info["sizeY"][1]), ("32", "24"))
        for sensor, camera in enumerate(cameras):
            lines = (self.folder / f"a-{sensor}.csv").read_text().splitlines()[1:]
            recorded = [tuple(map(int, line.split(","))) for line in lines]
            events = [(t - 1000, x, y, p) for t, x, y, p in camera.events()]
            self.assertGreater(len(events), 100)
            last = recorded[-len(events):]  # the camera may have come after the first packets
            self.assertTrue(events == last, f"{events[:2]} and more are not {last[:2]} and more")
        self.assertEqual(process.wait(60), 0)

    def test_beyond_this_machine_packets_are_compressed_and_times_are_those_of_the_clock(self):
        process, [(_, port)] = self.serve("--rate", "200", "--listen", "0.0.0.0:0")
        camera = self.camera("127.0.0.1", port)
        camera.read_header()
        self.assertEqual(camera.compression, aedat4.LZ4)
        first = next(camera.packets())["t"][0]
        self.assertLess(abs(first / 1e6 - time.time()), 60)
        self.end(process, signal.SIGINT)

    def test_a_slow_viewer_is_cut_and_one_that_leaves_delays_nobody(self):
        process, [port] = self.serve("--threshold", "0.005", "--rate", "200", "--listen", "127.0.0.1:0",
                                     "--backlog", "1")
        stalled, leaving, watching = (self.camera(*port, buffer) for buffer in (4096, None, None))
        leaving.read_header()
        leaving.socket.close()
        watching.read_header()
        told, after_cut = [], threading.Event()
        reader = threading.Thread(target=lambda: told.extend(self.lines_until_cut(process.stderr, after_cut)))
        reader.start()
        packets = watching.packets()
        before = sum(1 for _ in itertools.takewhile(lambda _: not after_cut.is_set(), packets))
        self.assertGreater(before, 0)
        self.assertEqual(len(list(itertools.islice(packets, 20))), 20)
        reader.join()
        self.assertEqual(sum(" watches 127.0.0.1:" in line for line in told), 3, told)
        self.assertEqual(sum(" has left; " in line for line in told), 1, told)
        self.assertRegex(told[-1], r"cut: \d+ events were sent to it, [1-9]\d* more waited in \d{7} bytes$")
        self.assertNotIn(" is cut: ", self.end(process, signal.SIGINT))

    def lines_until_cut(self, lines, seen):
        for line in lines:
            yield line
            if " was too slow and is cut: " in line:
                seen.set()
                return

    def test_a_server_that_stops_is_a_failure_after_whole_packets(self):
        process, [port] = self.serve("--rate", "200", "--listen", "127.0.0.1:0")
        camera = self.camera(*port)
        camera.read_header()
        packets = camera.packets()
        next(packets)
        self.daemon.send_signal(signal.SIGTERM)
        for _ in packets:
            pass
        told = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 1, told)
        self.assertIn("saccade: the server has stopped and ended the stream at frame", told)
        self.daemon.wait(60)  # a second signal would end it at once

    def test_wrong_usage_is_named(self):
        taken = socket.create_server(("127.0.0.1", 0))
        self.addCleanup(taken.close)
        for listen, reason in [("7777", "is not ADDRESS:PORT"), (":7777", "is not ADDRESS:PORT"),
                               ("127.0.0.1:70000", "is not ADDRESS:PORT"), ("::1:7777", "is not ADDRESS:PORT"),
                               ("127.0.0.1:65535", "sensor 1 would have port 65536"),
                               (f"127.0.0.1:{taken.getsockname()[1]}", "cannot be used: Address already in use")]:
            done = subprocess.run([SACCADE, "serve-dv", *SCENE, "--threshold", "1,2", "--listen", listen, *self.control],
                                  capture_output=True, text=True, timeout=60, check=False)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, f"^saccade: --listen: .*{reason}")


if __name__ == "__main__":
    if MISSING:
        print("skipped: this Python has no", ", ".join(MISSING))
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
