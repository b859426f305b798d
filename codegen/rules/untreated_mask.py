"""A received message says with bits which of its fields to ignore, and the table takes no notice of them."""

from collections.abc import Iterator
from os.path import commonprefix

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.dialect.dialect import EnumDefinition, WireField
from codegen.model.reception import ReceivedField, Reception
from codegen.model.system import System
from codegen.pattern import pattern

RULE = Rule(
    "untreated-mask",
    "A field of a received message has bits that say which of the others to ignore, and the table takes others "
    "whatever those say: what its sender did not mean is taken for a value. Take the field into a quantity that code "
    "looks at, name under 'unless' of a field the bit that says so of it, or under 'where' the bits with which the "
    "table counts. 'when: {}' says that a field is a value whatever the bits say.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each table and field of such bits; where some look at it, for each other that a bit names."""
    for table in system.receptions:
        for field in table.wire.fields:
            enum = system.dialect.enums.get(field.definition.enum or "")
            bits = () if enum is None else _ignoring(enum)
            blind = [taken for taken in table.fields if not table.looks_at(field.name, taken)]
            if enum is None or not bits or not blind:
                continue
            if all(each.field.name != field.name for taken in table.fields for each in taken.provisos):
                yield _finding(table, field, bits)
                continue
            for taken in blind:
                for bit in bits:
                    if _names(bit, taken.field.name, enum):
                        yield _left_out(table, field, taken, bit)


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
        f"write the bit of each field: unless: {{{field.name}: ...}}, or take it: {field.name}: {{state: ...}}, or "
        f"write where: {{{field.name}: 0}}",
        ((field.definition.place, f"{field.name} is declared here"),),
    )


def _names(bit: str, name: str, enum: EnumDefinition) -> bool:
    """Return whether a bit is about a field: ``..._VX_IGNORE`` is about vx, ``..._AX_IGNORE`` about afx."""
    shared = commonprefix([entry.name for entry in enum.entries]).rpartition("_")[0]  # noqa: RUF071  of characters
    words = bit.removeprefix(f"{shared}_").removesuffix("_IGNORE").lower()
    return words in (name, name.replace("af", "a", 1))


def _left_out(table: Reception, field: WireField, taken: ReceivedField, bit: str) -> Diagnostic:
    """Return the finding that one field does not look at bits that others do."""
    return Diagnostic(
        taken.spec.place,
        RULE,
        f"{table.wire.name}.{taken.label} is taken whether {field.name} has {bit} or not, and others look at theirs",
        f"write unless: {{{field.name}: {bit}}}",
        ((field.definition.place, f"{field.name} is declared here"),),
    )
