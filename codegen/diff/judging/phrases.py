"""Phrases that mean the same in descriptions, in one wording: what is compared is what they say."""

import re
from collections.abc import Mapping
from functools import cache

from codegen.pattern import pattern

_TURNS = r"\b(?:turn(?:s|ing|ed)?|orbit(?:s|ing)?|loiter(?:s|ing)?|circl(?:e|es|ing))(?: to)?(?: the)?"

_TELLS = r"(?:(?:indicates|tells|says|states|shows|boolean|boolean:|flag:|boolean indicating) )?"
_CLOCKWISE = r"(?<!not )\b(?:(?:counted |measured )?clockwise from|relative to|with respect to)"
"""Ways in which a bearing is counted: all are one."""
_BACK = r"(?<=[a-z]) of "
"""The beginning of what points back to what was said: ``the minute of that hour`` is a minute."""

_SAME: tuple[tuple[str, re.Pattern[str], str], ...] = tuple(
    (part, pattern(phrase, re.IGNORECASE), word)
    for part, phrase, word in (
        ("clockwise", r"\b(?:counter|anti)[- ]?clockwise\b", "counterclockwise"),
        ("ccw", r"\bccw\b", "counterclockwise"),
        ("left", rf"{_TURNS} left\b|\bleft turns?\b", "counterclockwise"),
        ("right", rf"{_TURNS} right\b|\bright turns?\b", "clockwise"),
        ("mav_bool_false", r"\bMAV_BOOL_FALSE\b", "0"),
        ("mav_bool_true", r"\bMAV_BOOL_TRUE\b", "1"),
        ("values not equal", r"\bvalues not equal to 0 or 1 are invalid\.?", ""),
        (" unless", r"\b(?:ignored|not used|unused) unless\b", "only used if"),
        (" out", r"\b(?:let(?:ting)?|paid|pay(?:ing)?) out\b", "released"),
        ("not ", r"\bnot (valid|active)\b", r"in\1"),
        ("not ", r"\bnot (healthy|available|known)\b", r"un\1"),
        ("not ", r"\bnot (armed|enabled)\b", r"dis\1"),
        ("not ", r"\b(?:does|do|did|could|has|have)? ?not (?:be )?(?:pass(?:ed)?|succeed(?:ed)?)\b", "failed"),
        ("not ", r"\bnot in use\b", "unused"),
        ("ignored", r"\bignored(?= (?:for|in|by)\b)", "not used"),
        ("lef", r"\bleft out of\b", "excluded from"),
        ("leav", r"\bleav(?:e|es|ing) out\b", "exclude"),
        ("first", r"\b(?:least significant byte|lsb) first\b", "little endian"),
        ("first", r"\b(?:most significant byte|msb) first\b", "big endian"),
        (" off", r"\b(?:turn|switch)(?:s|es|ed|ing)? ((?:the |a |it )?(?:\w+ )?)off\b", r"disable \1"),
        (" on", r"\b(?:turn|switch)(?:s|es|ed|ing)? ((?:the |a |it )?(?:\w+ )?)on\b(?! the| a)", r"enable \1"),
        (" off", r"\b(is|are|stays?|remains?) off\b", r"\1 disabled"),
        (" on", r"\b(is|are|stays?|remains?) on(?=[.,;:)]|$| for\b| while\b| if\b)", r"\1 enabled"),
        (" north", rf"{_CLOCKWISE} (?=(?:\w+ )?north\b)", "from "),
        (" side", r"\b(?:this|our|own) side\b", "local side"),
        ("whether", rf"^\W*{_TELLS}whether(?: or not)?\b", "true if"),
        ("universal", r"\bcoordinated universal time(?: \(utc\))?", "UTC"),
        ("24", r"\b24[- ]?h(?:ours?)? (?:format|clock)\b", ""),
        (" that ", rf"{_BACK}that \w+", ""),
        (" same ", rf"{_BACK}the same \w+", ""),
        (" one", r"\bthe (\w{4,}) one\b(?! of)", r"\1"),
        ("non-", r"\bnon-(?=[a-z]{3})", "not "),
        ("re-", r"\bre-(?=[a-z]{3})", "re"),
        ("co-", r"\bco-(?=[a-z]{3})", "co"),
    )
)
"""Parts of phrases in small letters, an expression for each phrase, and what stands for it."""

