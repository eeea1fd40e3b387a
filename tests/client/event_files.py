"""Makes files of events with `saccade convert`, for tests that read them with programs of others."""
import json
import pathlib
import resource
import signal
import subprocess


def write_csv(path, events):
    """Events are (t_us, x, y, p)."""
    path.write_text("t,x,y,p\n" + "".join(f"{t},{x},{y},{p}\n" for t, x, y, p in events))


def convert(saccade, source, target, size, most_bytes=None):
    """Runs the command. most_bytes: size at which the disk seems full."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, most_bytes))
    return subprocess.run([saccade, "convert", "--force", "--size", f"{size[0]}x{size[1]}", source, target],
                          preexec_fn=limit if most_bytes else None, capture_output=True, text=True, timeout=60,
                          check=False)


def describe(saccade, csv, size, request):
    """Writes CSV.json, which says that the events are of sensor 0 of this request."""
    copy = pathlib.Path(f"{csv}.copy.csv")
    convert(saccade, csv, copy, size).check_returncode()
    about = json.loads(pathlib.Path(f"{copy}.json").read_text(encoding="utf-8"))  # with the digest
    pathlib.Path(f"{csv}.json").write_text(json.dumps({**about, "request": request}), encoding="utf-8")


def rig_request(size, fx, view):
    """A request of two views with one sensor, whose view has the focal length fx."""
    views = [{"width": size[0], "height": size[1], "intrinsics": {"fx": fx if n == view else 1, "fy": 9, "cx": 1, "cy": 2}}
             for n in range(2)]
    return {"view": views[0], "further_views": views[1:], "sensors": [{"view": view}]}
