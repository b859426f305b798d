"""Compares a term in the reach of a field's name with the field, as if it were said of it."""

from collections.abc import Iterator

from codegen.claims.reading import Reading
from codegen.claims.weighed.comparison import Comparison
from codegen.claims.weighed.numbers import of_number
from codegen.claims.weighed.pairs import Pair
from codegen.claims.weighed.types import of_type
from codegen.claims.weighed.units import of_unit
from codegen.pattern import pattern

_DENIED = pattern(r"\b(?:no|not|never|n't)(?: an?| the| in| of)? $")
"""Before what is not said, but denied: "is no float"."""


_GIVEN = pattern(r"\b(?:sensor|probe|device|driver|receiver|chip|unit) (?:gives|reports|delivers|outputs|counts) $")
"""Before the unit of something else."""


def compared(reading: Reading, pair: Pair) -> Iterator[Comparison]:
    """Yield what the term of a pair would say, and whether the dialect agrees."""
    letter = pair.term.letter
    if letter in "TU" and (_DENIED.search(pair.before(16)) or _GIVEN.search(pair.before(24))):
        return
    if letter == "U":
        yield from of_unit(pair)
    elif letter == "T":
        yield from of_type(pair)
    elif letter in "NS":
        yield from of_number(reading, pair)
