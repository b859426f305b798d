"""A quantity or a parameter that is read when a message is built: found, and held against its field."""

import math
from fractions import Fraction
from functools import reduce
from operator import or_

from codegen.answers.fitting import BAD_SOURCE, NOT_AN_ENUM_FIELD, field_unit
from codegen.answers.limits import Bounds, dialect_bounds, written_bounds
from codegen.answers.scope import Scope
from codegen.diagnostics import Report
from codegen.frozen import dataclass
from codegen.measure import UNCARRIED_CONVERSION, UNIT_MISMATCH, obstacle
from codegen.model.answers.answer import Elements
from codegen.model.answers.scaling import DIVISOR_MAX
from codegen.model.dialect.dialect import EnumDefinition, Kind, WireField
from codegen.model.units.affine import AffineMap
from codegen.model.units.unit import Unit, conversion
from codegen.model.vehicle import Parameter, Quantity, QuantityKind


@dataclass(frozen=True, slots=True)
class Taken:
    """A source that fits: the key of the table that names it, and what one stored step is on the wire.

    ``bounds`` are those of source, dialect and table in wire units, and in an integer field those of the source are
    rounded as its values are; ``written`` are those of the table alone, and ``declared`` those that the source states.
    ``in_wire`` is one unit of the source in wire units, ``initial`` its initial value in these.
    """

    source: Quantity | Parameter
    key: str
    factor: Fraction
    bounds: Bounds
    written: Bounds
    declared: Bounds
    in_wire: Fraction
    initial: Fraction | None


def take(covers: Elements, scope: Scope) -> Taken | None:
    """Return what ``state`` or ``parameter`` names; None after a finding."""
    written = covers.written
    source: Quantity | Parameter | None
    if written.state is not None:
        key, source = "state", scope.quantity(written.state, written.at("state"))
    else:
        key, source = "parameter", scope.parameter(written.parameter or "", written.at("parameter"))
    if isinstance(source, Quantity) and source.kind is QuantityKind.BOOLEAN and _has_flags(covers, scope):
        hint = "use it in 'flags': ENTRY if component.quantity"
        scope.report.add(BAD_SOURCE, written.at(key), f"{source.path} is a boolean", hint)
        return None
    return None if source is None else taken(covers, source, key, scope.report)


def _has_flags(covers: Elements, scope: Scope) -> bool:
    definition = covers.field.definition
    enum = scope.enum(definition.enum) if definition.enum else None
    return covers.field.type.is_integer and enum is not None and (enum.is_bitmask or definition.is_bitmask)


def _number_hint(covers: Elements) -> str:
    """Return what to keep in place of a boolean for a field without flags."""
    enum = covers.field.definition.enum
    if enum is not None:
        return f"keep an entry of {enum} in a quantity with enum: {enum}"
    return f"{covers.field.name} takes a number: keep it in a quantity with min: 0 and max: 1, not boolean: true"


def taken(covers: Elements, source: Quantity | Parameter, key: str, report: Report) -> Taken | None:
    """A source that the table names under ``key``; None, with a finding, where it does not fit."""
    unit = _unit(covers, source, key, report)
    factor = None if unit is None else _factor(covers, source, unit, key, report)
    if unit is None or factor is None:
        return None
    in_wire = Fraction(1)
    if isinstance(source, Parameter):
        in_wire = factor / source.step
    elif source.kind is QuantityKind.NUMBER:
        in_wire = factor * source.steps
    written = written_bounds(covers.written, source.unit, in_wire, report)
    own = Bounds(source.minimum * factor, source.maximum * factor)
    sent = own.rounded(covers.written.rounding) if covers.field.type.is_integer else own
    bounds = sent.within(dialect_bounds(covers.field)).within(written)
    declared = Bounds(None if source.spec.min is None else own.low, None if source.spec.max is None else own.high)
    if isinstance(source, Quantity) and source.enum is not None:
        declared = _entries(source.enum)
    initial = source.initial if isinstance(source, Quantity) else None
    assert not isinstance(initial, str)
    return Taken(source, key, factor, bounds, written, declared, in_wire, None if initial is None else initial * factor)


