"""The options of a command, as its --help describes them."""
import pathlib
import re
import subprocess
from dataclasses import dataclass


@dataclass(frozen=True)
class Option:
    """name: as it is given, "--size"; of a positional one without dashes. kind: "TEXT", "FLOAT", "INT" or "UINT", and ""
    for a flag. about: what --help says of it, without its default."""

    name: str
    kind: str
    about: str

    @property
    def positional(self):
        return not self.name.startswith("-")


def options_of(*command):
    """All that take a value."""
    every = ["--help-all"] if len(command) > 1 and pathlib.Path(command[0]).name == "saccade" else ["--help"]
    text = subprocess.run([*command, *every], capture_output=True, text=True, check=True).stdout
    text = re.sub(r"\n {30}(?=\S)", " ", text.split("\nSubcommands:")[0])  # what takes two lines becomes one
    text = re.sub(r" (?:Excludes|Needs):(?: --[\w-]+)+", "", text)  # CLI11 lists them by their addresses
    rows = re.findall(r"^  (?:-\w,)?(--[\w-]+|[a-z]+)(?:,--\w+)? (TEXT|FLOAT|INT|UINT|FRAMES|NAME)(\S*.*)$", text, re.M)
    return [Option(name, kind, re.sub(r"^\S*=\S*", "", rest).strip()) for name, kind, rest in rows]


def commands_of(*program):
    """The subcommands of a program, each as words."""
    text = subprocess.run([*program, "--help"], capture_output=True, text=True, check=True).stdout
    names = re.findall(r"^  ([\w-]+) ", text.partition("\nSubcommands:")[2], re.M)
    return [[name] for name in names]
