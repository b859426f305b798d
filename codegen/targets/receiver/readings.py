"""The inverse of the bindings: for each, the expression that turns the field back into what it was made from."""

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction

from codegen.model.dialect import Dialect, EnumDefinition, Kind, WireField
from codegen.model.system import (
    Binding,
    FixedBinding,
    FlagsBinding,
    LiveBinding,
    PartBinding,
    PopulatedMessage,
    SplitBinding,
    TextBinding,
)
from codegen.model.unit import UNITS, Unit
from codegen.model.vehicle import Component, Parameter, Quantity, QuantityKind
from codegen.targets.receiver.cells import cell_readings
from codegen.targets.receiver.reading import Reading, scaled
from codegen.targets.receiver.roles import charging_entry, describes_a_battery

FACT = "info."
"""How the names of facts begin among those of quantities."""
CHARGING = "is_charging"
"""The name of what a message says about being charged; no attribute of its own."""


def readings_of(message: PopulatedMessage, component: Component, dialect: Dialect) -> tuple[Reading, ...]:
    """Everything that a message says about an instance of the component, each name once."""
    found: dict[str, Reading] = {}
    for binding in message.bindings:
        for reading in _inverse(binding, message, component, dialect):
            found.setdefault(reading.name, reading)
    for reading in cell_readings(message):
        found.setdefault(reading.name, reading)
    return tuple(found.values())


def _inverse(binding: Binding, message: PopulatedMessage, component: Component, dialect: Dialect) -> Iterator[Reading]:
    if isinstance(binding, SplitBinding):
        if _is_own(binding.source, component):
            yield _joined(binding)
    elif isinstance(binding, LiveBinding) and _is_own(binding.source, component):
        assert isinstance(binding.source, Quantity)
        yield _quantity(binding, binding.source)
    elif isinstance(binding, FlagsBinding):
        yield from _flags(binding, component, dialect)
    elif isinstance(binding, FixedBinding | PartBinding | TextBinding | LiveBinding):
        yield from _fact(binding, message, component, dialect)
    field = binding.covers.field
    enum = dialect.enums.get(field.definition.enum or "")
    if enum is not None and not field.is_array and charging_entry(enum) is not None:
        yield _charging(field, enum)


def _is_own(source: Quantity | Parameter, component: Component) -> bool:
    return isinstance(source, Quantity) and source.component == component.name


def _quantity(binding: LiveBinding, source: Quantity) -> Reading:
    """wire = stored * factor, and ``steps`` stored units are one unit: so unit = wire / (factor * steps)."""
    expression, uses = scaled(_element(binding), 1 / (binding.factor * source.steps))
    if "element" in expression:
        uses |= {"element"}
    enum = source.enum.name if source.kind is QuantityKind.ENUM and source.enum else ""
    return Reading(source.name, expression, source.unit.name, source.spec.doc, binding.covers.label, enum, uses)


def _joined(binding: SplitBinding) -> Reading:
    covers, source = binding.covers, binding.source
    whole = f'joined(raw("{covers.field.name}"), {covers.first}, {covers.count}, {binding.unused})'
    expression, uses = scaled(whole, 1 / (binding.factor * source.steps))
    return Reading(source.name, expression, source.unit.name, source.spec.doc, covers.label, uses=uses | {"joined"})


def _element(binding: LiveBinding) -> str:
    covers = binding.covers
    got = f'get("{covers.field.name}")'
    return f"element({got}, {covers.first})" if covers.field.is_array else got


def _flags(binding: FlagsBinding, component: Component, dialect: Dialect) -> Iterator[Reading]:
    """The names of the bits that are set, and each boolean of the component that alone decides some bits."""
    field = binding.covers.field
    enum = dialect.enums.get(field.definition.enum or "")
    if field.is_array or enum is None:
        return
    yield _flag_names(field, enum)
    deciding = Counter(value for _, value, _ in binding.conditional)
    for name, value, quantity in binding.conditional:
        if quantity.component == component.name and deciding[value] == 1 and not value & binding.mask:
            expression = f'is_set(get("{field.name}"), {value:#x})'
            yield Reading(quantity.name, expression, "", quantity.spec.doc, name, uses=frozenset({"is_set"}))


def _flag_names(field: WireField, enum: EnumDefinition) -> Reading:
    expression = f'flags(enum_names.{enum.name}, get("{field.name}"))'
    return Reading(field.name, expression, "", "", field.name, uses=frozenset({"flags", enum.name}))


def _charging(field: WireField, enum: EnumDefinition) -> Reading:
    entry = charging_entry(enum)
    assert entry is not None
    function, number = ("is_set", f"{entry.value:#x}") if _is_bitmask(field, enum) else ("is_entry", str(entry.value))
    expression = f'{function}(get("{field.name}"), {number})'
    return Reading(CHARGING, expression, "", "", field.name, uses=frozenset({function}))


def _is_bitmask(field: WireField, enum: EnumDefinition) -> bool:
    return field.definition.is_bitmask or enum.is_bitmask


def _fact(
    binding: FixedBinding | PartBinding | TextBinding | LiveBinding,
    message: PopulatedMessage,
    component: Component,
    dialect: Dialect,
) -> Iterator[Reading]:
    """What the table states, or takes from elsewhere, under the name of the board's fact or of the field.

    Facts of the board, and all that a message about the battery itself says, stay as they are as long as the battery
    does. What else the table states may be different in a message of another vehicle, and age.
    """
    covers = binding.covers
    field = covers.field
    if field.is_array and field.type.kind is not Kind.CHAR:
        return  # elements without a meaning of their own
    owner, _, fact = (covers.answer.board or "").partition(".")
    if fact and owner == component.name:
        name = FACT + fact
    elif describes_a_battery(other.name for other in message.wire.fields):
        name = FACT + field.name
    elif field.name in component.quantities:
        return  # the quantity itself, which this message leaves out
    else:
        name = field.name
    enum = dialect.enums.get(field.definition.enum or "")
    got = f'get("{field.name}")'
    if field.type.kind is Kind.CHAR:
        yield Reading(name, f"text({got})", "", "", field.name, uses=frozenset({"text"}))
    elif enum is not None and _is_bitmask(field, enum):
        yield _flag_names(field, enum)
    elif enum is not None:
        uses = frozenset({"entry", enum.name})
        yield Reading(name, f"entry(enum_names.{enum.name}, {got})", "", "", field.name, uses=uses)
    else:
        unit = UNITS.get(field.definition.units or "")
        shown = unit_of(unit, component) if unit else None
        factor = unit.to(shown) if unit and shown else None
        expression, uses = scaled(got, factor or Fraction(1))
        yield Reading(name, expression, shown.name if shown else "", "", field.name, uses=uses)


def unit_of(unit: Unit, component: Component) -> Unit:
    """The unit that a dimension is shown in: that of a quantity of the component, or the first that is listed."""
    own = [quantity.unit for quantity in component.quantities.values() if quantity.unit.dimension == unit.dimension]
    return own[0] if own else next(other for other in UNITS.values() if other.dimension == unit.dimension)
