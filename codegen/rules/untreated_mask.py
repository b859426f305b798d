"""A received message says with bits which of its fields to ignore, and the table takes no notice of them."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.dialect.dialect import EnumDefinition, WireField
from codegen.model.reception import Reception
from codegen.model.system import System
from codegen.pattern import pattern

RULE = Rule(
    "untreated-mask",
    "A field of a received message has bits that say which of the others to ignore, and the table takes others "
    "whatever those say: what its sender did not mean is taken for a value. Take the field into a quantity that code "
    "looks at, or name under 'where' the bits with which the table counts.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each table and field of such bits."""
    for table in system.receptions:
        seen = {taken.field.name for taken in table.fields} | {field.name for field, _ in table.conditions}
        for field in table.wire.fields:
            enum = system.dialect.enums.get(field.definition.enum or "")
            if enum is not None and field.name not in seen and (bits := _ignoring(enum)):
                yield _finding(table, field, bits)


def _ignoring(enum: EnumDefinition) -> tuple[str, ...]:
    """Return the entries of a bitmask that say what to ignore, by their names."""
    names = (entry.name for entry in enum.entries if enum.is_bitmask)
    return tuple(name for name in names if pattern(r"(?:.*_)?IGNORE(?:_.*)?").fullmatch(name))


def _finding(table: Reception, field: WireField, bits: tuple[str, ...]) -> Diagnostic:
    label = f"{table.wire.name}.{field.name}"
    more = f" and {len(bits) - 1} more bits" if len(bits) > 1 else ""
    return Diagnostic(
        table.spec.place,
        RULE,
        f"{label} says with {bits[0]}{more} what to ignore, and the table takes no notice of it",
        f"take it, for code to look at: {field.name}: {{state: ...}}, or write where: {{{field.name}: 0}}",
        ((field.definition.place, f"{field.name} is declared here"),),
    )
