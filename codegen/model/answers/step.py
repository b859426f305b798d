"""A step on the way of a value from its source to the wire."""

from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class Step:
    """A step from sensor to wire: a word for its kind, what happens, more about it, the criteria that ask for it."""

    kind: str
    text: str
    details: tuple[str, ...]
    criteria: tuple[str, ...]
