"""One field of a received message: the quantity that it sets, what converts it, and which numbers are taken."""

import math
from collections.abc import Callable
from fractions import Fraction

from codegen.answers.fitting import NOT_AN_ENUM_FIELD, field_unit
from codegen.answers.halves import float_within
from codegen.answers.limits import EMPTY_LIMITS, LIMIT_BEYOND_FIELD, Bounds, dialect_bounds
from codegen.derivations.surroundings import SET_TWICE
from codegen.diagnostics import Report, Rule
from codegen.measure import UNCARRIED_CONVERSION, UNIT_MISMATCH, obstacle, read_number
from codegen.model.answers.scaling import Scaling, rounded
from codegen.model.code.storage import SMALL_INT_MAX, Storage
from codegen.model.dialect.dialect import Kind, WireField
from codegen.model.reception import ReceivedField
from codegen.model.spec.population import Rounding
from codegen.model.spec.receive import ReceivedFieldSpec
from codegen.model.units.affine import AffineMap
from codegen.model.units.unit import conversion, unit_named
from codegen.model.vehicle import Citation, Quantity, QuantityKind
from codegen.resolve.population.population import Parts
from codegen.resolve.quantities.state import find_quantity
from codegen.resolve.receptions.special_values import special_values
from codegen.source import Place

NOT_RECEIVED = Rule(
    "cannot-receive",
    "A quantity cannot keep what a field carries. A whole number goes into any quantity of one word, converted to its "
    "unit, or unconverted into one of more; a float into a quantity that is kept as a float of its size in the field's "
    "unit, or one of 32 bits into one of one word, rounded to the nearest; a text into a text of at least its length. "
    "The quantity belongs to a component of which there is one, and is no list.",
    remedy="take a quantity that is kept as the field is: a number, a float, or a text of its length",
)
_ONE_FOR_EACH = (
    "declare a quantity for each value that arrives, in a component of which there is one, such as "
    "far: {quantities: {level_1: ..., level_2: ...}}, and write state: far.level_2"
)
_PART_LIMIT = 1 << 28
"""The limit of numerator and denominator of a factor with which wholes_plain.py makes whole numbers of floats."""
_FLOATS = {4: Storage.BINARY32, 8: Storage.BINARY64}


def resolve_taken(
    field: WireField,
    element: int,
    written: ReceivedFieldSpec,
    citation: Citation | None,
    parts: Parts,
    report: Report,
) -> ReceivedField | None:
    """The field with its quantity; None after a finding."""
    quantity = _target(field, written, parts, report)
    if quantity is None:
        return None
    if quantity.kind is QuantityKind.TEXT:
        for key in ("min", "max", "rounding"):
            if key in written.places:
                report.add(NOT_RECEIVED, written.at(key), f"{key} says nothing of a text", "leave it out")
        zero = Fraction(0)
        special_values(field, written, None, report)
        if citation is None:
            return None
        return ReceivedField(field, element, quantity, Fraction(1), zero, zero, written, citation)
    factor = _factor(field, quantity, written, report)
    if factor is None or not _is_kept(field, quantity, factor, written, report):
        return None
    bounds = _bounds(field, quantity, factor, written, report)
    special = special_values(field, written, parts.dialect.enums.get(field.definition.enum or ""), report)
    if bounds is None or citation is None:
        return None
    taken = ReceivedField(field, element, quantity, factor, *bounds, written, citation, *special)
    if taken.low == taken.high and taken.low in taken.special:
        _nothing_left(taken.low, taken.high, field, quantity, written, report)
        return None
    return taken


def _target(field: WireField, written: ReceivedFieldSpec, parts: Parts, report: Report) -> Quantity | None:
    """The quantity that the field sets; None after a finding."""
    place, (path, bracket, _) = written.at("state"), written.state.partition("[")
    if bracket:
        message = f"{written.state} is a part of {path}, and a field sets a whole quantity"
        report.add(NOT_RECEIVED, place, message, _ONE_FOR_EACH)
        return None
    quantity = find_quantity(written.state, parts.components, parts.spec.state, place, report)
    if quantity is None:
        return None
    if not quantity.derivation.is_received:
        message = f"{quantity.path} is not for a message to set: {quantity.derivation.words(quantity)}"
        related = [(quantity.spec.place, f"{quantity.path} is declared here")]
        report.add(SET_TWICE, place, message, "give the message a quantity of its own", related)
        return None
    related = [
        (quantity.spec.place, f"{quantity.path} is declared here"),
        (field.definition.place, f"{field.name} is declared here"),
    ]
    problem = _part_problem(field, quantity, parts)
    if problem is not None:
        report.add(NOT_RECEIVED, place, problem, _ONE_FOR_EACH, related)
        return None
    problem = _kind_problem(field, quantity)
    if problem is not None:
        rule = NOT_AN_ENUM_FIELD if quantity.kind is QuantityKind.ENUM else NOT_RECEIVED
        report.add(rule, place, problem, None, related)
        return None
    return quantity


