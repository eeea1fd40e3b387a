"""Decodes the events of event_camera_msgs/EventPacket, as docs.prophesee.ai describes "EVT 3.0 Format"."""
import struct

HIGH_US, WRAP_US = 4096, 1 << 24


class Evt3:
    """What a receiver keeps from message to message."""

    def __init__(self):
        self.high = None  # microseconds, with wraps

    def decode(self, message):
        """The events of a message, as (t_us, x, y, p)."""
        words = struct.unpack(f"<{len(message) // 2}H", message)
        events, low, row, base, i = [], None, None, 0, 0
        while i < len(words):
            kind, content = words[i] >> 12, words[i] & 0xFFF
            if kind == 8:
                self.high = self.after_wraps(content * HIGH_US)
            elif kind == 6:
                low = content
            elif kind == 0:
                row = content
            elif kind == 2:
                events.append((self.high + low, content & 0x7FF, row, content >> 11))
            elif kind == 3:
                base = content
            else:
                assert [word >> 12 for word in words[i:i + 3]] == [4, 4, 5]
                bits = words[i] & 0xFFF | (words[i + 1] & 0xFFF) << 12 | (words[i + 2] & 0xFF) << 24
                events += [(self.high + low, base % 2048 + n, row, base >> 11) for n in range(32) if bits >> n & 1]
                i += 2
            i += 1
        return events

    def after_wraps(self, us):
        if self.high is None:
            return us
        return us + (self.high - us + WRAP_US - 1) // WRAP_US * WRAP_US
