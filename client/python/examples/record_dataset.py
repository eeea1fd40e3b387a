"""Records a data set: the events of each motion and threshold as .npz, and the request that gives them
again beside them.

    python3 record_dataset.py FOLDER [SCENE]

The server is that of $SACCADE_SERVER, or the one on this machine.
"""
from __future__ import annotations

import pathlib
import sys

from google.protobuf.json_format import MessageToJson

import saccade

MOTIONS = ["pan:-20", "pan:20", "orbit", "shake"]
THRESHOLDS = [0.1, 0.2]  # two sensors of one feed, which is rendered once


def record(client: saccade.Client, scene: str, motion: str, folder: pathlib.Path) -> None:
    parts: list[list[saccade.Events]] = [[] for _ in THRESHOLDS]
    with client.open(scene=scene, motion=motion, size=(64, 48), rate_hz=500, duration_s=0.1,
                     threshold=THRESHOLDS) as stream:
        for events in stream:
            parts[events.sensor].append(events)
        name = motion.replace(":", "")
        (folder / f"{name}.json").write_text(MessageToJson(stream.resolved))
    for threshold, of_sensor in zip(THRESHOLDS, parts):
        events = saccade.concatenate(of_sensor)
        events.save(folder / f"{name}-{threshold}.npz")
        print(f"{motion}, threshold {threshold}: {len(events)} events")


def main() -> None:
    folder, scene = pathlib.Path(sys.argv[1]), (sys.argv[2:] or ["cornell-box"])[0]
    folder.mkdir(parents=True, exist_ok=True)
    with saccade.connect() as client:
        for motion in MOTIONS:
            record(client, scene, motion, folder)


if __name__ == "__main__":
    main()
