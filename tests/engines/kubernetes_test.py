"""The manifests of `saccade-farm kubernetes` fit the schemas of the API, and have no key that these do not know:
kubernetes_test.py FARM FOLDER_FOR_NPM"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import data_sets

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "client"))
import npm_packages

FARM, NPM = sys.argv[1:3]
CHECK = pathlib.Path(__file__).with_name("check_manifest.cjs")
reason = npm_packages.missing(NPM, ["kubernetes-models@4.5.1", "ajv@8.17.1"])
if reason:
    print(f"skipped: {reason}")
    sys.exit(77)
try:
    import yaml
except ImportError:
    print("skipped: this Python has no yaml (package python3-yaml)")
    sys.exit(77)

PLACES = {"volume": ["--claim", "sets", "--path", "a b/" + data_sets.NASTY],
          "bucket": ["--bucket", "s3:sets/" + data_sets.NASTY, "--rclone-secret", "store"]}
WRONG = [('"backoffLimitPerIndex"', '"backofLimitPerIndex"', "/spec/backofLimitPerIndex is unknown"),
         ('"runAsNonRoot"', '"runAsNoRoot"', "/securityContext/runAsNoRoot is unknown"),
         ('"drop"', '"dropp"', "/capabilities/dropp is unknown"),
         ('"completions": 4', '"completions": "4"', "/spec/completions"),
         ('"FailIndex"', '"Fail"', "/spec/podFailurePolicy/rules/1/action"),
         ('"4096Mi"', '"4096MB"', "/resources/requests/memory"),
         ('"template"', '"templates"', "missingProperty"),
         ('"metadata"', '"meta"', "/meta/name is unknown")]


def faults(text):
    done = subprocess.run(["node", CHECK], input=text, capture_output=True, text=True, check=False,
                          env={**os.environ, "NODE_PATH": os.path.join(NPM, "node_modules")})
    assert done.returncode == 0, done.stderr
    return done.stdout


class Manifests(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        farm = data_sets.Farm(FARM, folder.name)
        data_set = farm.plan("set")
        self.jobs = {}
        for place, options in PLACES.items():
            text = farm("kubernetes", data_set, "--image", "example.org/saccade:1", "--scenes", "/scenes", *options)
            self.jobs[place] = yaml.safe_load(text)

    def text(self, place):
        return json.dumps([self.jobs[place]])

    def test_fit_the_schemas(self):
        for place in PLACES:
            self.assertEqual(faults(self.text(place)), "", place)

    def test_faults_would_be_found(self):
        for place in PLACES:
            for right, wrong, told in WRONG:
                text = self.text(place)
                self.assertIn(right, text)
                self.assertIn(told, faults(text.replace(right, wrong)), (place, wrong))

    def test_a_failure_for_ever_ends_its_shard_and_an_eviction_counts_for_nothing(self):
        spec = self.jobs["volume"]["spec"]
        first, second = spec["podFailurePolicy"]["rules"]
        self.assertEqual((first["action"], first["onPodConditions"][0]["type"]), ("Ignore", "DisruptionTarget"))
        self.assertEqual((second["action"], second["onExitCodes"]["values"]), ("FailIndex", [2, 78]))
        self.assertEqual(second["onExitCodes"]["containerName"], spec["template"]["spec"]["containers"][0]["name"])
        self.assertEqual((spec["completions"], spec["template"]["spec"]["restartPolicy"]), (4, "Never"))

    def test_every_mount_has_its_volume(self):
        for job in self.jobs.values():
            pod = job["spec"]["template"]["spec"]
            mounted = {mount["name"] for c in [*pod.get("initContainers", []), *pod["containers"]] for mount in c["volumeMounts"]}
            self.assertEqual(mounted, {volume["name"] for volume in pod["volumes"]})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
