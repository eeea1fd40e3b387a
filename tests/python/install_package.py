"""Builds the Python package as a user does, sdist and wheel, and installs it into a fresh virtual environment.

Usage: install_package.py SOURCE_OF_PACKAGE FOLDER PROTOC. Makes FOLDER/venv. It needs no network: the tools to build
and the libraries are the system's.
"""
import os
import pathlib
import shutil
import subprocess
import sys

source, folder, protoc = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
PYTHON = folder / "venv/bin/python"


def run(*command):
    subprocess.run([str(word) for word in command], check=True, env={**os.environ, "PROTOC": protoc})


shutil.rmtree(folder, ignore_errors=True)
# A copy, because setuptools writes beside the sources.
made = shutil.ignore_patterns("__pycache__", "*.egg-info", "build", "dist", "*_pb2.py*")
shutil.copytree(source, folder / "source", ignore=made)
run(sys.executable, "-m", "build", "--no-isolation", "--outdir", folder / "dist", folder / "source")
run(sys.executable, "-m", "venv", "--system-site-packages", folder / "venv")
wheel, = (folder / "dist").glob("saccade-*.whl")
run(PYTHON, "-m", "pip", "install", "--quiet", "--no-index", "--disable-pip-version-check", wheel)