def _part_problem(field: WireField, quantity: Quantity, parts: Parts) -> str | None:
    """Return why a quantity of which there are several values cannot take what the field carries."""
    owner, path = parts.components[quantity.component], quantity.path
    if owner.instances != 1:
        return f"there are {owner.instances} of {owner.name}, and {path} does not say which"
    if quantity.elements is not None:
        return f"{path} is a list, and {field.name} sets single values"
    return None


def _kind_problem(field: WireField, quantity: Quantity) -> str | None:
    """Return why a quantity of its kind cannot take what the field carries."""
    path = quantity.path
    is_text = field.type.kind is Kind.CHAR
    if is_text != (quantity.kind is QuantityKind.TEXT):
        return f"{field.name} is {'a text' if is_text else 'a number'}, and {path} a {quantity.kind.value} quantity"
    if is_text:
        if quantity.length < field.count:
            return f"{field.name} has {field.count} characters, and {path} keeps {quantity.length} bytes only"
        return None
    if quantity.enum is not None and quantity.enum.name != field.definition.enum:
        return f"{path} is a {quantity.enum.name}, {field.name} is {field.definition.enum or 'of no enum'}"
    if quantity.kind is not QuantityKind.NUMBER and not field.type.is_integer:
        return f"{field.name} is a float, and {path} a {quantity.kind.value} quantity"
    return None


def _factor(field: WireField, quantity: Quantity, written: ReceivedFieldSpec, report: Report) -> Fraction | None:
    """Return how many stored steps 1 on the wire is; None after a finding."""
    if quantity.kind is not QuantityKind.NUMBER:
        return Fraction(1)
    unit = field_unit(field, report)
    if unit is None:
        return None
    way = conversion(unit, quantity.stored)
    factor = None if way is None or way.offset else _steps(way, field, quantity)
    if factor is not None:
        return factor
    related = [
        (quantity.spec.at("unit"), f"{quantity.path} gets its unit here"),
        (field.definition.place, f"{field.name} is declared here"),
    ]
    why, hint = obstacle(unit, quantity.stored), None
    if why is not None:
        message, hint = f"{field.name} cannot go into {quantity.path}: {why}", f"keep it in {unit.name}"
    else:
        own, other = quantity.unit, f"{field.name} is {unit.a_kind} ({unit.name or 'no unit'})"
        message = f"{other}, {quantity.path} is {own.a_kind} ({own.name or 'no unit'})"
    report.add(UNCARRIED_CONVERSION if why else UNIT_MISMATCH, written.at("state"), message, hint, related)
    return None


def _steps(way: AffineMap, field: WireField, quantity: Quantity) -> Fraction | None:
    """Return the factor; with pi, a fraction in its place that rounds each whole number alike that is taken."""
    close = way.close_factor(_PART_LIMIT - 1)
    if close is None or not way.pi or not field.type.is_integer:
        return close
    most = max(abs(Fraction(quantity.minimum)), abs(Fraction(quantity.maximum))) / close
    return way.whole_factor(min(math.ceil(most) + 1, max(-field.type.minimum, field.type.maximum)))


def _is_kept(
    field: WireField, quantity: Quantity, factor: Fraction, written: ReceivedFieldSpec, report: Report
) -> bool:
    """Return whether the words of the quantity take the number of the field; False after a finding."""
    storage = quantity.storage
    if field.type.is_integer:
        fits = storage is Storage.SMALL or (not storage.is_float and factor == 1)
    else:
        fits = storage is _FLOATS[field.type.size] and factor == 1
        if storage is Storage.SMALL and field.type.size == 4:
            return _is_rounded(field, quantity, factor, written, report)
    if fits:
        return True
    kind = "a float" if storage.is_float else "an integer"
    kept = f"{kind} of {16 * storage.halves} bits" if storage.halves else "a whole number of one word"
    unit = quantity.stored.name or "without a unit"
    message = f"{field.name} is {field.type.name} in {field.unit_text or 'no unit'}"
    message += f", and {quantity.path} is kept as {kept} in {unit}"
    hint = f"keep it as the field has it: leave out stored, or write unit: {field.definition.units or '(none)'}"
    report.add(NOT_RECEIVED, written.at("state"), message, hint)
    return False


def _is_rounded(
    field: WireField, quantity: Quantity, factor: Fraction, written: ReceivedFieldSpec, report: Report
) -> bool:
    """Return whether whole numbers are made of a float; False after a finding."""
    problem, key, hint = "", "state", "keep it in a coarser unit"
    if max(factor.numerator, factor.denominator) >= _PART_LIMIT:
        problem = f"{field.name} comes in too different a unit to be kept in {quantity.stored.name or 'numbers'}"
    elif written.rounding is not Rounding.NEAREST:
        problem = f"{field.name} is a float, of which whole numbers are rounded to the nearest only"
        key, hint = "rounding", "leave it out"
    if problem:
        report.add(NOT_RECEIVED, written.at(key), problem, hint)
    return not problem


