"""Changes of enums and their entries, with the parameters of commands."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from codegen.diagnostics import shortened_list
from codegen.diff.change import BOTH, Change, ChangeRule, changed
from codegen.diff.dialect import wire_rules as rules
from codegen.diff.dialect.lifecycle import lifecycle_changes
from codegen.diff.dialect.meaning import Vocabulary
from codegen.diff.dialect.parameters import other_parameter
from codegen.diff.judging.defaults import moved_default
from codegen.diff.judging.judging import HARMLESS, Judgement, gone_entry, gravest, other_entry
from codegen.diff.judging.texts import same_entry
from codegen.model.dialect.dialect import CommandParameter, EnumDefinition, EnumEntry
from codegen.source import Place

Users = Mapping[str, Sequence[str]]
"""The fields, as MESSAGE.field, that have the numbers of an enum, by its name."""


def enum_changes(
    old: Mapping[str, EnumDefinition], new: Mapping[str, EnumDefinition], users: Users
) -> Iterator[Change]:
    """Yield what changed in the enums of a dialect, in the order of their names."""
    for name in sorted(old.keys() | new.keys()):
        before, after = old.get(name), new.get(name)
        fields = users.get(name, ())
        if before is None and after is not None:
            yield _enum(rules.ENUM_ADDED, name, None, _size(after), (None, after.place), fields)
        elif after is None and before is not None:
            yield _enum(rules.ENUM_REMOVED, name, _size(before), None, (before.place, None), fields)
        elif before is not None and after is not None and before is not after:
            yield from _within(before, after, fields, Vocabulary(old, new))


def _size(enum: EnumDefinition) -> str:
    count = len(enum.entries)
    return f"{count} {'entry' if count == 1 else 'entries'}"


def _within(old: EnumDefinition, new: EnumDefinition, fields: Sequence[str], enums: Vocabulary) -> Iterator[Change]:
    name, places = new.name, (old.place, new.place)
    if old.is_bitmask != new.is_bitmask:
        words = ["bits" if side.is_bitmask else "numbers" for side in (old, new)]
        change = _enum(rules.ENUM_BITMASK, name, words[0], words[1], places, fields)
        yield _as_judged(change, _as_bits(old) if new.is_bitmask else HARMLESS)
    if old.description != new.description:
        yield _enum(rules.DESCRIPTION, name, old.description or None, new.description or None, places, fields)
    for change in lifecycle_changes(name, old.lifecycle, new.lifecycle, places, _messages(fields)):
        yield replace(change, enum=name)
    yield from _entries(old, new, fields, enums)


def _as_bits(old: EnumDefinition) -> Judgement:
    """Return what comes of numbers that are read as sets of bits: nothing where
    each is one bit, or said to be a set.
    """
    bits = {entry.value for entry in old.entries if entry.value and not entry.value & (entry.value - 1)}
    mixed = [entry for entry in old.entries if entry.value not in bits and entry.value]
    names = [entry.name for entry in mixed if not _is_set(entry)]
    if not names:
        return HARMLESS
    return Judgement(doubt=f"whether {shortened_list(names, 3)} was ever a set of bits")


def _is_set(entry: EnumEntry) -> bool:
    """Return whether a number of several bits is said to be a set: its name or text speaks of all, or of a mask."""
    return any(word in f"{entry.name} {entry.description}".lower() for word in ("mask", "all", "bits", "any"))


def _entries(old: EnumDefinition, new: EnumDefinition, fields: Sequence[str], enums: Vocabulary) -> Iterator[Change]:
    before = {entry.name: entry for entry in old.entries}
    after = {entry.name: entry for entry in new.entries}
    gone = {entry.name: entry for entry in old.entries if entry.name not in after}
    moved = moved_default(old.entries, new.entries)
    for entry in new.entries:
        known = before.get(entry.name)
        if known is None:
            known = next((each for each in gone.values() if each.value == entry.value), None)
            if known is not None:
                del gone[known.name]
                change = _entry(rules.ENTRY_RENAMED, new.name, entry, (known.name, entry.name), known, fields)
                yield _as_judged(change, other_entry(known, entry, old))
        if known is None:
            said = f"{entry.name} = {entry.value}"
            yield _enum(rules.ENTRY_ADDED, f"{new.name}.{entry.name}", None, said, (None, entry.place), fields)
            continue
        default = moved.judgement if moved is not None and moved.entry == entry.name else HARMLESS
        yield from _entry_changes(known, entry, default, new.name, fields, enums)
    for entry in gone.values():
        said = f"{entry.name} = {entry.value}"
        change = _enum(rules.ENTRY_REMOVED, f"{new.name}.{entry.name}", said, None, (entry.place, None), fields)
        found = gone_entry(entry, is_bitmask=old.is_bitmask or new.is_bitmask)
        yield change if found.breaks else _as_judged(change, found)


def _as_judged(change: Change, judgement: Judgement) -> Change:
    """A change with what was found to come of it."""
    effect = "; ".join(word for word in (judgement.effect, change.effect) if word)
    return replace(change, effect=effect, breaks=BOTH if judgement.breaks else (), doubt=judgement.doubt)


def _entry_changes(
    old: EnumEntry, new: EnumEntry, default: Judgement, enum: str, fields: Sequence[str], enums: Vocabulary
) -> Iterator[Change]:
    """Yield what changed in an entry; ``default`` is what comes of it being the default of its enum now."""
    if old.value != new.value:
        yield _entry(rules.ENTRY_VALUE, enum, new, (str(old.value), str(new.value)), old, fields)
    if old.description != new.description:
        texts = old.description or None, new.description or None
        found = same_entry(old.description, new.description) if old.name == new.name else HARMLESS
        found = gravest(found, default)
        change = _entry(rules.ENTRY_MEANING if found.gravity else rules.DESCRIPTION, enum, new, texts, old, fields)
        yield _as_judged(change, found)
    if sorted(old.traits) != sorted(new.traits):
        change = _entry(rules.ENTRY_TRAITS, enum, new, (_written(old.traits), _written(new.traits)), old, fields)
        yield _as_judged(change, _other_traits(dict(old.traits), dict(new.traits)))
    subject, places = f"{enum}.{new.name}", (old.place, new.place)
    for change in lifecycle_changes(subject, old.lifecycle, new.lifecycle, places, _messages(fields)):
        yield replace(change, enum=enum, entry=new.name)
    before = {parameter.number: parameter for parameter in old.parameters}
    after = {parameter.number: parameter for parameter in new.parameters}
    for number in sorted(before.keys() | after.keys()):
        pair = before.get(number), after.get(number)
        yield from _parameter(f"{subject}.{number}", *pair, (old, new), fields, enums)


def _other_traits(old: Mapping[str, str], new: Mapping[str, str]) -> Judgement:
    """Return what comes of another location or destination: COMMAND_INT scales what is a location."""
    differing = [name for name, text in old.items() if name in new and new[name] != text]
    if not differing:
        return HARMLESS
    return Judgement(doubt=f"whether parameters 5 and 6 are sent otherwise, {' and '.join(differing)} being another")


def _parameter(
    subject: str,
    old: CommandParameter | None,
    new: CommandParameter | None,
    entries: tuple[EnumEntry, EnumEntry],
    fields: Sequence[str],
    enums: Vocabulary,
) -> Iterator[Change]:
    if old is not None and new is not None and (old.attributes, old.description) == (new.attributes, new.description):
        return
    places = (old.place if old else entries[0].place), (new.place if new else entries[1].place)
    words = [_written(side.attributes) if side else None for side in (old, new)]
    texts = [side.description if side else "" for side in (old, new)]
    found = other_parameter(old, new, entries, enums)
    if old is None or new is None or sorted(old.attributes) != sorted(new.attributes) or found.gravity:
        shown = [word if side is None else word or "a parameter" for word, side in zip(words, (old, new), strict=True)]
        if shown[0] == shown[1]:
            shown = [text or None for text in texts]
        change = _enum(rules.COMMAND_PARAMETER, subject, shown[0], shown[1], places, fields)
        yield _as_judged(change, found)
        if texts == shown:
            return
    if texts[0] != texts[1]:
        yield _enum(rules.DESCRIPTION, subject, texts[0] or None, texts[1] or None, places, fields)


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
