"""Changes of one message between two dialects: its fields, its layout, its CRC_EXTRA, and what the fields mean."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from codegen.diagnostics import shortened_list
from codegen.diff.change import BOTH, MOST_NAMES, Change, ChangeRule, Notice, Victim, changed
from codegen.diff.dialect import wire_rules as rules
from codegen.diff.dialect.meaning import Vocabulary, meaning_changes
from codegen.diff.dialect.pairing import Pair, paired_fields, type_text
from codegen.diff.judging.judging import by_words
from codegen.diff.judging.wording import name_likeness, text_likeness
from codegen.model.dialect.dialect import WireField, WireMessage

_DECEIVED = (rules.FIELD_TYPE, rules.FIELD_ORDER, rules.FIELD_SENTINEL, rules.FIELD_MULTIPLIER)
"""Changes for which frames of the other version are misread, if they are read at all."""


def field_changes(old: WireMessage, new: WireMessage, enums: Vocabulary) -> tuple[Change, ...]:
    """Return what changed within a message, the layout first; descriptions last.
    ``enums`` are those of both versions.
    """
    structure = tuple(_structure(old, new))
    found = [*structure, *_layout(old, new, structure), *_crc_extra(old, new, structure)]
    for pair in paired_fields(old, new):
        found += meaning_changes(pair, new.name, enums)
    if _is_dropped(old, new):
        found = [replace(change, effect="") if change.rule in _DECEIVED else change for change in found]
    return tuple(found)


def _is_dropped(old: WireMessage, new: WireMessage) -> bool:
    return old.id != new.id or old.crc_extra != new.crc_extra


def _structure(old: WireMessage, new: WireMessage) -> Iterator[Change]:
    pairs = paired_fields(old, new)
    before, after = {pair.old.name for pair in pairs}, {pair.new.name for pair in pairs}
    moved = [pair.new.name for pair in pairs if pair.new.definition.is_extension and pair.old.offset != pair.new.offset]
    for field in old.fields:
        if field.name not in before:
            yield _removed(field, old, new, moved)
    for field in new.fields:
        if field.name not in after:
            yield _added(field, old, new, moved)
    for pair in pairs:
        if pair.old.name != pair.new.name:
            yield _renamed(pair, new)
        if type_text(pair.old) != type_text(pair.new):
            yield _field(
                rules.FIELD_TYPE, pair, new, (type_text(pair.old), type_text(pair.new)), _retyped_effect(pair, moved)
            )
        if pair.old.definition.is_extension != pair.new.definition.is_extension:
            sides = _side(pair.old), _side(pair.new)
            yield _field(rules.BOUNDARY, pair, new, sides, _moved_effect(pair))
    for is_extension in (False, True):
        kept = [pair for pair in pairs if _is_on(pair, is_extension)]
        yield from _order(kept, old, new, is_extension=is_extension)


def _is_on(pair: Pair, is_extension: bool) -> bool:
    return pair.old.definition.is_extension == pair.new.definition.is_extension == is_extension


def _removed(field: WireField, old: WireMessage, new: WireMessage, moved: Sequence[str]) -> Change:
    subject = f"{new.name}.{field.name}"
    sizes = _sizes(old, new)
    if not field.definition.is_extension:
        effect, notice = sizes, Notice.NOTICED
    elif _is_dropped(old, new):
        effect, notice = sizes, Notice.SILENT
    else:
        effect = f"old receivers read zeros there{_and_shifted(moved)}; {sizes}"
        notice = Notice.SILENT
    places = field.definition.place, None
    said = f"{type_text(field)}{_described(field)}"
    return changed(
        rules.FIELD_REMOVED, subject, said, None, places, effect, notice=notice, messages=names_of_both(old, new)
    )


def _added(field: WireField, old: WireMessage, new: WireMessage, moved: Sequence[str]) -> Change:
    subject = f"{new.name}.{field.name}"
    said = f"{type_text(field)}{_described(field)}"
    sizes = _sizes(old, new)
    places = None, field.definition.place
    names = names_of_both(old, new)
    if not field.definition.is_extension:
        effect = sizes
        return changed(rules.FIELD_ADDED, subject, None, said, places, effect, messages=names)
    if _is_dropped(old, new):
        return changed(rules.EXTENSION_ADDED, subject, None, said, places, sizes, messages=names)
    breaks: tuple[Victim, ...] = ()
    effect = f"old receivers pass over it; from an old sender it reads as 0{_meaning_of_zero(field)}; {sizes}"
    if _meaning_of_zero(field):
        breaks = (Victim.NEW_STATION,)
    if moved:
        shifted = shortened_list(moved, MOST_NAMES)
        effect = f"it moves {shifted}: the other version reads them from the wrong bytes; {sizes}"
        breaks = BOTH
    return changed(rules.EXTENSION_ADDED, subject, None, said, places, effect, breaks=breaks, messages=names)


def _meaning_of_zero(field: WireField) -> str:
    """Return what is wrong with a 0 that nobody sent; empty where 0 is the sentinel."""
    sentinel = field.sentinel
    if sentinel is None or all(value == 0 for value in sentinel.values if value is not None):
        return ""
    return f", a value, as unknown is {sentinel.written}"


def _renamed(pair: Pair, message: WireMessage) -> Change:
    """A field at the same bytes under another name: of an extension nobody notices, so its words have to tell."""
    change = _field(rules.FIELD_RENAMED, pair, message, (pair.old.name, pair.new.name), "")
    if not (pair.old.definition.is_extension and pair.new.definition.is_extension):
        return change
    names = name_likeness(pair.old.name, pair.new.name)
    texts = text_likeness(pair.old.definition.description, pair.new.definition.description)
    found = by_words(names, texts, pair.old.name, pair.new.name)
    effect = found.effect if found.breaks else "the bytes are the same"
    return replace(change, effect=effect, breaks=BOTH if found.breaks else (), doubt=found.doubt)


def _retyped_effect(pair: Pair, moved: Sequence[str]) -> str:
    old, new = pair.old, pair.new
    if not (new.definition.is_extension and old.definition.is_extension):
        return ""
    what = "another number of values" if old.type == new.type else "other numbers"
    return f"the other version reads {what}{_and_shifted([name for name in moved if name != new.name])}"


def _and_shifted(names: Sequence[str]) -> str:
    return f", and {shortened_list(names, MOST_NAMES)} from the wrong bytes" if names else ""


def _moved_effect(pair: Pair) -> str:
    before, after = pair.old.offset, pair.new.offset
    return f"it stays at byte {after}" if before == after else f"it goes from byte {before} to byte {after}"


def _sizes(old: WireMessage, new: WireMessage) -> str:
    if old.length == new.length:
        return f"the payload still has {bytes_text(new.length)}"
    return f"the payload goes from {old.length} to {bytes_text(new.length)}"


def bytes_text(count: int) -> str:
    """``1 byte``, ``2 bytes``."""
    return f"{count} byte{'' if count == 1 else 's'}"


def _side(field: WireField) -> str:
    return "extension" if field.definition.is_extension else "base field"


def _order(kept: Sequence[Pair], old: WireMessage, new: WireMessage, *, is_extension: bool) -> Iterator[Change]:
    """Fields that lie in another order, as one change; those whose type or side changed are told by that."""
    same = [pair for pair in kept if pair.old.type == pair.new.type]
    before = [pair.new.name for pair in sorted(same, key=lambda pair: pair.old.offset)]
    after = [pair.new.name for pair in sorted(same, key=lambda pair: pair.new.offset)]
    if before == after:
        return
    first = next(pair for pair, name in zip(sorted(same, key=_offset), before, strict=True) if pair.new.name != name)
    notice = Notice.SILENT if is_extension else Notice.NOTICED
    effect = "the other version reads them from each other's bytes" if is_extension else ""
    places = first.old.definition.place, first.new.definition.place
    yield changed(
        rules.FIELD_ORDER,
        new.name,
        ", ".join(before),
        ", ".join(after),
        places,
        effect,
        notice=notice,
        messages=names_of_both(old, new),
    )


def _offset(pair: Pair) -> int:
    return pair.new.offset


def _layout(old: WireMessage, new: WireMessage, structure: Sequence[Change]) -> Iterator[Change]:
    """Yield what lies elsewhere without a field that tells why: of one dialect read correctly there is nothing."""
    if structure:
        return
    before, after = _lengths(old), _lengths(new)
    moved = [pair for pair in paired_fields(old, new) if pair.old.offset != pair.new.offset]
    if before != after:
        places = old.definition.place, new.definition.place
        yield changed(
            rules.LAYOUT, new.name, before, after, places, "receivers disagree", messages=names_of_both(old, new)
        )
    for pair in moved:
        sides = f"byte {pair.old.offset}", f"byte {pair.new.offset}"
        yield _field(rules.LAYOUT, pair, new, sides, "it is read from the wrong bytes", notice=Notice.SILENT)


def _lengths(message: WireMessage) -> str:
    return f"{bytes_text(message.base_length)}, {message.length} with extensions"


def _crc_extra(old: WireMessage, new: WireMessage, structure: Sequence[Change]) -> Iterator[Change]:
    if old.crc_extra == new.crc_extra:
        return
    causes = [_cause(change) for change in structure if change.notice is Notice.NOTICED]
    if old.name != new.name:
        causes.insert(0, f"{old.name} is called {new.name}")
    effect = "receivers of the other version drop every frame"
    if causes:
        effect += f", because {'; '.join(causes)}"
    places = old.definition.place, new.definition.place
    names = names_of_both(old, new)
    before, after = str(old.crc_extra), str(new.crc_extra)
    yield changed(rules.CRC_EXTRA, new.name, before, after, places, effect, causes=causes, messages=names)


def _cause(change: Change) -> str:
    name = change.subject.rpartition(".")[2]
    words = {
        rules.FIELD_REMOVED.id: f"{name} is gone",
        rules.FIELD_ADDED.id: f"{name} is new",
        rules.FIELD_RENAMED.id: f"{change.old} is called {change.new}",
        rules.FIELD_TYPE.id: f"{name} is {change.new}, no longer {change.old}",
        rules.BOUNDARY.id: f"{name} is now {'an extension' if change.new == 'extension' else 'a base field'}",
        rules.FIELD_ORDER.id: "the fields are in another order",
    }
    return words[change.rule.id]


def _described(field: WireField) -> str:
    definition = field.definition
    words = [
        field.unit_text,
        f"enum {definition.enum}" if definition.enum else "",
        f"unknown {field.sentinel.written}" if field.sentinel else "",
    ]
    return "".join(f", {word}" for word in words if word)


def _field(
    rule: ChangeRule,
    pair: Pair,
    message: WireMessage,
    sides: tuple[str, str],
    effect: str,
    *,
    notice: Notice | None = None,
) -> Change:
    """A change of a field that both versions have: of an extension nothing tells."""
    is_silent = pair.old.definition.is_extension and pair.new.definition.is_extension
    places = pair.old.definition.place, pair.new.definition.place
    return changed(
        rule,
        f"{message.name}.{pair.new.name}",
        *sides,
        places,
        effect,
        notice=notice or (Notice.SILENT if is_silent else None),
        messages=(message.name,),
    )


def names_of_both(old: WireMessage, new: WireMessage) -> tuple[str, ...]:
    """The name of a message in each version; one if it has kept it."""
    return tuple(dict.fromkeys((old.name, new.name)))
