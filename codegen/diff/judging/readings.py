"""Phrases of a text that go with single numbers, with signs, and with a bit that is set or not."""

import re
from collections.abc import Mapping
from functools import cache

from codegen.diff.judging.words import stem
from codegen.pattern import pattern

_LONGEST = 20
_SEVERAL = 2
_OR = re.compile(r"^(?:.*\b(?:indicating|of|is|are|either) )?(?:or |and )?", re.IGNORECASE)
_DOES = (
    "leaves|leave|keeps|keep|disables|disable|enables|enable|stops|stop|starts|start|turns|turn|switches|selects"
    "|requests|asks|lets|makes|holds|resets|uses|without"
)
"""Verbs of what a number does: ``0 disables the limit``."""
_STATED = pattern(
    r"(?<![\w.])(-?\d+|NaN\b)(?:\.0+(?!\d))?(?:\)(?= (?:if|when|while)))?"
    r"\s*(?:[:=]|(?:means|is|to|for|if|when|while|where)\b"
    rf"|(?:indicates?|tells?|says?|denotes?|marks?)(?: that)?\b|(?=(?:{_DOES})\b))"
    r"\s*([A-Za-z][^,;.:=()\[\]\n\d]*)",
    re.IGNORECASE,
)
_STATE = pattern(
    r"\b(true|false|not set|unset|cleared|set)\b\s*(?:[:=]|(?:means|if|when|while|where)\b)"
    r"\s*([a-z][^,;.:=()\[\]\n\d]*)",
    re.IGNORECASE,
)
_STATES = {"true": 1, "set": 1, "false": 0, "not set": 0, "unset": 0, "cleared": 0}
_CONDITION = pattern(
    r"(?:^|[.;,(]\s*)(?:if|when)(?: set to| it is| this is| the value is)? (-?\d{1,19}|NaN),? (?:then )?"
    r"(?!(?:or|and|to|is|means|it is)\b)([a-z][^,;.:=()\[\]\n\d]*)",
    re.IGNORECASE,
)
_SIGN = pattern(r"(?<!if this is )(?<!if )(?<!when )\b(positive|negative)\b[:,]?\s*((?:[a-z]+[\s/()-]*){1,10})")
_IDLE = frozenset(map(stem, (
    "for", "is", "are", "means", "while", "when", "if", "to", "the", "value", "values", "number", "numbers", "and",
    "or", "axis", "a", "an", "one", "being", "makes", "make", "that", "use", "it", "with", "by", "of",
)))  # fmt: skip
_ALSO = {"into": "in", "right": stem("clockwise"), "left": stem("counterclockwise")}
"""Words for a direction by another one, which is the same to who looks down on a turn."""
_THERE = frozenset(map(stem, ("there", "was", "were", "turn", "has", "have", "been", "s", "its", "this", "as")))
_NO = re.compile(r"^no (?=\w)", re.IGNORECASE)
_LETTERS = pattern(r"[a-z]+")
_ZERO = pattern(rf"\b(?:all )?zeros?\b(?=\s*(?:[:=]|(?:means|if|when|{_DOES})\b))", re.IGNORECASE)
_BRACKETED = pattern(r"([A-Za-z][^;.:=()\[\]\n\d]*?)\s*\((\d+)\)(?=\s*(?:,|or\b|and\b|[.;]|$|\w))")

Senses = frozenset[str]
_SENSES: Mapping[str, re.Pattern[str]] = {
    sense: pattern(words, re.IGNORECASE)
    for sense, words in {
        "kept": r"\b(?:no change|unchanged|keep|kept|keeps|leave|leaves|maintain|retain|stays?|holds?|as it is"
        r"|as (?:now|before)|(?:do not|don't|not) changed?|unaffected|untouched)\b",
        "by default": r"\bdefaults?\b",
        "chosen by the vehicle": r"\b(?:chooses?|decides?|choice|automatic(?:ally)?|at will)\b",
        "none": r"\b(?:none|nothing|no (?!change|effect|action|longer|error|fault|failure|problem)\w+|unlimited"
        r"|without)\b",
        "healthy": r"\b(?:no (?:errors?|faults?|failures?|problems?)|fine|healthy|ok|okay|good|operational"
        r"|functional|works?|working)\b",
        "faulty": r"(?<!no )\b(?:errors?|fail(?:s|ed|ure)?|faulty?|unhealthy|broken|defective|bad)\b",
        "any": r"\b(?:any|arbitrary|no preference|not matter|don't care)\b",
        "off": r"\b(?:not run(?:ning)?|inactive|disabl\w*|off|deactivat\w*|silent)\b",
        "stopped": r"\b(?:stop\w*|end(?:s|ed|ing)?|cancel\w*)\b",
        "on": r"\b(?:enabl\w*|on|activat\w*|start\w*|begin\w*)\b",
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
    for one in _CONDITION.finditer(text):
        number = one[1] if one[1].isalpha() else int(one[1])
        found[number] = f"{found[number]}, {one[2]}" if number in found else one[2].strip()
    return found or _bracketed(text)


def _bracketed(text: str) -> dict[int | str, str]:
    """Return what a text says before several numbers in brackets: ``success (1) or failure (0)``."""
    if text.count("(") < _SEVERAL:
        return {}
    found: dict[int | str, str] = {int(one[2]): _OR.sub("", one[1]) for one in _BRACKETED.finditer(text)}
    return found if len(found) >= _SEVERAL else {}


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


_OF_SOMETHING = frozenset({"none", "off", "stopped", "on", "healthy", "faulty"})
"""Senses of an action or a state: what it is of has to be the same, too."""
_NEAR_SENSES = (frozenset({"none", "off"}), frozenset({"off", "stopped"}), frozenset({"none", "healthy"}))
"""Of a limit that is disabled there is none, and a message that is disabled is stopped; to stop is to do something."""


def is_one_sense(words: str, other: str) -> bool:
    """Return whether two texts about a number have the same usual sense; of an action, also the same object."""
    before, after = senses_of(words), senses_of(other)
    if not before or not after:
        return False
    if before == after and before.isdisjoint(_OF_SOMETHING):
        return True
    if not (before | after) <= _OF_SOMETHING or not (before == after or before | after in _NEAR_SENSES):
        return False
    objects = _object(words), _object(other)
    return objects[0] <= objects[1] or objects[1] <= objects[0]


def _object(words: str) -> frozenset[str]:
    """Return what is left of a text about a number without the words that tell of its sense."""
    for sense in _OF_SOMETHING:
        words = _NO.sub(
            " ", _SENSES[sense].sub(lambda found: f" {_NO.sub('', found[0])} " if found[0][:3] == "no " else " ", words)
        )
    return frozenset(stem(word) for word in _LETTERS.findall(words.lower()) if stem(word) not in _IDLE | _THERE)


def senses_of(words: str) -> Senses:
    """Return which of the usual things is said of a number: that all is kept, a default, that it is ignored."""
    return frozenset(sense for sense, expression in _SENSES.items() if expression.search(words))
