# Generated from templates/firmware/scan_plain.py: do not edit.
# Inputs: af5d4e7f7a5eeef5
"""What the main loop looks at all the time, in plain Python; scan_viper is the same in machine code.

Functions of few variables: MicroPython puts those of larger ones on the heap at every call.
"""

LOOK_MS = 100  # no later something is looked at again
LATE = 0x10000

_OFF_MS = 1000  # what is off is looked at again then
_UNKNOWN = -1073741824
_MASK = 0x3FFFFFFF  # ticks are counted in 30 bits


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


def holding(words, rows):
    """Return which conditions hold, a bit for each; one about a value that is unknown does not, but for a sense of 2.

    `rows` has how many there are, and of each the place of its value among `words`, its sense and its limit. Below the
    limit is -1, above it 1; 2 is unknown, and 0 holds never.
    """
    bits = 0
    number = rows[0]
    while number:
        number -= 1
        bits = bits << 1 | _holds(words[rows[1 + 3 * number]], rows, 2 + 3 * number)
    return bits


def _holds(value, rows, at):
    """Return 1 if a condition holds, the sense of which is at a place, else 0."""
    if value == _UNKNOWN:
        return 1 if rows[at] == 2 else 0  # unknown
    if rows[at] < 0:
        return 1 if value < rows[at + 1] else 0
    return 1 if rows[at] == 1 and value > rows[at + 1] else 0
