"""Entries of overlays that no field with their enum can carry."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.dialect.carried_entries import too_narrow, words
from codegen.model.dialect.dialect import EnumEntry
from codegen.model.system import System

RULE = Rule(
    "entry-beyond-fields",
    "An overlay gives an entry of an enum a number that no field with this enum can carry: it could never be sent, and "
    "never be heard. Give it a smaller number, or a field of the overlay's own a larger type. Parameters of commands, "
    "which are floats, carry any number, and an enum that nothing has is not looked at.",
    remedy="take a smaller number, or give a field of the overlay's own a larger type",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every entry that an overlay adds."""
    dialect = system.dialect
    messages = [message.definition for message in dialect.messages.values()] if dialect.overlays else []
    for enum in dialect.enums.values() if dialect.overlays else ():
        for entry in enum.entries:
            carrier = too_narrow(entry, enum.name, messages, dialect.enums) if _is_new(entry, system) else None
            if carrier is not None:
                text, hint = words(entry, enum.name, carrier)
                message, field = carrier
                related = ((field.place, f"{message.name}.{field.name} is declared here"),)
                yield Diagnostic(entry.place, RULE, f"{entry.name}: {text}", hint, related)


def _is_new(entry: EnumEntry, system: System) -> bool:
    """Return whether an overlay has the entry, and no correction its value, which is told at the correction."""
    is_corrected = any(each.part == entry.name and each.attribute == "value" for each in system.dialect.corrections)
    return entry.place.file in system.dialect.overlays and not is_corrected