def _limits_place(written: ReceivedFieldSpec) -> Place:
    return written.at("min" if written.min is not None else "max" if written.max is not None else "state")


def _nothing_left(
    low: Fraction, high: Fraction, field: WireField, quantity: Quantity, written: ReceivedFieldSpec, report: Report
) -> None:
    message = f"nothing of {field.name} is left that {quantity.path} takes: {low} to {high}"
    report.add(EMPTY_LIMITS, _limits_place(written), message)


def _bounds(
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
    at = _limits_place(written)
    if low > high:
        _nothing_left(low, high, field, quantity, written, report)
        return None
    for key, end, natural_end, sign in (("min", stated[0], natural.low, 1), ("max", stated[1], natural.high, -1)):
        assert natural_end is not None
        if end is not None and sign * (natural_end - end) >= 1:
            message = f"{key} has no effect: {quantity.path} takes {field.name} from {_shown(natural.low)}"
            coarser = "keep it in coarser steps: stored, or leave it out"
            hint = coarser if getattr(quantity.spec, key) is None and quantity.storage is Storage.SMALL else None
            told = f"{message} to {_shown(natural.high)} on the wire anyway"
            report.add(LIMIT_BEYOND_FIELD, written.at(key), told, hint)
    if field.type.is_integer and quantity.storage is Storage.SMALL and factor != 1:
        worst = max(abs(low), abs(high)) * factor.numerator + factor.denominator
        if worst > SMALL_INT_MAX:
            most = math.floor(Fraction(SMALL_INT_MAX - factor.denominator) / factor.numerator / in_wire)
            wanted = quantity.stored.name or "a number"
            message = f"{field.name} is too wide to be converted to {wanted}: boards count to {SMALL_INT_MAX}"
            kept = field.unit_text or "numbers"
            hint = f"a max (and a min) of up to {most} {quantity.unit.name}, or keep it in {kept}"
            report.add(NOT_RECEIVED, at, message, hint)
            return None
        return None if _is_cut(natural, field, quantity, written, report) else (low, high)
    return None if _is_no_turn(field, quantity, written, report) else (low, high)


def _is_no_turn(field: WireField, quantity: Quantity, written: ReceivedFieldSpec, report: Report) -> bool:
    """Return whether a word ends before a whole turn, and nobody says that an angle ends there; a finding then."""
    turn = conversion(unit_named("deg"), quantity.unit)
    if turn is None or field.type.is_integer or quantity.storage is not Storage.SMALL:
        return False
    for key, end in (("max", quantity.maximum), ("min", quantity.minimum)):
        last = float(end / quantity.steps)
        if not _is_stated(key, quantity, written) and abs(last) < turn.settled(Fraction(360), float):
            return _report_cut(key, last, field, quantity, written, report)
    return False


def _is_cut(natural: Bounds, field: WireField, quantity: Quantity, written: ReceivedFieldSpec, report: Report) -> bool:
    """Return whether numbers of the field are left out because a word ends, and nobody says that none of them come.

    It is a finding then: the quantity would stay as it was from some number on, such as a time after 18 minutes.
    """
    stated = dialect_bounds(field)
    special = set(field.sentinel.values) if field.sentinel else set()
    for key, end, wire_end in (
        ("max", natural.high, field.type.maximum if stated.high is None else stated.high),
        ("min", natural.low, field.type.minimum if stated.low is None else stated.low),
    ):
        assert end is not None
        if _is_stated(key, quantity, written) or end == wire_end or (abs(wire_end - end) == 1 and wire_end in special):
            continue
        last = float((quantity.maximum if key == "max" else quantity.minimum) / quantity.steps)
        return _report_cut(key, last, field, quantity, written, report)
    return False


def _is_stated(key: str, quantity: Quantity, written: ReceivedFieldSpec) -> bool:
    """Return whether the table or the quantity says where its values end."""
    return getattr(written, key) is not None or getattr(quantity.spec, key) is not None


def _report_cut(
    key: str, last: float, field: WireField, quantity: Quantity, written: ReceivedFieldSpec, report: Report
) -> bool:
    """Report a number that the quantity ends with though the field goes on, and return True."""
    most = f"{last:.7g} {quantity.unit.name}".rstrip()
    message = f"{field.name} has numbers that {quantity.path} cannot keep: a word in {quantity.stored.name} ends at"
    hint = f"say how far it comes, {key}: up to {most}, or keep it in coarser steps: stored"
    report.add(NOT_RECEIVED, written.at("state"), f"{message} {most}", hint)
    return True


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
