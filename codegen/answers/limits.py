"""Limits of a live value: of the table, of the dialect and of the wire type, with the sentinel kept out of reach."""

import math
from fractions import Fraction
from typing import TYPE_CHECKING

from codegen.diagnostics import Report, Rule
from codegen.frozen import dataclass
from codegen.measure import read_number
from codegen.model.answers.answer import Elements
from codegen.model.answers.scaling import Scaling, rounded
from codegen.model.dialect.dialect import WireField
from codegen.model.dialect.literals import exact_number
from codegen.model.spec.population import FieldAnswer, Rounding
from codegen.model.units.unit import Unit, beyond_decimals, shortly
from codegen.model.vehicle import Parameter, Quantity, QuantityKind

if TYPE_CHECKING:
    from codegen.answers.source import Taken

EMPTY_LIMITS = Rule(
    "empty-limits",
    "Nothing is left that a field could carry: the limits of the table, the dialect, the quantity and the wire type "
    "exclude each other, or only the sentinel is left.",
    remedy="widen min and max until they leave what the field and the quantity both have",
)

LIMIT_BEYOND_FIELD = Rule(
    "limit-beyond-field",
    "A limit of a table lies beyond what the field, the dialect or the quantity allows, or is the sentinel: it would "
    "have no effect. Correct it or leave it out.",
    remedy="narrow it to what the field and the quantity have, or leave it out",
)

BEYOND_FIELD = Rule(
    "beyond-field",
    "A quantity or a parameter reaches, by its own min or max or with its initial value, what a field cannot carry by "
    "its type, its sentinel, its minValue or its maxValue: it would go out as another value. Narrow it, or say in the "
    "table with min or max that the field ends there.",
)

SENTINEL_AS_INITIAL = Rule(
    "sentinel-as-initial",
    "The initial value of a quantity, or the default of a parameter, is the number that means unknown in a field that "
    "carries it. No real value goes out as that: until it is set the field says the number beside it, 0 % for -1. A "
    "quantity without an initial value is unknown at first, and goes out as the sentinel.",
)


@dataclass(frozen=True, slots=True)
class Bounds:
    """Inclusive bounds in wire units, not yet rounded; None where there is none."""

    low: Fraction | None
    high: Fraction | None

    def within(self, other: "Bounds") -> "Bounds":
        """Return what both allow."""
        lows = [low for low in (self.low, other.low) if low is not None]
        highs = [high for high in (self.high, other.high) if high is not None]
        return Bounds(max(lows, default=None), min(highs, default=None))

    def rounded(self, rounding: Rounding) -> "Bounds":
        """Return what values at the bounds become in an integer field: no value between them goes out as any beyond."""
        low, high = (None if end is None else Fraction(rounded(end, rounding)) for end in (self.low, self.high))
        return Bounds(low, high)

    def whole(self) -> tuple[Fraction, Fraction]:
        """The smallest and the largest whole number within; both bounds are there."""
        assert self.low is not None
        assert self.high is not None
        return Fraction(math.ceil(self.low)), Fraction(math.floor(self.high))


def written_bounds(answer: FieldAnswer, unit: Unit, factor: Fraction, report: Report) -> Bounds:
    """``min`` and ``max`` of the table, given in ``unit`` or as amounts, times ``factor``: in wire units."""
    bounds: list[Fraction | None] = []
    for key, written in (("min", answer.min), ("max", answer.max)):
        value = None if written is None else read_number(written, unit, answer.at(key), report)
        bounds.append(None if value is None else value * factor)
    return Bounds(*bounds)


def dialect_bounds(field: WireField) -> Bounds:
    """``minValue`` and ``maxValue`` of the dialect, numbers on the wire.

    Text that is not a number is no bound, nor are two that leave no value: both have a finding in the dialect.
    """
    written = (field.definition.minimum, field.definition.maximum)
    low, high = (None if text is None else exact_number(text) for text in written)
    return Bounds(None, None) if low is not None and high is not None and low > high else Bounds(low, high)


def counts(covers: Elements, numbers: range) -> bool:
    """Return whether one integer field carries what the program counts: by type and dialect, and none means unknown."""
    field = covers.field
    if not field.type.is_integer or covers.count != 1:
        return False
    stated, sentinels = dialect_bounds(field), field.sentinel.values[covers.first :][:1] if field.sentinel else ()
    low = max(Fraction(field.type.minimum), field.type.minimum if stated.low is None else stated.low)
    high = min(Fraction(field.type.maximum), field.type.maximum if stated.high is None else stated.high)
    return low <= numbers[0] and numbers[-1] <= high and not any(number in numbers for number in sentinels)


def kept_apart(source: Quantity | Parameter, sentinel: int | float | None) -> int | float | None:
    """The sentinel that no value of a source may become by chance; None where there is none.

    An entry of an enum that has the number of the sentinel says the same as that, such as MAV_LANDED_STATE_UNDEFINED:
    the entry or flag beside it would say something else.
    """
    is_number = isinstance(source, Parameter) or source.kind is QuantityKind.NUMBER
    return sentinel if is_number else None


