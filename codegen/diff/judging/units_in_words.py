"""Reads the unit that a text states: ``in millimeters``, ``(mG)``, ``0.01 degrees Celsius``, ``tenths of a volt``."""

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from typing import NamedTuple

from codegen.model.units.unit import Unit, ratio
from codegen.pattern import pattern

_SYMBOLS = {
    "meter": "m", "metre": "m", "gram": "g", "second": "s", "amp": "A", "ampere": "A", "volt": "V", "degree": "deg",
    "radian": "rad", "percent": "%", "hertz": "Hz", "minute": "min", "hour": "h", "pascal": "Pa", "watt": "W",
    "celsius": "degC", "pixel": "pix", "gauss": "gauss", "joule": "J", "liter": "l", "litre": "l", "kelvin": "K",
    "tesla": "T", "ohm": "Ohm", "newton": "N",
}  # fmt: skip
_PREFIXES = {"milli": "m", "micro": "u", "nano": "n", "centi": "c", "deci": "d", "kilo": "k", "hecto": "h", "mega": "M"}
_PARTS = {"tenth": 10, "hundredth": 100, "thousandth": 1000, "millionth": 10**6}
_LETTERS = {10: "d", 100: "c", 1000: "m", 10**6: "u"}
_CELSIUS = pattern(r"deg(?:ree)?s? (?:celsius|centigrade|c)$")

_PREFIX = rf"(?:(?:{'|'.join(_PREFIXES)})-?)?"
_DEGREE = r"deg(?:ree)?s? (?:celsius|centigrade|c\b)"
_WORD = rf"(?:(?:revolution|rotation)s? per minute|{_PREFIX}(?:{_DEGREE}|(?:{'|'.join(_SYMBOLS)})s?))"
_WORDS = pattern(
    rf"(?<![\w.])({_WORD})(?:(?:\s+per\s+|/)({_WORD})(?!\w)( squared| per second\b)?)?(?!\w)",
    re.IGNORECASE,
    needs="|".join((*_SYMBOLS, "deg", "revolution", "rotation")),
)
_SMALL = r"0?\.0*1|1[eE]-\d|1/10{1,9}"
_NAMED = pattern(
    rf"(?:\b(?:in )?(?:units|steps|multiples) of |\bin |[(\[])(?:{_SMALL}|10{{1,9}} )?\s?"
    r"([A-Za-z%][A-Za-z0-9%/^*]{0,15}(?<![*/^]))(?=[)\].,;\s]|$)"
)
_FACTOR = pattern(r"\s*(?:\*|x|times)\s*(10{1,9}|1[eE]\d)(?![\w.])")
_COUNTED = pattern(r"(?:[\d.)\]]|\b(?:per|every|each|one|a|an))\s*$", re.IGNORECASE)
_BEFORE = pattern(
    rf"(?:\b(?P<part>{'|'.join(_PARTS)})s? of (?:an? |the )?"
    rf"|(?:\bin |\b(?:units|steps|multiples) of |[(\[])(?P<small>{_SMALL})\s?[*x]?\s?"
    r"|\b(?:(?:units|steps|multiples) of )(?P<steps>10{1,9}) ?|(?<![\w.])(?P<times>10{1,9}) ?\* ?)$",
    re.IGNORECASE,
)
_INTRODUCED = pattern(
    r"(?:\b(?:is |are )?(?:given |measured |expressed |stated |sent )?in (?:units of |steps of |multiples of )?"
    r"|\bunits?(?: is| are| of|:)? |[(\[])$",
    re.IGNORECASE,
)
_LONGEST_BEFORE = 40
"""Letters before a unit that may belong to it: ``measured in units of thousandths of a``."""


class _Statement(NamedTuple):
    """A unit that a text states, as dialects write it, and where it stands with the words that introduce it."""

    unit: str
    start: int
    end: int


def unit_in_words(text: str) -> str | None:
    """The one unit that a text states, as dialects write it: of ``in millimeters``, ``(mG)``; not of ``5 seconds``."""
    found = {one.unit for one in _statements(text)}
    return next(iter(found)) if len(found) == 1 else None


