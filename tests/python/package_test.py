"""The installed package: its version, its contents, and the modules that it loads."""
import importlib.metadata
import os
import pathlib
import re
import subprocess
import sys
import unittest

import saccade


class Package(unittest.TestCase):
    def test_it_is_the_installed_one(self):
        self.assertTrue(pathlib.Path(saccade.__file__).is_relative_to(sys.prefix), saccade.__file__)
        self.assertTrue((pathlib.Path(saccade.__file__).parent / "py.typed").exists())

    def test_its_version_is_that_of_the_server(self):
        lists = (pathlib.Path(os.environ["SOURCE"]) / "CMakeLists.txt").read_text()
        version = re.search(r"project\(saccade VERSION ([\d.]+)", lists)[1]
        self.assertEqual(importlib.metadata.version("saccade"), version)
        self.assertEqual(saccade.__version__, version)

    def test_the_messages_stand_in_the_package(self):
        from saccade.v1 import control_pb2, events_pb2
        self.assertEqual(control_pb2.Request.DESCRIPTOR.full_name, "saccade.v1.Request")
        self.assertTrue(pathlib.Path(events_pb2.__file__).is_relative_to(pathlib.Path(saccade.__file__).parent))

    def test_optional_libraries_are_loaded_only_where_they_are_used(self):
        optional = ["torch", "h5py", "lz4", "zstandard", "matplotlib"]
        code = f"import sys, saccade; print([name for name in {optional} if name in sys.modules])"
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.strip(), "[]")

    def test_every_public_name_is_described(self):
        for name in saccade.__all__:
            if isinstance(getattr(saccade, name), type) or callable(getattr(saccade, name)):
                self.assertTrue(getattr(saccade, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()
