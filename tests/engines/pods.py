"""Runs the pods of an Indexed Job as a kubelet would: in the root of an image, as the user, with the volumes, arguments and
variables that the manifest says, and nothing else. It needs root, and no Kubernetes."""
import os
import pathlib
import re
import shlex
import subprocess
import tempfile

import yaml

PATH = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"


def expanded(text, variables):
    """Kubernetes' $(NAME); $$ stands for $, and what is unknown stays."""
    def value(found):
        return "$" if found[0] == "$$" else variables.get(found[1], found[0])
    return re.sub(r"\$\$|\$\(([-._A-Za-z0-9]+)\)", value, text)


def variables_of(container, index, more):
    variables = {"PATH": PATH, **more, "JOB_COMPLETION_INDEX": str(index)}
    for variable in container.get("env", []):
        variables[variable["name"]] = expanded(variable["value"], variables)
    return variables


class Pods:
    """`roots`: the root of each image. `claims`, `secrets`: their folders. `more`: other folders within the containers."""

    def __init__(self, manifest, roots, claims=None, secrets=None, more=None):
        self.job = yaml.safe_load(manifest)
        self.spec = self.job["spec"]["template"]["spec"]
        self.roots, self.claims, self.secrets, self.more = roots, claims or {}, secrets or {}, more or {}

    def run(self, index, variables=None):
        """The exit code of a pod."""
        with tempfile.TemporaryDirectory() as scratch:
            with self.start(index, scratch, variables) as worker:
                pass
        return worker.returncode

    def start(self, index, scratch, variables=None):
        """Starts a pod, whose new volumes are in `scratch`: the process of its worker, for send()."""
        pathlib.Path(scratch).chmod(0o755)
        volumes = {volume["name"]: self._folder(volume, pathlib.Path(scratch)) for volume in self.spec["volumes"]}
        for container in self.spec.get("initContainers", []):
            with self._start(container, index, volumes, variables or {}) as process:
                pass
            assert process.returncode == 0, container["name"]
        return self._start(self.spec["containers"][0], index, volumes, variables or {})

    def _folder(self, volume, scratch):
        if "persistentVolumeClaim" in volume:
            return self.claims[volume["persistentVolumeClaim"]["claimName"]]
        if "secret" in volume:
            return self.secrets[volume["secret"]["secretName"]]
        assert "emptyDir" in volume, volume
        folder = scratch / volume["name"]
        folder.mkdir()
        os.chown(folder, -1, self.spec["securityContext"]["fsGroup"])
        folder.chmod(0o2775)
        return folder

    def _start(self, container, index, volumes, more):
        root = self.roots[container["image"]]
        variables = variables_of(container, index, more)
        words = [expanded(word, variables) for word in container["command"] + container.get("args", [])]
        lines = ["set -e", f"mount --bind {shlex.quote(str(root))} {shlex.quote(str(root))}", f"cd {shlex.quote(str(root))}"]
        mounts = [(volumes[mount["name"]], mount["mountPath"], mount.get("subPath", ""), mount.get("readOnly", False))
                  for mount in container["volumeMounts"]]
        mounts += [(folder, path, "", False) for path, folder in self.more.items()]
        for folder, path, sub_path, read_only in mounts:
            source, target = shlex.quote(str(pathlib.Path(folder) / sub_path)), shlex.quote(str(root) + path)
            lines += [f"mkdir -p {target}", f"mount --bind {source} {target}"]
            lines += [f"mount -o remount,bind,ro {target}"] if read_only else []
        assert container["securityContext"]["readOnlyRootFilesystem"]
        user = self.spec["securityContext"]
        lines += ["mount -t proc proc proc", "mount -t devtmpfs dev dev 2>/dev/null || mount --bind /dev dev",
                  f"mount -o remount,bind,ro {shlex.quote(str(root))}",
                  f"exec chroot --userspec={user['runAsUser']}:{user['runAsGroup']} --groups={user['fsGroup']} . " + shlex.join(words)]
        command = ["unshare", "--mount", "--pid", "--fork", "bash", "-c", "\n".join(lines)]
        return subprocess.Popen(command, env=variables, stdin=subprocess.DEVNULL)


def send(pod, signal):
    """Sends a signal to the first process of a pod, as a kubelet does. SIGKILL ends all of the pod."""
    children = pathlib.Path(f"/proc/{pod.pid}/task/{pod.pid}/children").read_text(encoding="utf-8").split()
    os.kill(int(children[0]), signal)


def overlay(folder):
    """A root with all that this machine has, whose changes are forgotten; None where there can be none."""
    folder = pathlib.Path(folder)
    for name in ("changes", "scratch", "root"):
        (folder / name).mkdir(parents=True)
    done = subprocess.run(["mount", "-t", "overlay", "-o", f"lowerdir=/,upperdir={folder}/changes,workdir={folder}/scratch",
                           "none", str(folder / "root")], stderr=subprocess.DEVNULL, check=False)
    return folder / "root" if done.returncode == 0 else None
