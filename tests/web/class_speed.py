"""A class in front of a server: N pages of one link, opened together. Prints how soon they are live, and their pace.

Usage: class_speed.py SACCADED [PAGES [SECONDS [SIZE [SPEED]]]]. The pages are WebSockets, not browsers: they ask for the
stream and for pictures as a page does, and draw nothing."""
import json
import os
import statistics
import sys
import threading
import time

from viewed_server import Page, ViewedServer

PICTURE_S = 0.25  # between two pictures
PATIENCE_S = 40  # for all pages to be live
SLOWEST = 1 / 256
program, pages, seconds, size, speed = (sys.argv[1:] + ["30", "15", "160x120", "0.25"][len(sys.argv) - 2:])
pages, seconds = int(pages), float(seconds)
WIDTH, HEIGHT = map(int, size.split("x"))
REQUEST = {"scene": "cornell-box", "view": {"width": WIDTH, "height": HEIGHT},
           "trajectory": {"motion": {"kind": "MOTION_KIND_PAN", "pxPerFrame": 0.5}},
           "timing": {"frameRateHz": 200, "clock": "CLOCK_PACED", "speed": float(speed), "minSpeed": SLOWEST},
           "sensors": [{"threshold": 0.2, "bias": 0.001}], "delivery": "DELIVERY_LIVE"}


def fields(frame):
    """The varints of a PacketHeader by number."""
    end, at, found = 4 + int.from_bytes(frame[:4], "little"), 4, {}

    def varint():
        nonlocal at
        value = shift = 0
        while True:
            byte, at = frame[at], at + 1
            value, shift = value | (byte & 127) << shift, shift + 7
            if byte < 128:
                return value

    while at < end:
        number, kind = divmod(varint(), 8)
        if kind == 0:
            found[number] = varint()
        else:
            size = {1: 8, 5: 4}.get(kind) or varint()
            at += size
    return found


class Watcher(threading.Thread):
    """One page. `live_s`: until its first events; `stream_s`: where its stream is; `lost`: packets."""

    def __init__(self, server, begin, stop):
        super().__init__(daemon=True)
        self.server, self.begin, self.stop = server, begin, stop
        self.live_s = self.speed = self.refusal = self.due = None
        self.stream_s = self.lag_s = self.lost = self.pictures = 0

    def run(self):
        page = Page(self.server)
        for name in ("listScenes", "listStreams", "serverInfo"):
            page.call(name)
        while True:
            reply = page.call("openStream", **REQUEST)
            if reply["status"]["code"] == "CODE_OK":
                break
            self.refusal = reply["status"]["message"]
            time.sleep(reply["status"]["retryAfterS"] or 2)
        stream = reply["openStream"]
        self.speed = stream["resolved"]["timing"]["speed"]
        page.attach(stream)
        asked = True
        while not self.stop.is_set():
            if not asked and time.monotonic() - at > PICTURE_S:
                page.send({"request": {"requestId": "2", "protocolVersion": 1, "getFrame":
                                       {"streamId": stream["streamId"], "token": stream["token"]}}})
                asked = True
            opcode, data = page.socket.recv_data()
            if opcode == 1:
                asked, at = False, time.monotonic()
                self.pictures += json.loads(data)["status"]["code"] == "CODE_OK"
                continue
            if opcode == 8:
                self.refusal = f"closed: {data[2:].decode()}"
                return
            self.take(fields(data))
            if self.live_s is None:
                self.live_s, asked, at = time.monotonic() - self.begin, False, 0
        page.socket.close()

    def take(self, header):
        if header.get(15) != 1:
            return
        seq = header.get(4, 0)
        self.lost += 0 if self.due is None else seq - self.due
        self.due = seq + 1
        self.stream_s, self.lag_s = header.get(7, 0) / 2 * 1e-9, header.get(20, 0) * 1e-3


def memory_mib(pid):
    with open(f"/proc/{pid}/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS")) / 1024


def cpu_s(pid):
    with open(f"/proc/{pid}/stat") as stat:
        ticks = stat.read().rsplit(")", 1)[1].split()[11:13]
    return sum(map(int, ticks)) / os.sysconf("SC_CLK_TCK")


server = ViewedServer(program, "--threads", "2", "--limit-cpu", "85")
try:
    before_mib, stop, begin = memory_mib(server.process.pid), threading.Event(), time.monotonic()
    watchers = [Watcher(server, begin, stop) for _ in range(pages)]
    for watcher in watchers:
        watcher.start()
    while any(w.live_s is None for w in watchers) and time.monotonic() - begin < PATIENCE_S:
        time.sleep(0.05)
    live = sorted(w.live_s or float("inf") for w in watchers)
    at, cpu = [w.stream_s for w in watchers], cpu_s(server.process.pid)
    time.sleep(seconds)
    moved = [w.stream_s - a for w, a in zip(watchers, at)]
    cpu = cpu_s(server.process.pid) - cpu
    print(f"{pages} pages of {size}: live after {statistics.median(live):.1f} s, the last after {live[-1]:.1f} s")
    print(f"speeds {({w.speed for w in watchers})}; in {seconds:g} s the streams went on by"
          f" {min(moved):.3f} to {max(moved):.3f} s; they are within"
          f" {max(w.stream_s for w in watchers) - min(w.stream_s for w in watchers):.3f} s of each other")
    print(f"lag at most {max(w.lag_s for w in watchers):.2f} s; lost {sum(w.lost for w in watchers)} packets;"
          f" pictures {sum(w.pictures for w in watchers) / pages / (time.monotonic() - begin):.1f} a second and page")
    print(f"saccaded: {cpu / seconds:.2f} CPUs, {memory_mib(server.process.pid):.0f} MiB, {before_mib:.0f} before")
    print("refusals:", {w.refusal for w in watchers if w.refusal} or "none")
    stop.set()
    for watcher in watchers:
        watcher.join(5)
finally:
    server.stop()
