"""Numbers to which a description gives a meaning of their own: nothing is to change, there is no value, or another.

NaN is looked for by itself: as no value is ever meant by it, every word about it gives it a meaning.
"""

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from codegen.model.dialect.literals import LIMITS
from codegen.model.dialect.phrase import phrase


class StatedValue(NamedTuple):
    """A number as a description writes it (``-1``, ``UINT16_MAX``, ``NaN``), and the words that give it its meaning.

    ``is_left`` is true of one that leaves things as they are.
    """

    text: str
    words: str
    is_left: bool

    @property
    def is_nan(self) -> bool:
        """Return whether it is NaN, which is no number."""
        return self.text == "NaN"

    @property
    def number(self) -> Fraction:
        """The number on the wire; ValueError of NaN."""
        name, _, less = self.text.upper().partition("-")
        if name.strip() in LIMITS:
            return Fraction(LIMITS[name.strip()] - int(less or 0))
        return Fraction(self.text)


_compiled = partial(phrase, flags=re.IGNORECASE)


_LIMIT = r"U?INT(?:8|16|32|64)_M(?:AX|IN)(?: ?- ?\d{1,3})?"
_NUMBER = rf"(?:-?\d{{1,10}}(?:\.\d{{1,6}})?|{_LIMIT}|zero)"
_APART = r"(?<![\w.,+/*^\[<>-])"
_END = r"(?![\w%°/^*\]])(?!\.\d)"
_MEANS = r"(?:is|are)(?= ignored)|means?|indicates?|implies|signifies|denotes|if|for|when|to(?! ?-?\d)"
_LINK = rf"\)? ?[:=]|\)?,? (?:or NaN )?(?:{_MEANS})\b"
_AHEAD = (
    rf"{_APART}(?P<text>{_NUMBER}){_END}(?: or (?P<other>{_NUMBER}){_END})?(?P<link>{_LINK}) ?"
    r"(?P<words>[^.;,()]{0,70})"
)
_BEHIND = (
    rf"\bif (?P<words>[^.;:,()]{{0,40}}?)[:,]? ?(?:(?:use|set|send|assign)(?: it)?(?: to)?:? ?)?{_APART}"
    rf"(?P<text>{_NUMBER}){_END}"
)
_RANGE = r"(?:\d|_MAX|_MIN)[\w%]*(?: to |\.\.| ?\.\. ?)$|\d $|(?:than|at least|at most|bits?|channel|index|from) $"
_LISTED = r"(?<![\w.-])-?\d+ ?[:=]"
_EXTREME = r"(?:the )?(?:max|min|full|reverse|left|right|down|up)"
_LEFT = (
    r"\bignor(?:e|ed|ing)\b|\bno (?:change|override)\b|\bunchanged\b|\bnot (?:be )?changed?\b|\bleaves?\b|\bkeeps?\b|"
    r"\bmaintain(?:s|ed)?\b|\b(?:do|does) not (?:set|change)\b|\bdon't (?:set|change)\b"
)
_FAILED = r"\bunknown\b|\bfailed\b|\bfailure\b|\binvalid\b"
_NONE = (
    r"\breleases?\b|\b(?:un|not )(?:specified|used|available)\b|\bnot set\b|\bunavailable\b|\binvalid\b|\bdisabled?\b|"
    r"\b(?:no|not) (?:\w+ )?(?:known|provided?|supplied|supported|measured?|estimated?|valid|applicable|required)\b|"
    r"\bdoes not (?:provide|measure|support|have)\b|\bunlimited\b|\binfinite\b|\bno limit\b"
)

_NEGATIVE = r"\b[Nn]egative values?(?: ?:| indicates?| means?)? (?P<words>[^.;,()]{0,70})"
_SMALLER = r"\b[Vv]alues? (?:smaller|less|lower) than (?P<limit>-?\d{1,9})(?P<words>[^.;,()]{0,70})"
_NAN = r"[^.;:,()]{0,50}(?<!maps to )\bNaN\b[^.;()]{0,70}"


def stated_values(description: str) -> Iterator[StatedValue]:
    """Yield the numbers of a description that are no value like the others, each once.

    A plain list of what numbers stand for (``0: idle, 1: busy``) has none, unless one of them leaves things as they
    are or is unknown. Of other numbers the words decide; a negative one before a colon, and the limit of a type, are
    always meant.
    """
    is_list = len(_compiled(_LISTED).findall(description)) > 1
    told: set[str] = set()
    for match in (*_compiled(_AHEAD).finditer(description), *_compiled(_BEHIND).finditer(description)):
        if _compiled(_RANGE).search(description[: match.start("text")]):
            continue
        found = match.groupdict()
        words = found["words"].strip()
        is_left = bool(_compiled(_LEFT).search(words))
        is_told = (
            is_left or bool(_compiled(_FAILED).search(words)) or (not is_list and bool(_compiled(_NONE).search(words)))
        )
        for text in (found["text"], found.get("other")):
            if text is None or text.lower() in told:
                continue
            is_odd = "link" in found and not is_list and not _compiled(_EXTREME).match(words) and _is_odd(text)
            if is_told or is_odd:
                told.add(text.lower())
                yield StatedValue("0" if text.lower() == "zero" else text, match[0].strip(), is_left)


def stated_below(description: str) -> tuple[Fraction, str] | None:
    """Return the number below which there is no value, and the words that say so.

    As in "Negative value: Unknown distance", and in "Values smaller than -1000 should be interpreted as unknown".
    """
    for form in (_NEGATIVE, _SMALLER):
        match = _compiled(form).search(description)
        if match is not None and _compiled(rf"{_FAILED}|{_NONE}|\bno measurement\b").search(match["words"]):
            return Fraction(match.groupdict().get("limit") or 0), match[0].strip()
    return None


def stated_nan(description: str) -> StatedValue | None:
    """Return what a description says of NaN, None where it says nothing; its number is none."""
    match = _compiled(_NAN).search(description)
    if match is None:
        return None
    words = match[0].strip()
    return StatedValue("NaN", words, bool(_compiled(_LEFT).search(words)))


def _is_odd(text: str) -> bool:
    """Return whether a number is one that is hardly written for itself: below 0, or at the end of a type."""
    return text.startswith("-") or text.partition("-")[0].strip() in LIMITS
