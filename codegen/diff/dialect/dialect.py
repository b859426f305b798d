"""Changes between two dialects, each with all that it includes: which file a message stands in does not count."""

from collections.abc import Iterator, Mapping

from codegen.diff.change import BOTH, Change, Notice, changed
from codegen.diff.dialect import wire_rules as rules
from codegen.diff.dialect.corrected import below_corrections
from codegen.diff.dialect.enums import enum_changes
from codegen.diff.dialect.fields import bytes_text, field_changes, names_of_both
from codegen.diff.dialect.hearing import between, by_id, heard, taken_for
from codegen.diff.dialect.lifecycle import lifecycle_changes
from codegen.diff.dialect.meaning import Vocabulary
from codegen.diff.dialect.pairing import type_text
from codegen.diff.judging.texts import other_message
from codegen.model.dialect.dialect import Dialect, WireMessage
from codegen.source import Place


def dialect_changes(old: Dialect, new: Dialect) -> tuple[Change, ...]:
    """Every change: of messages in the order of their ids, then of enums, then of what corrections hide."""
    if old is new:
        return ()
    found: list[Change] = []
    if old.version != new.version:
        places = _anywhere(old), _anywhere(new)
        names = tuple(name for name, message in new.messages.items() if _has_version(message))
        effect = f"{', '.join(names)} says so" if names else "no message says so"
        before, after = str(old.version), str(new.version)
        found.append(changed(rules.DIALECT_VERSION, new.name, before, after, places, effect, messages=names))
    found += _messages(old.messages, new.messages, Vocabulary(old.enums, new.enums))
    found += enum_changes(old.enums, new.enums, _users(old, new))
    found += below_corrections(old, new)
    return tuple(found)


def _anywhere(dialect: Dialect) -> Place:
    return Place(dialect.files[-1]) if dialect.files else Place(dialect.name)


def _has_version(message: WireMessage) -> bool:
    return any(field.definition.type == "uint8_t_mavlink_version" for field in message.fields)


def _messages(old: Mapping[str, WireMessage], new: Mapping[str, WireMessage], enums: Vocabulary) -> Iterator[Change]:
    renamed = {after.name: before for before, after in _renamed(old, new)}
    ids, taken_by = by_id(old), by_id(new)
    for message in sorted(new.values(), key=lambda each: each.id):
        before = old.get(message.name) or renamed.get(message.name)
        if before is None:
            yield _added(message, ids)
        elif before is not message and before != message:
            yield from heard(_within(before, message, ids, taken_by, enums), between(before, message, ids, taken_by))
    kept = {message.name for message in renamed.values()}
    for message in old.values():
        if message.name not in new and message.name not in kept:
            yield _removed(message, taken_by)


def _renamed(
    old: Mapping[str, WireMessage], new: Mapping[str, WireMessage]
) -> Iterator[tuple[WireMessage, WireMessage]]:
    """Messages with one id and under names that the other version does not have, if they share most of their fields."""
    gone = {message.id: message for message in old.values() if message.name not in new}
    for message in new.values():
        before = None if message.name in old else gone.get(message.id)
        if before is not None and _is_alike(before, message):
            yield before, message


def _is_alike(old: WireMessage, new: WireMessage) -> bool:
    before = {(field.name, type_text(field)) for field in old.fields}
    after = {(field.name, type_text(field)) for field in new.fields}
    return 2 * len(before & after) > max(len(before), len(after))


def _added(message: WireMessage, ids: Mapping[int, WireMessage]) -> Change:
    """A new message; ``ids`` are the messages of the old version."""
    notice, holder = taken_for(message, ids), ids.get(message.id)
    return changed(
        rules.MESSAGE_ADDED,
        message.name,
        None,
        _identity(message),
        (None, message.definition.place),
        f"the id was {holder.name}'s: {_mistaken(notice)}" if holder else "",
        notice=notice,
        breaks=BOTH if holder else None,
        messages=(message.name,),
    )


def _removed(message: WireMessage, taken_by: Mapping[int, WireMessage]) -> Change:
    heir = taken_by.get(message.id)
    effect = f"the id is {heir.name}'s now" if heir is not None else "who waits for it waits in vain"
    places, notice = (message.definition.place, None), taken_for(message, taken_by)
    said = _identity(message)
    return changed(
        rules.MESSAGE_REMOVED, message.name, said, None, places, effect, notice=notice, messages=(message.name,)
    )


def _mistaken(notice: Notice) -> str:
    """Return what receivers make of a message whose id they know as another one's."""
    shown = "" if notice is Notice.SILENT else ", until CRC_EXTRA shows that it is not"
    return f"receivers of the other version take it for that{shown}"


def _identity(message: WireMessage) -> str:
    size = bytes_text(message.base_length)
    if message.length != message.base_length:
        size += f", {message.length} with extensions"
    return f"id {message.id}, CRC_EXTRA {message.crc_extra}, {size}"


def _within(
    old: WireMessage,
    new: WireMessage,
    ids: Mapping[int, WireMessage],
    taken_by: Mapping[int, WireMessage],
    enums: Vocabulary,
) -> Iterator[Change]:
    places = old.definition.place, new.definition.place
    names = names_of_both(old, new)
    if old.name != new.name:
        yield changed(rules.MESSAGE_RENAMED, new.name, old.name, new.name, places, messages=names)
    if old.id != new.id:
        other = ids.get(new.id) or taken_by.get(old.id)
        notice = between(old, new, ids, taken_by)
        effect = "receivers of the other version pass over it"
        if other is not None:
            effect = f"the id is {other.name}'s in the other version: {_mistaken(notice)}"
        yield changed(rules.MESSAGE_ID, new.name, str(old.id), str(new.id), places, effect, messages=names)
    yield from field_changes(old, new, enums)
    yield from lifecycle_changes(new.name, old.definition.lifecycle, new.definition.lifecycle, places, names)
    before, after = old.definition.description, new.definition.description
    if before != after:
        found = other_message(before, after)
        rule, breaks = (
            (rules.MESSAGE_MEANING, BOTH if found.breaks else ()) if found.gravity else (rules.DESCRIPTION, None)
        )
        words = before or None, after or None
        yield changed(rule, new.name, *words, places, found.effect, breaks=breaks, doubt=found.doubt, messages=names)


def _users(old: Dialect, new: Dialect) -> Mapping[str, list[str]]:
    """The fields that use each enum, in either version."""
    users: dict[str, dict[str, None]] = {}
    for dialect in (new, old):
        for message in dialect.messages.values():
            for field in message.fields:
                if field.definition.enum:
                    users.setdefault(field.definition.enum, {})[f"{message.name}.{field.name}"] = None
    return {name: list(fields) for name, fields in users.items()}
