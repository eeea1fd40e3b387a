"""EVT3: words of 16 bits that set a state. docs.prophesee.ai/stable/data/encoding_formats/evt3.html.

Type in bits 15 to 12. 0 ADDR_Y: y 11. 2 ADDR_X: x 11, p 1; an event. 3 VECT_BASE_X: x 11, p 1. 4 VECT_12 and
5 VECT_8: an event for each bit, at base, base + 1, ...; the base then moves on by 12 or 8. 6 TIME_LOW: t[11:0].
8 TIME_HIGH: t[23:12]. Others carry no events.
"""
from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from saccade.readers.columns import Columns
from saccade.readers.state import UNKNOWN, Latched, Wraps, tell_unknown

ONE_BIT = (1 << np.arange(12)).astype(np.uint16)
ADDR_Y, ADDR_X, VECT_BASE_X, VECT_12, VECT_8, TIME_LOW, TIME_HIGH = 0, 2, 3, 4, 5, 6, 8


class Evt3Decoder:
    WORD = np.dtype("<u2")

    def __init__(self) -> None:
        self._wraps = Wraps(bits=12)
        self._high, self._low, self._y = Latched(), Latched(), Latched()
        self._base, self._base_moved, self._polarity = Latched(), Latched(), Latched()
        self._moved = 0  # the widths of all vectors so far

    def decode(self, words: NDArray[np.uint16]) -> Columns:
        kind, value = (words >> 12).astype(np.int64), (words & 0xFFF).astype(np.int64)
        is_high, is_low, is_y = kind == TIME_HIGH, kind == TIME_LOW, kind == ADDR_Y
        high = self._high.spread(is_high, self._wraps.unwrap(value[is_high]))
        low = self._low.spread(is_low, value[is_low])
        y = self._y.spread(is_y, value[is_y] & 0x7FF)
        base, polarity, bits = self._vectors(kind, value)
        known = (high >= 0) & (low >= 0) & (y >= 0) & (base >= 0)  # a recording may begin between words of a state
        tell_unknown(int(np.count_nonzero((bits != 0) & ~known)))
        word = np.flatnonzero((bits != 0) & known)
        # Each bit that is set is an event; those of a word follow each other from the lowest bit on.
        row, bit = np.nonzero(bits[word, np.newaxis].astype(np.uint16) & ONE_BIT != 0)
        word = word[row]
        t, x = (high[word] << 12) + low[word], base[word] + bit
        return t, x.astype(np.uint16), y[word].astype(np.uint16), polarity[word]

    def _vectors(self, kind: NDArray[np.int64],
                 value: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.bool_], NDArray[np.int64]]:
        """For each word: x of its first bit, polarity, and the bits that are events. ADDR_X has one bit, the lowest."""
        single, wide, narrow = kind == ADDR_X, kind == VECT_12, kind == VECT_8
        width = np.where(wide, 12, 0) + np.where(narrow, 8, 0)
        moved = self._moved + np.cumsum(width) - width  # by the vectors before the word
        self._moved += int(width.sum())
        is_base = kind == VECT_BASE_X
        start = self._base.spread(is_base, value[is_base] & 0x7FF)
        vector = np.where(start < 0, UNKNOWN, start + moved - self._base_moved.spread(is_base, moved[is_base]))
        base = np.where(single, value & 0x7FF, vector)
        polarity = np.where(single, value >> 11, self._polarity.spread(is_base, value[is_base] >> 11)) > 0
        bits = np.where(single, 1, np.where(wide, value, np.where(narrow, value & 0xFF, 0)))
        return base, polarity, bits
