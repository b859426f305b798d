"""Loops that write the elements of a field: which place a turn of one writes to."""

from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class Turns:
    """A loop that writes ``count`` elements of ``size`` bytes: ``element`` is an expression for the one of a turn."""

    element: str
    size: int
    count: int


def placed(offset: int, size: int, turns: Turns | None) -> str:
    """The place of an offset in steps of ``size`` bytes, in a loop that of a turn."""
    if turns is None:
        return str(offset // size)
    steps = turns.size // size
    moved = f"{steps} * {turns.element}" if steps != 1 else turns.element
    return f"{offset // size} + {moved}" if offset else moved
