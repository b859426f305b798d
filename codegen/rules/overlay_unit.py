"""Units of overlays that the generator does not know."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic
from codegen.measure import unknown_field_unit
from codegen.model.system import System
from codegen.model.units.unit import Unit


def check(system: System) -> Iterator[Diagnostic]:
    """Every field of the messages that overlays add, whether a table answers it or not."""
    for message in system.dialect.added_messages():
        for field in message.fields:
            units = field.definition.units
            if units is not None and Unit.parse(units) is None:
                yield unknown_field_unit(field)
