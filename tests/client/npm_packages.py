"""Fetches packages of npm for a test. They stay in the build folder, and never come into the repository."""
import os
import pathlib
import shutil
import subprocess


def missing(folder, packages):
    """Fetches packages (name@version) into `folder`. Why they cannot be used; None if they can."""
    if shutil.which("node") is None or shutil.which("npm") is None:
        return "node and npm are not installed"
    wanted = [pathlib.Path(folder, "node_modules", name.rsplit("@", 1)[0]) for name in packages]
    if all(path.exists() for path in wanted):
        return None
    done = subprocess.run(["npm", "install", "--no-save", "--no-audit", "--no-fund", "--prefix", folder, *packages],
                          capture_output=True, text=True, check=False)
    return None if done.returncode == 0 else "npm cannot fetch " + ", ".join(packages)


def run(folder, script, *arguments):
    """Runs a CommonJS script, which finds the packages of `folder`, and returns what it prints."""
    done = subprocess.run(["node", script, *arguments], capture_output=True, text=True, timeout=60, check=False,
                          env={**os.environ, "NODE_PATH": str(pathlib.Path(folder, "node_modules"))})
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return done.stdout
