"""Attributes that are forgotten: what code has set counts for so long only."""

import time

from words import UNKNOWN


def aging(name, place, expires, after_ms):
    """Return the attribute `name`, of the word at `place`, that is forgotten so many ms after it was set.

    The word at `expires` has the time until which it is believed, unknown is for ever. Ticks are counted in 30 bits.
    """
    back_ms = 0x3FFFFFFF - after_ms + 1  # so far back round the ticks: a sum with `after_ms` may be no small integer

    def get(self):
        until_ms = self.words[expires]
        if until_ms != UNKNOWN and 0 < (time.ticks_ms() - until_ms & 0x3FFFFFFF) < 0x20000000:
            self.words[place] = UNKNOWN
            self.words[expires] = UNKNOWN
        return getattr(self, name)

    def put(self, value):
        setattr(self, name, value)
        self.words[expires] = time.ticks_ms() - back_ms & 0x3FFFFFFF

    return property(get, put)
