"""The scans that the main loop makes all the time, in machine code; scan_plain has the same in Python, explained."""

# ptr32 is viper's own name. Calls are dear: one function does it all.
# ruff: noqa: F821

import micropython
from micropython import const

LOOK_MS = 100
LATE = 0x10000

_UNKNOWN = const(-0x3FFFFFFF - 1)


@micropython.viper
def take_due(times: ptr32, now_ms: int, left: int) -> int:
    """Return the number of the first message that is due, and let it be due again."""
    count = times[0]
    furthest_ms = times[1]
    wait_ms = 100
    slot = ptr32(int(times) + 8)
    number = 0
    while number < count:
        ahead_ms = slot[0] - now_ms & 0x3FFFFFFF
        if not ahead_ms or ahead_ms > furthest_ms:
            parts = slot[3]
            if parts:
                if left <= 0:
                    return number
                period = slot[1] + slot[2]
                slot[1] = period % parts
                period //= parts
                due_ms = slot[0] + period & 0x3FFFFFFF
                ahead_ms = due_ms - now_ms & 0x3FFFFFFF
                if not ahead_ms or ahead_ms > furthest_ms:
                    slot[0] = now_ms + period & 0x3FFFFFFF
                    return number + 0x10000
                slot[0] = due_ms
                return number
            slot[0] = now_ms + 1000 & 0x3FFFFFFF
            slot[1] = -1
            ahead_ms = 1000
        if ahead_ms < wait_ms:  # noqa: PLR1730  as above
            wait_ms = ahead_ms
        slot = ptr32(int(slot) + 16)
        number += 1
    return 0 - wait_ms


@micropython.viper
def watch(words: ptr32, rows: ptr32, now_ms: int, flags: int) -> int:  # noqa: C901, PLR0912, PLR0915  as above
    """Count for how long conditions hold; return 1 where one does that is about a value, or the value is unknown."""
    bit = 1
    sign = bit << 31  # ports with words of 64 bits read 32 bits without one
    count = rows[0]
    untimed = rows[1]
    level = rows[2]
    passed_ms = (now_ms - rows[5] + 0x20000000 & 0x3FFFFFFF) - 0x20000000
    rows[5] = now_ms & 0x3FFFFFFF
    due = -1
    highest = 0
    found = 0
    number = 0
    row = ptr32(int(rows) + 36)
    while number < count:
        sense = (row[1] ^ sign) - sign
        value = (words[row[0]] ^ sign) - sign
        holds = 0
        if sense == 3:
            holds = flags & 2
        elif value == _UNKNOWN:
            if sense == 2:
                holds = found = 1
        elif sense < 0:
            if value < (row[2] ^ sign) - sign:
                holds = found = 1
        elif sense == 1 and value > (row[2] ^ sign) - sign:
            holds = found = 1
        if number >= untimed:
            held_ms = (row[5] ^ sign) - sign
            if holds:
                highest = row[6]
            if not flags & 1:
                row[5] = -1
            elif sense < 2 and value <= (row[3] ^ sign) - sign:
                if (holds or held_ms >= 0) and row[6] <= level:
                    due = number
            elif holds:
                if held_ms < 0:
                    held_ms = 0
                elif held_ms < 0x1000000:
                    held_ms += passed_ms
                row[5] = held_ms
                after_ms = (row[4] ^ sign) - sign
                if after_ms >= 0 and held_ms >= after_ms:
                    due = number
            else:
                row[5] = -1
        row = ptr32(int(row) + 28)
        number += 1
    place = (rows[6] ^ sign) - sign
    if place >= 0 and (words[place] ^ sign) - sign == _UNKNOWN:
        found = 1
        highest = rows[7]
    place = (rows[8] ^ sign) - sign
    if place >= 0:
        words[place] = highest
    rows[3] = due
    rows[4] = highest
    return found


@micropython.viper
def holding(words: ptr32, rows: ptr32) -> int:
    """Return which conditions hold while somebody is heard, a bit for each."""
    bit = 1
    sign = bit << 31  # as above
    count = rows[0]
    bits = 0
    row = ptr32(int(rows) + 36)
    while count:
        value = (words[row[0]] ^ sign) - sign
        sense = (row[1] ^ sign) - sign
        if value == _UNKNOWN:
            if sense == 2:
                bits |= bit
        elif sense < 0:
            if value < (row[2] ^ sign) - sign:
                bits |= bit
        elif sense == 1 and value > (row[2] ^ sign) - sign:
            bits |= bit
        bit <<= 1
        row = ptr32(int(row) + 28)
        count -= 1
    return bits
