"""Event simulators of others, on the frames of a clip: rivals.py NAME CLIP.npz PICTURES OUT.npz
Prints the CPU seconds that the simulator took. PICTURES is a folder with the frames as numbered PNG files. A clip has
`frames` (n, height, width; 0 to 255), `rate` (frames per second), `threshold` (C) and `bias` (of white).
All simulators have one response, log(v / 255 + bias), start at the first frame, and have no noise.
"""
import os
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import numpy as np


def microseconds(clip, frame):
    return round(1e6 * frame / clip.rate)


def frame_by_frame(inputs, step):
    """Rows of t (us), x, y, p of step(input, frame), and the CPU seconds of all steps."""
    seconds, rows = 0, []
    for frame, picture in enumerate(inputs):
        began = time.process_time()
        events = step(picture, frame)
        seconds += time.process_time() - began
        if events is not None:
            rows.append(np.asarray(events, dtype=np.float64))
    return np.concatenate(rows) if rows else np.zeros((0, 4)), seconds


def formula(clip):
    """The rule of ESIM (Rebecq et al. 2018) in NumPy: log brightness is linear between two frames."""
    logs = np.log(clip.light + clip.bias)
    level = logs[0].copy()

    def step(now, frame):
        change = now - logs[frame - 1]
        crossed = np.trunc((now - level) / clip.threshold).astype(int) * (change != 0)
        y, x = np.nonzero(crossed)
        each = np.abs(crossed[y, x])
        y, x = np.repeat(y, each), np.repeat(x, each)
        sign, nth = np.sign(crossed[y, x]), np.arange(each.sum()) - np.repeat(np.cumsum(each) - each, each) + 1
        share = (level[y, x] + sign * nth * clip.threshold - logs[frame - 1, y, x]) / change[y, x]
        level[:] += clip.threshold * crossed
        return np.stack([1e6 / clip.rate * (frame - 1 + np.clip(share, 0, 1)), x, y, sign], axis=1)
    return frame_by_frame(logs, lambda now, frame: step(now, frame) if frame else None)


def esim(clip):
    """esim_py of rpg_vid2e. It reads the PNG files itself, which counts."""
    import esim_py
    simulator = esim_py.EventSimulator(clip.threshold, clip.threshold, 0, clip.bias, True)
    times = [frame / clip.rate for frame in range(len(clip.frames))]
    began = time.process_time()
    rows = simulator.generateFromStampedImageSequence(clip.pictures, times)
    seconds = time.process_time() - began
    return np.stack([1e6 * rows[:, 2], rows[:, 0], rows[:, 1], rows[:, 3]], axis=1), seconds


def v2e(clip):
    """Its EventEmulator; `hdr` says that frames are logarithms already."""
    import torch
    from v2ecore.emulator import EventEmulator
    torch.set_num_threads(1)
    emulator = EventEmulator(pos_thres=clip.threshold, neg_thres=clip.threshold, sigma_thres=0, leak_rate_hz=0,
                             device="cpu", hdr=True)
    logs = np.log(clip.light + clip.bias).astype(np.float32)
    rows, seconds = frame_by_frame(logs, lambda now, frame: emulator.generate_events(now, frame / clip.rate))
    return rows * [1e6, 1, 1, 1], seconds


def dvs_voltmeter(clip):
    """Its rate of change is K1 dL / (mean L + K2), and its threshold 1. It divides by its noise: K6 is tiny."""
    import torch
    from src.simulator import EventSim
    torch.set_num_threads(1)
    constants = [1 / clip.threshold, clip.bias, 0, 0, 0, 1e-6]
    simulator = EventSim(SimpleNamespace(SENSOR=SimpleNamespace(K=constants)), "", "")
    return frame_by_frame(clip.light.astype(np.float64),
                          lambda now, frame: simulator.generate_events(now, microseconds(clip, frame)))


def iebcs(clip):
    """It adds 1 before the logarithm. Its low pass must be some microseconds: 20 at white, with a bias of 0.02."""
    from dvs_sensor import DvsSensor
    sensor = DvsSensor("peer")
    _, height, width = clip.frames.shape
    sensor.initCamera(width, height, lat=0, jit=0, ref=1, tau=1, th_pos=clip.threshold, th_neg=clip.threshold,
                      th_noise=0, bgnp=1e-9, bgnn=1e-9)
    lights = clip.light / clip.bias

    def step(now, frame):
        if frame == 0:
            return sensor.init_image(now)
        found = sensor.update(now, microseconds(clip, frame) - microseconds(clip, frame - 1))
        return np.stack([found.get_ts(), found.get_x(), found.get_y(), found.get_p()], axis=1)
    return frame_by_frame(lights, step)


# By name: the function, and the environment variable of the folder that holds its modules.
RIVALS = {
    "formula": (formula, None),
    "esim": (esim, "PEERS_ESIM"),
    "v2e": (v2e, "PEERS_V2E"),
    "dvs_voltmeter": (dvs_voltmeter, "PEERS_DVS_VOLTMETER"),
    "iebcs": (iebcs, "PEERS_IEBCS"),
}


def run(name, clip):
    """Columns of the events in time order, and the CPU seconds."""
    simulate, variable = RIVALS[name]
    sys.path[:0] = filter(None, [os.environ.get(variable or "")])
    rows, seconds = simulate(clip)
    rows = rows[np.argsort(rows[:, 0], kind="stable")]
    return {"t": rows[:, 0].astype(np.int64), "x": rows[:, 1].astype(np.uint16), "y": rows[:, 2].astype(np.uint16),
            "p": (rows[:, 3] > 0).astype(np.uint8)}, seconds


def clip_of(path, pictures):
    with np.load(path) as file:
        frames = file["frames"]
        numbers = {name: float(file[name]) for name in ("rate", "threshold", "bias")}
    paths = sorted(map(str, Path(pictures).iterdir()))
    return SimpleNamespace(frames=frames, light=frames / 255, pictures=paths, **numbers)


if __name__ == "__main__":
    try:
        columns, cpu = run(sys.argv[1], clip_of(*sys.argv[2:4]))
    except ImportError as fault:
        sys.exit(f"not installed: {fault}")
    np.savez(sys.argv[4], **columns)
    print(cpu)
