"""Classes of Python as their source shows them: how they are made, and which methods and attributes they have."""

from collections.abc import Mapping, Sequence
from dataclasses import field

from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class Signature:
    """The parameters of a function by name, without ``self``.

    ``positional`` are those that a call can give by their places, ``keyed`` those that it can give by name, and
    ``required`` those that it has to give. ``takes_all`` and ``takes_all_keyed`` stand for ``*args`` and ``**keys``.
    """

    positional: tuple[str, ...] = ()
    keyed: frozenset[str] = frozenset()
    required: tuple[str, ...] = ()
    takes_all: bool = False
    takes_all_keyed: bool = False

    def refusal(self, places: int, names: Sequence[str]) -> str:
        """Return why a call with so many arguments by their places, and these by name, fails; empty if it does not."""
        if places > len(self.positional) and not self.takes_all:
            most = len(self.positional)
            return f"takes {'no argument' if not most else f'{most} at most'}, and is given {places}"
        placed = self.positional[:places]
        for name in names:
            if name in placed:
                return f"is given {name} twice, by its place and by its name"
            if name not in self.keyed and not self.takes_all_keyed:
                return f"does not take {name}"
        lacking = [name for name in self.required if name not in placed and name not in names]
        return f"wants {lacking[0]}, which it is not given" if lacking else ""


@dataclass(frozen=True, slots=True)
class PythonClass:
    """A class that a module defines, with what it inherits from others of the module.

    ``methods`` have a signature, or None where it cannot be told. ``attributes`` are all its names, those of its
    objects, too. ``is_open``: it can have others, which the source does not show. ``line`` is that of its head.
    ``lengths`` are those of attributes that it makes at one place alone, as an array or a list of a length that stands
    there.
    """

    line: int
    methods: Mapping[str, Signature | None]
    attributes: frozenset[str]
    is_open: bool
    lengths: Mapping[str, int] = field(default_factory=dict)
