"""Phrases of a text that go with single numbers, with signs, and with a bit that is set or not."""

import re
from collections.abc import Mapping
from functools import cache

from codegen.diff.judging.words import stem
from codegen.pattern import pattern

_LONGEST = 20
_STATED = pattern(
    r"(?<![\w.])(-?\d+|NaN\b)(?:\.0+(?!\d))?\s*(?:[:=]|(?:means|is|to|for|if|when|while|where)\b)"
    r"\s*([A-Za-z][^,;.:=()\[\]\n\d]*)",
    re.IGNORECASE,
)
_STATE = pattern(
    r"\b(true|false|not set|unset|cleared|set)\b\s*(?:[:=]|(?:means|if|when|while|where)\b)"
    r"\s*([a-z][^,;.:=()\[\]\n\d]*)",
    re.IGNORECASE,
)
_STATES = {"true": 1, "set": 1, "false": 0, "not set": 0, "unset": 0, "cleared": 0}
_SIGN = pattern(r"(?<!if this is )(?<!if )(?<!when )\b(positive|negative)\b[:,]?\s*((?:[a-z]+[\s/()-]*){1,10})")
_IDLE = frozenset(map(stem, (
    "for", "is", "are", "means", "while", "when", "if", "to", "the", "value", "values", "number", "numbers", "and",
    "or", "axis", "a", "an", "one", "being", "makes", "make", "that", "use", "it", "with", "by", "of",
)))  # fmt: skip
_ALSO = {"into": "in", "right": stem("clockwise"), "left": stem("counterclockwise")}
"""Words for a direction by another one, which is the same to who looks down on a turn."""
_LETTERS = pattern(r"[a-z]+")
_ZERO = pattern(r"\bzero\b(?=\s*(?:[:=]|means\b))", re.IGNORECASE)

Senses = frozenset[str]
_SENSES: Mapping[str, re.Pattern[str]] = {
    sense: pattern(words, re.IGNORECASE)
    for sense, words in {
        "kept": r"\b(?:no change|unchanged|keep|kept|keeps|leave|leaves|maintain|retain)\b",
        "by default": r"\bdefaults?\b",
        "chosen by the vehicle": r"\b(?:chooses?|decides?|choice|automatic(?:ally)?|at will)\b",
        "none": r"\b(?:none|no limit|unlimited)\b",
        "ignored": r"\b(?:ignored?|no effect|do nothing|no action|disregard(?:ed)?)\b",
        "the best": r"\b(?:best|maximum|highest|full|perfect)\b",
        "the worst": r"\b(?:worst|minimum|lowest)\b",
    }.items()
}


@cache
def stated_values(text: str) -> Mapping[int | str, str]:
    """Return what a text says of single numbers: ``0: forward, 1: reverse``, ``NaN to keep the present angle``."""
    found: dict[int | str, str] = {}
    if "ero" in text:
        text = _ZERO.sub("0", text)
    for one in _STATED.finditer(text):
        if len(one[1]) < _LONGEST:
            number, words = one[1] if one[1].isalpha() else int(one[1]), one[2].strip()
            found[number] = f"{found[number]}, {words}" if number in found else words
    return found


def stated_states(text: str) -> dict[int | str, str]:
    """Return what a text says of a bit, by 1 and 0: ``set while the probe is wet``, ``false: closed``."""
    small = text.lower()
    if not any(word in small for word in ("true", "false", "set", "cleared")):
        return {}
    return {_STATES[one[1].lower()]: one[2].strip() for one in _STATE.finditer(text)}


def stated_signs(text: str) -> dict[str, frozenset[str]]:
    """Return the words that say what a positive and what a negative number is; of directions, nothing but these."""
    found: dict[str, frozenset[str]] = {}
    small = text.lower()
    if "tive" not in small:
        return found
    for one in _SIGN.finditer(small):
        words = (_ALSO.get(word) or stem(word) for word in _LETTERS.findall(one[2]))
        told = frozenset(word for word in words if word not in _IDLE)
        found[one[1]] = found.get(one[1], frozenset()) | told
    return {sign: directions(words) or words for sign, words in found.items()}


def directions(words: frozenset[str]) -> frozenset[str]:
    """Return which of some words are directions, or senses of a turn."""
    return words & _DIRECTIONS


_DIRECTIONS = frozenset(map(stem, (
    "up", "down", "left", "right", "forward", "backward", "reverse", "clockwise", "counterclockwise", "north", "south",
    "east", "west", "front", "rear", "back", "above", "below", "ascend", "descend", "increase", "decrease",
)))  # fmt: skip


def senses_of(words: str) -> Senses:
    """Return which of the usual things is said of a number: that all is kept, a default, that it is ignored."""
    return frozenset(sense for sense, expression in _SENSES.items() if expression.search(words))
