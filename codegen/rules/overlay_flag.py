"""Flags of overlays that a bitmask cannot tell apart."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.system import System

RULE = Rule(
    "flag-of-several-bits",
    "An overlay, or a dialect of the project, gives a flag several bits. Setting it sets the flags of those bits, "
    "too, and whoever sets these sets it. Give it one bit, in the XML or in a correction. Shipped dialects are not "
    "looked at.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every entry that an overlay adds to a bitmask; 0 stands for none of the flags."""
    dialect = system.dialect
    for enum in dialect.enums.values() if dialect.overlays else ():
        for entry in enum.entries if enum.is_bitmask else ():
            if entry.place.file in dialect.overlays and entry.value & (entry.value - 1):
                shared = [other for other in enum.entries if other is not entry and other.value & entry.value]
                yield Diagnostic(
                    entry.place,
                    RULE,
                    f"{entry.name} is 0x{entry.value:X}: {entry.value.bit_count()} bits",
                    "a flag is a power of two: correct the value",
                    tuple((other.place, f"{other.name} has one of them") for other in shared[:1]),
                )
