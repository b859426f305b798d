"""Attributes for lists of numbers of more than 30 bits, and of floats; wide has those for single ones.

Each value is set and read by its place, and can be None: unknown. A list is set as a whole, too, by as many values as
it has, or by None, which makes all of them unknown. Each value is told by itself where it is beyond its limits.
"""

import time

from wide import about_real, about_whole, float_at, keep, keep_float, keep_shown, shown_at, whole_at
from words import UNKNOWN


class _Row:
    """The values of a list: `functions` read and write one by its place in the words, and by what it is about."""

    def __init__(self, component, place, count, about, functions):
        self._component = component
        self.first = place
        self.width = about[0]
        self._count = count
        self._about = about
        self._functions = functions

    def __len__(self):
        return self._count

    def __getitem__(self, index):
        return self._functions[0](self._component.words, self._at(index), self._about)

    def __setitem__(self, index, value):
        self._functions[1](self._component, self._at(index), self._about, value)

    def _at(self, index):
        if not -self._count <= index < self._count:
            raise IndexError("there are fewer elements")
        return self.first + self.width * (index % self._count)


def integers(place, count, halves, low, high, name, told=None):
    """Return an attribute for a list of whole numbers from `low` to `high`."""
    return _attribute(place, count, about_whole(halves, low, high, name, told), (whole_at, keep))


def shown_integers(place, count, halves, low, high, name, numerator, denominator=1, told=None):
    """Return the same in the unit of people, `numerator` / `denominator` steps of which make one."""
    about = about_whole(halves, low, high, name, told, numerator, denominator)
    return _attribute(place, count, about, (shown_at, keep_shown))


def floats(place, count, halves, name, low=None, high=None, told=None, numerator=1, denominator=1):
    """Return an attribute for a list of floats of 32 or 64 bits, with limits in the units that are kept."""
    about = about_real(halves, name, low, high, told, numerator, denominator)
    return _attribute(place, count, about, (float_at, keep_float))


class _Believed:
    """A list that is forgotten: it can be read, and is set as a whole, by which its age is known."""

    def __init__(self, owner, believed):
        self._owner = owner
        self._believed = believed

    def __len__(self):
        return len(self._believed(self._owner))

    def __getitem__(self, index):
        return self._believed(self._owner)[index]


def aging_row(name, place, count, words, expires, after_ms):
    """Return the attribute `name`, a list from `place` on, that is forgotten so many ms after it was set as a whole.

    The word at `expires` is as ages.aging() has it.
    """
    back_ms = 0x3FFFFFFF - after_ms + 1

    def believed(self):
        until_ms = self.words[expires]
        if until_ms != UNKNOWN and 0 < (time.ticks_ms() - until_ms & 0x3FFFFFFF) < 0x20000000:
            for at in range(place, place + count * words, words):
                self.words[at] = UNKNOWN
            self.words[expires] = UNKNOWN
        return getattr(self, name)

    def get(self):
        return _Believed(self, believed)

    def put(self, values):
        setattr(self, name, values)
        self.words[expires] = time.ticks_ms() - back_ms & 0x3FFFFFFF

    return property(get, put)


def _attribute(place, count, about, functions):
    def get(self):
        return _Row(self, place, count, about, functions)

    def put(self, values):
        if values is not None and len(values) != count:
            raise ValueError(f"there are {count} values, not {len(values)}")
        row = get(self)
        for index in range(count):
            row[index] = None if values is None else values[index]

    return property(get, put)
