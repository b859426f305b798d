"""Places in source files, which every diagnostic points at."""

import os
from collections.abc import Mapping
from dataclasses import field
from typing import NamedTuple

from codegen.frozen import dataclass


class Place(NamedTuple):
    """A position in a source file; line and column count from 1.

    ``file`` is an absolute path, so that a place stays valid whatever the working directory is;
    it is shortened only when it is shown. A tuple rather than a dataclass, as all of which a dialect has thousands:
    they are made sooner.
    """

    file: str
    line: int = 1
    column: int = 1

    def shown(self, base: str | None = None) -> str:
        """``file:line:col``, relative to ``base`` (default: the working directory) where the file lies below it."""
        return f"{shown_path(self.file, base)}:{self.line}:{self.column}"


def shown_path(path: str, base: str | None = None) -> str:
    """``path`` relative to ``base`` (default: the working directory) if it lies below it, else unchanged.

    What lies in a revision or an archive is named as git does: ``HEAD~1:specs/state.yaml``.
    """
    relative = os.path.relpath(path, base or os.getcwd())
    return path if relative.startswith(os.pardir) else relative.replace(":/", ":", 1)


@dataclass(frozen=True, slots=True, kw_only=True)
class Written:
    """Base of everything that was read from a YAML file: it knows where it, and each of its keys, stands.

    ``place`` is the place of the record itself (for an entry of a mapping: of its key);
    ``places`` has, for each key that was written, the place of its value; ``unread`` are the keys of these whose value
    could not be read, which has been reported: the record has their defaults.
    """

    place: Place = field(compare=False, repr=False)
    places: Mapping[str, Place] = field(compare=False, repr=False, default_factory=dict)
    unread: tuple[str, ...] = field(compare=False, repr=False, default=())

    def at(self, key: str) -> Place:
        """The place of the value written for ``key``, or of the whole record where the key is not written."""
        return self.places.get(key, self.place)

    def has_unread(self, *keys: str) -> bool:
        """Return whether one of the keys is written with a value that could not be read, which has been reported."""
        return any(key in self.unread for key in keys)
