"""Attributes that are forgotten: what code has set counts for so long only."""

import time

from conversion import to_steps
from words import UNKNOWN, accessors, in_unit


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


def aged_number(place, low, high, name, numerator, denominator, expires, after_ms):
    """Return what words.number() does, two attributes, both of which are forgotten as one of aging() is.

    They take half the heap of two by aging(). What is set to something that is no number is unknown from then on.
    """
    back_ms = 0x3FFFFFFF - after_ms + 1
    _, put_always = accessors(place, low, high, name)

    def get(self, place=place, expires=expires):
        words = self.words
        value = words[place]
        if value == UNKNOWN:
            return None
        until_ms = words[expires]
        if until_ms != UNKNOWN and 0 < (time.ticks_ms() - until_ms & 0x3FFFFFFF) < 0x20000000:
            words[place] = UNKNOWN
            words[expires] = UNKNOWN
            return None
        return value

    def put(self, value, put=put_always, place=place, expires=expires, back_ms=back_ms):
        # The text about a number beyond its limits reads it: it must not be forgotten in between.
        self.words[place] = UNKNOWN
        self.words[expires] = UNKNOWN
        put(self, value)
        self.words[expires] = time.ticks_ms() - back_ms & 0x3FFFFFFF

    def in_units(self, get=get, numerator=numerator, denominator=denominator):
        value = get(self)
        return None if value is None else in_unit(value, numerator, denominator)

    def put_units(self, value, put=put, numerator=numerator, denominator=denominator):
        put(self, to_steps(value, numerator, denominator))

    return property(get, put), property(get if numerator == denominator else in_units, put_units)
