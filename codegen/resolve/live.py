"""Answers that are read when a message is built: quantities of the state and parameters."""

from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.model.dialect import Kind
from codegen.model.system import Elements, InstanceBinding, LiveBinding, SplitBinding
from codegen.model.unit import Unit
from codegen.model.vehicle import Component, Parameter, Quantity, QuantityKind
from codegen.resolve.constant import field_unit
from codegen.resolve.fixed import NO_SENTINEL, NOT_AN_ENUM_FIELD
from codegen.resolve.limits import Bounds, check_reach, dialect_bounds, limits_of, written_bounds
from codegen.resolve.measure import UNIT_MISMATCH

BAD_SPLIT = Rule(
    "bad-split",
    "Only a quantity can be split, over at least two elements of an integer array whose sentinel is the largest "
    "number of its type.",
)
BAD_SOURCE = Rule(
    "bad-source",
    "A source does not fit its field: a boolean, a text field, or one value for several elements without split.",
)


def bind_instance(covers: Elements, component: Component, report: Report) -> InstanceBinding | None:
    """The index of the component's instance, counted from 0 or from the number that a parameter gives the first."""
    field_type, first = covers.field.type, component.first_number
    last = component.instances - 1 + (first.maximum if first else 0)
    if not field_type.is_integer or covers.count != 1 or field_type.maximum < last:
        message = f"{covers.field.name} cannot carry an instance number"
        report.add(BAD_SOURCE, covers.answer.at("state"), f"{message} up to {last}" if first else message)
        return None
    return InstanceBinding(covers, component.name, first)


def bind_live(
    covers: Elements, source: Quantity | Parameter, key: str, report: Report
) -> LiveBinding | SplitBinding | None:
    """A quantity or a parameter, converted exactly to the unit of the field and limited to what it can carry."""
    place = covers.answer.at(key)
    unit = check_source(covers, source, key, report)
    factor = None if unit is None else factor_of(covers, source, unit, key, report)
    if unit is None or factor is None:
        return None
    in_wire = Fraction(1)
    if isinstance(source, Parameter) or source.kind is QuantityKind.NUMBER:
        in_wire = source.unit.to(unit) or in_wire
    bounds = Bounds(source.minimum * factor, source.maximum * factor)
    bounds = bounds.within(dialect_bounds(covers.field))
    written = written_bounds(covers.answer, source.unit, in_wire, report)
    bounds = bounds.within(written)
    if covers.answer.split:
        return _bind_split(covers, source, factor, bounds, report)
    if covers.count != 1:
        report.add(
            BAD_SOURCE,
            place,
            f"{covers.label} has {covers.count} elements and gets one value",
            "add 'split: true', or answer the elements one by one",
        )
        return None
    sentinel = covers.field.sentinel.values[covers.first] if covers.field.sentinel else None
    may_be_unknown = isinstance(source, Quantity) and source.initial is None
    if may_be_unknown and sentinel is None:
        report.add(
            NO_SENTINEL,
            place,
            f"{covers.answer.state} can be unknown, and {covers.field.name} has no value that says so",
            "give the quantity an 'initial' value, or add the sentinel to the corrections file",
            [(covers.field.definition.place, f"{covers.field.name} is declared here")],
        )
        return None
    limits = limits_of(covers.field, sentinel, bounds, factor, covers.answer, report)
    if limits is None:
        return None
    unknown = sentinel if may_be_unknown else None
    check_reach(covers, written, limits, unknown, report)
    return LiveBinding(
        covers=covers,
        source=source,
        factor=factor,
        rounding=covers.answer.rounding,
        low=limits.low,
        high=limits.high,
        unknown=unknown,
        hole=limits.hole,
        beside=limits.beside,
    )


def check_source(covers: Elements, source: Quantity | Parameter, key: str, report: Report) -> Unit | None:
    """The unit of the field, if the kind of the source fits the kind of the field."""
    place = covers.answer.at(key)
    if covers.field.type.kind is Kind.CHAR:
        report.add(BAD_SOURCE, place, f"{covers.field.name} is a text, the source is a number")
        return None
    if isinstance(source, Quantity) and source.kind is QuantityKind.BOOLEAN:
        report.add(BAD_SOURCE, place, f"{source.path} is a boolean", "use it in 'flags': ENTRY if component.quantity")
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
    return field_unit(covers.field, place, report)


def factor_of(covers: Elements, source: Quantity | Parameter, unit: Unit, key: str, report: Report) -> Fraction | None:
    """What one stored step is in wire units."""
    if isinstance(source, Parameter):
        to_wire, step = source.unit.to(unit), source.step
    elif source.kind is QuantityKind.NUMBER:
        to_wire, step = source.stored.to(unit), Fraction(1)
    else:
        to_wire, step = Fraction(1), Fraction(1)
    if to_wire is None:
        report.add(
            UNIT_MISMATCH,
            covers.answer.at(key),
            f"{source.path} is a {source.unit.dimension} ({source.unit.name or 'no unit'}), "
            f"{covers.field.name} is a {unit.dimension} ({unit.name or 'no unit'})",
            related=[
                (source.spec.at("unit"), f"{source.path} gets its unit here"),
                (covers.field.definition.place, f"{covers.field.name} is declared here"),
            ],
        )
        return None
    return step * to_wire


def _bind_split(
    covers: Elements, source: Quantity | Parameter, factor: Fraction, bounds: Bounds, report: Report
) -> SplitBinding | None:
    place = covers.answer.at("split")
    wire_type = covers.field.type
    sentinels = (
        covers.field.sentinel.values[covers.first : covers.first + covers.count] if covers.field.sentinel else ()
    )
    if (
        isinstance(source, Parameter)
        or covers.count < 2
        or not wire_type.is_integer
        or any(value != wire_type.maximum for value in sentinels)
        or not sentinels
    ):
        report.add(BAD_SPLIT, place, f"{covers.label} cannot be split")
        return None
    cell_high = wire_type.maximum - 1
    field_bounds = Bounds(Fraction(0), Fraction(cell_high * covers.count))
    low, high = bounds.within(field_bounds).low, bounds.within(field_bounds).high
    assert low is not None
    assert high is not None
    return SplitBinding(
        covers=covers,
        source=source,
        factor=factor,
        rounding=covers.answer.rounding,
        low=-(-low.numerator // low.denominator),
        high=high.numerator // high.denominator,
        cell_high=cell_high,
        unused=wire_type.maximum,
    )
