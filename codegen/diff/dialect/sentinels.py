"""The value that means unknown, in two versions: stated by an attribute, or in words before there was one."""

import math
import re
from collections.abc import Mapping

from codegen.diff.change import BOTH, Victim
from codegen.diff.judging.conflicts import is_alike
from codegen.diff.judging.phrases import in_one_wording, says_unknown
from codegen.diff.judging.readings import stated_values
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import Sentinel, WireField
from codegen.model.dialect.literals import LIMITS

_WORD = re.compile(r"-?[\w.]*\w")
_NUMBER = re.compile(r"-?(?:\d+\.?\d*|0[xX][0-9a-fA-F]{1,16})")
_SENTENCE = re.compile(r"(?<=[.;])\s")
_WHEN = re.compile(r"\b(?:if|when|where|not|unknown|invalid|unset|unused|ignored?|use|set|sent?d?)\b", re.IGNORECASE)
_NEGATIVE = re.compile(r"\bnegative\b", re.IGNORECASE)
_SIGN = re.compile(r"\b(?:unknown|invalid|not (?:known|available))\b", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class OtherSentinel:
    """The effect of another sentinel, the sides that it breaks, and the question for a person."""

    effect: str
    breaks: tuple[Victim, ...]
    doubt: str = ""


def is_same_sentinel(old: Sentinel | None, new: Sentinel | None) -> bool:
    """Return whether the same values mean unknown, however they are written, in the elements that both have."""
    if old is None or new is None:
        return old is new
    pairs = zip(old.values, new.values, strict=False)  # an array may be shorter than it was
    return old.form is new.form and all(_text(before) == _text(after) for before, after in pairs)


def other_sentinel(old: WireField, new: WireField) -> OtherSentinel:
    """Return the effect of another sentinel; it breaks nobody where both descriptions name the value."""
    before, after = (side.sentinel for side in (old, new))
    texts = old.definition.description, new.definition.description
    if before is not None and after is not None:
        is_disputed = is_described(after, texts[0]) and not is_described(before, texts[0])
        doubt = "which of both was meant: the description said the new one before" if is_disputed else ""
        effect = f"old receivers take {after.written} for a measurement, new ones take {before.written} for one"
        return OtherSentinel(effect, BOTH, doubt)
    if after is not None:
        if is_described(after, texts[0]):
            return OtherSentinel("the description said so before", ())
        told = _own_meanings(after, texts[0])
        if told and all(map(says_unknown, told.values())):
            return OtherSentinel("the description said so before", ())
        now = _own_meanings(after, texts[1])
        if told and not any(map(says_unknown, now.values())):
            effect = f"the description said before what {after.written} is"
            doubt = _other_meaning(told, now)
            return OtherSentinel(effect, (), doubt)
        return OtherSentinel(f"old receivers take {after.written} for a measurement", (Victim.OLD_STATION,))
    assert before is not None
    if is_described(before, texts[1]):
        return OtherSentinel("the description still says so", ())
    effect = f"new receivers take an old sender's {before.written} for a measurement, old ones a real"
    return OtherSentinel(f"{effect} {before.written} for unknown", BOTH)


def _own_meanings(sentinel: Sentinel, description: str) -> dict[str, str]:
    """Return what a text says of the values of a sentinel; empty unless it says something of each."""
    stated = {str(number).lower(): words for number, words in stated_values(in_one_wording(description)).items()}
    values = {_text(value).lower() for value in sentinel.values if value is not None}
    return {value: stated[value] for value in values} if values and values <= stated.keys() else {}


def _other_meaning(told: Mapping[str, str], now: Mapping[str, str]) -> str:
    """Return the question whether values that were told of are the values for unknown; empty where they still are
    what they were.
    """
    for value, words in told.items():
        if value not in now or not is_alike(words, now[value]):
            return f"whether {value}, which was {words!r}, was for what is not known"
    return ""


def is_described(sentinel: Sentinel, description: str) -> bool:
    """Return whether a text names each value: a bare number only where it says when
    that is sent, so not ``0 to 100``.
    """
    values = {_text(value) for value in sentinel.values if value is not None}
    names = {part.strip() for part in re.split(r"[\[\],:]", sentinel.written) if part.strip()}
    sentences = _SENTENCE.split(description)
    return bool(values) and all(
        any(_names(sentence, value) or _has(sentence, names) for sentence in sentences) for value in values
    )


def _has(sentence: str, names: set[str]) -> bool:
    """Return whether a sentence has a name of the attribute, such as an entry of an enum."""
    return any(name in _WORD.findall(sentence) for name in names if not _NUMBER.fullmatch(name))


def _names(sentence: str, value: str) -> bool:
    words = _WORD.findall(sentence)
    if any(_text(LIMITS[word]) == value for word in words if word in LIMITS):
        return True
    if any(word.lower() == value.lower() == "nan" for word in words):
        return True
    if not _WHEN.search(sentence):
        return False
    if value.startswith("-") and _NEGATIVE.search(sentence) and _SIGN.search(sentence):
        return True
    numbers = {_number(word) for word in words if _NUMBER.fullmatch(word)}
    return value in numbers or (value == "0" and "zero" in sentence.lower())


def _number(word: str) -> str:
    if word.lower().lstrip("-").startswith("0x"):
        return str(int(word, 16))
    return _text(float(word)) if "." in word else str(int(word)) if len(word) < 40 else word


def _text(value: int | float | None) -> str:
    if isinstance(value, float):
        if math.isnan(value):
            return "NaN"
        if value.is_integer():
            return str(int(value))
    return str(value)
