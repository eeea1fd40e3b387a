"""The manifests for live farms on Kubernetes: fields that exist, and parts that fit together and fit the image.

An example of each object lists the fields that the API has in it, as far as the manifests may use them.
"""
import re
import sys
import unittest

import house

try:
    import yaml
except ImportError:
    print("skipped: python3-yaml is not installed")
    sys.exit(77)

FOLDER = "deploy/kubernetes/"
LABELS = {"app.kubernetes.io/name": ""}
META = {"name": "", "labels": LABELS}
PROBE = {"httpGet": {"path": "", "port": ""}, "periodSeconds": 1, "failureThreshold": 1}
SECURITY = {"runAsNonRoot": True, "runAsUser": 1, "runAsGroup": 1}
CONTAINER = {
    "name": "", "image": "", "command": [""], "env": [{"name": "", "value": ""}],
    "ports": [{"name": "", "containerPort": 1}],
    "resources": {"requests": {"cpu": "", "memory": ""}, "limits": {"memory": ""}},
    "readinessProbe": PROBE, "livenessProbe": PROBE,
    "securityContext": {"readOnlyRootFilesystem": True, "allowPrivilegeEscalation": False,
                        "capabilities": {"drop": [""]}},
    "volumeMounts": [{"name": "", "mountPath": "", "readOnly": True}]}
POD = {
    "restartPolicy": "", "nodeSelector": {"kubernetes.io/os": "", "kubernetes.io/arch": ""},
    "automountServiceAccountToken": False, "enableServiceLinks": False, "terminationGracePeriodSeconds": 1,
    "securityContext": {**SECURITY, "fsGroup": 1, "seccompProfile": {"type": ""}}, "containers": [CONTAINER],
    "volumes": [{"name": "", "secret": {"secretName": "", "defaultMode": 1}, "emptyDir": {"sizeLimit": ""}}]}
TEMPLATE = {"metadata": {"labels": LABELS}, "spec": POD}
KINDS = {
    "Service": ("v1", {"clusterIP": "", "selector": LABELS, "ports": [{"name": "", "port": 1, "targetPort": ""}]}),
    "DaemonSet": ("apps/v1", {"selector": {"matchLabels": LABELS}, "template": TEMPLATE,
                              "updateStrategy": {"type": "", "rollingUpdate": {"maxUnavailable": 1}}}),
    "Job": ("batch/v1", {"backoffLimit": 1, "template": TEMPLATE})}


class OnceLoader(yaml.SafeLoader):
    """Refuses a key that stands twice, as Kubernetes does."""

    def construct_mapping(self, node, deep=False):
        keys = [self.construct_object(key) for key, _ in node.value]
        if len(set(keys)) < len(keys):
            raise yaml.YAMLError(f"a key stands twice: {keys}")
        return super().construct_mapping(node, deep)


def objects(name):
    return list(yaml.load_all(house.text(FOLDER + name), OnceLoader))


def faults(value, example, place):
    """What is not as in the example: keys that it lacks, and values of another kind."""
    if type(value) is not type(example):
        return [f"{place}: {value!r}"]
    if isinstance(value, list):
        return [fault for i, one in enumerate(value) for fault in faults(one, example[0], f"{place}[{i}]")]
    if not isinstance(value, dict):
        return []
    return [fault for key, one in value.items() for fault in
            (faults(one, example[key], f"{place}.{key}") if key in example else [f"{place}.{key} does not exist"])]


class Manifests(unittest.TestCase):
    def setUp(self):
        self.service, self.daemons = objects("live-farm.yaml")
        self.job, = objects("live-trainer.yaml")
        self.pod = self.daemons["spec"]["template"]
        self.container, = self.pod["spec"]["containers"]

    def test_every_field_exists(self):
        for item in (self.service, self.daemons, self.job):
            version, spec = KINDS[item["kind"]]
            known = {"apiVersion": "", "kind": "", "metadata": META, "spec": spec}
            self.assertEqual(faults(item, known, item["kind"]), [])
            self.assertEqual(item["apiVersion"], version)
        self.container["imagePullPolicies"] = self.container["ports"][0]["containerPort"] = "5770"
        self.assertEqual(len(faults(self.daemons["spec"], KINDS["DaemonSet"][1], "spec")), 2)
        with self.assertRaisesRegex(yaml.YAMLError, "stands twice"):
            yaml.load("{a: 1, a: 2}", OnceLoader)

    def test_the_name_has_the_address_of_each_pod(self):
        self.assertEqual(self.service["spec"]["clusterIP"], "None")
        labels = self.pod["metadata"]["labels"]
        for selector in (self.service["spec"]["selector"], self.daemons["spec"]["selector"]["matchLabels"]):
            self.assertEqual(selector, labels)
        address = next(one["value"] for one in self.job["spec"]["template"]["spec"]["containers"][0]["env"]
                       if one["name"] == "SACCADE_SERVER")
        self.assertEqual(address, f"tcp://{self.service['metadata']['name']}:5770")

    def test_ports_and_keys_are_those_of_the_image(self):
        image = dict(re.findall(r"\b([A-Z_]+)=(\S+)", house.text("deploy/Dockerfile")))
        ports = {one["name"]: one["containerPort"] for one in self.container["ports"]}
        self.assertEqual(ports, {name: int(image["SACCADE_" + name.upper()].rpartition(":")[2])
                                 for name in ("control", "data", "broadcast", "http")})
        for one in self.service["spec"]["ports"]:  # of a headless one these are the ports of the pods themselves
            self.assertEqual((one["port"], one["targetPort"]), (ports[one["name"]], one["name"]))
        mounted = {one["name"]: one["mountPath"] for one in self.container["volumeMounts"]}
        self.assertEqual(set(mounted), {one["name"] for one in self.pod["spec"]["volumes"]})
        for key in ("SACCADE_SECRET_KEY", "SACCADE_CLIENT_KEYS"):
            self.assertTrue(image[key].startswith(mounted["keys"] + "/"), key)
        self.assertEqual(image["XDG_CACHE_HOME"], mounted["cache"])
        self.assertIn(f"USER {self.pod['spec']['securityContext']['runAsUser']}:", house.text("deploy/Dockerfile"))

    def test_pods_are_ready_when_the_server_is(self):
        pages = house.text("server/app/app.cpp")
        for probe in ("readinessProbe", "livenessProbe"):
            self.assertIn(f'"{self.container[probe]["httpGet"]["path"]}"', pages)
        self.assertEqual(self.container["readinessProbe"]["httpGet"], {"path": "/readyz", "port": "http"})


if __name__ == "__main__":
    unittest.main()
