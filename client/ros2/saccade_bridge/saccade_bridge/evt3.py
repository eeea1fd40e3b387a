"""Encodes events as EVT3, as docs.prophesee.ai describes it under "EVT 3.0 Format": words of 16 bits."""
import numpy as np

ADDR_Y, ADDR_X, TIME_LOW, TIME_HIGH = 0x0000, 0x2000, 0x6000, 0x8000
TIME_BITS, POLARITY_SHIFT = 12, 11


def differs(column):
    """Where a value is not the one before it; true for the first."""
    return np.concatenate([[True], column[1:] != column[:-1]])[:column.size]


def encode(events):
    """The bytes of a saccade.Events. They build on none before them; without events they tell the time alone."""
    if not len(events):
        return _time_words(np.array([events.t0])).astype("<u2").tobytes()
    row, column, on = (part.astype(np.int64) for part in (events.y, events.x, events.p))
    words = np.column_stack([_time_words(events.t), ADDR_Y | row, ADDR_X | on << POLARITY_SHIFT | column])
    always = np.ones(len(events), bool)
    told = np.column_stack([differs(events.t >> TIME_BITS), differs(events.t), differs(row), always])
    return words[told].astype("<u2").tobytes()


def _time_words(t_us):
    mask = (1 << TIME_BITS) - 1
    return np.column_stack([TIME_HIGH | t_us >> TIME_BITS & mask, TIME_LOW | t_us & mask])