_AXIS = pattern(r"(?<![\w(])[xyz](?=[ -])(?! ?[-+*/=])", re.IGNORECASE)
_AXES = {
    "ned": {"x": "north", "y": "east", "z": "down"},
    "enu": {"x": "east", "y": "north", "z": "up"},
    "frd": {"x": "forward", "y": "right", "z": "down"},
    "flu": {"x": "forward", "y": "left", "z": "up"},
}
"""The names of the axes of a frame, which a text has in small letters."""

_DENYING = ("not ", "no ", "invalid", "cannot", "unavailable", "undefined", "unmeasured", "n/a", "never", "isn't")
"""Parts in small letters of what says in other words that something is unknown."""
_LIMIT = pattern(r"\b(U?)INT(8|16|32|64)_MAX\b")
_EXAMPLE = pattern(
    r"\((?:e\.g\.?|for example|for instance)[^)=:]*\)|,? (?:e\.g\.|for example,?|for instance,?) [^.;:,=()]*",
    re.IGNORECASE,
)
_UNKNOWN = pattern(
    r"\b(?:unknown|invalid|unavailable|undefined|unmeasured)\b|\bn/a\b"
    r"|\b(?:not|cannot be|isn't|never) (?:yet )?"
    r"(?:available|known|provided?|measured|supplied|estimated|valid|supported|present|sent)\b"
    r"|\bnot applicable\b|\b(?:does|do) ?not apply\b"
    r"|\b(?:does|do|can) ?not (?:provide|measure|know|supply|estimate|support|send|have)\b"
    r"|\b(?:is|are|has|have) no (?:\w+ )?(?:estimate|sensor|measurement|reading|data|information|value)\b"
    r"|^no (?:\w+ )?(?:estimate|sensor|measurement|reading|data|information)\b",
    re.IGNORECASE,
)  # fmt: skip


@cache
def in_one_wording(text: str) -> str:
    """Return a text with phrases of one meaning in one wording, and limits of types as their numbers."""
    if "INT" in text:
        text = _LIMIT.sub(lambda found: str(2 ** (int(found[2]) - (not found[1])) - 1), text)
    small = text.lower()
    for part, phrase, word in _SAME:
        if part in small:
            text = phrase.sub(word, text)
    return text


def with_named_axes(old: str, new: str) -> tuple[str, str]:
    """Return two texts with ``north`` for ``x`` where both tell of the frame NED, and the like for other frames."""
    for frame, axes in _AXES.items():
        if frame in old.lower() and frame in new.lower():
            return _named(old, axes), _named(new, axes)
    return old, new


def _named(text: str, axes: Mapping[str, str]) -> str:
    return _AXIS.sub(lambda found: axes[found[0].lower()], text)


def without_examples(text: str) -> str:
    """Return a text without its examples, such as ``(e.g. 18 for 6 p.m.)``; those of what a number means stay."""
    if "e.g" not in text and "or example" not in text and "or instance" not in text:
        return text
    return _EXAMPLE.sub(" ", text)


def with_unknown(text: str) -> str:
    """Return a text with one word for all that says that nothing is known: ``not available``, ``is not measured``."""
    small = text.lower()
    for part in _DENYING:
        if part in small:
            return _UNKNOWN.sub("unknown", text)
    return text


def says_unknown(words: str) -> bool:
    """Return whether what is said of a number is that nothing is known where it is sent."""
    return _UNKNOWN.search(words) is not None
