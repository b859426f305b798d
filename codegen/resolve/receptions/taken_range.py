"""The numbers of a received field that are taken: what the table, the quantity and the field allow, in wire units."""

import math
from collections.abc import Callable
from fractions import Fraction

from codegen.answers.halves import float_within
from codegen.answers.limits import EMPTY_LIMITS, LIMIT_BEYOND_FIELD, Bounds, dialect_bounds
from codegen.diagnostics import Report, Rule
from codegen.measure import read_number
from codegen.model.answers.scaling import Scaling, rounded
from codegen.model.code.storage import SMALL_INT_MAX, Storage
from codegen.model.code.two_steps import in_one_step, in_two_steps, most_in_steps
from codegen.model.dialect.dialect import WireField
from codegen.model.spec.population import Rounding
from codegen.model.spec.receive import ReceivedFieldSpec
from codegen.model.units.unit import conversion, unit_named
from codegen.model.vehicle import Quantity, QuantityKind
from codegen.source import Place

NOT_RECEIVED = Rule(
    "cannot-receive",
    "A quantity cannot keep what a field carries. A whole number goes into any quantity of one word, converted to its "
    "unit, or unconverted into one of more; a float into a quantity that is kept as a float of its size in the field's "
    "unit, or one of 32 bits into one of one word, rounded to the nearest; a text into a text of at least its length. "
    "The quantity belongs to a component of which there is one, and is no list.",
    remedy="take a quantity that is kept as the field is: a number, a float, or a text of its length",
)


def taken_range(
    field: WireField, quantity: Quantity, factor: Fraction, written: ReceivedFieldSpec, report: Report
) -> tuple[Fraction, Fraction] | None:
    """The smallest and the largest number on the wire that is taken; None after a finding."""
    in_wire = Fraction(1)
    if quantity.kind is QuantityKind.NUMBER:
        in_wire = quantity.steps / factor
    stated: list[Fraction | None] = []
    for key in ("min", "max"):
        limit = getattr(written, key)
        if limit is not None and quantity.kind is not QuantityKind.NUMBER:
            report.add(
                NOT_RECEIVED,
                written.at(key),
                f"{quantity.path} is no number, so {key} says nothing of it",
                hint=f"leave {key} out",
            )
            limit = None
        value = None if limit is None else read_number(limit, quantity.unit, written.at(key), report)
        stated.append(None if value is None else value * in_wire)
    natural = _natural(field, quantity, factor, written).within(dialect_bounds(field))
    low, high = _ends(natural.within(Bounds(*stated)), field, quantity, factor)
    if low > high:
        nothing_left(low, high, field, quantity, written, report)
        return None
    for key, end, natural_end, sign in (("min", stated[0], natural.low, 1), ("max", stated[1], natural.high, -1)):
        assert natural_end is not None
        if end is not None and sign * (natural_end - end) >= 1:
            message = f"{key} has no effect: {quantity.path} takes {field.name} from {_shown(natural.low)}"
            coarser = "keep it in coarser steps: stored, or leave it out"
            hint = coarser if getattr(quantity.spec, key) is None and quantity.storage is Storage.SMALL else None
            told = f"{message} to {_shown(natural.high)} on the wire anyway"
            report.add(LIMIT_BEYOND_FIELD, written.at(key), told, hint)
    if quantity.storage is Storage.SMALL and not (
        _is_multiplied(low, high, field, quantity, factor, written, report)
        and _is_whole(natural, field, quantity, factor, written, report)
    ):
        return None
    return low, high


def nothing_left(
    low: Fraction, high: Fraction, field: WireField, quantity: Quantity, written: ReceivedFieldSpec, report: Report
) -> None:
    """Report that no number of a field is taken."""
    message = f"nothing of {field.name} is left that {quantity.path} takes: {low} to {high}"
    report.add(EMPTY_LIMITS, _limits_place(written), message)


def _limits_place(written: ReceivedFieldSpec) -> Place:
    return written.at("min" if written.min is not None else "max" if written.max is not None else "state")


def _is_multiplied(
    low: Fraction,
    high: Fraction,
    field: WireField,
    quantity: Quantity,
    factor: Fraction,
    written: ReceivedFieldSpec,
    report: Report,
) -> bool:
    """Return whether whole numbers of 30 bits make each number of the field that of the quantity; else a finding."""
    most = max(abs(low), abs(high))
    if not field.type.is_integer or factor == 1 or in_one_step(factor, most) or in_two_steps(factor, most):
        return True
    wanted, hint = quantity.stored.name or "a number", f"keep it in {field.unit_text or 'numbers'}"
    last = math.floor(most_in_steps(factor, most) * factor / quantity.steps)
    turn = _turn(quantity)
    if last >= (1 if turn is None else turn / 4):  # no angle ends before those of a latitude
        hint = f"a max (and a min) of up to {last} {quantity.unit.name}, or {hint}"
    message = f"{field.name} is too wide to be converted to {wanted}: boards count to {SMALL_INT_MAX}"
    report.add(NOT_RECEIVED, _limits_place(written), message, hint)
    return False


