"""Fields that are single numbers of the state: the suite compares the received value with the set one, in units.

It reads the units anew, so only texts are told here: that in which the quantity is kept. That of the field, pymavlink
knows itself, unless a correction sets it.
"""

from collections.abc import Iterator

from codegen.model.answers.answer import Answer
from codegen.model.dialect.dialect import WireField
from codegen.model.system import PopulatedMessage, System
from codegen.model.vehicle import Quantity


def value_sources(system: System) -> Iterator[dict[str, object]]:
    """The table and the field of each, where its number is from, and between which numbers on the wire it is told."""
    for message in system.messages:
        for answer in message.answers:
            number, field = answer.arriving, answer.covers.field
            if number is not None and _is_told(number.quantity, answer, message, system):
                yield {
                    "table": message.name,
                    "field": field.name,
                    **({"element": answer.covers.first} if field.is_array else {}),
                    "component": number.quantity.component,
                    "attribute": number.quantity.attribute,
                    "unit": number.quantity.stored.name,
                    **_corrected(message.wire.name, field, system),
                    "ends": [float(number.scaling.low), float(number.scaling.high)],
                    "unknown": number.unknown,
                    "is_whole": field.type.is_integer,
                }


def _corrected(message: str, field: WireField, system: System) -> dict[str, object]:
    """Return the unit that a correction sets, which the XML of pymavlink does not state."""
    corrections = system.dialect.corrections_of(message, field.name)
    return {"corrected": field.unit_text} if any(each.attribute == "units" for each in corrections) else {}


def _is_told(source: Quantity, answer: Answer, message: PopulatedMessage, system: System) -> bool:
    """Return whether both have a unit that the dialect states itself, and the
    message is about the instance that is set.
    """
    field = answer.covers.field
    is_own = message.component is not None and message.component.name == source.component
    is_one = system.components[source.component].instances == 1
    stated = field.multiplier == 1 and bool(field.unit_text) and field.unit_text == field.definition.units
    return stated and bool(source.stored.name) and (is_own or is_one)
