"""Attributes that are texts: views of several words of a component, each of which has two bytes in UTF-8.

Bytes behind its end are 0. While the text is not known, the first word is UNKNOWN, of which the low 16 bits are 0, too:
it goes out as the empty text. A text is cut to the bytes that are kept, between two characters, and ends at its first
NUL. To set one allocates, to send it does not.
"""

from words import UNKNOWN


def text(place, length, initial=None):
    """Return an attribute for a text of up to `length` bytes; set to None it is `initial`, or unknown."""

    def get(self):
        words = self.words
        if words[place] == UNKNOWN:
            return None
        data = bytearray(length)
        end = 0
        while end < length:
            letter = words[place + (end >> 1)] >> ((end & 1) << 3) & 0xFF
            if not letter:
                break
            data[end] = letter
            end += 1
        return str(data[:end], "utf-8")

    def put(self, value):
        words = self.words
        if value is None:
            value = initial
        data = _kept("" if value is None else value, length)
        for at in range(0, length, 2):
            high = data[at + 1] << 8 if at + 1 < len(data) else 0
            words[place + (at >> 1)] = data[at] | high if at < len(data) else 0
        if value is None:
            words[place] = UNKNOWN

    return property(get, put)


def _kept(value, length):
    """Return the bytes that are kept of a text."""
    data = value.encode()
    end = data.find(b"\0")
    if end < 0:
        end = len(data)
    if end > length:
        end = length
        while data[end] & 0xC0 == 0x80:
            end -= 1
    return data[:end]
