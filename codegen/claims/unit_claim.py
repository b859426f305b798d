"""The unit that a document gives a field, beside the one that the dialect has."""

from collections.abc import Iterator

from codegen.claims.reading import Reading
from codegen.claims.sentinel import UNIT
from codegen.diagnostics import Diagnostic
from codegen.model.dialect.dialect import WireMessage
from codegen.model.units.nearest_unit import worded_unit
from codegen.model.units.unit import Unit
from codegen.source import Place


def unit_claim(reading: Reading, message: WireMessage, name: str, written: str, place: Place) -> Iterator[Diagnostic]:
    """What is wrong with the unit of a field; nothing where either is no unit, or a number."""
    field = message.field(name)
    own = Unit.parse(field.definition.units) if field else None
    unit = worded_unit(written)
    if field is None or own is None or unit is None or not unit.dimension or is_same_unit(unit, own):
        return
    about = f"{message.name}.{name}"
    text = f"{about} is in {field.definition.units}, not {written}"
    yield reading.found(UNIT, place, f"{about} in {written}", text)


def is_same_unit(one: Unit, other: Unit) -> bool:
    """Whether numbers in either are the same."""
    return (one.dimension, one.scale, one.pi) == (other.dimension, other.scale, other.pi)
