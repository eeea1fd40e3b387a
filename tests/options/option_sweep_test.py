"""Gives every option of every program values that are wrong, and prints what the programs answer.

Usage: option_sweep_test.py SACCADED SACCADE SACCADE_EVAL. --help of each command tells its options, so that none is left
out. Each is refused before anything is rendered; the answer names option and value, in words of ours. Options that
several commands share are tried with the first of them. Without SACCADE_FULL=1 each has two of its values.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from described_options import commands_of, options_of
from wrong_values import WORDS_OF_OTHERS, wrong_values

SACCADED, SACCADE, EVAL = (str(pathlib.Path(path).resolve()) for path in sys.argv[1:4])
FULL = os.environ.get("SACCADE_FULL") == "1"
FREE = ["--control", "tcp://127.0.0.1:0", "--data", "tcp://127.0.0.1:0", "--broadcast", "tcp://127.0.0.1:0"]
PARTNERS = {  # options that are refused alone
    SACCADED: {"--secret-key": ["--client-keys"], "--client-keys": ["--secret-key"],
               "--viewer-key": ["--secret-key", "--client-keys"]},
    SACCADE: {"--secret-key": ["--server-key"], "--server-key": ["--secret-key"]},
}
KEYS = {"--secret-key": "a.key", "--server-key": "a.pub", "--client-keys": "a.pub"}
MAY_BE_EMPTY = {"--secret-key", "--client-keys", "--viewer-key", "--bakes", "--meshes", "--config"}  # of saccaded: none
CPU_S, TIMEOUT_S = 4, 120  # a refusal takes less than a second of CPU; the machine may be loaded


class Place:
    """A folder with what the command lines name, and a server."""

    def __init__(self, folder, control):
        self.folder, self.control = folder, control
        (folder / "folder").mkdir()
        (folder / "file.csv").write_bytes(b"\xff\x00 nonsense\n")
        (folder / "frames.f32").write_bytes(bytes(4 * 4 * 4 * 3))
        for name in ("a.key", "a.pub"):
            (folder / name).write_text("k" * 40 + "\n")
        self.csv = folder / "events.csv"
        self.csv.write_text("t,x,y,p\n1,2,1,1\n")
        self.lines = self.make_lines()

    def fill_in(self, value):
        for word, path in (("$FOLDER", "folder"), ("$FILE", "file.csv"), ("$NONE", "none")):
            value = value.replace(word, str(self.folder / path))
        return value

    def client(self):
        return ["--control", self.control]

    def make_lines(self):
        """A right command line for each command, but for what it has to have: {command: (positional, others)}."""
        out = str(self.folder / "out.csv")
        stream = ["--motion", "right", "--size", "8x8", "--duration", "0.01", *self.client()]
        scene, quick = {"scene": "cornell-box"}, ["--size", "8x8", "--frames", "1:2", "--reference", "64"]
        figure = [*quick, "-o", str(self.folder / "figure")]
        return {
            (SACCADED,): ({}, [*FREE, "--http", "off", "--check-config"]),
            (SACCADE, "list"): ({}, self.client()), (SACCADE, "info"): ({}, self.client()),
            (SACCADE, "streams"): ({}, self.client()), (SACCADE, "close"): ({"streams": "nothing"}, self.client()),
            (SACCADE, "record"): (scene, [*stream, "--output", out]),
            (SACCADE, "events"): ({"frames": str(self.folder / "frames.f32")},
                                  ["--size", "4x4", "--rate", "100", "--output", out, *self.client()]),
            (SACCADE, "view"): (scene, stream), (SACCADE, "serve-dv"): (scene, ["--listen", "127.0.0.1:0", *stream]),
            (SACCADE, "replay"): ({"recording": str(self.folder / "none.json")}, ["--output", out, *self.client()]),
            (SACCADE, "convert"): ({"input": str(self.csv), "output": out}, ["--size", "4x4"]),
            (SACCADE, "verify"): ({"file": str(self.csv)}, []), (SACCADE, "keygen"): ({"name": "a"}, []),
            (EVAL, "render"): (scene, ["--size", "8x8", "--spp", "1", "--output", str(self.folder / "out.png")]),
            (EVAL, "scene"): (scene, []),
            (EVAL, "frames"): (scene, ["--size", "8x8", "--frames", "1:2"]),
            (EVAL, "compare"): ({"dump": str(self.folder / "folder"), "reference": str(self.folder / "folder")}, []),
            (EVAL, "compare-renders"): ({"picture": str(self.csv), "reference": str(self.csv)}, []),
            (EVAL, "compare-events"): ({"A": str(self.csv), "B": str(self.csv)}, ["--size", "4x4"]),
            (EVAL, "refine"): (scene, ["--size", "8x8", "--intervals", "1"]),
            (EVAL, "times"): (scene, ["--size", "8x8", "--windows", "1"]),
            (EVAL, "bake"): (scene, ["--size", "8x8", "--frames", "1", "--output", str(self.folder / "bake")]),
            (EVAL, "cells"): ({"scenes": "cornell-box"}, figure), (EVAL, "chart"): ({"scenes": "cornell-box"}, figure),
            (EVAL, "odds"): ({"scenes": "cornell-box"}, figure), (EVAL, "tasks"): ({"scenes": "cornell-box"}, figure),
            **{(EVAL, "figure", name): ({"scenes": "cornell-box"}, figure) for (name,) in commands_of(EVAL, "figure")},
            (EVAL, "sensor"): ({}, ["--size", "4x4"]),
            (EVAL, "simplification"): ({"scenes": "cornell-box"}, [*quick, "--output", str(self.folder / "s.csv")]),
        }


def without(words, name):
    names = {name, "--motion"} if name == "--trajectory" else {name, "-o"} if name == "--output" else {name}
    return [word for i, word in enumerate(words) if word not in names and (i == 0 or words[i - 1] not in names)]


def line_with(place, command, option, value):
    positional, others = place.lines[command]
    if option.positional:
        positional = {**positional, option.name: value}
        return [*command, *positional.values(), *others]
    partners = PARTNERS.get(command[0], {}).get(option.name, [])
    keys = [f"{name}={place.folder / KEYS[name]}" for name in partners]
    return [*command, *positional.values(), *without(others, option.name), f"{option.name}={value}", *keys]


def cases(place):
    """(command, option, value): each option of a program once, as --help describes it."""
    seen = set()
    for command in place.lines:
        for option in options_of(*command):
            if (command[0], option.name, option.about) in seen:
                continue
            seen.add((command[0], option.name, option.about))
            values = wrong_values(option)
            if command == (SACCADED,) and option.name in MAY_BE_EMPTY:
                values.remove("")
            for value in values if FULL else [values[0], values[len(seen) % (len(values) - 1) + 1]]:
                yield command, option, place.fill_in(value)


def numbers_in(text):
    """Of the texts: -1e300 is -1e+300, and 200% is 2."""
    found = re.findall(r"(-?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(%?)", text)
    return {float(number) / 100 if percent else float(number) for number, percent in found}


def names(answer, value):
    """Whether the answer has the value, a part of it such as the number of NAME=NUMBER, or tells that it lacks parts."""
    parts = [value, *re.split(r"[=:,/%@]", value)]
    return (any(part and part in answer for part in parts) or "required but received" in answer
            or bool(numbers_in(value) & numbers_in(answer)))


def fault_of(option, value, code, answer):
    if code not in (1, 2):
        return f"exit code {code}"
    is_file = value.startswith("/") and value in answer
    if option.name.lstrip("-") not in answer.lower() and not option.positional and not is_file:
        return "does not name the option"
    if value and not names(answer, value):
        return "does not name the value"
    return next((f"says '{word}'" for word in WORDS_OF_OTHERS if word in answer), "")


def ask(line, folder):
    line = ["prlimit", f"--cpu={CPU_S}", "--", *line]
    try:
        done = subprocess.run(line, cwd=folder, capture_output=True, text=True, errors="replace", timeout=TIMEOUT_S,
                              stdin=subprocess.DEVNULL, check=False)
    except subprocess.TimeoutExpired:
        return "none", "it goes on"
    return done.returncode, (done.stdout + done.stderr).strip()


def start_server():
    command = [SACCADED, *FREE, "--http", "off", "--threads", "1"]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    ready = next((match for match in (re.search(r"ready: control (\S+)", line) for line in server.stdout) if match), None)
    if ready is None:
        raise RuntimeError("saccaded did not start")
    return server, ready[1]


class Options(unittest.TestCase):
    def setUp(self):
        self.place_folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.server, control = start_server()
        self.addCleanup(self.stop)
        self.place = Place(self.place_folder, control)

    def stop(self):
        self.server.terminate()
        self.server.communicate()

    def test_each_refuses_what_is_wrong(self):
        tried = list(cases(self.place))
        lines = [line_with(self.place, *case) for case in tried]
        faults = []
        print("program | option | value | exit code | answer")
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            answers = pool.map(lambda line: ask(line, self.place_folder), lines)
            for (command, option, value), (code, answer) in zip(tried, answers):
                fault = fault_of(option, value, code, answer)
                program = " ".join([pathlib.Path(command[0]).name, *command[1:]])
                row = f"{program} | {option.name} | {value} | {code} | {' / '.join(answer.splitlines())[:300]}"
                print(f"{row} | FAULT: {fault}" if fault else row, flush=True)
                faults += [f"{row}: {fault}"] if fault else []
        print(f"{len(tried)} values")
        self.assertIsNone(self.server.poll())
        self.assertEqual(len(faults), 0, "\n" + "\n".join(faults))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
