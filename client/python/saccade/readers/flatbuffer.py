"""Reads tables of FlatBuffers, as far as AEDAT4 needs them. Layout: flatbuffers.dev/internals."""
from __future__ import annotations

import struct
from typing import Any


class Table:
    """A table within `data`. Fields are numbered as the schema lists them. Raises struct.error where it ends early."""

    def __init__(self, data: bytes, at: int) -> None:
        self.data, self._at = data, at
        self._vtable = at - struct.unpack_from("<i", data, at)[0]
        self._vtable_bytes = struct.unpack_from("<H", data, self._vtable)[0]

    @classmethod
    def root(cls, data: bytes) -> Table:
        """The root of a buffer that begins with its size."""
        return cls(data, 4 + struct.unpack_from("<I", data, 4)[0])

    def number(self, field: int, kind: str, default: int) -> Any:
        """kind: as struct names it, such as "i" for 32 bits."""
        at = self._position(field)
        return default if at is None else struct.unpack_from("<" + kind, self.data, at)[0]

    def vector(self, field: int) -> tuple[int, int]:
        """Where its first item lies, and how many there are."""
        at = self._position(field)
        if at is None:
            return 0, 0
        start = at + struct.unpack_from("<I", self.data, at)[0]
        return start + 4, struct.unpack_from("<I", self.data, start)[0]

    def text(self, field: int) -> str:
        start, size = self.vector(field)
        return self.data[start : start + size].decode()

    def _position(self, field: int) -> int | None:
        entry = 4 + 2 * field
        if entry >= self._vtable_bytes:
            return None
        offset = struct.unpack_from("<H", self.data, self._vtable + entry)[0]
        return self._at + offset if offset else None
