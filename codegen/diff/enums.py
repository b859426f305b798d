"""Changes of enums and their entries, with the parameters of commands."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from codegen.diagnostics import shortened_list
from codegen.diff import wire_rules as rules
from codegen.diff.change import Change, ChangeRule, changed
from codegen.diff.lifecycle import lifecycle_changes
from codegen.model.dialect import CommandParameter, EnumDefinition, EnumEntry
from codegen.source import Place

_MEANING = ("units", "enum", "multiplier", "reserved")

Users = Mapping[str, Sequence[str]]
"""The fields, as MESSAGE.field, that have the numbers of an enum, by its name."""


def enum_changes(
    old: Mapping[str, EnumDefinition], new: Mapping[str, EnumDefinition], users: Users
) -> Iterator[Change]:
    """What changed in the enums of a dialect, in the order of their names."""
    for name in sorted(old.keys() | new.keys()):
        before, after = old.get(name), new.get(name)
        fields = users.get(name, ())
        if before is None and after is not None:
            yield _enum(rules.ENUM_ADDED, name, None, _size(after), (None, after.place), fields)
        elif after is None and before is not None:
            yield _enum(rules.ENUM_REMOVED, name, _size(before), None, (before.place, None), fields)
        elif before is not None and after is not None and before is not after:
            yield from _within(before, after, fields)


def renamed_enums(old: Mapping[str, EnumDefinition], new: Mapping[str, EnumDefinition]) -> dict[str, str]:
    """The new names of enums that are called otherwise and have the same entries, by their old names."""
    added = {_numbers(enum): name for name, enum in new.items() if name not in old and enum.entries}
    return {name: added[_numbers(enum)] for name, enum in old.items() if name not in new and _numbers(enum) in added}


def _numbers(enum: EnumDefinition) -> frozenset[tuple[str, int]]:
    return frozenset((entry.name, entry.value) for entry in enum.entries)


def _size(enum: EnumDefinition) -> str:
    count = len(enum.entries)
    return f"{count} {'entry' if count == 1 else 'entries'}"


def _within(old: EnumDefinition, new: EnumDefinition, fields: Sequence[str]) -> Iterator[Change]:
    name, places = new.name, (old.place, new.place)
    if old.is_bitmask != new.is_bitmask:
        words = ["bits" if side.is_bitmask else "numbers" for side in (old, new)]
        yield _enum(rules.ENUM_BITMASK, name, words[0], words[1], places, fields)
    if old.description != new.description:
        yield _enum(rules.DESCRIPTION, name, old.description or None, new.description or None, places, fields)
    for change in lifecycle_changes(name, old.lifecycle, new.lifecycle, places, _messages(fields)):
        yield replace(change, enum=name)
    yield from _entries(old, new, fields)


def _entries(old: EnumDefinition, new: EnumDefinition, fields: Sequence[str]) -> Iterator[Change]:
    before = {entry.name: entry for entry in old.entries}
    after = {entry.name: entry for entry in new.entries}
    gone = {entry.name: entry for entry in old.entries if entry.name not in after}
    for entry in new.entries:
        known = before.get(entry.name)
        if known is None:
            known = next((each for each in gone.values() if each.value == entry.value), None)
            if known is not None:
                del gone[known.name]
                yield _entry(rules.ENTRY_RENAMED, new.name, entry, (known.name, entry.name), known, fields)
        if known is None:
            said = f"{entry.name} = {entry.value}"
            yield _enum(rules.ENTRY_ADDED, f"{new.name}.{entry.name}", None, said, (None, entry.place), fields)
            continue
        yield from _entry_changes(known, entry, new.name, fields)
    for entry in gone.values():
        said = f"{entry.name} = {entry.value}"
        yield _enum(rules.ENTRY_REMOVED, f"{new.name}.{entry.name}", said, None, (entry.place, None), fields)


def _entry_changes(old: EnumEntry, new: EnumEntry, enum: str, fields: Sequence[str]) -> Iterator[Change]:
    if old.value != new.value:
        yield _entry(rules.ENTRY_VALUE, enum, new, (str(old.value), str(new.value)), old, fields)
    if old.description != new.description:
        yield _entry(rules.DESCRIPTION, enum, new, (old.description or None, new.description or None), old, fields)
    if sorted(old.traits) != sorted(new.traits):
        yield _entry(rules.ENTRY_TRAITS, enum, new, (_written(old.traits), _written(new.traits)), old, fields)
    subject, places = f"{enum}.{new.name}", (old.place, new.place)
    for change in lifecycle_changes(subject, old.lifecycle, new.lifecycle, places, _messages(fields)):
        yield replace(change, enum=enum, entry=new.name)
    before = {parameter.number: parameter for parameter in old.parameters}
    after = {parameter.number: parameter for parameter in new.parameters}
    for number in sorted(before.keys() | after.keys()):
        yield from _parameter(f"{subject}.{number}", before.get(number), after.get(number), (old, new), fields)


def _parameter(
    subject: str,
    old: CommandParameter | None,
    new: CommandParameter | None,
    entries: tuple[EnumEntry, EnumEntry],
    fields: Sequence[str],
) -> Iterator[Change]:
    places = (old.place if old else entries[0].place), (new.place if new else entries[1].place)
    words = [_written(side.attributes) if side else None for side in (old, new)]
    if old is None or new is None or sorted(old.attributes) != sorted(new.attributes):
        shown = [word if side is None else word or "a parameter" for word, side in zip(words, (old, new), strict=True)]
        change = _enum(rules.COMMAND_PARAMETER, subject, shown[0], shown[1], places, fields)
        yield change if _is_other(old, new) else replace(change, breaks=())
    texts = [side.description if side else "" for side in (old, new)]
    if texts[0] != texts[1]:
        yield _enum(rules.DESCRIPTION, subject, texts[0] or None, texts[1] or None, places, fields)


def _is_other(old: CommandParameter | None, new: CommandParameter | None) -> bool:
    """Whether a number means something else than before: it is not enough that more is said of it."""
    if old is None:
        return False
    before, after = dict(old.attributes), dict(new.attributes) if new else {}
    return new is None or any(name in before and before[name] != after.get(name) for name in _MEANING)


def _written(attributes: Sequence[tuple[str, str]]) -> str | None:
    return ", ".join(f"{name} {value}" for name, value in sorted(attributes)) or None


def _entry(
    rule: ChangeRule,
    enum: str,
    entry: EnumEntry,
    words: tuple[str | None, str | None],
    old: EnumEntry,
    fields: Sequence[str],
) -> Change:
    return _enum(rule, f"{enum}.{entry.name}", *words, (old.place, entry.place), fields)


def _enum(
    rule: ChangeRule,
    subject: str,
    old: str | None,
    new: str | None,
    places: tuple[Place | None, Place | None],
    fields: Sequence[str],
) -> Change:
    enum, _, rest = subject.partition(".")
    change = changed(rule, subject, old, new, places, _used_by(rule, fields), messages=_messages(fields), rows=fields)
    return replace(change, enum=enum, entry=rest.partition(".")[0] or None)


def _used_by(rule: ChangeRule, fields: Sequence[str]) -> str:
    if rule in (rules.DESCRIPTION, rules.ENUM_ADDED) or not fields:
        return ""
    return f"used by {shortened_list(fields, 3)}"


def _messages(fields: Sequence[str]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(field.partition(".")[0] for field in fields))
