"""The names of a dialect's enums and entries, found once for all documents that are compared with the same dialect."""

from collections.abc import Mapping, Sequence

from codegen.model.dialect.dialect import EnumDefinition
from codegen.once import once

Enums = Mapping[str, EnumDefinition]


@once
def entry_values(enums: Enums) -> Mapping[str, int]:
    """Return the values of all entries by name."""
    return {entry.name: entry.value for enum in enums.values() for entry in enum.entries}


@once
def enums_of_entries(enums: Enums) -> Mapping[str, frozenset[str]]:
    """Return the names of the enums that have an entry, by the name of the entry."""
    found: dict[str, frozenset[str]] = {}
    for name, enum in enums.items():
        for entry in enum.entries:
            found[entry.name] = found.get(entry.name, frozenset()) | {name}
    return found


@once
def all_names(enums: Enums) -> frozenset[str]:
    """Return the names of all enums and entries, and those of entries without the name of their enum before them."""
    bare = {entry.name.removeprefix(f"{name}_") for name, enum in enums.items() for entry in enum.entries}
    return frozenset((*entry_values(enums), *enums, *bare))


@once
def entries_by_start(enums: Enums) -> Mapping[str, Sequence[str]]:
    """Return the names of entries by what all of an enum begin with, the name of that enum."""
    entries = {f"{name}_": [entry.name for entry in enum.entries] for name, enum in enums.items()}
    return {start: names for start, names in entries.items() if names and names[0].startswith(start)}


@once
def flags(enums: Enums) -> Mapping[str, tuple[EnumDefinition, int]]:
    """Return the entries of all bitmasks by name, each with its enum and value."""
    masks = (enum for enum in enums.values() if all(not entry.value & (entry.value - 1) for entry in enum.entries))
    return {entry.name: (enum, entry.value) for enum in masks for entry in enum.entries}
