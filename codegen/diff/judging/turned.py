"""Two words that are turned into what they exclude, which leaves the meaning: ``negative down`` for ``positive up``."""

from codegen.diff.judging.words import excluding, stem
from codegen.pattern import pattern

_TOKEN = pattern(r"[a-z]+|\d+|[.;,:()]")
_CARRYING = ("positive", "negative", "true", "false", "set", "cleared", "row", "column")
_CARRIERS = frozenset(map(stem, _CARRYING))
"""Words that say by what the rest of a clause is shown."""
_STATES = {"set", stem("cleared")}
_TWO = 2
_ENDS = frozenset(".;,()")
_SIDES = frozenset(map(stem, ("left", "right")))


def is_turned_twice(old: str, new: str) -> bool:
    """Return whether two texts differ in nothing but words that exclude each other, in each clause one that shows and
    one that is shown: ``true if it is open`` and ``false if it is closed`` are the same.

    Of a symmetric matrix the rows of the upper right triangle are the columns of the lower left one.
    """
    small = old.lower()
    if not any(word in small for word in _CARRYING):
        return False
    before, after = ([_spelt(word) for word in _TOKEN.findall(text.lower())] for text in (old, new))
    if len(before) != len(after) or before == after:
        return False
    is_triangle = "triangl" in "".join(before)
    clauses: list[set[str]] = [set()]
    for word, other in zip(before, after, strict=True):
        if word in _ENDS and word == other and not is_triangle:
            clauses.append(set())
        elif word != other:
            if other not in excluding(word) and {word, other} != _STATES:
                return False
            if not (is_triangle and word in _SIDES):
                clauses[-1].add("shows" if word in _CARRIERS else f"{word} is shown")
    return all(not found or ("shows" in found and len(found) == _TWO) for found in clauses)


def _spelt(word: str) -> str:
    return word if word in _ENDS else stem(word)
