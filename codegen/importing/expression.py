"""Products of a quantity and numbers, as documents write them: ``(BatteryState.voltage * 1000) as u16``."""

import re
from dataclasses import replace
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.dialect.wire_types import SPELLINGS

_TOKEN = re.compile(
    r"\s*(?:(?P<number>\d{1,15}(?:_\d{1,12})*(?:\.\d{0,15})?(?:[eE][-+]?\d{1,2})?)"
    r"|(?P<path>[A-Za-z_]\w*(?:\[\d{1,3}\])?(?:(?:\.|::|->)[A-Za-z_]\w*(?:\[\d{1,3}\])?)*(?:\(\))?)"
    r"|(?P<mark>[*/()\u00d7\u00b7]))"
)
_OPERATORS = ("*", "/", "\u00d7", "\u00b7")
_ROUNDING = ("round", "int", "math.floor", "floor", "trunc")
_OWNERS = ("state", "self", "system", "system_state", "vehicle_state")
_MAX_TOKENS = 60


@dataclass(frozen=True, slots=True)
class Product:
    """``path`` times ``factor``; ``path`` is that of a quantity, ``battery.voltage``, and ``cast`` a wire type."""

    path: str
    factor: Fraction
    cast: str | None = None


@dataclass(frozen=True, slots=True)
class _Term:
    """A product with at most one path, as it is read."""

    factor: Fraction = Fraction(1)
    path: str | None = None
    cast: str | None = None


def read_product(text: str) -> Product | None:
    """The product that ``text`` is, with brackets, ``as u16``, ``(uint16_t)`` and ``round()``; None if it is none.

    A path has an owner: ``battery.voltage``, ``state.battery.voltage``, ``BatteryState.voltage``; a single word is
    prose.
    """
    tokens = _tokens(text)
    if tokens is None:
        return None
    reader = _Reader(tokens)
    term = reader.product()
    if term is None or reader.rest or term.path is None:
        return None
    return Product(term.path, term.factor, term.cast)


def quantity_path(written: str) -> str | None:
    """``battery.voltage`` from any way of writing it; None for a word without an owner."""
    parts = [re.sub(r"\[\d+\]|\(\)", "", part) for part in re.split(r"\.|::|->", written)]
    while len(parts) > 2 and parts[0] in _OWNERS:
        parts.pop(0)
    if len(parts) != 2:
        return None
    owner = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", parts[0]).lower()
    return f"{owner.removesuffix('_state') or owner}.{parts[1]}"


def _tokens(text: str) -> list[tuple[str, str]] | None:
    tokens: list[tuple[str, str]] = []
    position = 0
    text = text.strip()
    while position < len(text):
        match = _TOKEN.match(text, position)
        if match is None or len(tokens) == _MAX_TOKENS:
            return None
        tokens.append((str(match.lastgroup), str(match[str(match.lastgroup)])))
        position = match.end()
    return tokens


class _Reader:
    """Recursive descent over at most ``_MAX_TOKENS`` tokens; every method returns None where the text is no product."""

    def __init__(self, tokens: list[tuple[str, str]]) -> None:
        self.rest = tokens[::-1]

    def product(self) -> _Term | None:
        term = self._cast_term()
        while term is not None and self.rest and self.rest[-1][1] in _OPERATORS:
            divides = self.rest.pop()[1] == "/"
            term = self._multiplied(term, self._cast_term(), divides)
        return term

    def _multiplied(self, left: _Term, right: _Term | None, divides: bool) -> _Term | None:
        if right is None or (left.path and right.path) or (divides and (right.path or not right.factor)):
            return None
        factor = left.factor / right.factor if divides else left.factor * right.factor
        return _Term(factor, left.path or right.path, left.cast or right.cast)

    def _cast_term(self) -> _Term | None:
        term = self._term()
        while term is not None and len(self.rest) > 1 and self.rest[-1][1] == "as":
            self.rest.pop()
            cast = SPELLINGS.get(self.rest.pop()[1])
            term = None if cast is None else replace(term, cast=cast)
        return term

    def _term(self) -> _Term | None:
        if not self.rest:
            return None
        kind, text = self.rest.pop()
        if kind == "number":
            return _Term(Fraction(text.replace("_", "")))
        if kind == "path":
            if text in _ROUNDING or (text in SPELLINGS and self._next_is("(")):
                inner = self._bracketed()
                return inner if inner is None or text in _ROUNDING else replace(inner, cast=SPELLINGS[text])
            path = quantity_path(text)
            return None if path is None else _Term(path=path)
        if text != "(":
            return None
        if self.rest and self.rest[-1][1] in SPELLINGS and len(self.rest) > 1 and self.rest[-2][1] == ")":
            cast = SPELLINGS[self.rest.pop()[1]]
            self.rest.pop()
            inner = self._term()
            return None if inner is None else replace(inner, cast=cast)
        self.rest.append(("mark", "("))
        return self._bracketed()

    def _bracketed(self) -> _Term | None:
        if not self._next_is("("):
            return None
        self.rest.pop()
        inner = self.product()
        if inner is None or not self._next_is(")"):
            return None
        self.rest.pop()
        return inner

    def _next_is(self, mark: str) -> bool:
        return bool(self.rest) and self.rest[-1][1] == mark
