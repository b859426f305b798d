"""The clock of the state is set by what satellites say."""

from clock_plain import tick
from micropython import const

_UNIX = const(4)  # behind the time since the start, see clock_plain
_OFF_BY = const(1000000)  # so many microseconds: a receiver tells the time later than it is


def set_clock(words, at, values, place):
    """Set the clock at a place of the words to the halves of `values`, unless it is right to the second."""
    tick(words, at)
    if not _is_near(words, at + _UNIX, values, place):
        half = 0
        while half < 4:
            words[at + _UNIX + half] = values[place + half]
            half += 1


def _is_near(words, at, values, place):
    if words[at] >> 16:
        return False  # it is unknown
    highest = words[at + 3] - values[place + 3]
    if not -1 <= highest <= 1:
        return False  # all that follows is a small integer on a board of 32 bits
    high = (highest << 16) + words[at + 2] - values[place + 2]
    if not -1 <= high <= 1:
        return False
    middle = (high << 16) + words[at + 1] - values[place + 1]
    if not -20 <= middle <= 20:
        return False
    return -_OFF_BY < (middle << 16) + words[at] - values[place] < _OFF_BY
