# Generated from templates/firmware/words.py: do not edit.
# Inputs: 410cf2270aa4fb9c
"""Attributes that are views of a component's words: 32-bit numbers in one array, -2 ** 30 for what is unknown.

Whole numbers in the units that go out; shown() has them in the units of people. To set an attribute to None, or one in
the units of people to NaN, makes it unknown.

What a view is about are defaults of its functions: closures and their cells would take twice the heap.
"""

import time
from array import array

from conversion import LARGEST, limited, to_steps

UNKNOWN = -1073741824


class Component:
    """Base of a part of the state; `words` are its part of the array, or an array of its own.

    Of several instances the first can be used as a list of all of them.
    """

    def __init__(self, size, start, words=None, instance=0):
        self.words = array("i", [UNKNOWN] * size) if words is None else words
        self._all = (self,)
        for at in range(0, len(start), 2):
            values = start[at + 1]
            self.words[start[at]] = values[instance] if isinstance(values, tuple) else values

    def __len__(self):
        return len(self._all)

    def __getitem__(self, instance):
        return self._all[instance]


def together(cls, words, base, size, instances):
    """Return the first of so many instances that share an array of words, one block behind the other."""
    whole = memoryview(words)
    every = tuple(cls(whole[base + size * at : base + size * (at + 1)], at) for at in range(instances))
    for each in every:
        each._all = every
    return every[0]


def whole(place):
    """Return an attribute for a whole number: what is beyond a word becomes the largest that it holds."""

    def get(self, place=place):
        value = self.words[place]
        return None if value == UNKNOWN else value

    def put(self, value, place=place):
        self.words[place] = UNKNOWN if value is None else limited(value, -LARGEST, LARGEST)

    return property(get, put)


def shown(place, numerator, denominator=1):
    """Return an attribute in the unit of people, `numerator` / `denominator` steps of which make one."""

    def get(self, place=place, numerator=numerator, denominator=denominator):
        value = self.words[place]
        return None if value == UNKNOWN else in_unit(value, numerator, denominator)

    def put(self, value, place=place, numerator=numerator, denominator=denominator):
        steps = to_steps(value, numerator, denominator)
        self.words[place] = UNKNOWN if steps is None else steps

    return property(get, put)


def result(place, numerator, denominator=1):
    """Return an attribute in the unit of people that only the firmware sets."""

    def get(self, place=place, numerator=numerator, denominator=denominator):
        value = self.words[place]
        return None if value == UNKNOWN else in_unit(value, numerator, denominator)

    return property(get)


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


def truth(place):
    """Return an attribute for a boolean."""

    def get(self, place=place):
        return self.words[place] != 0

    def put(self, value, place=place):
        self.words[place] = 1 if value else 0

    return property(get, put)


def known(place):
    """Return an attribute that tells whether a word is known."""

    def get(self, place=place):
        return self.words[place] != UNKNOWN

    return property(get)


def at_least(place, limit, own=None):
    """Return an attribute that tells whether a word is at least a limit, or the instance's own one at place `own`."""

    def get(self, place=place, limit=limit, own=own):
        return self.words[place] >= (limit if own is None else self.words[own])

    return property(get)


def below(place, limit, own=None):
    """Return an attribute that tells whether a word is known and below a limit, or the instance's own one."""

    def get(self, place=place, limit=limit, own=own):
        value = self.words[place]
        return value != UNKNOWN and value < (limit if own is None else self.words[own])

    return property(get)


class _Elements:
    """The whole numbers of a list, each of which can be None."""

    def __init__(self, words, first, count):
        self._words = words
        self._first = first
        self._count = count

    def __len__(self):
        return self._count

    def __getitem__(self, index):
        value = self._words[self._place(index)]
        return None if value == UNKNOWN else value

    def __setitem__(self, index, value):
        self._words[self._place(index)] = UNKNOWN if value is None else limited(value, -LARGEST, LARGEST)

    def _place(self, index):
        if not -self._count <= index < self._count:
            raise IndexError("there are fewer elements")
        return self._first + index % self._count


def elements(first, count, own=None):
    """Return an attribute for a list of whole numbers; `own` is the place of the instance's own count."""

    def get(self):
        return _Elements(self.words, first, count if own is None else self.words[own])

    def put(self, values):
        _fill(get(self), values, 1, 1)

    return property(get, put)


def shown_elements(first, count, numerator, denominator=1, own=None):
    """Return an attribute for a list in the unit of people; None makes all of them unknown."""

    def of(self):
        return _Elements(self.words, first, count if own is None else self.words[own])

    def get(self):
        return [None if value is None else in_unit(value, numerator, denominator) for value in of(self)]

    def put(self, values):
        _fill(of(self), values, numerator, denominator)

    return property(get, put)


def in_unit(value, numerator, denominator):
    """Return steps in the unit of people; a whole number stays one where these are the same."""
    return value if numerator == denominator else value * denominator / numerator


def _fill(steps, values, numerator, denominator):
    if values is not None and len(values) != len(steps):
        raise ValueError(f"there are {len(steps)} values, not {len(values)}")
    for index in range(len(steps)):
        steps[index] = None if values is None else to_steps(values[index], numerator, denominator)
