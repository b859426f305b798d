# Generated from templates/firmware/scan_plain.py: do not edit.
# Inputs: 0884dc26855e8bf7
"""The scans that the main loop makes all the time, in plain Python; scan_viper is the same in machine code.

Functions of few variables: MicroPython puts those of larger ones on the heap at every call.
"""

LOOK_MS = 100  # no later something is looked at again
LATE = 0x10000

_OFF_MS = 1000  # what is off is looked at again then
_UNKNOWN = -1073741824
_MASK = 0x3FFFFFFF  # ticks are counted in 30 bits
_HEAD = 9  # words of the rows before the first condition
_ROW = 7  # of each
_HALF = 0x20000000
_LONGEST_MS = 1 << 24  # how long a condition holds is not counted further


def take_due(times, now_ms, left):
    """Return the number of the first message that is due, whose next time is then a period later.

    LATE more: it came too late for its next time, too, and begins anew from now. -1 to -100: none is, for so many ms.
    With nothing `left` the message keeps its time. `times` has how many there are and how many ms one is ahead at
    most, and of each when it is due in ms, what that is late by in parts of a millisecond, and its period, so many
    parts of so many in a millisecond: 0 of those for one that is off, and late by -1 once that was noticed.
    """
    wait_ms = LOOK_MS
    at = 2
    while at >> 2 < times[0]:
        ahead_ms = times[at] - now_ms & _MASK
        if not 0 < ahead_ms <= times[1]:  # further ahead: the ticks went half round while nobody asked
            if times[at + 3]:
                return (at >> 2) + _go_on(times, at, now_ms) if left else at >> 2
            times[at] = now_ms + _OFF_MS & _MASK
            times[at + 1] = -1
            ahead_ms = _OFF_MS
        if ahead_ms < wait_ms:  # noqa: PLR1730  min() takes longer
            wait_ms = ahead_ms
        at += 4
    return -wait_ms


def _go_on(times, at, now_ms):
    """Set the next time of a message; return LATE if that has passed as well."""
    period = times[at + 1] + times[at + 2]
    times[at + 1] = period % times[at + 3]
    period //= times[at + 3]
    times[at] = times[at] + period & _MASK
    if 0 < times[at] - now_ms & _MASK <= times[1]:
        return 0
    times[at] = now_ms + period & _MASK  # a pass came too late: no burst to catch up
    return LATE


def watch(words, rows, now_ms, flags):
    """Count for how long conditions hold; return 1 where one does that is about a value, or the value is unknown.

    `flags` has 1 if times run, else they begin anew, and 2 while nobody is heard. `rows` has how many conditions there
    are, the number of the first that is timed, and the level that is up. What is found is put behind that: the number
    of the last condition that has held for long enough, -1 for none, how bad it is, and when that was, in ticks. How
    bad it is is the highest level of which a condition holds, and the worst while the value is unknown: the place of
    that value comes next, the worst level, and where among `words` it is put as well, -1 for nowhere.

    Then there is of each: the place of its value among `words`, its sense, its limit, up to where its value is not
    believed, for how many ms it has to hold (-1: however long, it never counts), for how many it does (-1: not at all),
    and its level. The sense is -1 for below the limit, 1 for above, 2 for unknown, 3 for nobody heard, and 0 holds
    never. A value that is unknown, or not believed, neither restarts a time nor lets it go on.
    """
    found = _look(words, rows, _passed(rows, now_ms) if flags & 1 else None, flags)
    rows[5] = now_ms & _MASK
    return 1 if _rate(words, rows) or found else 0


def holding(words, rows):
    """Return which conditions hold while somebody is heard, a bit for each; `rows` are those of watch()."""
    bits = 0
    at = len(rows)
    while at > _HEAD:
        at -= _ROW
        bits <<= 1
        if _holds(words[rows[at]], rows, at, 0):
            bits |= 1
    return bits


def _passed(rows, now_ms):
    """Return how many ms have passed, below 0 where the ticks went half round; no number on the way is a large one."""
    passed_ms = (now_ms & _MASK) - rows[5]
    if passed_ms >= _HALF:
        return passed_ms - _HALF - _HALF
    return passed_ms + _HALF + _HALF if passed_ms < -_HALF else passed_ms


def _look(words, rows, passed_ms, flags):
    """Look at each condition; return whether one holds that is about a value."""
    rows[3] = -1
    rows[4] = 0
    at = _HEAD
    while at < len(rows):
        if _look_at(words[rows[at]], rows, at, passed_ms, flags):
            flags |= 4
        at += _ROW
    return flags & 4


def _look_at(value, rows, at, passed_ms, flags):
    """Look at a condition, and count where it is timed; return whether it holds and is about a value."""
    flags = _holds(value, rows, at, flags)
    if at >= _HEAD + _ROW * rows[1]:
        if flags:
            rows[4] = rows[at + 6]
        _count(value, rows, at, passed_ms, flags)
    return flags and rows[at + 1] != 3


def _rate(words, rows):
    """Put where it belongs how bad it is; return whether the value is unknown."""
    is_unknown = rows[6] >= 0 and words[rows[6]] == _UNKNOWN
    if is_unknown:
        rows[4] = rows[7]
    if rows[8] >= 0:
        words[rows[8]] = rows[4]
    return is_unknown


def _holds(value, rows, at, flags):
    """Return whether a condition holds."""
    sense = rows[at + 1]
    if sense == 3:  # nobody is heard
        return flags & 2 != 0
    if value == _UNKNOWN or sense == 2:
        return value == _UNKNOWN and sense == 2
    return value < rows[at + 2] if sense < 0 else sense == 1 and value > rows[at + 2]


def _count(value, rows, at, passed_ms, holds):
    """Count for how long a condition holds; None ms pass where times do not run."""
    if passed_ms is None:
        rows[at + 5] = -1
    elif rows[at + 1] < 2 and value <= rows[at + 3]:
        if (holds or rows[at + 5] >= 0) and rows[at + 6] <= rows[2]:  # what is up stays up
            rows[3] = (at - _HEAD) // _ROW
    elif not holds:
        rows[at + 5] = -1
    else:
        if rows[at + 5] < 0:
            rows[at + 5] = 0
        elif rows[at + 5] < _LONGEST_MS:
            rows[at + 5] += passed_ms
        if 0 <= rows[at + 4] <= rows[at + 5]:
            rows[3] = (at - _HEAD) // _ROW
