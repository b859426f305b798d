"""The values that stand for unknown in a field: by the dialect's attribute, or else by the words of its description."""

import re
from functools import cache

from codegen.model.dialect.dialect import WireField
from codegen.model.dialect.literals import named_number
from codegen.pattern import pattern

_VALUE = r"(?<![\w.+-])(?P<value>NaN|U?INT(?:8|16|32|64)_M(?:AX|IN)|-?\d{1,6})(?![\w.])"
_WORDS = (
    pattern(
        r"\b(?P<value>zero|-?\d{1,6}) (?:means|indicates) (?:unknown|not (?:available|supported)|invalid)",
        re.IGNORECASE,
    ),
    pattern(
        rf"{_VALUE}:? (?:if |when |for |means |is |= ?)?(?:it is |value is )?"
        r"(?:unknown|invalid|not (?:known|available))"
    ),
    pattern(rf"{_VALUE}: [^.;,]*\bnot\b"),
    pattern(
        r"\b(?P<value>zero|-?\d{1,6}|U?INT(?:8|16|32|64)_M(?:AX|IN)|NaN) (?:values? |in this value )?(?:means?"
        r"|indicates?|marks?)"
        r" [^.;,>]{0,40}?\b(?:unknown|invalid|not available|ignore|unused)",
        re.IGNORECASE,
        needs="indicate|mark|mean",
    ),
    pattern(rf"\b[Uu]se {_VALUE} if [^.;,]{{0,40}}\b(?:unknown|not available|invalid)"),
    pattern(rf"\b(?:unknown|invalid): {_VALUE}", re.IGNORECASE),
    pattern(
        rf"(?:unknown|not known|invalid|not available),? (?:set to|set it to|use|is|=|send)[: ]+{_VALUE}", re.IGNORECASE
    ),
)


def unknown_values(field: WireField) -> tuple[list[int | float], str] | None:
    """The numbers that stand for unknown and how they are written; None where the dialect says nothing of it."""
    if field.sentinel is not None:
        return [value for value in field.sentinel.values if value is not None], field.sentinel.written
    if is_negative_unknown(field):
        return [-1], "negative"
    for form in _WORDS:
        found = form.search(field.definition.description)
        written = ("0" if found["value"].lower() == "zero" else found["value"]) if found else ""
        value = number_of(written)
        if value is not None:
            return [value], written
    return None


_STATE = pattern(r"(?<![\w.])(?P<value>-?\d{1,5}) ?[=:] ?[^.;,:=]{0,40}?\b(?:unknown|unset|invalid|not available)\b")
_FAILURE = pattern(r"(?<![\w.])(?P<value>-?\d{1,5}) ?[=:] ?[^.;,:=]{0,40}?\bfail(?:ed|ure)\b")


@cache
def described_unknowns(field: WireField) -> tuple[int, ...]:
    """Return the values of a field that its description calls unknown besides: "1 = invalid, 0 = unset"."""
    return tuple(int(found["value"]) for found in _STATE.finditer(field.definition.description))


@cache
def described_failures(field: WireField) -> tuple[int, ...]:
    """Return the values of a field that its description has for a failure: "-1 = odometry has failed"."""
    return tuple(int(found["value"]) for found in _FAILURE.finditer(field.definition.description))


_NEGATIVE = pattern(
    r"\bnegative values?:? (?:means? |is |for |= ?)?(?:unknown|invalid|not)|\b(?:unknown|invalid)[^.;]{0,20}"
    r" negative\b",
    re.IGNORECASE,
)


def is_negative_unknown(field: WireField) -> bool:
    """Return whether any negative value stands for unknown."""
    return _NEGATIVE.search(field.definition.description) is not None


def number_of(written: str) -> int | float | None:
    """The number that a text names: ``UINT16_MAX``, ``NaN``, decimal, ``0xFFFF``."""
    if pattern(r"0[xX][0-9a-fA-F]{1,16}").fullmatch(written):
        return int(written, 16)
    return named_number(written)
