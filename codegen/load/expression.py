"""Arithmetic as documents write it, worked out exactly: numbers with units, + - * / and powers, casts, and one name.

In prose an expression is what ends at a place, and has no names; a cell is as a whole a quantity times numbers, such as
``(BatteryState.voltage * 1000) as u16``.
"""

import re
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.dialect.wire_types import SPELLINGS
from codegen.pattern import pattern

MAX_TOKENS = 60
"""Longest expression that is looked at."""

_IN_PROSE = pattern(
    r"\s*(?:(?P<number>0[xX][0-9a-fA-F]{1,16}|\d{1,3}(?:,\d{3}){1,4}(?!\d)(?:\.\d{1,15})?|\d{1,18}(?:\.\d{1,15})?"
    r"(?:[eE][-+]?\d{1,2})?)(?:[ ]?(?P<unit>%|(?!x[ \d])[A-Za-zµ°][A-Za-z°]{0,8}(?:/[A-Za-z]{1,3})?)(?![\w(]))?"
    r"|(?P<mark>\*\*|[-+*/^()\u00d7\u00b7\u00f7\u2212]|x(?=[ ]?[\d(])))"
)
_IN_COLUMN = pattern(
    r"\s*(?:(?P<number>\d{1,15}(?:_\d{1,12})*(?:\.\d{0,15})?(?:[eE][-+]?\d{1,2})?)"
    r"|(?P<name>[A-Za-z_]\w*(?:\[\d{1,3}\])?(?:(?:\.|::|->)[A-Za-z_]\w*(?:\[\d{1,3}\])?)*(?:\(\))?)"
    r"|(?P<mark>[*/()\u00d7\u00b7]))"
)
_NO_PART = pattern(r"[=<>:;|\"'`?!{}\[\]&#$@\n]")
_SIGNS = {"\u00d7": "*", "\u00b7": "*", "x": "*", "\u00f7": "/", "\u2212": "-", "^": "**"}
_POWERS_OF = (2, 10)
"""Bases for which ``^`` is a power, and not the exclusive or of a program."""

_ROUNDING = ("round", "int", "math.floor", "floor", "trunc")
_OWNERS = ("state", "self", "system", "system_state", "vehicle_state")


@dataclass(frozen=True, slots=True)
class Expression:
    """An expression at ``start`` of a text up to ``end``, its exact value, and the units that its numbers have."""

    start: int
    end: int
    value: Fraction
    units: frozenset[str]


@dataclass(frozen=True, slots=True)
class Product:
    """``path`` times ``factor``; ``path`` is that of a quantity, ``battery.voltage``, and ``cast`` a wire type."""

    path: str
    factor: Fraction
    cast: str | None = None


@dataclass(frozen=True, slots=True)
class _Token:
    """A number, a name or a mark; the marks of one meaning have one text."""

    kind: str
    text: str
    start: int
    end: int
    number: Fraction | None = None
    unit: str | None = None


@dataclass(frozen=True, slots=True)
class _Term:
    """The value of a part of an expression: a number, times at most one quantity."""

    factor: Fraction
    path: str | None = None
    cast: str | None = None


def expression_before(text: str, end: int) -> Expression | None:
    """The longest expression that ends at ``end`` and has an operator; None where there is none.

    It begins after a letter, a sign of another kind or the start of the text. What is not certainly arithmetic (a
    range such as 0-100, a date, a percentage) is none.
    """
    low = max(end - 200, 0)
    low = max((found.end() for found in _NO_PART.finditer(text, low, end)), default=low)
    end = low + len(text[low:end].rstrip())
    tokens = _tokens_before(text, low, end)
    for first in range(len(tokens)):
        run = tokens[first:]
        if run[0].number is None and run[0].text not in ("(", "-"):
            continue
        if first and tokens[first - 1].unit == "%":
            continue  # a percentage of something, or a remainder
        if run[0].start > 0 and (text[run[0].start - 1].isalnum() or text[run[0].start - 1] in "._"):
            continue
        found = _evaluated(run)
        has_operator = any(token.number is None and token.text not in "()" for token in run[1:])
        if found is not None and has_operator:
            units = frozenset(token.unit for token in run if token.unit)
            return None if _is_range(text, run) else Expression(run[0].start, run[-1].end, found.factor, units)
    return None


def read_product(text: str) -> Product | None:
    """The product that ``text`` is, with brackets, ``as u16``, ``(uint16_t)`` and ``round()``; None if it is none.

    A path has an owner: ``battery.voltage``, ``state.battery.voltage``, ``BatteryState.voltage``; a single word is
    prose.
    """
    tokens = _tokens_of(text.strip())
    found = None if tokens is None else _evaluated(tokens)
    return None if found is None or found.path is None else Product(found.path, found.factor, found.cast)


def quantity_path(written: str) -> str | None:
    """``battery.voltage`` from any way of writing it; None for a word without an owner."""
    parts = [re.sub(r"\[\d+\]|\(\)", "", part) for part in re.split(r"\.|::|->", written)]
    while len(parts) > 2 and parts[0] in _OWNERS:
        parts.pop(0)
    if len(parts) != 2:
        return None
    owner = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", parts[0]).lower()
    return f"{owner.removesuffix('_state') or owner}.{parts[1]}"


