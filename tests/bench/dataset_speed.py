"""Windows per second of saccade.Dataset, against h5py's bare read of the same bytes.

Usage: dataset_speed.py [DATASET [WINDOW_S]], with the package saccade installed. Without one it draws two: of long
recordings and of short ones. The bare read slices /events/t, x, y, p where each window is, of files that stay open
as those of Dataset do. Both take turns of 100 windows, and open all files anew in each round. CPU time.
"""
import collections
import functools
import multiprocessing
import pathlib
import sys
import tempfile
import time

import h5py
import numpy as np

import saccade

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
import farm_set

ROUNDS, MOST_FILES, MOST_WINDOWS, TURN = 3, 128, 4000, 100
CHUNK = 131072  # events, as `saccade record` packs them
DRAWN = {"long: 1,000,000 events in 2 s": (40, 1_000_000, 2_000_000, 0.05),
         "short: 30,000 events in 0.2 s": (200, 30_000, 200_000, 0.01)}


class Bare:
    """Slices of files that stay open."""

    def __init__(self):
        self.files = collections.OrderedDict()

    def read(self, path, first, last):
        if path not in self.files:
            if len(self.files) == MOST_FILES:
                self.files.popitem(last=False)
            file = h5py.File(path, "r")
            self.files[path] = file, [file[f"events/{name}"] for name in "txyp"]
        self.files.move_to_end(path)
        return [column[first:last] for column in self.files[path][1]]


def bounds_of(data, numbers):
    """The file of each window, and where in it the window is."""
    found, opened = {}, None
    for number in sorted(numbers):
        window = data[number]
        if window.sequence.path != opened:
            opened = window.sequence.path
            with h5py.File(opened) as file:
                t = file["events/t"][:]
        first, last = np.searchsorted(t, [window.events.t0, window.events.t1])
        found[number] = opened, int(first), int(last)
    return [found[number] for number in numbers]


def take(wire, make, places):
    """Reads turns of windows when asked, and answers with the CPU time and the number of events."""
    read = None
    while (turn := wire.recv()) is not None:
        read = make() if turn.start == 0 else read
        begin = time.process_time()
        events = sum(read(place) for place in places[turn])
        wire.send((time.process_time() - begin, events))


def dataset_reader(path, window_s):
    data = saccade.Dataset(path, window_s=window_s)
    return lambda number: len(data[number].events)


def bare_reader():
    bare = Bare()
    return lambda place: len(bare.read(*place)[0])


def measure(path, window_s, shuffle):
    """Windows per second of Dataset and of the bare read."""
    numbers = list(saccade.Dataset(path, window_s=window_s).order(shuffle=shuffle))[:MOST_WINDOWS]
    bounds = bounds_of(saccade.Dataset(path, window_s=window_s), numbers)
    wires, readers = [], []
    # Processes of their own: HDF5 shares a file, and its cache, between those who open it in one process.
    for make, places in ((functools.partial(dataset_reader, path, window_s), numbers), (bare_reader, bounds)):
        ours, theirs = multiprocessing.get_context("spawn").Pipe()
        readers.append(multiprocessing.get_context("spawn").Process(target=take, args=(theirs, make, places)))
        readers[-1].start()
        wires.append(ours)
    spent, events = [0.0, 0.0], [0, 0]
    for first in list(range(0, len(numbers), TURN)) * ROUNDS:
        for which, wire in enumerate(wires):
            wire.send(slice(first, first + TURN))
            found = wire.recv()
            spent[which], events[which] = spent[which] + found[0], events[which] + found[1]
    for wire, reader in zip(wires, readers):
        wire.send(None)
        reader.join()
    assert events[0] == events[1] > 0
    return [len(numbers) * ROUNDS / seconds for seconds in spent]


def report(path, name, window_s):
    """The lowest of the ratios."""
    ratios = []
    for shuffle in (False, True):
        ours, bare = measure(path, window_s, shuffle)
        how = "shuffled" if shuffle else "in order"
        print(f"{name}, windows of {window_s} s, {how}: Dataset {ours:.0f} windows per second, bare {bare:.0f}, "
              f"ratio {ours / bare:.2f}")
        ratios.append(ours / bare)
    return min(ratios)


def drawn():
    """The lowest ratio of the data sets that are drawn here."""
    ratios = []
    for name, (sequences, count, duration_us, window_s) in DRAWN.items():
        with tempfile.TemporaryDirectory() as folder:
            farm_set.make(folder, sequences, 2, count, duration_us, chunk=CHUNK)
            ratios.append(report(folder, name, window_s))
    return min(ratios)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        report(sys.argv[1], sys.argv[1], float((sys.argv[2:] or ["0.05"])[0]))
    else:
        drawn()