def scaling_of(
    field: WireField,
    sentinel: int | float | None,
    bounds: Bounds,
    factor: Fraction,
    written: FieldAnswer,
    report: Report,
) -> Scaling | None:
    """The scaling of a live value: ``bounds`` within the wire type, sentinel excluded; None if nothing is left.

    A sentinel at an end shortens the range by one step. One inside becomes a hole: the value that would read as
    unknown is moved by one step away from zero, so that it keeps its sign. A step is 1 in an integer field, and in a
    float field what one stored step is on the wire (``factor``).
    """
    low, high, step = bounds.low, bounds.high, factor
    if field.type.is_integer:
        low, high = bounds.within(Bounds(Fraction(field.type.minimum), Fraction(field.type.maximum))).whole()
        step = Fraction(1)
    assert low is not None
    assert high is not None
    hole = beside = None
    if sentinel is not None and math.isfinite(sentinel):
        unknown = Fraction(sentinel)
        if low == unknown:
            low += step
        elif high == unknown:
            high -= step
        elif low < unknown < high:
            hole = unknown
            beside = unknown - step if unknown < 0 else unknown + step
    if low > high:
        where = "min" if written.min is not None else "max"
        report.add(EMPTY_LIMITS, written.at(where), f"no value is left for {field.name}: {low} to {high}")
        return None
    return Scaling(factor, written.rounding, low, high, hole, beside)


def check_reach(
    covers: Elements, written: Bounds, scaling: Scaling, unknown: int | float | None, report: Report
) -> None:
    """Report limits of the table (``written``) that what is left of them does not reach."""
    reaches = (
        ("min", written.low, written.low is not None and scaling.low > written.low + 1),
        ("max", written.high, written.high is not None and scaling.high < written.high - 1),
    )
    for key, value, is_beyond in reaches:
        if value is not None and (is_beyond or value == unknown):
            message = f"{key} of {covers.label} is {value}, but it carries {scaling.low} to {scaling.high} only"
            report.add(LIMIT_BEYOND_FIELD, covers.written.at(key), message)


def check_declared(covers: Elements, taken: "Taken", carried: Bounds, report: Report) -> None:
    """Report what the source says that it reaches, where the field, which carries ``carried``, ends before.

    Where the table says itself where the field ends, that is what is meant; and a sentinel at the end goes out as the
    step beside it, as everywhere.
    """
    sentinel = covers.field.sentinel
    sentinels = sentinel.values[covers.first : covers.first + covers.count] if sentinel else ()
    if _begins_unknown(covers, taken, sentinels, report):
        return
    is_of_enum = isinstance(taken.source, Quantity) and taken.source.enum is not None
    where = "here" if is_of_enum else f"at {taken.source.path}, or here"
    written, unit, place = covers.written, taken.source.unit.name, covers.written.at(taken.key)

    def shown(value: Fraction) -> str:
        return f"{shortly(value / taken.in_wire)} {unit}".rstrip()

    initial = taken.initial
    for key, declared, end, stated in (
        ("min", taken.declared.low, carried.low, written.min),
        ("max", taken.declared.high, carried.high, written.max),
        ("min", initial, carried.low, written.min),
        ("max", initial, carried.high, written.max),
    ):
        if declared is None or end is None or stated is not None:
            continue
        value = Fraction(rounded(declared, written.rounding)) if covers.field.type.is_integer else declared
        if value not in sentinels and (value < end if key == "min" else value > end):
            what = "is initially" if declared is initial else "goes down to" if key == "min" else "goes up to"
            report.add(
                BEYOND_FIELD,
                place,
                f"{taken.source.path} {what} {shown(declared)}, and {covers.label} ({covers.field.type.name}) ends at "
                f"{shown(end)}",
                f"{key}: {_writable(end, taken, upwards=key == 'min')} {where}, if the field is to end there",
                [(taken.source.spec.at(key if declared is not initial else "initial"), "it is declared here")],
            )
            return


def _writable(end: Fraction, taken: "Taken", upwards: bool) -> str:
    """Return the end of a field in the unit of the source, as a limit of this can be stated: within it, in whole steps.

    A quantity with ``stored`` takes nothing between two steps, and YAML no fraction.
    """
    exact, step = end / taken.in_wire, taken.factor / taken.in_wire
    if isinstance(taken.source, Quantity) and taken.source.spec.stored is not None:
        step *= beyond_decimals(step)
        exact = step * (math.ceil(exact / step) if upwards else math.floor(exact / step))
    return shortly(exact)


def _begins_unknown(
    covers: Elements, taken: "Taken", sentinels: tuple[int | float | None, ...], report: Report
) -> bool:
    """Report a source whose first number means unknown in the field, and return whether it is one.

    What lies beyond the table's own limits goes out as these, which is what is meant.
    """
    source, written = taken.source, taken.written
    begins = taken.initial if isinstance(source, Quantity) else source.default * taken.factor
    if begins is None or not any(kept_apart(source, sentinel) is not None for sentinel in sentinels):
        return False
    value = Fraction(rounded(begins, covers.written.rounding)) if covers.field.type.is_integer else begins
    is_meant = (written.low is not None and value < written.low) or (written.high is not None and value > written.high)
    if is_meant or value not in sentinels:
        return False
    key, what = ("initial", "initially") if isinstance(source, Quantity) else ("default", "by default")
    shown = f"{shortly(begins / taken.in_wire)} {source.unit.name}".rstrip()
    hint = f"leave initial out: {source.path} is unknown then until it is set, and {covers.label} says so"
    report.add(
        SENTINEL_AS_INITIAL,
        covers.written.at(taken.key),
        f"{source.path} is {what} {shown}, which means unknown in {covers.label}",
        hint if isinstance(source, Quantity) else "take another default, or answer with a quantity that can be unknown",
        [(source.spec.at(key), "it is declared here")],
    )
    return True
