"""View of enum_names.py: the names of numbers and of bits."""

from collections.abc import Iterable

from codegen.frozen import dataclass
from codegen.model.dialect.dialect import Dialect, EnumDefinition


@dataclass(frozen=True, slots=True)
class NamesView:
    """One enum: ``entries`` are number, as it is printed, and name; of bits those of one bit come first."""

    name: str
    is_bitmask: bool
    entries: tuple[tuple[str, str], ...]


def names_view(names: Iterable[str], dialect: Dialect) -> tuple[NamesView, ...]:
    """The enums that readings name, in the order given."""
    return tuple(_names(dialect.enums[name], dialect) for name in names)


def _names(enum: EnumDefinition, dialect: Dialect) -> NamesView:
    is_bitmask = enum.is_bitmask or _is_used_as_bits(enum, dialect)
    entries: dict[int, str] = {}
    for entry in enum.entries:
        entries.setdefault(entry.value, entry.name)
    if not is_bitmask:
        return NamesView(enum.name, False, tuple((str(value), name) for value, name in entries.items()))
    bits = sorted((value for value in entries if value > 0), key=lambda value: (value.bit_count() > 1, value))
    return NamesView(enum.name, True, tuple((hex(value), entries[value]) for value in bits))


def _is_used_as_bits(enum: EnumDefinition, dialect: Dialect) -> bool:
    fields = (field for message in dialect.messages.values() for field in message.fields)
    return any(field.definition.is_bitmask and field.definition.enum == enum.name for field in fields)
