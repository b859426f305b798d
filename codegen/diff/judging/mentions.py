"""Single numbers of a text, and how often it denies something: ``true unless`` for ``true if``."""

from codegen.diff.judging.phrases import with_unknown
from codegen.pattern import pattern

_NEGATION = pattern(r"\b(?:not|no|never|unless|except|without|cannot)\b|n't\b")
_NUMBER = pattern(r"(?<![\w.])-?(?:0x[0-9a-f]+|\d+(?:\.\d+)?)(?![\w.]*\d)")
_LIMITS = frozenset(str(2**bits - 1) for bits in (7, 8, 15, 16, 31, 32, 63, 64))
_UNKNOWN = pattern(
    r"\bnot (?:available|known|used|provided|set|supported|measured|applicable|equal)\b|\b(?:do not|don't) use\b"
)


def numbers(text: str) -> frozenset[str]:
    """Return the numbers of a text in one spelling, without the limits of types: those are its value for unknown."""
    return frozenset(_spelt(number[0]) for number in _NUMBER.finditer(text.lower().replace("..", " "))) - _LIMITS


def _spelt(number: str) -> str:
    if "x" in number:
        return str(int(number, 16))
    return number.rstrip("0").rstrip(".") if "." in number else str(int(number))


def negations(text: str) -> int:
    """Return how often a text denies something, without what it says of values that are unknown or not allowed."""
    small = with_unknown(text).lower()
    return len(_NEGATION.findall(_UNKNOWN.sub(" ", small))) if _NEGATION.search(small) else 0
