"""Single numbers of a text, and how often it denies something: ``true unless`` for ``true if``."""

import re

from codegen.diff.judging.phrases import with_unknown
from codegen.diff.judging.words import stem
from codegen.pattern import pattern

_NEGATION = pattern(
    r"\b(?:not|no|never|unless|except|without|cannot)\b|n't\b"
    r"|\b(?:left|leav(?:e|es|ing)) (?:out|alone)\b|\bdropped from\b"
    r"|\b(?:exclud|omit|skip|suppress|bypass|disregard|discard|withh[eo]ld|ignor)\w*"
)
_QUANTIFIERS = {
    "all": "all", "every": "all", "both": "both", "this": "this one", "own": "this one", "single": "one", "one": "one",
    "another": "another", "other": "another",
}  # fmt: skip
_QUANTIFIED = pattern(rf"\b({'|'.join(_QUANTIFIERS)}) (?:of (?:the |these )?|the )?([a-z]{{3,}})")
_RANGE_END = pattern(
    r"(?:\d ?(?:to|-|\.\.+|through|and) ?|\b(?:share|out|parts?|fraction|maximum|up) (?:of|to|is) )(\d+)\b"
    r"|\b(\d+)(?= ?(?:is|=|:|for) (?:the )?(?:max|full|100))"
)
_NUMBER = pattern(r"(?<![\w.])-?(?:0x[0-9a-f]+|\d+(?:\.\d+)?)(?![\w.]*\d)")
_LIMITS = frozenset(str(2**bits - 1) for bits in (7, 8, 15, 16, 31, 32, 63, 64))
OTHERWISE = pattern(r"\b(?:else|otherwise)\b", re.IGNORECASE)
"""Words that say the rest without denying anything."""
_UNKNOWN = pattern(
    r"\bnot (?:available|known|provided|set|supported|measured|applicable|equal)\b|\bnot used\b(?! (?:for|in|by|as))"
    r"|\b(?:do not|don't) use\b(?! (?:the|this|a) )|\bignor\w* (?:it\b|(?:the|this) (?:value|field|number|parameter)\b)"
)


def numbers(text: str) -> frozenset[str]:
    """Return the numbers of a text in one spelling, without the limits of types, which are its value for unknown, but
    for those with which a range or a scale ends.
    """
    small = text.lower()
    found = frozenset(_spelt(number[0]) for number in _NUMBER.finditer(small.replace("..", " ")))
    if found.isdisjoint(_LIMITS):
        return found
    return found - (_LIMITS - {end[1] or end[2] for end in _RANGE_END.finditer(small)})


def _spelt(number: str) -> str:
    if "x" in number:
        return str(int(number, 16))
    return number.rstrip("0").rstrip(".") if "." in number else str(int(number))


def quantities_of(text: str) -> dict[str, frozenset[str]]:
    """Return of how many of what a text tells, by the thing: ``all`` or ``this`` of ``link``."""
    found: dict[str, frozenset[str]] = {}
    for one in _QUANTIFIED.finditer(text.lower()):
        noun = stem(one[2])
        found[noun] = found.get(noun, frozenset()) | {_QUANTIFIERS[one[1]]}
    return found


def negations(text: str) -> int:
    """Return how often a text denies something, without what it says of values that are unknown or not allowed."""
    small = with_unknown(text).lower()
    return len(_NEGATION.findall(_UNKNOWN.sub(" ", small))) if _NEGATION.search(small) else 0