def says_unit(text: str) -> bool:
    """Return whether a text has a unit, written out or in brackets."""
    return _WORDS.search(text) is not None or any(Unit.parse(one[1]) is not None for one in _NAMED.finditer(text))


def without_same_unit(old: str, new: str) -> tuple[str, str]:
    """Return two texts without the unit that both state, each in words of its own: ``in centimetres`` and ``(cm)``."""
    before, after = _statements(old), _statements(new)
    if not before or not after or not is_same_unit(before[0].unit, after[0].unit):
        return old, new
    if len({one.unit for one in before}) != 1 or len({one.unit for one in after}) != 1:
        return old, new
    return _without(old, before), _without(new, after)


def is_same_unit(one: str, other: str) -> bool:
    """Return whether a number in one unit is the same number in the other one."""
    units = Unit.parse(one), Unit.parse(other)
    return one == other or (units[0] is not None and units[1] is not None and ratio(units[0], units[1]) == 1)


def _without(text: str, statements: tuple[_Statement, ...]) -> str:
    for one in sorted(statements, key=lambda each: each.start, reverse=True):
        text = f"{text[: one.start]} {text[one.end :]}"
    return text


@cache
def _statements(text: str) -> tuple[_Statement, ...]:
    """Return the units that a text states; what is counted with them, such as ``5 seconds``, states none."""
    return tuple(_each_statement(text))


def _each_statement(text: str) -> Iterator[_Statement]:
    for one in _WORDS.finditer(text):
        head = text[max(0, one.start() - _LONGEST_BEFORE) : one.start()]
        factor = _BEFORE.search(head)
        if factor is None and _COUNTED.search(head):
            continue
        unit = _symbol(one[1]) + (f"/{_symbol(one[2])}" if one[2] else "") + (f"/{_symbol(one[2])}" if one[3] else "")
        yield _statement(text, one, _multiplied(unit, factor), one.start() - (len(factor[0]) if factor else 0))
    for one in _NAMED.finditer(text):
        if Unit.parse(one[1]) is not None and one[1] not in ("h", "d") and not _WORDS.match(text, one.start(1)):
            head = text[max(0, one.start(1) - _LONGEST_BEFORE) : one.start(1)]
            factor = _BEFORE.search(head)
            yield _statement(text, one, _multiplied(one[1], factor), one.start())


def _statement(text: str, found: re.Match[str], unit: str, start: int) -> _Statement:
    """A unit with the factor behind it, and all that introduces it."""
    after = _FACTOR.match(text, found.end())
    introduced = _INTRODUCED.search(text[:start])
    times = f"*{Fraction(after[1]).numerator}" if after is not None else ""
    end = found.end() if after is None else after.end()
    start = start if introduced is None else introduced.start()
    return _Statement(unit + times, start, end + (text[start] in "([" and text[end : end + 1] in (")", "]")))


def _multiplied(unit: str, factor: re.Match[str] | None) -> str:
    """Return a unit of which parts or multiples are counted, as dialects write it: ``cdeg`` for hundredths of one."""
    if factor is None:
        return unit
    if factor["steps"] or factor["times"]:
        return f"{unit}/{factor['steps'] or factor['times']}"
    parts = _PARTS[factor["part"].lower()] if factor["part"] else int(1 / Fraction(factor["small"].lower()))
    short = f"{_LETTERS.get(parts, '')}{unit}"
    return short if is_same_unit(short, f"{unit}*{parts}") else f"{unit}*{parts}"


def _symbol(word: str) -> str:
    """The symbol of a unit that is written out."""
    plain = _CELSIUS.sub("celsius", word.lower().replace("-", ""))
    if plain.startswith(("revolution", "rotation")):
        return "rpm"
    plain = plain if plain.endswith(("celsius", "gauss")) or plain in _SYMBOLS else plain.removesuffix("s")
    for prefix, letter in _PREFIXES.items():
        if plain.startswith(prefix) and plain.removeprefix(prefix) in _SYMBOLS:
            return letter + _SYMBOLS[plain.removeprefix(prefix)]
    return _SYMBOLS.get(plain, plain)
