"""EVT2: words of 32 bits. docs.prophesee.ai/stable/data/encoding_formats/evt2.html.

Bits of an event, from the lowest: y 11, x 11, t[5:0] 6, type 4 (0 OFF, 1 ON). Of TIME_HIGH: t[33:6] 28, type 8.
"""
from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from saccade.readers.columns import Columns
from saccade.readers.state import Latched, Wraps, tell_unknown

TIME_HIGH = 8


class Evt2Decoder:
    WORD = np.dtype("<u4")

    def __init__(self) -> None:
        self._high = Latched()
        self._wraps = Wraps(bits=28)

    def decode(self, words: NDArray[np.uint32]) -> Columns:
        kind = words >> 28
        is_high = kind == TIME_HIGH
        high = self._high.spread(is_high, self._wraps.unwrap((words[is_high] & 0xFFFFFFF).astype(np.int64)))
        is_event = (kind <= 1) & (high >= 0)
        tell_unknown(int(np.count_nonzero((kind <= 1) & (high < 0))))
        event = words[is_event]
        t = high[is_event] << 6 | (event >> 22 & 0x3F)
        return t, (event >> 11 & 0x7FF).astype(np.uint16), (event & 0x7FF).astype(np.uint16), kind[is_event] == 1
