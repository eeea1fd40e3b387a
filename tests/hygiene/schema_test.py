"""The schema keeps buf's STANDARD rules. Exit code 77: buf is not installed."""
import pathlib, shutil, subprocess, sys

if not shutil.which("buf"):
    print("buf is not installed (npm install @bufbuild/buf)")
    sys.exit(77)
proto = pathlib.Path(__file__).resolve().parents[2] / "proto"
sys.exit(subprocess.run(["buf", "lint"], cwd=proto).returncode)
