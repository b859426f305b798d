"""The words and marks around a term as traits of what it may say: those before it, behind it, and up to the name."""

from codegen.claims.parts.span import Span
from codegen.pattern import pattern

MARK = "word "
"""The beginning of all traits that are words."""
_WORD = pattern(r"[a-z']+|[A-Z]|[-=:(),.;|*/<>]")
_REACH = 40
"""Characters on either side of a term in which its words are."""
_MANY = 3
_LONGEST = 80
"""The longest piece between a name and a term, in characters, of which the words are looked at."""


def words_beside(span: Span, at: int, low: int, high: int) -> frozenset[str]:
    """Return the words and marks on both sides of a term, in its sentence between two offsets."""
    before = _WORD.findall(span.text, max(low, at - _REACH), at)[-_MANY:]
    behind = _WORD.findall(span.text, at + 1, min(high, at + 1 + _REACH))[:_MANY]
    found = {f"{MARK}before {word}" for word in before} | {f"{MARK}behind {word}" for word in behind}
    found |= {f"{MARK}just before {word}" for word in before[-1:]} | {f"{MARK}next {word}" for word in behind[:1]}
    return frozenset(found)


def words_between(gap: str) -> frozenset[str]:
    """Return the words and marks between a name and a term, if they are near each other."""
    return frozenset(f"{MARK}between {word}" for word in _WORD.findall(gap)) if len(gap) < _LONGEST else frozenset()
