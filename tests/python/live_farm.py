"""Streams from several servers, of which one after the other is killed. Each must be as one that nothing disturbs.

Usage: live_farm.py [--servers 3] [--streams 24] [--seconds 60] [--every 5] [--readers 4]. It needs the package, and
$SACCADED.
"""
import argparse
import concurrent.futures
import contextlib
import logging
import sys
import threading
import time

import numpy as np

import saccade
from saccaded import Server


def settings_of(number, seconds, **clock):
    """Of a stream that shares nothing with the others."""
    return {"scene": "cornell-box", "motion": "random:4", "motion_seed": number, "seed": number, "size": (32, 24),
            "rate_hz": 10, "duration_s": seconds, "truth": ["pose"], **clock}


class Farm:
    """Servers of which at most one is down. A context manager that stops them."""

    def __init__(self, count):
        self._running = contextlib.ExitStack()
        self.servers = [self._running.enter_context(Server()) for _ in range(count)]
        self.addresses = [server.address for server in self.servers]
        self.killed = 0

    def kill_next(self):
        """Starts the server again that was killed before, and kills the next one."""
        if self.killed:
            self.restart()
        self.servers[self.killed % len(self.servers)].kill()
        self.killed += 1

    def keep_killing(self, every, seconds, over):
        """Kills one `every` so many seconds, until near the end."""
        while not over.wait(every) and (self.killed + 1) * every < seconds:
            self.kill_next()

    def restart(self):
        """Starts the server again that was killed last, on its ports."""
        last = (self.killed - 1) % len(self.servers)
        self.servers[last] = self._running.enter_context(Server(endpoints=self.servers[last].endpoints))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._running.close()


class Trial:
    """What streams give while their servers are killed."""

    def __init__(self, streams, seconds):
        self.seconds, self.items = seconds, [[] for _ in range(streams)]
        self.opened_again = 0
        self.longest_s = 0.0  # that one item was waited for

    def receive(self, farm, every, retry, readers):
        """Reads PACED streams. Each of the readers has a client and a thread, and reads its streams in turn."""
        streams, over = range(len(self.items)), threading.Event()
        with concurrent.futures.ThreadPoolExecutor(readers + 1) as pool:
            killing = pool.submit(farm.keep_killing, every, self.seconds, over)
            reading = [pool.submit(self._read, farm, streams[i::readers], retry) for i in range(readers)]
            concurrent.futures.wait(reading)
            over.set()
        for one in (*reading, killing):
            one.result()

    def _read(self, farm, numbers, retry):
        with saccade.connect(farm.addresses, retry=retry) as client:
            live = {i: client.open(**settings_of(i, self.seconds, clock="paced")) for i in numbers}
            samples = {i: stream.samples() for i, stream in live.items()}
            while live:
                for i, stream in list(live.items()):
                    if not self._take(stream, samples[i], self.items[i]):
                        live.pop(i).close()

    def _take(self, stream, samples, items):
        began, stream_id = time.monotonic(), stream.opened.stream_id
        item = next(samples, None)
        self.longest_s = max(self.longest_s, time.monotonic() - began)
        self.opened_again += stream.opened.stream_id != stream_id
        if item is not None:
            items.append(item)
        return item is not None

    def differing(self, address):
        """The streams that are not as FAST ones of an undisturbed server, and the number of all events."""
        found, count = [], 0
        with saccade.connect(address) as client:
            for i, items in enumerate(self.items):
                with client.open(**settings_of(i, self.seconds)) as stream:
                    expected = columns_of(list(stream.samples()))
                columns = columns_of(items)
                count += len(columns[0])
                if not all(map(np.array_equal, columns, expected)):
                    found.append(i)
        return found, count


def columns_of(items):
    """Those of the events, their interval, and the times and rows of the poses."""
    events = saccade.concatenate([item for item in items if isinstance(item, saccade.Events)])
    poses = [item for item in items if isinstance(item, saccade.Truth)]
    return (events.t, events.x, events.y, events.p, (events.t0, events.t1), [pose.t for pose in poses],
            [pose.data for pose in poses])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name, default in (("servers", 3), ("streams", 24), ("seconds", 60), ("every", 5), ("readers", 4)):
        parser.add_argument(f"--{name}", type=int, default=default)
    options = parser.parse_args()
    logging.getLogger("saccade").setLevel(logging.ERROR)
    trial = Trial(options.streams, options.seconds)
    began = time.monotonic()
    with Farm(options.servers) as farm:
        trial.receive(farm, options.every, saccade.RetryPolicy(), options.readers)
    took = time.monotonic() - began
    with Server() as server:
        wrong, count = trial.differing(server.address)
    print(f"{options.streams} streams of {options.seconds} s took {took:.1f} s; {farm.killed} servers were killed")
    print(f"streams were opened again {trial.opened_again} times; the longest wait was {trial.longest_s:.1f} s")
    print(f"{count} events; streams that differ: {wrong or 'none'}")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
