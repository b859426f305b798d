"""One thing that may be said of a field, and whether the dialect agrees."""

from codegen.diagnostics import Rule
from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class Comparison:
    """One thing that may be said of a field: of which ``kind``, by which rule, and in the words of its findings.

    ``traits`` are what speaks for or against a statement of this kind.
    """

    kind: str
    rule: Rule
    is_right: bool
    text: str = ""
    traits: tuple[str, ...] = ()


def traits(**those: object) -> tuple[str, ...]:
    """Return the names of the traits that are there, with spaces."""
    return tuple(name.replace("_", " ") for name, is_there in those.items() if is_there)
