"""One row for each field of a received message, as documents and ``explain`` print it."""

from codegen.frozen import dataclass
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.reception import ReceivedField, Reception
from codegen.model.spec.receive import Sender
from codegen.model.units.unit import NUMBER, conversion, decimal, map_words
from codegen.model.vehicle import QuantityKind
from codegen.source import Place

SENDERS = {
    Sender.ANY: "from anybody",
    Sender.GROUND_STATION: "from a system of which a ground station is heard on that link",
    Sender.OWN_SYSTEM: "from other components of this vehicle",
}


@dataclass(frozen=True, slots=True)
class ReceivedRow:
    """The row of a table for a received field, as text; ``place`` is that of its entry."""

    offset: int
    size: int
    field: str
    type: str
    unit: str
    quantity: str
    conversion: str
    taken: str
    unknown: str
    unchanged: str
    criterion: str
    place: Place


def received_rows(table: Reception) -> tuple[ReceivedRow, ...]:
    """The rows of a table, in wire order."""
    return tuple(_row(taken) for taken in table.fields)


def condition_words(table: Reception) -> str:
    """Return the values that a message must have to be taken, as "gps_id 1"; empty where none is asked for."""
    return ", ".join(f"{field.name} {number}" for field, number in table.conditions)


def sender_words(table: Reception) -> str:
    """Whose messages are taken."""
    return SENDERS[table.spec.sender]


def _row(taken: ReceivedField) -> ReceivedRow:
    field = taken.field
    length = f"[{field.count}]" if field.is_array else ""
    quantity = taken.quantity
    unknown = [each for each in taken.sentinel_words.split(", ") if each not in ("", "NaN")]
    unchanged = [each for each in taken.unchanged_words.split(", ") if each not in ("", "NaN")]
    (unchanged if taken.is_kept_by_nan else unknown).extend(
        [] if field.type.is_integer or taken.is_text else ["NaN", "infinite"]
    )
    (unchanged if taken.is_kept_by_absence else unknown).extend(["MAVLink 1"] if taken.is_extension else [])
    (unchanged if taken.is_kept_otherwise else unknown).extend(["otherwise"] if taken.provisos else [])
    return ReceivedRow(
        offset=taken.offset,
        size=field.size if taken.is_text else field.type.size,
        field=taken.label,
        type=f"{field.type.name}{length}{' ext' if taken.is_extension else ''}",
        unit=field.unit_text,
        quantity=quantity.path,
        conversion=conversion_words(taken),
        taken=", ".join(each for each in (taken.range_words or "ASCII", taken.proviso_words) if each),
        unknown=", ".join(unknown),
        unchanged=", ".join(unchanged),
        criterion=str(taken.citation),
        place=taken.spec.place,
    )


def conversion_words(taken: ReceivedField) -> str:
    """``x 1/100 = deg, nearest``; nothing where the number is kept as it comes."""
    if taken.quantity.kind is QuantityKind.BOOLEAN:
        return "not 0"
    if taken.factor == 1:
        return ""
    factor = taken.factor
    way = conversion(wire_unit(taken.field) or NUMBER, taken.quantity.stored)
    shown = f"x {decimal(factor)}" if factor.denominator == 1 else f"x {factor.numerator}/{factor.denominator}"
    if way is not None and way.pi:
        shown = map_words(way).replace("*", "x")  # the firmware has a fraction in place of pi
    rounding = "" if factor.denominator == 1 else f", {taken.spec.rounding.value.replace('_', ' ')}"
    return f"{shown} = {taken.quantity.stored.name or 'steps'}{rounding}"
