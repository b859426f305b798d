"""Changes between two dialects, each with all that it includes: which file a message stands in does not count."""

from collections.abc import Iterator, Mapping

from codegen.diff import wire_rules as rules
from codegen.diff.change import BOTH, Change, changed
from codegen.diff.enums import enum_changes
from codegen.diff.fields import field_changes
from codegen.diff.lifecycle import lifecycle_changes
from codegen.diff.pairing import type_text
from codegen.model.dialect import Dialect, WireMessage
from codegen.source import Place


def dialect_changes(old: Dialect, new: Dialect) -> tuple[Change, ...]:
    """Every change: of messages in the order of their ids, then of enums."""
    if old is new:
        return ()
    found: list[Change] = []
    if old.version != new.version:
        places = _anywhere(old), _anywhere(new)
        names = tuple(name for name, message in new.messages.items() if _has_version(message))
        effect = f"{', '.join(names)} says so" if names else "no message says so"
        before, after = str(old.version), str(new.version)
        found.append(changed(rules.DIALECT_VERSION, new.name, before, after, places, effect, messages=names))
    found += _messages(old.messages, new.messages)
    found += enum_changes(old.enums, new.enums, _users(old, new))
    return tuple(found)


def _anywhere(dialect: Dialect) -> Place:
    return Place(dialect.files[-1]) if dialect.files else Place(dialect.name)


def _has_version(message: WireMessage) -> bool:
    return any(field.definition.type == "uint8_t_mavlink_version" for field in message.fields)


def _messages(old: Mapping[str, WireMessage], new: Mapping[str, WireMessage]) -> Iterator[Change]:
    renamed = {after.name: before for before, after in _renamed(old, new)}
    ids = {message.id: message for message in old.values()}
    taken_by = {message.id: message for message in new.values()}
    for message in sorted(new.values(), key=lambda each: each.id):
        before = old.get(message.name) or renamed.get(message.name)
        if before is None:
            yield _added(message, ids.get(message.id))
        else:
            yield from _within(before, message)
    kept = {message.name for message in renamed.values()}
    for message in old.values():
        if message.name not in new and message.name not in kept:
            yield _removed(message, taken_by.get(message.id))


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


def _added(message: WireMessage, holder: WireMessage | None) -> Change:
    """A new message; ``holder`` is the message of the old version that had its id."""
    effect, breaks = "", None
    if holder is not None and holder.name != message.name:
        effect = f"the id was {holder.name}'s: receivers of the other version take it for that"
        breaks = BOTH
        if holder.crc_extra != message.crc_extra:
            effect += ", until CRC_EXTRA shows that it is not"
    places = None, message.definition.place
    return changed(
        rules.MESSAGE_ADDED,
        message.name,
        None,
        _identity(message),
        places,
        effect,
        breaks=breaks,
        messages=(message.name,),
    )


def _removed(message: WireMessage, heir: WireMessage | None) -> Change:
    effect = f"the id is {heir.name}'s now" if heir is not None else "who waits for it waits in vain"
    places = message.definition.place, None
    return changed(
        rules.MESSAGE_REMOVED, message.name, _identity(message), None, places, effect, messages=(message.name,)
    )


def _identity(message: WireMessage) -> str:
    size = f"{message.base_length} bytes"
    if message.length != message.base_length:
        size += f", {message.length} with extensions"
    return f"id {message.id}, CRC_EXTRA {message.crc_extra}, {size}"


def _within(old: WireMessage, new: WireMessage) -> Iterator[Change]:
    places = old.definition.place, new.definition.place
    names = tuple(dict.fromkeys((old.name, new.name)))
    if old.name != new.name:
        yield changed(rules.MESSAGE_RENAMED, new.name, old.name, new.name, places, messages=names)
    if old.id != new.id:
        effect = "receivers of the other version pass over it"
        yield changed(rules.MESSAGE_ID, new.name, str(old.id), str(new.id), places, effect, messages=names)
    yield from field_changes(old, new)
    yield from lifecycle_changes(new.name, old.definition.lifecycle, new.definition.lifecycle, places, names)
    before, after = old.definition.description, new.definition.description
    if before != after:
        yield changed(rules.DESCRIPTION, new.name, before or None, after or None, places, messages=names)


def _users(old: Dialect, new: Dialect) -> Mapping[str, list[str]]:
    """The fields that use each enum, in either version."""
    users: dict[str, dict[str, None]] = {}
    for dialect in (new, old):
        for message in dialect.messages.values():
            for field in message.fields:
                if field.definition.enum:
                    users.setdefault(field.definition.enum, {})[f"{message.name}.{field.name}"] = None
    return {name: list(fields) for name, fields in users.items()}
