"""Phrases that mean the same in descriptions, in one wording: what is compared is what they say."""

import re
from functools import cache

_TURNS = r"\b(?:turn(?:s|ing|ed)?|orbit(?:s|ing)?|loiter(?:s|ing)?|circl(?:e|es|ing))(?: to)?(?: the)?"

_SAME: tuple[tuple[str, str], ...] = (
    (r"\b(?:counter|anti)[- ]?clockwise\b|\bccw\b", "counterclockwise"),
    (rf"{_TURNS} left\b|\bleft turns?\b", "counterclockwise"),
    (rf"{_TURNS} right\b|\bright turns?\b", "clockwise"),
    (r"\bMAV_BOOL_FALSE\b", "0"),
    (r"\bMAV_BOOL_TRUE\b", "1"),
    (r"\bvalues not equal to 0 or 1 are invalid\.?", ""),
    (r"\b(?:ignored|not used|unused) unless\b", "only used if"),
    (r"\b(?:let(?:ting)?|paid|pay(?:ing)?) out\b", "released"),
    (r"\b(re|co)-(?=[a-z]{3})", r"\1"),
)  # fmt: skip
"""Expressions for phrases, and what stands for each."""

_BITS = (7, 8, 15, 16, 31, 32, 63, 64)
_LIMIT = re.compile(r"\b(U?)INT(8|16|32|64)_MAX\b")
_UNKNOWN = re.compile(
    r"\b(?:unknown|invalid|unavailable|undefined|unmeasured)\b|\bn/a\b"
    r"|\b(?:not|cannot be|isn't|never) (?:yet )?"
    r"(?:available|known|provided?|measured|supplied|estimated|valid|supported|present|sent)\b"
    r"|\b(?:does|do|can) ?not (?:provide|measure|know|supply|estimate|support|send|have)\b"
    r"|\b(?:is|are|has|have) no (?:\w+ )?(?:estimate|sensor|measurement|reading|data|information|value)\b"
    r"|^no (?:\w+ )?(?:estimate|sensor|measurement|reading|data|information)\b",
    re.IGNORECASE,
)  # fmt: skip


@cache
def in_one_wording(text: str) -> str:
    """Return a text with phrases of one meaning in one wording, and limits of types as their numbers."""
    text = _LIMIT.sub(lambda found: str(2 ** (int(found[2]) - (not found[1])) - 1), text)
    for phrase, word in _SAME:
        if _expression(phrase).search(text):
            text = _expression(phrase).sub(word, text)
    return text


@cache
def _expression(phrase: str) -> re.Pattern[str]:
    return re.compile(phrase, re.IGNORECASE)


def with_unknown(text: str) -> str:
    """Return a text with one word for all that says that nothing is known: ``not available``, ``is not measured``."""
    return _UNKNOWN.sub("unknown", text)


def says_unknown(words: str) -> bool:
    """Return whether what is said of a number is that nothing is known where it is sent."""
    return _UNKNOWN.search(words) is not None
