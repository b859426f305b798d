# Generated from templates/firmware/lists.py: do not edit.
# Inputs: c8056fb08c3360c8
"""Attributes that are lists of whole numbers of up to 30 bits: views of several words of a component.

Each number is set and read by its place, and can be None: unknown. rows has lists of numbers of more bits.
"""

from conversion import to_steps
from words import accessors, in_unit


class _Elements:
    """The whole numbers of a list, each of which can be None; `accessors` get and set the number at a place."""

    width = 1  # words for each

    def __init__(self, component, first, count, accessors, age=None):
        self.first = first
        self._age = age
        self._component = component
        self._count = count
        self._accessors = accessors

    def __len__(self):
        return self._count

    def __getitem__(self, index):
        return self._accessors[0](self._component, self._place(index))

    def __setitem__(self, index, value):
        self._accessors[1](self._component, value, self._place(index))
        if self._age is not None:
            self._component.words[self._age] = 0

    def _place(self, index):
        if not -self._count <= index < self._count:
            raise IndexError("there are fewer elements")
        return self.first + index % self._count


def elements(first, count, low, high, name, own=None, age=None):
    """Return an attribute for a list of whole numbers; `own` is the place of the instance's own count.

    The word at `age`, which readings count up, begins anew when one of them is set.
    """
    functions = accessors(first, low, high, name)

    def get(self):
        return _Elements(self, first, count if own is None else self.words[own], functions, age)

    def put(self, values):
        _fill(get(self), values, 1, 1)

    return property(get, put)


def shown_elements(name, numerator, denominator=1):
    """Return an attribute for the list `name` in the unit of people; None makes all of them unknown."""

    def get(self):
        steps = getattr(self, name)

        def value_at(_component, place):
            value = steps[place]
            return None if value is None else in_unit(value, numerator, denominator)

        def put_at(_component, value, place):
            steps[place] = to_steps(value, numerator, denominator)

        return _Elements(self, 0, len(steps), (value_at, put_at))

    def put(self, values):
        _fill(getattr(self, name), values, numerator, denominator)

    return property(get, put)


def _fill(steps, values, numerator, denominator):
    if values is not None and len(values) != len(steps):
        raise ValueError(f"there are {len(steps)} values, not {len(values)}")
    for index in range(len(steps)):
        steps[index] = None if values is None else to_steps(values[index], numerator, denominator)
