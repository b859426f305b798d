"""Numbers that a field cannot carry, or that are not the ends of its range, in the reach of its name."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.described_range import range_of
from codegen.claims.rules import RANGE
from codegen.claims.statements.fields import number
from codegen.claims.unknown_value import unknown_values
from codegen.claims.weighed.comparison import Comparison, traits
from codegen.claims.weighed.pairs import Pair
from codegen.pattern import pattern

_TO = pattern(r"N ?(?:U ?)?(?:\.\.+|\u2026|[-\u2013]|to|and|through) ?(?:about )?$")
_UP_TO = pattern(
    r"\b(?:up to|at most|max\w*|ends? at|limit\w*|reach\w*|wraps?(?: at)?|saturates?(?: at)?|highest|greatest|largest"
    r"|more than|above|over|beyond|exceed\w*|best|full|to|until|full scale)\b[^.;NQ]{0,16}$"
)
_FITS = pattern(r"\b(?:fits?|possible|represent\w*|carry|carried|cannot|can't|cover\w*|enough|sent|clip\w*)\b")
_BEHIND = pattern(r" ?(?:bytes?|hz|times|elements|bits?|fields|messages|samples|characters)\b")
_DEVICE = pattern(r"\b(?:sensor|device|servo|motor|camera|vehicle|pilot|we|our|your|their)\b")


_ENDS, _SMALL = 1, 2
"""The distance that an end may have from that of the description, 359 for 360; none in ranges that are small."""


def of_limit(pair: Pair) -> Iterator[Comparison]:
    """Yield what a number says of the range of a field."""
    value, field = number(pair.term), pair.one.field
    if value is None or field.definition.enum or _BEHIND.match(pair.behind(12)):
        return
    before = pair.before(30)
    first = _first(pair) if _TO.search(before) else None
    cued = _UP_TO.search(before)
    described = range_of(field)
    if first is None and (cued is None or not (field.type.is_integer or described)):
        return
    common = traits(
        up_to=cued,
        fits=_FITS.search(pair.sentence),
        behind_another=first is not None,
        fits_behind=_FITS.search(pair.behind(30)),
        of_a_device_or_of_somebody=_DEVICE.search(pair.sentence),
    )
    if described is not None and first is None and float(value) > described[0]:
        yield from _end(pair, float(value), described, common)
    if described is not None and first is not None:
        known = unknown_values(field)
        is_right = any(
            abs(float(value) - high) <= _ENDS * (high > _SMALL) and abs(float(first) - low) <= _ENDS * (high > _SMALL)
            for low, high in _ranges(pair)
        )
        if known is None or float(value) not in known[0]:
            own = f"{pair.one.name} goes from {described[0]:g} to {described[1]:g}"
            text = f"{own}, not from {first} to {pair.term.written}"
            more = traits(
                same_end=float(value) == described[1],
                same_start=float(first) == described[0],
                inside=described[0] <= float(first) and float(value) <= described[1],
            )
            yield Comparison("range", RANGE, is_right, text, (*common, *more, "described"))
            return
    if field.type.is_integer and (cued is not None or first is not None):
        low, high = field.type.minimum, field.type.maximum
        is_right = all(value in (each.type.maximum, each.type.minimum) for each in pair.fields)
        is_beyond = all(not each.type.minimum <= value <= each.type.maximum for each in pair.fields)
        if is_beyond or is_right:
            text = f"{pair.one.name} goes from {low} to {high}, not to {pair.term.written}"
            yield Comparison("range", RANGE, is_right, text, (*common, "of the type"))


def _end(pair: Pair, value: float, described: tuple[float, float], common: tuple[str, ...]) -> Iterator[Comparison]:
    """The end of a range of which no beginning is told: "full throw is 10000"."""
    low, high = described
    is_right = any(abs(value - end) <= _ENDS * (end > _SMALL) for _, end in _ranges(pair))
    known = unknown_values(pair.one.field)
    if known is not None and value in known[0]:
        return
    text = f"{pair.one.name} goes from {low:g} to {high:g}, not to {pair.term.written}"
    by_ten = any(value == high * ten or value * ten == high for ten in (10, 100, 1000))
    found = traits(inside=value < high, another_power_of_ten=by_ten)
    yield Comparison("range", RANGE, is_right, text, (*common, *found, "end alone", "described"))


def _first(pair: Pair) -> int | float | Fraction | None:
    """The number before the last one of two with "to" between."""
    found = [term for at, term in pair.span.sentence.within(max(pair.at - 12, pair.low), pair.at, "N")]
    return number(found[-1]) if found else None


def _ranges(pair: Pair) -> Iterator[tuple[float, float]]:
    for field in pair.fields:
        if (each := range_of(field)) is not None:
            yield each
