"""The types of the installed package and of the examples are complete: mypy passes, and is strict by pyproject.toml.

Exit code 77: mypy is not installed.

Usage: types_test.py FOLDER_OF_CACHE.
"""
import os
import pathlib
import shutil
import subprocess
import sys

import saccade

if not shutil.which("mypy"):
    print("skipped: mypy is not installed")
    sys.exit(77)
package = pathlib.Path(os.environ["SOURCE"]) / "client/python"
installed = pathlib.Path(saccade.__file__).parent
examples = [path for path in sorted((package / "examples").glob("*.py")) if path.name != "bare_client.py"]
command = ["mypy", "--config-file", package / "pyproject.toml", "--cache-dir", sys.argv[1], installed, *examples]
sys.exit(subprocess.run(command, cwd=installed.parent, check=False).returncode)
