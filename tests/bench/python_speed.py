"""Events per second that one core takes into numpy, from a mock server that sends prepared packets.

Usage: python_speed.py [EVENTS_PER_PACKET...], with the package saccade installed. Prints a line for each: against the
wall clock, and against the CPU time of the client with its I/O thread. The mock server is a process of its own.
"""
import multiprocessing
import pathlib
import sys
import time

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
import saccade
from fake_server import MS, FakeServer, packet, payload_of
from saccade.v1 import events_pb2

EVENTS = 40_000_000
WIDTH, HEIGHT = 346, 260


def prepare(count):
    """A stream of EVENTS events in packets of `count`, as serialized messages. They share their payload."""
    rng = np.random.default_rng(1)
    payload = payload_of(np.sort(rng.integers(0, 1000, count)), rng.integers(0, WIDTH, count),
                         rng.integers(0, HEIGHT, count), rng.integers(0, 2, count))
    number = EVENTS // count
    packets = [packet("s", i, i * count, i * MS, (i + 1) * MS, payload) for i in range(number)]
    end = packet("s", number, number * count, number * MS, number * MS, kind=events_pb2.KIND_END)
    return [(header.SerializeToString(), payload) for header, payload in [*packets, end]]


def serve(endpoint, count):
    server = FakeServer(frames=0)
    messages = prepare(count)
    endpoint.send(server.control.endpoint)
    server.open("s")
    server.attached()
    credit = 0
    for head, payload in messages:
        while credit <= 0:
            credit += server.data.receive(events_pb2.DataRequest).credit.bytes
        server.data.send(head, payload)
        credit -= len(head) + len(payload)
    endpoint.recv()  # until the client has them all


def measure(count):
    """Prints both rates for packets of `count` events. Returns that of CPU time, in events per second."""
    ours, theirs = multiprocessing.get_context("spawn").Pipe()
    mock = multiprocessing.get_context("spawn").Process(target=serve, args=(theirs, count))
    mock.start()
    with saccade.connect(ours.recv()) as client:
        with client.open(scene="s", motion="right", size=(WIDTH, HEIGHT), rate_hz=1000, delivery="lossless") as stream:
            events, wall, cpu = 0, time.perf_counter(), time.process_time()
            for part in stream:
                events += len(part)
            wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    ours.send(None)
    mock.join()
    print(f"{count:6} events per packet: {events / wall / 1e6:5.0f} million events per second of the wall clock, "
          f"{events / cpu / 1e6:5.0f} per second of CPU")
    return events / cpu


if __name__ == "__main__":
    for size in map(int, sys.argv[1:] or ["512", "4096", "32768"]):
        measure(size)
