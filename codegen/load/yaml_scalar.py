"""Values of unquoted YAML scalars under the core schema of YAML 1.2 (section 10.3.2 of its specification)."""

import math
from fractions import Fraction

from codegen.pattern import pattern

ScalarValue = str | bool | Fraction | float | None
"""Text, a boolean, an exact number or nothing; a float stands for a number without an exact value here:
``.nan``, ``.inf``, or one beyond the limits below (then infinite)."""

MAX_DIGITS = 400
MAX_EXPONENT = 400
"""Longest number and largest power of ten that are read exactly: enough for every double, and no number of a few
characters can take up gigabytes."""

_MAY_BE_VALUE = pattern(r"[-+.0-9~nNtTfF]|$")
"""The beginnings of all that is no text: most scalars are names and sentences, which begin otherwise."""
_NULL = pattern(r"null|Null|NULL|~|")
_TRUE = pattern(r"true|True|TRUE")
_FALSE = pattern(r"false|False|FALSE")
_DECIMAL = pattern(r"[-+]?[0-9]+")
_OCTAL = pattern(r"0o([0-7]+)")
_HEXADECIMAL = pattern(r"0x([0-9a-fA-F]+)")
_FLOAT = pattern(r"[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE]([-+]?[0-9]+))?")
_SPECIAL = {f"{sign}{name}": float(sign + "inf") for sign in ("", "+", "-") for name in (".inf", ".Inf", ".INF")}
_SPECIAL |= dict.fromkeys((".nan", ".NaN", ".NAN"), math.nan)


def plain_value(text: str) -> ScalarValue:
    """The value of an unquoted scalar: ``12:30``, ``yes`` and dates are text, ``010`` is ten, ``3.95`` is 79/20."""
    if not _MAY_BE_VALUE.match(text):
        return text
    if _NULL.fullmatch(text):
        return None
    if _TRUE.fullmatch(text):
        return True
    if _FALSE.fullmatch(text):
        return False
    number = _number(text)
    return text if number is None else number


def _number(text: str) -> Fraction | float | None:
    if text in _SPECIAL:
        return _SPECIAL[text]
    for form, base in ((_OCTAL, 8), (_HEXADECIMAL, 16)):
        if digits := form.fullmatch(text):
            return math.inf if len(text) > MAX_DIGITS else Fraction(int(digits[1], base))
    if _DECIMAL.fullmatch(text):
        return math.inf if len(text) > MAX_DIGITS else Fraction(int(text))
    if written := _FLOAT.fullmatch(text):
        if len(text) > MAX_DIGITS or abs(int(written[1] or 0)) > MAX_EXPONENT:
            return math.inf
        return Fraction(text)
    return None
