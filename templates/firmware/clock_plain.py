"""The clocks of the state go on, in plain Python; clock_viper is the same in machine code.

Words from `at` on: 64 bits in halves of 16, the low ones first, of the microseconds since the start and since 1970; the
ticks in us and in ms that were counted last; the same clocks in whole milliseconds. ticks_us starts again every 18
minutes: how often it did is told by ticks_ms, which takes 12 days to do so. No number passes 2 ** 30.
"""

import time

from micropython import const

_UNIX = const(4)
_LAST_US = const(8)
_LAST_MS = const(9)
_BOOT_MS = const(10)
_UNIX_MS = const(14)


def tick(words, at):
    """Count on to now; call it every 12 days at least."""
    passed = _since(words, at + _LAST_US, time.ticks_us())
    turns = (_since(words, at + _LAST_MS, time.ticks_ms()) - passed // 1000 + 536870) // 1073742
    _count(words, at, passed, turns)
    _divide(words, at, at + _BOOT_MS)
    if words[at + _UNIX] >> 16 == 0:
        _count(words, at + _UNIX, passed, turns)
        _divide(words, at + _UNIX, at + _UNIX_MS)


def ticking(name):
    """Return the attribute `name` of the component of the clocks as of now: they go on before it is read or set."""

    def get(self):
        tick(self.words, 0)
        return getattr(self, name)

    def put(self, value):
        tick(self.words, 0)
        setattr(self, name, value)

    return property(get, put)


def _since(words, at, now):
    """Return the ticks since those in a word, which become these."""
    passed = now - words[at] & 0x3FFFFFFF
    words[at] = now
    return passed


def _count(words, at, passed, turns):
    """Add `passed` and 2 ** 30 for each of the turns."""
    total = (words[at] & 0xFFFF) + (passed & 0xFFFF)
    words[at] = total & 0xFFFF
    total = words[at + 1] + (total >> 16) + (passed >> 16) + ((turns & 3) << 14)
    words[at + 1] = total & 0xFFFF
    total = words[at + 2] + (total >> 16) + (turns >> 2)
    words[at + 2] = total & 0xFFFF
    words[at + 3] = words[at + 3] + (total >> 16) & 0xFFFF


def _divide(words, at, to):
    """Write the whole milliseconds."""
    left = 0
    place = 3
    while place >= 0:
        left = left << 16 | words[at + place]
        words[to + place] = left // 1000
        left %= 1000
        place -= 1
