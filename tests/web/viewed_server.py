"""A saccaded of the tests on free ports, and one WebSocket of its viewer."""
import json
import re
import subprocess
import unittest

FREE = "tcp://127.0.0.1:0"


class ViewedServer:
    """The program with further flags. `url`: of its viewer, "off" if it has none."""

    def __init__(self, program, *flags, tcp=FREE, http="http://127.0.0.1:0"):
        self.process = subprocess.Popen(
            [program, "--control", tcp, "--data", tcp, "--broadcast", tcp, "--http", http,
             *([] if "--limit-cpu" in flags else ["--limit-cpu", "0"]), *([] if "--threads" in flags else ["--threads", "1"]), *flags], stdout=subprocess.PIPE, text=True)
        ready = next(filter(None, (re.search(r"ready: control (\S+) .*http (\S+) viewer (\S+),", line)
                                   for line in self.process.stdout)), None)
        if ready is None:
            self.process.communicate()
            raise RuntimeError(f"saccaded ended with {self.process.returncode}")
        self.control, self.http, self.url = ready.groups()

    def stop(self):
        """Returns the exit status."""
        self.process.terminate()
        self.process.communicate(timeout=60)
        return self.process.returncode


class Page:
    """What a page does on its WebSocket."""

    def __init__(self, server, origin=None, **options):
        import websocket
        url = server.http.replace("http://", "ws://") + "/viewer"
        self.socket = websocket.create_connection(url, origin=origin or server.http, timeout=20, **options)
        self.packets = []

    def send(self, message):
        self.socket.send(json.dumps(message))

    def reply(self):
        """The next reply; packets before it are kept."""
        while True:
            opcode, data = self.socket.recv_data()
            if opcode == 1:
                return json.loads(data)
            if opcode != 2:
                raise ConnectionError("closed")
            self.packets.append(data)

    def packet(self):
        return self.packets.pop(0) if self.packets else self.socket.recv_data()[1]

    def call(self, name, **argument):
        """The whole reply to a call."""
        self.send({"request": {"requestId": "1", "protocolVersion": 1, name: argument}})
        return self.reply()

    def open(self, delivery="DELIVERY_LIVE", width=32, threshold=0.1, **options):
        """Opens a small stream without end; options are those of its timing. Returns StreamOpened."""
        reply = self.call("openStream", scene="cornell-box", view={"width": width, "height": width * 3 // 4},
                         trajectory={"name": "right"}, timing={"frameRateHz": 500, "clock": "CLOCK_PACED", **options},
                         sensors=[{"threshold": threshold}], delivery=delivery)
        if reply["status"].get("field") == "delivery":  # the system's libzmq has no broadcasts
            raise unittest.SkipTest(reply["status"]["message"])
        return reply["openStream"]

    def streams(self):
        """Ids of all streams of the server."""
        return [stream["streamId"] for stream in self.call("listStreams")["listStreams"]["streams"]]

    def attach(self, stream):
        self.send({"attach": {"streamId": stream["streamId"], "token": stream["token"]}})
