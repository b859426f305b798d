"""Arithmetic as documents write it, worked out exactly: numbers with units, + - * / and powers, no names, no calls."""

import re
from collections.abc import Sequence
from fractions import Fraction

from codegen.frozen import dataclass

MAX_TOKENS = 60
"""Longest expression that is looked at."""

_TOKEN = re.compile(
    r"\s*(?:(?P<number>0[xX][0-9a-fA-F]{1,16}|\d{1,3}(?:,\d{3}){1,4}(?!\d)(?:\.\d{1,15})?|\d{1,18}(?:\.\d{1,15})?"
    r"(?:[eE][-+]?\d{1,2})?)(?:[ ]?(?P<unit>%|(?!x[ \d])[A-Za-zµ°][A-Za-z°]{0,8}(?:/[A-Za-z]{1,3})?)(?![\w(]))?"
    r"|(?P<operator>\*\*|[-+*/^()\u00d7\u00b7\u00f7\u2212]|x(?=[ ]?\d)))"
)
_NO_PART = re.compile(r"[=<>:;|\"'`?!{}\[\]&#$@\n]")
_SIGNS = {"\u00d7": "*", "\u00b7": "*", "x": "*", "\u00f7": "/", "\u2212": "-", "^": "**"}
_POWERS_OF = (2, 10)
"""Bases for which ``^`` is a power, and not the exclusive or of a program."""


@dataclass(frozen=True, slots=True)
class Expression:
    """An expression at ``start`` of a text up to ``end``, its exact value, and the units that its numbers have."""

    start: int
    end: int
    value: Fraction
    units: frozenset[str]


@dataclass(frozen=True, slots=True)
class _Token:
    text: str
    number: Fraction | None
    unit: str | None
    start: int
    end: int


def expression_before(text: str, end: int) -> Expression | None:
    """The longest expression that ends at ``end`` and has an operator; None where there is none.

    It begins after a letter, a sign of another kind or the start of the text. What is not certainly arithmetic (a
    range such as 0-100, a date, a percentage) is none.
    """
    low = max(end - 200, 0)
    low = max((found.end() for found in _NO_PART.finditer(text, low, end)), default=low)
    end = low + len(text[low:end].rstrip())
    tokens = _tokens(text, low, end)
    for first in range(len(tokens)):
        run = tokens[first:]
        if run[0].number is None and run[0].text not in ("(", "-"):
            continue
        if first and tokens[first - 1].unit == "%":
            continue  # a percentage of something, or a remainder
        if run[0].start > 0 and (text[run[0].start - 1].isalnum() or text[run[0].start - 1] in "._"):
            continue
        value = _value(run)
        has_operator = any(token.number is None and token.text not in "()" for token in run[1:])
        if value is not None and has_operator:
            units = frozenset(token.unit for token in run if token.unit)
            return None if _is_range(text, run) else Expression(run[0].start, run[-1].end, value, units)
    return None


def _tokens(text: str, low: int, end: int) -> list[_Token]:
    """The tokens that lead up to ``end`` without a gap: what stands before the last thing that is no token is left."""
    tokens: list[_Token] = []
    position = low
    while position < end:
        found = _TOKEN.match(text, position, end)
        if found is None or found.end() == position:
            tokens.clear()
            position += 1
            continue
        kind = "number" if found["number"] else "operator"
        written = found[kind]
        number = _number(written) if found["number"] else None
        if found["unit"] == "%":
            number = None
        tokens.append(_Token(_SIGNS.get(written, written), number, found["unit"], found.start(kind), found.end()))
        position = found.end()
    return tokens[-MAX_TOKENS:]


def _number(written: str) -> Fraction:
    if written[:2] in ("0x", "0X"):
        return Fraction(int(written, 16))
    return Fraction(written.replace(",", ""))


def _is_range(text: str, run: Sequence[_Token]) -> bool:
    """Whether a hyphen between numbers without a space may be no minus: 0-4095, 2022-03-26."""
    return any(
        token.text == "-" and text[token.start - 1].isalnum() and text[token.end].isalnum() for token in run[1:-1]
    )


def _value(tokens: Sequence[_Token]) -> Fraction | None:
    """The value of a complete expression, or None."""
    parser = _Parser(tokens)
    value = parser.sum()
    return value if parser.is_at_end else None


class _Parser:
    """Recursive descent over at most ``MAX_TOKENS`` tokens; None is whatever cannot be worked out."""

    def __init__(self, tokens: Sequence[_Token]) -> None:
        self._tokens = tokens
        self._next = 0

    @property
    def is_at_end(self) -> bool:
        return self._next == len(self._tokens)

    def sum(self) -> Fraction | None:
        value = self._product()
        while value is not None and (sign := self._taken("+", "-")):
            other = self._product()
            if other is None:
                return None
            value = value + other if sign == "+" else value - other
        return value

    def _product(self) -> Fraction | None:
        value = self._power()
        while value is not None and (sign := self._taken("*", "/")):
            other = self._power()
            if other is None or (sign == "/" and other == 0):
                return None
            value = value * other if sign == "*" else value / other
        return value

    def _power(self) -> Fraction | None:
        base = self._operand()
        if base is None or not self._taken("**"):
            return base
        exponent = self._operand()
        if exponent is None or exponent.denominator != 1 or abs(exponent) > 64 or base not in _POWERS_OF:
            return None
        return base**exponent.numerator

    def _operand(self) -> Fraction | None:
        if self._taken("("):
            value = self.sum()
            return value if self._taken(")") else None
        if self._taken("-"):
            value = self._operand()
            return None if value is None else -value
        if self.is_at_end:
            return None
        number = self._tokens[self._next].number
        self._next += number is not None
        return number

    def _taken(self, *texts: str) -> str | None:
        if self.is_at_end or self._tokens[self._next].number is not None or self._tokens[self._next].text not in texts:
            return None
        self._next += 1
        return self._tokens[self._next - 1].text
