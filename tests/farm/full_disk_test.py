"""A data set on a disk that becomes full: what is there is whole, and the next run makes the rest."""
import os
import subprocess
import sys
import tempfile
import unittest

FARM = sys.argv[1]
SKIPPED = 77

RECIPE = """
name = "full"
sequences = 40
shards = 2
[record]
output = "events.raw"
scene = "cornell-box"
motion = "pan:90"
size = "64x48"
rate = 500
duration = 0.02
"""


def farm(*words):
    return subprocess.run([FARM, *words], capture_output=True, text=True)


def main():
    with tempfile.TemporaryDirectory() as folder:
        disk, recipe = os.path.join(folder, "disk"), os.path.join(folder, "recipe.toml")
        os.mkdir(disk)
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", disk], stderr=subprocess.DEVNULL).returncode:
            print("no disk can be mounted here")
            return SKIPPED
        try:
            check(recipe, os.path.join(disk, "set"), disk)
        finally:
            subprocess.run(["umount", disk], check=True)
    return 0


def check(recipe, data_set, disk):
    test = unittest.TestCase()
    with open(recipe, "w", encoding="utf-8") as file:
        file.write(RECIPE)
    test.assertEqual(farm("plan", recipe, "-o", data_set, "--no-estimate").returncode, 0)
    full = farm("run", data_set)
    test.assertEqual(full.returncode, 75, full.stderr)
    test.assertIn("No space left on device", full.stderr)
    verified = farm("verify", data_set).stdout
    test.assertIn(" 0 damaged", verified)
    test.assertNotIn(" 0 missing", verified)
    subprocess.run(["mount", "-o", "remount,size=64m", disk], check=True)
    test.assertEqual(farm("run", data_set).returncode, 0)
    test.assertIn("0 damaged, 0 missing, 0 foreign", farm("verify", data_set).stdout)
    test.assertIn("40 of 40", farm("status", data_set).stdout)


if __name__ == "__main__":
    sys.exit(main())
