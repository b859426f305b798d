"""The inverse of the answers: for each, the expression that turns the field back into what it was made from."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.model.answers.answer import Answer, Elements
from codegen.model.code.reading import Reading, flag_names, scaled
from codegen.model.dialect.dialect import Dialect, EnumDefinition, EnumEntry, Kind, WireField
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.spec.receiver import RolesSpec
from codegen.model.system import PopulatedMessage
from codegen.model.units.unit import NUMBER, Unit, ratio, shown_units
from codegen.model.vehicle import Component
from codegen.targets.receiver.roles import charging_entry, describes

FACT = "info."
"""The beginning of the names of facts among those of quantities."""
CHARGING = "is_charging"
"""The name of what a message says about being charged; no attribute of its own."""


def readings_of(
    message: PopulatedMessage, component: Component, roles: RolesSpec, dialect: Dialect
) -> tuple[Reading, ...]:
    """Return all readings of a message about an instance of the component, each name once."""
    found: dict[str, Reading] = {}
    for answer in message.answers:
        for reading in _inverse(answer, message, component, roles, dialect):
            found.setdefault(reading.name, reading)
    for answer in message.answers:
        for reading in answer.joint_readings(message.answers):
            found.setdefault(reading.name, reading)
    return tuple(found.values())


def _inverse(
    answer: Answer, message: PopulatedMessage, component: Component, roles: RolesSpec, dialect: Dialect
) -> Iterator[Reading]:
    yield from answer.readings(component, dialect)
    if answer.is_fact(component):
        yield from _fact(answer.covers, message, component, roles, dialect)
    field = answer.covers.field
    enum = dialect.enums.get(field.definition.enum or "")
    entry = None if enum is None or field.is_array else charging_entry(enum, roles)
    if enum is not None and entry is not None:
        yield _charging(field, enum, entry)


def _charging(field: WireField, enum: EnumDefinition, entry: EnumEntry) -> Reading:
    function, number = ("is_set", f"{entry.value:#x}") if _is_bitmask(field, enum) else ("is_entry", str(entry.value))
    expression = f'{function}(get("{field.name}"), {number})'
    return Reading(CHARGING, expression, "", "", field.name, uses=(function,))


def _is_bitmask(field: WireField, enum: EnumDefinition) -> bool:
    return field.definition.is_bitmask or enum.is_bitmask


def _fact(
    covers: Elements, message: PopulatedMessage, component: Component, roles: RolesSpec, dialect: Dialect
) -> Iterator[Reading]:
    """Yield what the table states, or takes from elsewhere, under the name of the board's fact or of the field.

    Facts of the board, and all that a message says about what an instance is, stay as they are as long as it is the
    same one. What else the table states may be different in a message of another vehicle, and age.
    """
    field = covers.field
    if field.is_array and field.type.kind is not Kind.CHAR:
        return  # elements without a meaning of their own
    owner, _, fact = (covers.written.board or "").partition(".")
    if fact and owner == component.name:
        name = FACT + fact
    elif describes((other.name for other in message.wire.fields), roles):
        name = FACT + field.name
    elif field.name in component.quantities:
        return  # the quantity itself, which this message leaves out
    else:
        name = field.name
    enum = dialect.enums.get(field.definition.enum or "")
    got = f'get("{field.name}")'
    if field.type.kind is Kind.CHAR:
        yield Reading(name, f"text({got})", "", "", field.name, uses=("text",))
    elif enum is not None and _is_bitmask(field, enum):
        yield flag_names(field, enum)
    elif enum is not None:
        uses: tuple[str, ...] = ("entry", enum.name)
        yield Reading(name, f"entry(enum_names.{enum.name}, {got})", "", "", field.name, uses=uses)
    else:
        unit = wire_unit(field)
        whole = Unit.parse(field.definition.units) or NUMBER
        shown = NUMBER if whole is NUMBER else unit_of(whole, component)
        factor = ratio(unit, shown) if unit else None
        expression, uses = scaled(got, factor or Fraction(1))
        yield Reading(name, expression, shown.name, "", field.name, uses=uses)


def unit_of(unit: Unit, component: Component) -> Unit:
    """The unit that a value is shown in: that of a quantity of the component, or the first that is listed.

    Only units that a factor leads to: degrees are not shown as radians.
    """
    listed = list(shown_units())
    own = [quantity.unit for quantity in component.quantities.values()]
    fitting = [*own, *([unit] if unit in listed else listed)]
    return next((other for other in fitting if ratio(unit, other) is not None), unit)