def _entries(enum: EnumDefinition) -> Bounds:
    """Return what the entries of an enum go from and to: of a bitmask all bits together."""
    values = [entry.value for entry in enum.entries]
    if enum.is_bitmask:
        return Bounds(Fraction(0), Fraction(reduce(or_, values, 0)))
    return Bounds(Fraction(min(values)), Fraction(max(values))) if values else Bounds(None, None)


def _unit(covers: Elements, source: Quantity | Parameter, key: str, report: Report) -> Unit | None:
    """The unit of the field, if the kind of the source fits the kind of the field."""
    place = covers.written.at(key)
    if covers.field.type.kind is Kind.CHAR:
        what = "parameters are numbers" if isinstance(source, Parameter) else f"{source.path} is a number"
        hint = "it takes a constant, a fact of the board, or a quantity that says how many bytes it keeps: text: 16"
        report.add(BAD_SOURCE, place, f"{covers.field.name} is a text, and {what}", hint)
        return None
    if isinstance(source, Quantity) and source.kind is QuantityKind.BOOLEAN:
        report.add(BAD_SOURCE, place, f"{source.path} is a boolean", _number_hint(covers))
        return None
    if isinstance(source, Quantity) and source.elements is not None and key != "each":
        message = f"{source.path} has a value for each of its elements"
        report.add(BAD_SOURCE, place, message, f"write {{each: {source.path}}}")
        return None
    if isinstance(source, Quantity) and source.enum is not None and source.enum.name != covers.field.definition.enum:
        wanted = covers.field.definition.enum or "no enum"
        report.add(
            NOT_AN_ENUM_FIELD, place, f"{source.path} is a {source.enum.name}, {covers.field.name} takes {wanted}"
        )
        return None
    return field_unit(covers.field, report)


def _factor(covers: Elements, source: Quantity | Parameter, unit: Unit, key: str, report: Report) -> Fraction | None:
    """Return what one stored step is in wire units."""
    if isinstance(source, Quantity) and source.kind is not QuantityKind.NUMBER:
        return Fraction(1)
    kept, step = (source.unit, source.step) if isinstance(source, Parameter) else (source.stored, Fraction(1))
    to_wire = _steps(kept, step, unit, source, covers.field)
    if to_wire is not None:
        return to_wire
    related = [
        (source.spec.at("unit"), f"{source.path} gets its unit here"),
        (covers.field.definition.place, f"{covers.field.name} is declared here"),
    ]
    why, hint = obstacle(kept, unit), f"answer with a quantity that is {unit.a_kind}, or with unknown"
    if why is not None:
        message, hint = f"{source.path} cannot go into {covers.field.name}: {why}", f"keep it in {unit.name}"
    else:
        message = (
            f"{source.path} is {source.unit.a_kind} ({source.unit.name or 'no unit'}), "
            f"{covers.field.name} is {unit.a_kind} ({unit.name or 'no unit'})"
        )
        if not unit.name:
            hint = f"a correction can say that {covers.field.name} is in {kept.name}: units: {kept.name}"
        elif not kept.name:
            file = "parameters.yaml" if isinstance(source, Parameter) else "state.yaml"
            hint = f"{file} can say what the numbers are: unit: {unit.name}"
    report.add(UNCARRIED_CONVERSION if why else UNIT_MISMATCH, covers.written.at(key), message, hint, related)
    return None


def _steps(kept: Unit, step: Fraction, unit: Unit, source: Quantity | Parameter, field: WireField) -> Fraction | None:
    """Return what a step of a unit is in the unit of the field; a fraction in place of pi where that lies between.

    For an integer field every value of the source that it can carry is rounded with it as with pi; for a float it is
    as close as the firmware's whole numbers get. None where an offset lies between, or the units measure something
    else.
    """
    way = conversion(kept, unit)
    if way is None or way.offset:
        return None
    way = AffineMap(step * way.factor, way.pi)
    close = way.close_factor(DIVISOR_MAX, times_twos=True)
    if close is None or not way.pi or not field.type.is_integer:
        return close
    of_source = max(abs(Fraction(source.minimum)), abs(Fraction(source.maximum)))
    of_field = max(-field.type.minimum, field.type.maximum) / close
    return way.whole_factor(math.ceil(min(of_source, of_field)) + 2)