def _is_whole(
    natural: Bounds,
    field: WireField,
    quantity: Quantity,
    factor: Fraction,
    written: ReceivedFieldSpec,
    report: Report,
) -> bool:
    """Return whether the quantity goes as far as the field, or somebody says that no number beyond comes; else report.

    It would stay as it was from some number on, such as a time after 18 minutes. A float is expected to come up to a
    whole turn, if it is an angle: nobody knows how far another one does.
    """
    for key, kept_end in (("max", quantity.maximum), ("min", quantity.minimum)):
        if getattr(written, key) is not None or getattr(quantity.spec, key) is not None:
            continue
        last = float(kept_end / quantity.steps)
        if field.type.is_integer:
            is_reached = factor == 1 or _is_end(key, natural, field)
        else:
            turn = _turn(quantity)
            is_reached = turn is None or abs(last) >= turn
        if not is_reached:
            most = f"{last:.7g} {quantity.unit.name}".rstrip()
            message = f"{field.name} has numbers that {quantity.path} cannot keep: a word in {quantity.stored.name}"
            hint = f"say how far it comes, {key}: up to {most}, or keep it in coarser steps: stored"
            report.add(NOT_RECEIVED, written.at("state"), f"{message} ends at {most}", hint)
            return False
    return True


def _is_end(key: str, natural: Bounds, field: WireField) -> bool:
    """Return whether all numbers of a field up to its end are taken, but for one there that is no value."""
    stated = dialect_bounds(field)
    special = set(field.sentinel.values) if field.sentinel else set()
    if key == "max":
        end, wire_end = natural.high, field.type.maximum if stated.high is None else stated.high
    else:
        end, wire_end = natural.low, field.type.minimum if stated.low is None else stated.low
    assert end is not None
    return end == wire_end or (abs(wire_end - end) == 1 and wire_end in special)


def _turn(quantity: Quantity) -> float | None:
    """Return a whole turn in the unit of a quantity; None where that measures no angle."""
    way = conversion(unit_named("deg"), quantity.unit)
    return None if way is None else way.settled(Fraction(360), float)


def _shown(number: Fraction | None) -> str:
    return "" if number is None else f"{float(number):.10g}"


def _natural(field: WireField, quantity: Quantity, factor: Fraction, written: ReceivedFieldSpec) -> Bounds:
    """The numbers that the type carries and that the quantity takes, in wire units."""
    least, most = Fraction(field.type.minimum), Fraction(field.type.maximum)
    if not field.type.is_integer:
        ends = quantity.minimum / factor, quantity.maximum / factor
        if quantity.storage is Storage.SMALL:  # the firmware looks at whole parts of 30 bits
            return Bounds(max(ends[0], Fraction(-SMALL_INT_MAX)), min(ends[1], Fraction(SMALL_INT_MAX)))
        return Bounds(*ends)
    if quantity.kind is QuantityKind.BOOLEAN:
        return Bounds(least, most)

    def kept(number: int) -> int:
        return rounded(number * factor, written.rounding)

    low = _first(int(least), int(most) + 1, lambda number: kept(number) >= quantity.minimum)
    high = _first(int(least), int(most) + 1, lambda number: kept(number) > quantity.maximum) - 1
    return Bounds(Fraction(low), Fraction(high))


def _first(low: int, end: int, holds: Callable[[int], bool]) -> int:
    """The first number from ``low`` on that a rising condition holds for; ``end`` for none."""
    while low < end:
        middle = (low + end) // 2
        low, end = (low, middle) if holds(middle) else (middle + 1, end)
    return low


def _ends(bounds: Bounds, field: WireField, quantity: Quantity, factor: Fraction) -> tuple[Fraction, Fraction]:
    """The ends as the field has them: floats that are nearest, as who sends 180 degrees in radians has them.

    Only where the quantity does not take what becomes of that one it is the last that does not pass the end.
    """
    assert bounds.low is not None
    assert bounds.high is not None
    if field.type.is_integer:
        return bounds.whole()
    storage = Storage(field.type.code)
    low, high = storage.nearest(bounds.low), storage.nearest(bounds.high)
    least, most = (rounded(end * factor, Rounding.NEAREST) for end in (low, high))
    if quantity.storage is storage or quantity.minimum <= least <= most <= quantity.maximum:
        return low, high
    within = float_within(Scaling(Fraction(1), Rounding.NEAREST, bounds.low, bounds.high), None, storage)
    return within.low, within.high
