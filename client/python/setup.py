"""Makes the message classes of proto/saccade/v1 while the package is built. pyproject.toml says the rest."""
import os
import pathlib
import shutil
import subprocess
import sys

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent
SCHEMA = HERE / "proto"


class BuildWithMessages(build_py):
    def run(self) -> None:
        super().run()
        make_messages(HERE if self.editable_mode else pathlib.Path(self.build_lib))


def make_messages(folder: pathlib.Path) -> None:
    """Writes saccade/v1/*_pb2.py and their types into `folder`. They import each other as saccade.v1."""
    protoc = os.environ.get("PROTOC") or shutil.which("protoc")
    if protoc is None:
        sys.exit("protoc is not installed (package protobuf-compiler); the variable PROTOC may name it")
    files = sorted(str(path.relative_to(SCHEMA)) for path in SCHEMA.glob("saccade/v1/*.proto"))
    out = folder.absolute()
    subprocess.run([protoc, f"--python_out={out}", f"--pyi_out={out}", "-I.", *files], cwd=SCHEMA, check=True)


setup(cmdclass={"build_py": BuildWithMessages})
