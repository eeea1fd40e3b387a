"""The programs saccaded and saccade, for tests."""
import os
import re
import subprocess
import threading

FREE = ["tcp://127.0.0.1:0"] * 3


class Server:
    """saccaded on free ports of loopback, with one thread unless told. A context manager that stops it.

    It takes every PACED stream, however slow the machine is.
    """

    def __init__(self, *flags, endpoints=FREE, threads=1):
        sockets = [word for pair in zip(("--control", "--data", "--broadcast"), endpoints) for word in pair]
        command = [os.environ["SACCADED"], *sockets, "--http", "off", "--threads", str(threads),
                   "--limit-cpu", "0", *flags]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        ready = next(filter(None, (re.search(r"ready: control (\S+) data (\S+) broadcast (\S+)", line)
                                   for line in self.process.stdout)), None)
        if ready is None:
            raise RuntimeError("saccaded did not start")
        self.log = threading.Thread(target=self.process.stdout.read)  # to its end, so that no write blocks
        self.log.start()
        self.endpoints = ready.groups()
        self.address = self.endpoints[0]

    def stop(self):
        self._end(self.process.terminate)

    def kill(self):
        self._end(self.process.kill)

    def _end(self, how):
        how()
        self.process.wait(timeout=60)
        self.log.join()
        self.process.stdout.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()


def record(server, path, *options):
    """Runs `saccade record`, the client in C++. Returns what it did."""
    command = [os.environ["SACCADE"], "record", "cornell-box", "--control", server.address, "-o", str(path), *options]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
