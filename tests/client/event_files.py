"""Makes files of events with `saccade convert`, for tests that read them with programs of others."""
import resource
import signal
import subprocess


def write_csv(path, events):
    """Events are (t_us, x, y, p)."""
    path.write_text("t_us,x,y,p\n" + "".join(f"{t},{x},{y},{p}\n" for t, x, y, p in events))


def convert(saccade, source, target, size, most_bytes=None):
    """Runs the command. most_bytes: size at which the disk seems full."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, most_bytes))
    return subprocess.run([saccade, "convert", "--force", "--size", f"{size[0]}x{size[1]}", source, target],
                          preexec_fn=limit if most_bytes else None, capture_output=True, text=True, timeout=60,
                          check=False)
