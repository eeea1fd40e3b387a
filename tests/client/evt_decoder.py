"""Decoders of Prophesee RAW files, transcribed from the pages "EVT 3.0 Format", "EVT 2.0 Format" and "RAW File Format"
of docs.prophesee.ai. They refuse what some decoder of the field would lose or misread.
"""
import struct


class Refused(Exception):
    """The file breaks a rule."""


def need(condition, what):
    if not condition:
        raise Refused(what)


def split_header(data):
    """The keys of the header with their values, and the bytes after it."""
    keys = {}
    while data.startswith(b"% "):
        line, data = data.split(b"\n", 1)
        text = line.decode("ascii")
        need(text == text.rstrip(), f"blanks at the end of {text!r}")
        if text == "% end":
            break
        _, key, value = text.split(" ", 2)
        keys[key] = value
    return keys, data


def size_of(keys):
    width, height = (int(edge) for edge in keys["geometry"].split("x"))
    options = dict(option.split("=") for option in keys["format"].split(";")[1:])
    need((int(options["width"]), int(options["height"])) == (width, height), "two sizes")
    return width, height


def decode_evt3(data):
    """The keys, the events (t_us, x, y, p), and the time up to which the file goes, in microseconds."""
    keys, body = split_header(data)
    need(keys["evt"] == "3.0" and keys["format"].startswith("EVT3;"), "not EVT3")
    need(len(body) % 2 == 0, "half a word")
    width, height = size_of(keys)
    words = struct.unpack(f"<{len(body) // 2}H", body)
    events = []
    high = low = row = base = None
    i = 0
    while i < len(words):
        kind, content = words[i] >> 12, words[i] & 0xFFF
        need(kind == 8 or high is not None, "no TIME_HIGH at the front")
        if kind == 8:  # EVT_TIME_HIGH: bits 23..12 of the time
            need(content == (0 if high is None else (high + 1) % 4096), "a step of TIME_HIGH is missing")
            high = 0 if high is None else high + 1
            low = None
        elif kind == 6:  # EVT_TIME_LOW: bits 11..0
            need(low is None or content > low, "TIME_LOW runs back, or is told twice")
            low = content
        elif kind == 0:  # EVT_ADDR_Y
            need(content < height, "a row outside of the image")
            row = content
        elif kind == 2:  # EVT_ADDR_X: one event
            need(low is not None and row is not None, "an event without time or row")
            need(content & 0x7FF < width, "a column outside of the image")
            events.append((high * 4096 + low, content & 0x7FF, row, content >> 11))
        elif kind == 3:  # VECT_BASE_X
            base = content
            need(base % 2048 <= width - 32, "a vector that does not lie within the image")
        elif kind == 4:  # VECT_12, VECT_12, VECT_8
            need([word >> 12 for word in words[i:i + 3]] == [4, 4, 5], "a vector without all its words")
            need(base is not None and low is not None and row is not None, "a vector without place or time")
            need(words[i + 2] & 0xF00 == 0, "bits of VECT_8 that are none")
            columns = words[i] & 0xFFF | (words[i + 1] & 0xFFF) << 12 | (words[i + 2] & 0xFF) << 24
            events += [(high * 4096 + low, base % 2048 + bit, row, base >> 11) for bit in range(32) if columns >> bit & 1]
            base = None
            i += 2
        else:
            raise Refused(f"a word of type {kind}")
        i += 1
    return keys, events, 0 if high is None else high * 4096


def decode_evt2(data):
    """As decode_evt3()."""
    keys, body = split_header(data)
    need(keys["evt"] == "2.0" and keys["format"].startswith("EVT2;"), "not EVT2")
    need(len(body) % 4 == 0, "part of a word")
    width, height = size_of(keys)
    events, high, wraps = [], None, 0
    for word in struct.unpack(f"<{len(body) // 4}I", body):
        kind = word >> 28
        need(kind == 8 or high is not None, "no TIME_HIGH at the front")
        if kind == 8:  # EVT_TIME_HIGH: bits 33..6 of the time
            content = word & 0xFFFFFFF
            if high is not None and content < high:
                need((high, content) == (0xFFFFFFF, 0), "a wrap that skips its last or first value")
                wraps += 1
            high = content
        elif kind in (0, 1):  # CD_OFF, CD_ON
            x, y = word >> 11 & 0x7FF, word & 0x7FF
            need(x < width and y < height, "an event outside of the image")
            events.append(((wraps << 28 | high) * 64 + (word >> 22 & 0x3F), x, y, kind))
        else:
            raise Refused(f"a word of type {kind}")
    return keys, events, 0 if high is None else (wraps << 28 | high) * 64
