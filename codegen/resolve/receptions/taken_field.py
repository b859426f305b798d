"""One field of a received message: the quantity that it sets, what converts it, and which numbers are taken."""

import math
from fractions import Fraction

from codegen.answers.fitting import NOT_AN_ENUM_FIELD, field_unit
from codegen.derivations.surroundings import SET_TWICE
from codegen.diagnostics import Report
from codegen.measure import UNCARRIED_CONVERSION, UNIT_MISMATCH, obstacle
from codegen.model.code.storage import Storage
from codegen.model.dialect.dialect import Kind, WireField
from codegen.model.reception import ReceivedField
from codegen.model.spec.population import Rounding
from codegen.model.spec.receive import ReceivedFieldSpec
from codegen.model.units.affine import AffineMap
from codegen.model.units.unit import conversion
from codegen.model.vehicle import Citation, Quantity, QuantityKind
from codegen.resolve.population.population import Parts
from codegen.resolve.quantities.state import find_quantity
from codegen.resolve.receptions.special_values import special_values
from codegen.resolve.receptions.taken_range import NOT_RECEIVED, nothing_left, taken_range

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
    bounds = taken_range(field, quantity, factor, written, report)
    special = special_values(field, written, parts.dialect.enums.get(field.definition.enum or ""), report)
    if bounds is None or citation is None:
        return None
    taken = ReceivedField(field, element, quantity, factor, *bounds, written, citation, *special)
    if taken.low == taken.high and taken.low in taken.special:
        nothing_left(taken.low, taken.high, field, quantity, written, report)
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
