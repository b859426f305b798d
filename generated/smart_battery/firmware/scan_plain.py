# Generated from templates/firmware/scan_plain.py: do not edit.
# Inputs: 20faa2730a00ccfa
"""What the main loop looks at all the time, in plain Python; scan_viper is the same in machine code."""

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
    for number in range(times[0]):
        at = 2 + 4 * number
        ahead_ms = times[at] - now_ms & _MASK
        if not 0 < ahead_ms <= times[1]:  # further ahead: the ticks went half round while nobody asked
            parts = times[at + 3]
            if parts:
                return number + _go_on(times, at, now_ms) if left else number
            times[at] = now_ms + _OFF_MS & _MASK
            times[at + 1] = -1
            ahead_ms = _OFF_MS
        if ahead_ms < wait_ms:  # noqa: PLR1730  min() takes longer
            wait_ms = ahead_ms
    return -wait_ms


def _go_on(times, at, now_ms):
    """Set the next time of a message; return LATE if that has passed as well."""
    parts = times[at + 3]
    period = times[at + 1] + times[at + 2]
    times[at + 1] = period % parts
    due_ms = times[at] + period // parts & _MASK
    is_late = not 0 < due_ms - now_ms & _MASK <= times[1]  # a pass came too late: no burst to catch up
    times[at] = now_ms + period // parts & _MASK if is_late else due_ms
    return LATE if is_late else 0


def holding(words, rows):
    """Return which conditions hold, a bit for each; one about a value that is unknown does not, but for a sense of 2.

    `rows` has how many there are, and of each the place of its value among `words`, its sense and its limit. Below the
    limit is -1, above it 1; 2 is unknown, and 0 holds never.
    """
    bits = 0
    for number in range(rows[0]):
        at = 1 + 3 * number
        value = words[rows[at]]
        sense = rows[at + 1]
        if value == _UNKNOWN:
            holds = sense == 2
        else:
            holds = value < rows[at + 2] if sense == -1 else sense == 1 and value > rows[at + 2]
        if holds:
            bits |= 1 << number
    return bits
