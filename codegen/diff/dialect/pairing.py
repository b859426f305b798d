"""Pairs the fields of two versions of a message."""

from collections.abc import Iterator
from typing import NamedTuple

from codegen.model.dialect.dialect import WireField, WireMessage


class Pair(NamedTuple):
    """A field in both versions, maybe under another name."""

    old: WireField
    new: WireField


def paired_fields(old: WireMessage, new: WireMessage) -> list[Pair]:
    """The fields that both versions have, those with a new name too, in the order of the new one."""
    renamed = {after.name: before for before, after in _renamed(old, new)}
    known = {field.name: field for field in old.fields}
    pairs = []
    for field in new.fields:
        before = known.get(field.name) or renamed.get(field.name)
        if before is not None:
            pairs.append(Pair(before, field))
    return pairs


def _renamed(old: WireMessage, new: WireMessage) -> Iterator[Pair]:
    """Fields that lie at the same bytes with the same type, under a name that the other version does not have."""
    names = {field.name for field in old.fields}, {field.name for field in new.fields}
    gone = {(field.offset, type_text(field)): field for field in old.fields if field.name not in names[1]}
    for field in new.fields:
        before = None if field.name in names[0] else gone.pop((field.offset, type_text(field)), None)
        if before is not None:
            yield Pair(before, field)


def type_text(field: WireField) -> str:
    """``uint16_t[10]``; of a field whose parts disagree, all of them."""
    definition = field.definition
    text = definition.type if definition.type == field.type.name else f"{definition.type} ({field.type.name})"
    if definition.length is not None:
        text += f"[{definition.length}]"
    return text if field.count == (definition.length or 1) else f"{text} of {field.count}"
