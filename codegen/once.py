"""Remembers results that are asked for repeatedly, are slow to compute, and concern objects that never change."""

from collections.abc import Callable
from typing import TypeVar

_About = TypeVar("_About")
_Found = TypeVar("_Found")

_MOST = 64
"""So many objects are remembered: more than the messages of a project."""


def once(find: Callable[[_About], _Found]) -> Callable[[_About], _Found]:
    """The function ``find``, which remembers what it found for the objects that it was asked about last.

    It knows them by identity: to compare two systems takes longer than most of what is asked about them.
    """
    known: dict[int, tuple[_About, _Found]] = {}

    def found(about: _About) -> _Found:
        key = id(about)
        if key not in known:  # what is remembered holds its object, so that no other has the same id
            if len(known) >= _MOST:
                del known[next(iter(known))]
            known[key] = (about, find(about))
        return known[key][1]

    return found
