"""Attributes for numbers of more than 30 bits, and for floats: views of several words of a component.

Each of these words has 16 bits, the low ones first, which every port reads without allocating; while the number is not
known, the first one is UNKNOWN. Set to None, or to NaN, a number becomes unknown. What is beyond its limits becomes
the limit.
"""

from struct import pack_into, unpack_from

from conversion import limited, to_steps
from words import UNKNOWN, in_unit

_data = bytearray(8)  # where a float and its bits are exchanged


def integer(place, halves, low, high):
    """Return an attribute for a whole number from `low` to `high`; one below 0 is kept as its two's complement."""
    about = halves, low, high  # a call with more than a few variables of its own would allocate

    def get(self):
        return whole_at(self.words, place, about)

    def put(self, value):
        keep_whole(self.words, place, about, value)

    return property(get, put)


def shown_integer(place, halves, low, high, numerator, denominator=1):
    """Return an attribute in the unit of people, `numerator` / `denominator` steps of which make one.

    It is as exact as the floats of the port, where a board with floats of 32 bits has 7 digits; a whole number in the
    unit that is kept is exact.
    """
    about = halves, low, high

    def get(self):
        value = whole_at(self.words, place, about)
        return None if value is None else in_unit(value, numerator, denominator)

    def put(self, value):
        if numerator != denominator or not isinstance(value, int):
            value = to_steps(value, numerator, denominator, low, high)
        keep_whole(self.words, place, about, value)

    return property(get, put)


def floating(place, halves, low=None, high=None, numerator=1, denominator=1):
    """Return an attribute for a float of 32 or 64 bits; `numerator` / `denominator` of its units make one that is kept.

    What is beyond the largest float of these bits becomes that one. Limits are in units that are kept.
    """
    about = halves, low, high, numerator, denominator

    def get(self):
        return float_at(self.words, place, about)

    def put(self, value):
        keep_float(self.words, place, about, value)

    return property(get, put)


def float_at(words, place, about):
    """Return the float of which the words from a place on are the halves, in the unit of people, or None."""
    if words[place] == UNKNOWN:
        return None
    halves, _, _, numerator, denominator = about
    for at in range(halves):
        _data[2 * at] = words[place + at] & 0xFF
        _data[2 * at + 1] = words[place + at] >> 8
    return in_unit(unpack_from("<f" if halves == 2 else "<d", _data)[0], numerator, denominator)


def keep_float(words, place, about, value):
    """Write the halves of a float within its limits, or that it is unknown."""
    halves, low, high, numerator, denominator = about
    if value is None or value != value:  # noqa: PLR0124
        words[place] = UNKNOWN
        return
    if numerator != denominator:
        value = value * numerator / denominator
    code, largest = ("<f", b"\xff\xff\x7f\x7f") if halves == 2 else ("<d", b"\xff\xff\xff\xff\xff\xff\xef\x7f")
    most = unpack_from(code, largest)[0]
    value = limited(value, -most if low is None else low, most if high is None else high)
    pack_into(code, _data, 0, value)
    for at in range(halves):
        words[place + at] = _data[2 * at] | _data[2 * at + 1] << 8


def whole_at(words, at, about):
    """Return the number of which the words from a place on are the halves, or None."""
    if words[at] == UNKNOWN:
        return None
    left = about[0] - 1
    value = words[at + left]
    if about[1] < 0 and value >= 0x8000:
        value -= 0x10000
    while left:
        left -= 1
        value = value << 16 | words[at + left]
    return value


def keep_whole(words, at, about, value):
    """Write the halves of a number within its limits, or that it is unknown."""
    if value is None:
        words[at] = UNKNOWN
        return
    value = limited(value, about[1], about[2])
    end = at + about[0]
    while at < end:
        words[at] = value & 0xFFFF
        value >>= 16
        at += 1