def _tokens_before(text: str, low: int, end: int) -> list[_Token]:
    """The tokens that lead up to ``end`` without a gap: what stands before the last thing that is no token is left."""
    tokens: list[_Token] = []
    position = low
    while position < end:
        found = _IN_PROSE.match(text, position, end)
        if found is None or found.end() == position:
            tokens.clear()
            position += 1
            continue
        tokens.append(_token(found, found["unit"]))
        position = found.end()
    return tokens[-MAX_TOKENS:]


def _tokens_of(text: str) -> list[_Token] | None:
    """Return the tokens of a text; None where a part of it is no token, or there are more than MAX_TOKENS."""
    tokens: list[_Token] = []
    position = 0
    while position < len(text):
        found = _IN_COLUMN.match(text, position)
        if found is None or len(tokens) == MAX_TOKENS:
            return None
        tokens.append(_token(found))
        position = found.end()
    return tokens


def _token(found: re.Match[str], unit: str | None = None) -> _Token:
    kind = next(kind for kind in ("number", "mark", "name") if found.groupdict().get(kind))
    written = found[kind]
    number = _number(written) if kind == "number" and unit != "%" else None
    text = _SIGNS.get(written, written) if kind == "mark" else written
    return _Token(kind, text, found.start(kind), found.end(), number, unit)


def _number(written: str) -> Fraction:
    if written[:2] in ("0x", "0X"):
        return Fraction(int(written, 16))
    return Fraction(re.sub("[,_]", "", written))


def _is_range(text: str, run: Sequence[_Token]) -> bool:
    """Return whether a hyphen between numbers without a space may be no minus: 0-4095, 2022-03-26."""
    return any(
        token.text == "-" and text[token.start - 1].isalnum() and text[token.end].isalnum() for token in run[1:-1]
    )


def _evaluated(tokens: Sequence[_Token]) -> _Term | None:
    """Return the value of the tokens; None where they are no complete expression, or cannot be worked out."""
    parser = _Parser(tokens)
    found = parser.sum()
    return found if parser.is_at_end else None


class _Parser:
    """Recursive descent over at most ``MAX_TOKENS`` tokens; None is whatever cannot be worked out."""

    def __init__(self, tokens: Sequence[_Token]) -> None:
        self._tokens = tokens
        self._next = 0

    @property
    def is_at_end(self) -> bool:
        return self._next == len(self._tokens)

    def sum(self) -> _Term | None:
        found = self._product()
        while found is not None and (sign := self._taken("+", "-")):
            other = self._product()
            if other is None or found.path or other.path:
                return None
            found = _Term(found.factor + other.factor if sign == "+" else found.factor - other.factor)
        return found

    def _product(self) -> _Term | None:
        found = self._cast()
        while found is not None and (sign := self._taken("*", "/")):
            found = _multiplied(found, self._cast(), divides=sign == "/")
        return found

    def _cast(self) -> _Term | None:
        """A power, ``as`` a wire type, maybe."""
        found = self._power()
        while found is not None and self._taken("as"):
            name = self._name()
            found = replace(found, cast=SPELLINGS[name]) if name in SPELLINGS else None
        return found

    def _power(self) -> _Term | None:
        base = self._operand()
        if base is None or not self._taken("**"):
            return base
        exponent = self._operand()
        if exponent is None or base.path or exponent.path or base.factor not in _POWERS_OF:
            return None
        if exponent.factor.denominator != 1 or abs(exponent.factor) > 64:
            return None
        return _Term(base.factor**exponent.factor.numerator)

    def _operand(self) -> _Term | None:
        if self._taken("("):
            return self._after_bracket()
        if self._taken("-"):
            found = self._operand()
            return found and replace(found, factor=-found.factor)
        if not self.is_at_end and (number := self._tokens[self._next].number) is not None:
            self._next += 1
            return _Term(number)
        name = self._name()
        if name in _ROUNDING or (name in SPELLINGS and self._text(0) == "("):
            inner = self._closed() if self._taken("(") else None
            return inner if inner is None or name in _ROUNDING else replace(inner, cast=SPELLINGS[name])
        path = None if name is None else quantity_path(name)
        return None if path is None else _Term(Fraction(1), path)

    def _after_bracket(self) -> _Term | None:
        """Return the value of a bracket, or of what follows one with a wire type in it, as C casts."""
        written = self._text(0)
        if written not in SPELLINGS or self._text(1) != ")":
            return self._closed()
        self._next += 2
        found = self._operand()
        return found and replace(found, cast=SPELLINGS[written])

    def _closed(self) -> _Term | None:
        found = self.sum()
        return found if self._taken(")") else None

    def _name(self) -> str | None:
        if self.is_at_end or self._tokens[self._next].kind != "name":
            return None
        self._next += 1
        return self._tokens[self._next - 1].text

    def _text(self, ahead: int) -> str | None:
        at = self._next + ahead
        return self._tokens[at].text if at < len(self._tokens) else None

    def _taken(self, *texts: str) -> str | None:
        if self._text(0) not in texts or self._tokens[self._next].number is not None:
            return None
        self._next += 1
        return self._tokens[self._next - 1].text


def _multiplied(left: _Term, right: _Term | None, *, divides: bool) -> _Term | None:
    """The product, or the quotient; None of two quantities, or divided by one or by 0."""
    if right is None or (left.path and right.path) or (divides and (right.path or not right.factor)):
        return None
    factor = left.factor / right.factor if divides else left.factor * right.factor
    return _Term(factor, left.path or right.path, left.cast or right.cast)
