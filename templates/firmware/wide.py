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
    about = place, halves, low, high  # a call with more than a few variables of its own would allocate

    def get(self):
        return _whole(self.words, about)

    def put(self, value):
        _keep(self.words, about, value)

    return property(get, put)


def shown_integer(place, halves, low, high, numerator, denominator=1):
    """Return an attribute in the unit of people, `numerator` / `denominator` steps of which make one.

    It is as exact as the floats of the port, where a board with floats of 32 bits has 7 digits; a whole number in the
    unit that is kept is exact.
    """
    about = place, halves, low, high

    def get(self):
        value = _whole(self.words, about)
        return None if value is None else in_unit(value, numerator, denominator)

    def put(self, value):
        if numerator != denominator or not isinstance(value, int):
            value = to_steps(value, numerator, denominator, low, high)
        _keep(self.words, about, value)

    return property(get, put)


def floating(place, halves, low=None, high=None, numerator=1, denominator=1):
    """Return an attribute for a float of 32 or 64 bits; `numerator` / `denominator` of its units make one that is kept.

    What is beyond the largest float of these bits becomes that one. Limits are in units that are kept.
    """
    code, largest = ("<f", b"\xff\xff\x7f\x7f") if halves == 2 else ("<d", b"\xff\xff\xff\xff\xff\xff\xef\x7f")

    def get(self):
        words = self.words
        if words[place] == UNKNOWN:
            return None
        for at in range(halves):
            _data[2 * at] = words[place + at] & 0xFF
            _data[2 * at + 1] = words[place + at] >> 8
        return in_unit(unpack_from(code, _data)[0], numerator, denominator)

    def put(self, value):
        words = self.words
        if value is None or value != value:  # noqa: PLR0124
            words[place] = UNKNOWN
            return
        if numerator != denominator:
            value = value * numerator / denominator
        most = unpack_from(code, largest)[0]
        value = limited(value, -most if low is None else low, most if high is None else high)
        pack_into(code, _data, 0, value)
        for at in range(halves):
            words[place + at] = _data[2 * at] | _data[2 * at + 1] << 8

    return property(get, put)


def _whole(words, about):
    """Return the number of which the words are the halves, or None."""
    at = about[0] + about[1] - 1
    if words[about[0]] == UNKNOWN:
        return None
    value = words[at]
    if about[2] < 0 and value >= 0x8000:
        value -= 0x10000
    while at > about[0]:
        at -= 1
        value = value << 16 | words[at]
    return value


def _keep(words, about, value):
    """Write the halves of a number within its limits, or that it is unknown."""
    at = about[0]
    if value is None:
        words[at] = UNKNOWN
        return
    value = limited(value, about[2], about[3])
    end = at + about[1]
    while at < end:
        words[at] = value & 0xFFFF
        value >>= 16
        at += 1
