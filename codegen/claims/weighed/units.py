"""Units in the reach of a field's name."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.parts.sentence import Term
from codegen.claims.parts.span import is_data
from codegen.claims.rules import UNIT
from codegen.claims.statements.fields import number
from codegen.claims.statements.scaling.factors import turns
from codegen.claims.statements.scaling.field_units import has_unit, of_field, shown_units
from codegen.claims.statements.units import ELSEWHERE
from codegen.claims.weighed.comparison import Comparison, traits
from codegen.claims.weighed.pairs import Pair
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_GOES_ON = pattern(r" ?(?:U|hours?|squared|per\b|/)")
"""Behind a part of a unit."""
_IS_PART = pattern(
    r"\b(?:cubic|square) $|(?:tenths?|hundredths?|thousandths?|fifths?) of (?:an? |one )?$"
    r"|\b(?:few|some|several|silent for|every|within|after|least|most) $"
)
"""Before a part of a unit, or one of an amount."""
_CONVERTED = pattern(r"\b(?:convert|scale|to_|from_|parse|decode)\w*\(")
"""Between a variable and its unit in code that makes it from something else."""
_KEY = pattern(r"\bunits?\W*$")
_DATA = frozenset(("bit", "bits", "pixel", "pixels", "pix", "byte", "bytes"))
_PLACED = pattern(r"(?:\bin|[(\[|:,=#*/]|//|\bis|\bare|\bT) ?$")
_ENDED = pattern(r"\s*(?:[,.;:)\]|]|$|\*/)")
_TO = pattern(r"\b(?:to|into|->|\u2192|becomes?) ?$")
_SCALED = pattern(r"[*/] ?N[^.;]{0,12}$")
_NUMBER = pattern(r"[NQ]")
_BESIDE = 22
"""Characters on either side of a unit in which a factor belongs to it."""
_AROUND = 200
"""Characters on either side of a unit in which the field's own one is told besides."""
_FIFTHS = "fifth"


def of_unit(pair: Pair) -> Iterator[Comparison]:
    """Yield what a unit says of a field."""
    unit, field = pair.term.value, pair.one.field
    if not isinstance(unit, Unit) or not unit.dimension or pair.one.message.field(pair.term.written) is not None:
        return
    owns = [Unit.parse(each.definition.units) for each in pair.fields]
    if all(own is None and has_unit(each, unit) for own, each in zip(owns, pair.fields, strict=True)):
        return
    if is_data(pair.span) and not pair.span.is_comment and not _KEY.search(pair.before(24)):
        return  # of what is made of it
    if ELSEWHERE.match(pair.span.text, pair.at + 1) or (pair.span.is_code and _CONVERTED.search(pair.gap)):
        return
    if _GOES_ON.match(pair.behind(8)) or _IS_PART.search(pair.before(24)):
        return
    if pair.term.written.lower() in _DATA and all(own is None or own.dimension != unit.dimension for own in owns):
        return
    if any(has_unit(each, unit) for each in pair.fields):
        yield Comparison("unit", UNIT, is_right=True)
        return
    own = owns[0]
    is_alike = own is not None and own.dimension == of_field(unit, field).dimension
    if is_alike and (_is_turned(pair, unit) or _FIFTHS in pair.sentence):
        return
    shown = shown_units(field)
    text = f"{pair.one.name} {f'is in {shown}' if shown else 'has no unit'}, not {pair.term.written}"
    yield Comparison("unit", UNIT, is_right=False, text=text, traits=_traits(pair, is_alike=is_alike))


def _is_turned(pair: Pair, unit: Unit) -> bool:
    """Return whether a number beside a unit turns the number of a field into it, or the reverse."""
    low, high = max(pair.at - _BESIDE, pair.low), min(pair.at + _BESIDE, pair.high)
    factors = (Fraction(value) for _, term in pair.span.sentence.within(low, high, "N") if (value := number(term)))
    either = [by for value in factors if value > 0 for by in (value, 1 / value)]
    return any(turns(each, unit, by) for by in either for each in pair.fields)


def _traits(pair: Pair, *, is_alike: bool) -> tuple[str, ...]:
    text, at = pair.span.text, pair.at
    others = [(offset, term) for offset, term in _units(pair, pair.low, pair.high) if offset != at]
    around = [(offset, term) for offset, term in _units(pair, max(at - _AROUND, 0), at + _AROUND) if offset != at]
    own = [offset for offset, term in around if _is_own(pair, term)]
    return traits(
        alike=is_alike,
        another_unit=others,
        own_unit=any(_is_own(pair, term) for _, term in others),
        own_unit_around=own,
        own_unit_behind=any(offset > at and not any(each in "FP" for each in text[at + 1 : offset]) for offset in own),
        number_near=_NUMBER.search(text[max(at - 25, 0) : at + 25]),
        placed=_PLACED.search(pair.before(14)),
        ended=_ENDED.match(text, at + 1),
        to_it=_TO.search(pair.before(14)),
        scaled_before=_SCALED.search(pair.before(20)),
    )


def _units(pair: Pair, low: int, high: int) -> Iterator[tuple[int, Term]]:
    return pair.span.sentence.within(low, high, "U")


def _is_own(pair: Pair, term: Term) -> bool:
    """Return whether a unit is that of one of the fields."""
    unit = term.value
    if not isinstance(unit, Unit) or not unit.dimension:
        return False
    return any(Unit.parse(each.definition.units) is not None and has_unit(each, unit) for each in pair.fields)
