# Generated from templates/firmware/scan_viper.py: do not edit.
# Inputs: 4bc8d9482143b2fc
"""What the main loop looks at all the time, in machine code; scan_plain has the same in Python and says how."""

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
        if ahead_ms == 0 or ahead_ms > furthest_ms:
            parts = slot[3]
            if parts:
                if left <= 0:
                    return number
                period = slot[1] + slot[2]
                slot[1] = period % parts
                period //= parts
                due_ms = slot[0] + period & 0x3FFFFFFF
                ahead_ms = due_ms - now_ms & 0x3FFFFFFF
                if ahead_ms == 0 or ahead_ms > furthest_ms:
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
def holding(words: ptr32, rows: ptr32) -> int:
    """Return which conditions hold, a bit for each."""
    bit = 1
    sign = bit << 31  # ports with words of 64 bits read 32 bits without one
    count = rows[0]
    bits = 0
    row = ptr32(int(rows) + 4)
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
        row = ptr32(int(row) + 12)
        count -= 1
    return bits
