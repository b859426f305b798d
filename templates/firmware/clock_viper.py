"""The clocks of the state go on, by MicroPython's viper emitter; clock_plain says how they are kept."""

# ptr32 is viper's own name.
# ruff: noqa: F821

from time import ticks_ms, ticks_us

import micropython
from micropython import const

_UNIX = const(4)
_LAST_US = const(8)
_LAST_MS = const(9)
_BOOT_MS = const(10)
_UNIX_MS = const(14)


@micropython.viper
def tick(clock_at: int):
    """Count on to now, in the words from an address on; call it every 12 days at least."""
    words = ptr32(clock_at)
    now = int(ticks_us())
    passed = now - words[_LAST_US] & 0x3FFFFFFF
    words[_LAST_US] = now
    now = int(ticks_ms())
    turns = ((now - words[_LAST_MS] & 0x3FFFFFFF) - passed // 1000 + 536870) // 1073742
    words[_LAST_MS] = now
    clocks = 2 if words[_UNIX] >> 16 == 0 else 1
    to = ptr32(clock_at + 4 * _BOOT_MS)
    while clocks:
        total = (words[0] & 0xFFFF) + (passed & 0xFFFF)
        words[0] = total & 0xFFFF
        total = words[1] + (total >> 16) + (passed >> 16) + ((turns & 3) << 14)
        words[1] = total & 0xFFFF
        total = words[2] + (total >> 16) + (turns >> 2)
        words[2] = total & 0xFFFF
        words[3] = words[3] + (total >> 16) & 0xFFFF
        left = 0
        place = 3
        while place >= 0:
            left = left << 16 | words[place]
            to[place] = left // 1000
            left = left % 1000
            place -= 1
        clocks -= 1
        words = ptr32(clock_at + 4 * _UNIX)
        to = ptr32(clock_at + 4 * _UNIX_MS)
