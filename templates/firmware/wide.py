"""Attributes for numbers of more than 30 bits, and for floats: views of several words of a component.

Each of these words has 16 bits, the low ones first, which every port reads without allocating; while the number is not
known, the first one is UNKNOWN. Set to None, or to NaN, a number becomes unknown. What is beyond its limits becomes
the limit, is counted and told. Where some message carries less, that is what `told` says: what is beyond that is
counted and told, too.
"""

from struct import pack_into, unpack_from

from conversion import limited, to_steps
from words import UNKNOWN, in_unit

_data = bytearray(8)  # where a float and its bits are exchanged


def integer(place, halves, low, high, name, told=None):
    """Return an attribute for a whole number from `low` to `high`; one below 0 is kept as its two's complement."""
    about = _about(place, halves, low, high, name, told)  # a call with more variables of its own would allocate

    def get(self):
        return _whole(self.words, about)

    def put(self, value):
        _set(self, about, value)

    return property(get, put)


def shown_integer(place, halves, low, high, name, numerator, denominator=1, told=None):
    """Return an attribute in the unit of people, `numerator` / `denominator` steps of which make one.

    It is as exact as the floats of the port, where a board with floats of 32 bits has 7 digits; a whole number in the
    unit that is kept is exact.
    """
    about = _about(place, halves, low, high, name, told)

    def get(self):
        value = _whole(self.words, about)
        return None if value is None else in_unit(value, numerator, denominator)

    def put(self, value):
        if numerator != denominator or not isinstance(value, int):
            value = to_steps(value, numerator, denominator, 1 << 64)
        _set(self, about, value)

    return property(get, put)


def floating(place, halves, name, low=None, high=None, told=None, numerator=1, denominator=1):
    """Return an attribute for a float of 32 or 64 bits; `numerator` / `denominator` of its units make one that is kept.

    What is beyond the largest float of these bits becomes that one. Limits are in units that are kept.
    """
    code, largest = ("<f", b"\xff\xff\x7f\x7f") if halves == 2 else ("<d", b"\xff\xff\xff\xff\xff\xff\xef\x7f")
    most = unpack_from(code, largest)[0]
    about = _about(place, halves, -most if low is None else low, most if high is None else high, name, told, code)

    def get(self):
        words = self.words
        if words[place] == UNKNOWN:
            return None
        for at in range(about[1]):
            _data[2 * at] = words[place + at] & 0xFF
            _data[2 * at + 1] = words[place + at] >> 8
        return in_unit(unpack_from(about[7], _data)[0], numerator, denominator)

    def put(self, value):
        if value is not None and value != value:  # noqa: PLR0124
            value = None
        if value is not None and numerator != denominator:
            value = value * numerator / denominator
        _set(self, about, value)

    return property(get, put)


def _about(place, halves, low, high, name, told, code=None):
    told = told or (low, high)
    return place, halves, low, high, told[0], told[1], name, code


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


def _set(component, about, value):
    """Keep a number, limited, or that it is unknown; one beyond what is told is counted and told."""
    if value is None:
        component.words[about[0]] = UNKNOWN
    elif about[4] <= value <= about[5]:
        _keep(component.words, about, value)
        if component.beyond:
            component.beyond.pop(about[0], None)
    else:
        _keep(component.words, about, limited(value, about[2], about[3]))  # raises for what is no number of the kind
        _keep(component.words, about, limited(value, about[4], about[5]))
        component.tell(about[0], about[6])
        _keep(component.words, about, limited(value, about[2], about[3]))


def _keep(words, about, value):
    """Write the halves of a number within its limits."""
    at = about[0]
    end = at + about[1]
    if about[7] is not None:
        pack_into(about[7], _data, 0, value)
        while at < end:
            half = 2 * (at - about[0])
            words[at] = _data[half] | _data[half + 1] << 8
            at += 1
        return
    while at < end:
        words[at] = value & 0xFFFF
        value >>= 16
        at += 1
