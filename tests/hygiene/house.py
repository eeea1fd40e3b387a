"""The files of the project, for the hygiene tests."""
import functools
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ["server", "client", "proto", "scenes", "tests", "deploy", ".ci"]
SOURCES = {".cpp", ".h"}
TEXTS = SOURCES | {"", ".txt", ".md", ".json", ".proto", ".py", ".xml", ".csv", ".yaml", ".toml", ".service", ".clang-format", ".js", ".mjs", ".html", ".css"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def files(suffixes):
    """All files of the project with one of these suffixes, as paths relative to its root, sorted."""
    found = [p for p in ROOT.iterdir() if p.is_file()]
    for folder in FOLDERS:
        found += [p for p in (ROOT / folder).rglob("*") if p.is_file()]
    return sorted(p.relative_to(ROOT) for p in found if p.suffix in suffixes and "__pycache__" not in p.parts)


def text(path):
    return (ROOT / path).read_text(encoding="utf-8", errors="replace")


@functools.cache
def includes(path):
    """What a source includes: pairs of `<` or `"`, and a name."""
    return INCLUDE.findall(text(path))
