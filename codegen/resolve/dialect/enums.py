"""The enums of several dialect files become one of each name."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace

from codegen.diagnostics import Report, Rule
from codegen.model.dialect.dialect import DialectFile, EnumDefinition, EnumEntry

ENUM_CONFLICT = Rule(
    "enum-conflict",
    "Files add their entries to an enum of the same name, and two entries disagree: one name with two values, or one "
    "value with two names. Rename or renumber one of them.",
    remedy="rename or renumber one of the two entries",
)


@dataclass(slots=True)
class _Merging:
    """An enum while the files' parts of it are added."""

    first: EnumDefinition
    is_bitmask: bool = False
    description: str = ""
    entries: list[EnumEntry] = field(default_factory=list)
    by_name: dict[str, EnumEntry] = field(default_factory=dict)
    by_value: dict[int, EnumEntry] = field(default_factory=dict)

    def finished(self) -> EnumDefinition:
        return replace(
            self.first, entries=tuple(self.entries), is_bitmask=self.is_bitmask, description=self.description
        )


def merge_enums(files: Iterable[DialectFile], report: Report) -> dict[str, EnumDefinition]:
    """The enums by name; entries in the order of the files, place and lifecycle of the first part.

    An entry that is stated twice alike is taken once. An entry without a value moves behind the entries of the
    earlier files if it would lie among them, as in mavgen.
    """
    merging: dict[str, _Merging] = {}
    for file in files:
        for part in file.enums:
            merged = merging.setdefault(part.name, _Merging(part))
            merged.is_bitmask = merged.is_bitmask or part.is_bitmask
            merged.description = merged.description or part.description
            for entry in _moved(part.entries, merged.by_value):
                _add(entry, merged, report)
    return {name: merged.finished() for name, merged in merging.items()}


def _moved(entries: tuple[EnumEntry, ...], earlier: dict[int, EnumEntry]) -> Iterable[EnumEntry]:
    if not earlier or not any(entry.is_implicit for entry in entries):
        return entries
    highest = max(earlier)
    values = [entry.value for entry in entries]
    if min(values) > highest or max(values) < min(earlier):
        return entries
    moved = []
    for entry in entries:
        if entry.is_implicit and entry.value <= highest:
            highest += 1
            entry = entry._replace(value=highest)  # noqa: PLW2901
        moved.append(entry)
    return moved


def _add(entry: EnumEntry, merged: _Merging, report: Report) -> None:
    namesake = merged.by_name.get(entry.name)
    if namesake is not None:
        if namesake.value != entry.value:
            message = f"{entry.name} is {entry.value} here and {namesake.value} elsewhere"
            report.add(ENUM_CONFLICT, entry.place, message, related=[(namesake.place, "the other value")])
        return
    holder = merged.by_value.setdefault(entry.value, entry)
    if holder is not entry:
        message = f"{entry.name} has the value {entry.value} of {holder.name}"
        report.add(ENUM_CONFLICT, entry.place, message, related=[(holder.place, "the other entry")])
    merged.by_name[entry.name] = entry
    merged.entries.append(entry)
