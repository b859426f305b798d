"""Entries of overlays that no field with their enum can carry."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.dialect.carried_entries import is_beyond, widest, words
from codegen.model.system import System

RULE = Rule(
    "entry-beyond-fields",
    "An overlay gives an entry of an enum a number that no field with this enum can carry: it could never be sent, and "
    "never be heard. Give it a smaller number, or a field of the overlay's own a larger type. Parameters of commands, "
    "which are floats, carry any number, and an enum that nothing has is not looked at.",
    remedy="take a smaller number, or give a field of the overlay's own a larger type",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every entry that an overlay adds, but for one whose value is corrected: that is told at the correction."""
    dialect = system.dialect
    if not dialect.overlays:
        return
    corrected = {each.part for each in dialect.corrections if each.attribute == "value"}
    messages = [message.definition for message in dialect.messages.values()]
    for enum in dialect.enums.values():
        added = [each for each in enum.entries if each.place.file in dialect.overlays and each.name not in corrected]
        carrier = widest(enum.name, messages, dialect.enums) if added else None
        if carrier is not None:
            beyond = (entry for entry in added if is_beyond(entry, carrier))
            yield from (Diagnostic(entry.place, RULE, *words(entry, enum.name, carrier)) for entry in beyond)
