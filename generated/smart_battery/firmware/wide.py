# Generated from templates/firmware/wide.py: do not edit.
# Inputs: bddefe67e62e8967
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
    return _attribute(place, about_whole(halves, low, high, name, told), whole_at, keep)


def shown_integer(place, halves, low, high, name, numerator, denominator=1, told=None):
    """Return an attribute in the unit of people, `numerator` / `denominator` steps of which make one.

    It is as exact as the floats of the port, where a board with floats of 32 bits has 7 digits; a whole number in the
    unit that is kept is exact.
    """
    return _attribute(place, about_whole(halves, low, high, name, told, numerator, denominator), shown_at, keep_shown)


def floating(place, halves, name, low=None, high=None, told=None, numerator=1, denominator=1):
    """Return an attribute for a float of 32 or 64 bits; `numerator` / `denominator` of its units make one that is kept.

    What is beyond the largest float of these bits becomes that one. Limits are in units that are kept.
    """
    return _attribute(place, about_real(halves, name, low, high, told, numerator, denominator), float_at, keep_float)


def _attribute(place, about, at, put_at):
    def get(self):
        return at(self.words, place, about)

    def put(self, value):
        put_at(self, place, about, value)

    return property(get, put)


# The description of a number: its halves, its limits, those that are told, its name in texts, the code of a float, and
# how many steps make how many units. A call with these as variables of its own would allocate.


def about_whole(halves, low, high, name, told, numerator=1, denominator=1):
    """Return the description of a whole number, as it is told above."""
    told = told or (low, high)
    return halves, low, high, told[0], told[1], name, None, numerator, denominator


def about_real(halves, name, low, high, told, numerator, denominator):
    """Return the description of a float, as it is told above."""
    code, largest = ("<f", b"\xff\xff\x7f\x7f") if halves == 2 else ("<d", b"\xff\xff\xff\xff\xff\xff\xef\x7f")
    most = unpack_from(code, largest)[0]
    low, high = -most if low is None else low, most if high is None else high
    told = told or (low, high)
    return halves, low, high, told[0], told[1], name, code, numerator, denominator


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


def shown_at(words, at, about):
    """Return the same in the unit of people."""
    value = whole_at(words, at, about)
    return None if value is None else in_unit(value, about[7], about[8])


def float_at(words, place, about):
    """Return the float of which the words from a place on are the halves, in the unit of people, or None."""
    if words[place] == UNKNOWN:
        return None
    for at in range(about[0]):
        _data[2 * at] = words[place + at] & 0xFF
        _data[2 * at + 1] = words[place + at] >> 8
    return in_unit(unpack_from(about[6], _data)[0], about[7], about[8])


def keep_shown(component, at, about, value):
    """Keep a whole number that is in the unit of people."""
    if about[7] != about[8] or not isinstance(value, int):
        value = to_steps(value, about[7], about[8], 1 << 64)
    keep(component, at, about, value)


def keep_float(component, at, about, value):
    """Keep a float that is in the unit of people."""
    if value is not None and value - value != 0:  # NaN or infinity
        value = None
    if value is not None and about[7] != about[8]:
        value = value * about[7] / about[8]
    keep(component, at, about, value)


def keep(component, at, about, value):
    """Keep a number, limited, or that it is unknown; one beyond what is told is counted and told."""
    if value is None:
        component.words[at] = UNKNOWN
    elif about[3] <= value <= about[4]:
        _write(component.words, at, about, value)
        if component.beyond:
            component.beyond.pop(at, None)
    else:
        _limit(component, at, about, value)


def _limit(component, at, about, value):  # by itself, so that neither has as many variables as lie on the heap
    value = limited(value, about[1], about[2])
    _write(component.words, at, about, value)  # raises for what is no such number
    told = limited(value, about[3], about[4])
    _write(component.words, at, about, told)
    component.tell(at, about[5])
    _write(component.words, at, about, value)


def _write(words, at, about, value):
    """Write the halves of a number."""
    end = at + about[0]
    if about[6] is not None:
        pack_into(about[6], _data, 0, value)
        while at < end:
            half = 2 * (about[0] - end + at)
            words[at] = _data[half] | _data[half + 1] << 8
            at += 1
        return
    while at < end:
        words[at] = value & 0xFFFF
        value >>= 16
        at += 1
