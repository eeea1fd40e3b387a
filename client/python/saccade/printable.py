"""Text of a server or a file, made fit for a terminal."""
from __future__ import annotations

import re

_CONTROLS = re.compile("[\x00-\x1f\x7f-\x9f]")


def printable(text: object) -> str:
    """The text with its control characters as escapes such as \\n and \\u001b: they could command a terminal."""
    return _CONTROLS.sub(lambda found: "\\n" if found[0] == "\n" else f"\\u{ord(found[0]):04x}", str(text))
