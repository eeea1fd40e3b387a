"""A data set through Snakemake, whose bytes are those of a local run: snakemake_test.py FARM"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import data_sets

FARM = os.path.abspath(sys.argv[1])
if shutil.which("snakemake") is None:
    print("skipped: snakemake is not installed")
    sys.exit(77)


class Snakemake(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.farm = data_sets.Farm(FARM, folder.name)
        self.folder = self.farm.folder

    def make(self, data_set, *options):
        self.farm("snakemake", data_set, "-o", self.folder / "Snakefile", "--cpus", "1", *options)
        return subprocess.run(["snakemake", "--snakefile", self.folder / "Snakefile", "--cores", "2", "--keep-going"],
                              cwd=self.folder, capture_output=True, text=True, check=False,
                              env={**os.environ, "HOME": str(self.folder)})

    def test_makes_all_shards_in_a_folder_with_a_nasty_name(self):
        data_set = self.farm.plan(data_sets.NASTY.replace("{x}", ""))
        done = self.make(data_set)
        self.assertEqual(done.returncode, 0, done.stderr)
        data_sets.check_same(self.farm, self.farm.made("whole"), data_set)
        self.assertEqual(list(self.folder.rglob("PWNED")), [])

    def test_a_shard_that_fails_runs_again_and_the_others_go_on(self):
        worker = self.folder / "worker"
        worker.write_text('#!/bin/bash\necho "$4" >>"$(dirname "$0")/calls"\n[ "$4" != 1/4 ] || exit 75\n'
                          f'exec "{FARM}" "$@"\n', encoding="utf-8")
        worker.chmod(0o755)
        data_set = self.farm.plan("failing", duration=0.02)
        self.assertNotEqual(self.make(data_set, "--program", worker, "--retries", "2").returncode, 0)
        calls = (self.folder / "calls").read_text(encoding="utf-8").split()
        self.assertEqual(calls.count("1/4"), 3)
        self.assertEqual(set(calls), {"0/4", "1/4", "2/4", "3/4"})  # a slow machine may fail another shard once
        self.assertEqual(data_sets.published(data_set), 9)
        self.assertEqual(self.make(data_set).returncode, 0)
        self.assertIn("0 damaged, 0 missing, 0 foreign", self.farm("verify", data_set))

    def test_a_folder_that_cannot_stand_in_a_snakefile_is_refused(self):
        for name in ("new\nline", "{braces}"):
            self.farm("snakemake", self.farm.plan(name, sequences=4, duration=0.02), expect=2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
