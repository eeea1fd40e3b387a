"""A data set as saccade-farm lays it out, of events that are drawn here, for tests."""
import hashlib
import json
import pathlib

import numpy as np

import saccade
from saccade.truth import TruthArrays
from saccade.v1 import recording_pb2
from saccade.writers.hdf5 import PACKED, write_hdf5
from saccade.writers.description import describe_events, write_description
from saccade.writers.npz import write_npz

SIZE, SPLITS = (64, 48), ("train", "val", "test")


def events_of(number, count, duration_us):
    rng = np.random.default_rng(number)
    t = np.sort(rng.integers(0, duration_us, count))
    return saccade.Events(t, rng.integers(0, SIZE[0], count), rng.integers(0, SIZE[1], count),
                          rng.integers(0, 2, count) > 0, SIZE, (0, duration_us))


def truth_of(number, duration_us):
    t = np.arange(0, duration_us + 1, 10_000)
    depth = np.full((len(t), SIZE[1], SIZE[0], 1), number, np.float32) + t[:, None, None, None] / 1e6
    return {"depth": TruthArrays(t, depth.astype(np.float32), np.zeros((len(t), 2), np.int64), ("depth",), "unit"),
            "pose": TruthArrays(t, np.column_stack([t / 1e6] + [np.full(len(t), number)] * 6), None)}


def split_of(number):
    return SPLITS[0] if number % 10 < 8 else SPLITS[number % 10 - 7]


def write_plan(root, sequences, shards):
    splits = [{"name": name, "sequences": str(sum(split_of(i) == name for i in range(sequences)))} for name in SPLITS]
    plan = {"name": "drawn", "sequences": str(sequences), "shards": shards, "seed": "7", "splits": splits}
    root.mkdir(parents=True, exist_ok=True)
    (root / "plan.json").write_text(json.dumps(plan) + "\n")


def shard_of(number, sequences, shards):
    return next(k for k in reversed(range(shards)) if -(-k * sequences // shards) <= number)


def line_of(number, shard, files, recordings):
    """As protobuf writes JSON: numbers of 64 bits are texts, and a 0 is left out."""
    line = {"number": str(number), "shard": shard, "split": split_of(number),
            "options": ["scene", "--seed", str(number)], "draws": {"speed": f"{number / 2:g}"}, "files": files,
            "recordings": recordings}
    told = {key: value for key, value in line.items() if value not in (0, "0")}
    return json.dumps(told, separators=(",", ":")) + "\n"


def recording_of(file, events, truth=(), sensor=0):
    found = {"file": file, "sensor": sensor, "width": SIZE[0], "height": SIZE[1], "end_ns": str(events.t1 * 1000),
             "events": str(len(events)), "truth": list(truth)}
    return {key: value for key, value in found.items() if value not in (0, "0", [])}


def pack_as_recorded(path, chunk):
    """Packs the columns of events again, in chunks of so many."""
    import h5py
    with h5py.File(path, "r+") as file:
        for name in "txyp":
            column = file[f"events/{name}"][:]
            del file[f"events/{name}"]
            file.create_dataset(f"events/{name}", data=column, maxshape=(None,), chunks=(chunk,), **PACKED)


def write_sequence(folder, number, events, formats, chunk):
    """Files of the first sensor, and an .h5 with a second one, which has half of the events."""
    folder.mkdir(parents=True)
    truth, recordings = truth_of(number, events.t1), []
    for kind in formats:
        path = folder / f"events.{kind}"
        if kind == "h5":
            second = saccade.Events(*(getattr(events, name)[::2] for name in "txyp"), SIZE, (0, events.t1), 1)
            write_hdf5(path, {"/": events, "/sensor_1": second},
                       {f"/truth/{name}": arrays for name, arrays in truth.items()})
            if chunk:
                pack_as_recorded(path, chunk)
            about = describe_events(second)
            about.request.sensors.add(), about.request.sensors.add()
            write_description(path.with_name("events.h5.sensor1"), about)
        else:
            write_npz(path, events, truth)
        about = describe_events(events)
        about.request.sensors.add(), about.request.sensors.add()
        write_description(path, about)
        recordings.append(recording_of(path.name, events, truth))
        if kind == "h5":
            recordings.append(recording_of(path.name, second, sensor=1))
    files = [{"name": path.name, "bytes": str(path.stat().st_size),
              "digest": hashlib.blake2b(path.read_bytes(), digest_size=32).hexdigest()}
             for path in sorted(folder.iterdir())]
    return files, recordings


def make(root, sequences=20, shards=3, count=400, duration_us=100_000, formats=("h5",), chunk=0):
    root = pathlib.Path(root)
    write_plan(root, sequences, shards)
    lines = [[] for _ in range(shards)]
    for number in range(sequences):
        shard = shard_of(number, sequences, shards)
        folder = root / f"shards/{shard:05}/{number:06}"
        events = events_of(number, count, duration_us)
        line = line_of(number, shard, *write_sequence(folder, number, events, formats, chunk))
        (folder / "sequence.json").write_text(line)
        lines[shard].append(line)
    for shard, of_shard in enumerate(lines):
        (root / f"shards/{shard:05}/index.jsonl").write_text("".join(of_shard))
    return root


def make_index(root, sequences, shards):
    """The lists alone, for measurements: no sequence is there."""
    root = pathlib.Path(root)
    write_plan(root, sequences, shards)
    files = [{"name": name, "bytes": "123456", "digest": "ab" * 32} for name in ("events.h5", "events.h5.json")]
    recordings = [{"file": "events.h5", "width": 64, "height": 48, "end_ns": "200000000", "events": "23456",
                   "truth": ["depth", "flow_forward"]}]
    for shard in range(shards):
        folder = root / f"shards/{shard:05}"
        folder.mkdir(parents=True)
        numbers = range(-(-shard * sequences // shards), -(-(shard + 1) * sequences // shards))
        (folder / "index.jsonl").write_text("".join(line_of(number, shard, files, recordings) for number in numbers))
    return root
