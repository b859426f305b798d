"""Entries of JSON, YAML or TOML with a factor for a field: the unit beside it is that of the number after the factor.

``field: relative_alt, factor: 0.01, unit: m`` says that the field counts in centimetres.
"""

from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from codegen.claims.parts.span import Span, is_data
from codegen.claims.reading import Reading
from codegen.claims.rules import SCALING, as_sure
from codegen.claims.statements.fields import Said, claimed, number
from codegen.claims.statements.scaling.factors import turns
from codegen.claims.statements.scaling.field_units import of_field
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import WireField
from codegen.model.units.unit import Unit, conversion
from codegen.pattern import pattern

_FACTOR = pattern(
    r"(?<![\w-])(?P<how>div(?:id\w*|isors?)?|denominator|factor|scal(?:e|ing)(?:_?factor)?|multipl\w*|mult?|gain|lsb|resolution"
    r"|slope)(?:_by)? ?[:=] ?(?P<number>N)(?![\w.])"
)
_UNIT = pattern(r"(?<![\w-])(?:[a-z]+_)?units?(?:_\w+)? ?[:=] ?(?P<unit>U)")
_TURNED = pattern(r"(?<![\w-])(?:to|target|convert\w*|out\w*|display\w*|shown?\w*|offset|bias|add) ?[:=]")
"""A key by which an entry does more to its number than a factor."""
_ENTRY = pattern(r"(?:^| )- |\}|\{|\[\[")
"""The ends of an entry on either side: an item of YAML, a brace, a table of TOML."""


@dataclass(frozen=True, slots=True)
class _Entry:
    """The offsets of the factor and of the unit of an entry, what the factor makes of a number, and the unit."""

    at: int
    unit_at: int
    factor: Fraction
    unit: Unit


def is_after_factor(said: Said, offset: int) -> bool:
    """Return whether a unit in a block of data is the one that a number has after the factor of its entry."""
    found = _entry(said)
    return found is not None and found.unit_at == offset and found.factor != 1


def keyed_factors(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """A factor in the entry of a field that does not make its number one in the unit of the entry."""
    found = _entry(said)
    one = claimed(reading, said, found.at, partial(_turns, unit=found.unit, stated=found.factor)) if found else None
    if found is None or one is None or found.factor == 1:
        return
    span = said.span
    written, unit = span.sentence.term(found.at).written, span.sentence.term(found.unit_at).written
    text = f"{one.name} is in {one.field.definition.units}, which the factor {written} does not turn into {unit}"
    yield reading.found(as_sure(SCALING, is_sure=False), span.place(found.at), f"{one.name} {written} {unit}", text)


def _turns(field: WireField, unit: Unit, stated: Fraction) -> bool:
    """Return whether a factor, rounded to some digits, makes the number of a field one in a unit."""
    own = Unit.parse(field.definition.units)
    turned = conversion(own, of_field(unit, field)) if own is not None else None
    is_near = turned is not None and turned.ratio is not None and abs(stated - turned.ratio) <= turned.ratio / _ROUNDED
    return is_near or turns(field, unit, stated)


_ROUNDED = 500
"""A factor of a document is within one part in so many of the exact one."""


def _entry(said: Said) -> _Entry | None:
    span = said.span
    if not is_data(span):
        return None
    low, high = _bounds(span, said)
    factor, unit = _FACTOR.search(span.text, low, high), _UNIT.search(span.text, low, high)
    if factor is None or unit is None or _TURNED.search(span.text, low, high):
        return None
    value, stated = number(span.sentence.term(factor.start("number"))), span.sentence.term(unit.start("unit")).value
    if not value or not isinstance(stated, Unit):
        return None
    is_division = factor["how"].startswith(("div", "denom"))
    turned = abs(1 / Fraction(value) if is_division else Fraction(value))  # a sign turns an axis round
    return _Entry(factor.start("number"), unit.start("unit"), turned, stated)


def _bounds(span: Span, said: Said) -> tuple[int, int]:
    """Return the bounds of the entry that a field is the key of, or that names it."""
    opened = _KEY.match(span.text, said.end)
    if opened is not None:
        end = span.text.find("}", opened.end())
        return opened.end(), end if end >= 0 else len(span.text)
    low = max((found.end() for found in _ENTRY.finditer(span.text, said.before, said.start)), default=said.start)
    others = [at for at, _ in span.sentence.within(said.end, len(span.text), "F")]
    stop = _ENTRY.search(span.text, said.end)
    return low, min(stop.start() if stop is not None else len(span.text), *others[:1], len(span.text))


_KEY = pattern(r" ?[:=] ?\{")
