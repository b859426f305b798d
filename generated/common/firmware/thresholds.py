# Generated from templates/firmware/thresholds.py: do not edit.
# Inputs: 5768fbe25870f71a
"""Attributes that tell on which side of a threshold a word of a component is."""

from conversion import LARGEST


def at_least(place, limit, own=None):
    """Return an attribute that tells whether a word is at least a limit, or the instance's own one at place `own`."""

    def get(self, place=place, limit=limit, own=own):
        return self.words[place] >= (limit if own is None else self.words[own])

    return property(get)


def below(place, limit, own=None, floor=-LARGEST, own_floor=None):
    """Return an attribute that tells whether a word is known and below a limit, or the instance's own one.

    It is at least the floor then, or the instance's own one.
    """

    def get(self, place=place, limit=limit, own=own, floor=floor, own_floor=own_floor):
        value = self.words[place]
        if value < (floor if own_floor is None else self.words[own_floor]):
            return False
        return value < (limit if own is None else self.words[own])

    return property(get)
