"""Finds messages that receivers of the other version do not read, as CRC_EXTRA or the id differs."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from codegen.diff.change import Change, Notice
from codegen.model.dialect.dialect import WireMessage

_GRAVITY = (Notice.SILENT, Notice.NOTICED, Notice.UNKNOWN_ID)


def by_id(messages: Mapping[str, WireMessage]) -> dict[int, WireMessage]:
    """The messages of a dialect by their ids."""
    return {message.id: message for message in messages.values()}


def taken_for(message: WireMessage, theirs: Mapping[int, WireMessage]) -> Notice:
    """Return what comes of a frame of ``message`` at a receiver that knows the
    messages ``theirs``, whatever their names.
    """
    known = theirs.get(message.id)
    if known is None:
        return Notice.UNKNOWN_ID
    return Notice.SILENT if known.crc_extra == message.crc_extra else Notice.NOTICED


def gravest(notices: Iterable[Notice]) -> Notice:
    """Return the gravest of several notices: the one by which a receiver notices a change least."""
    return min(notices, key=_GRAVITY.index)


def between(
    old: WireMessage, new: WireMessage, before: Mapping[int, WireMessage], after: Mapping[int, WireMessage]
) -> Notice:
    """Return what comes of frames of two versions of a message, ``before`` and
    ``after`` being the messages of both by id.
    """
    return gravest((taken_for(old, after), taken_for(new, before)))


def heard(changes: Iterable[Change], notice: Notice) -> list[Change]:
    """The changes of a message: what breaks somebody does so as ``notice`` says, the frames being read or dropped."""
    return [
        replace(change, notice=notice) if change.is_breaking and change.notice is not Notice.NONE else change
        for change in changes
    ]


def dropped(old: Mapping[str, WireMessage], new: Mapping[str, WireMessage]) -> dict[str, Notice]:
    """The messages of two dialects, by name, whose frames receivers of the other version do not read, and why."""
    before, after = by_id(old), by_id(new)
    found = {name: between(old[name], message, before, after) for name, message in new.items() if name in old}
    return {name: notice for name, notice in found.items() if notice is not Notice.SILENT}


def heard_in(changes: Iterable[Change], notices: Mapping[str, Notice]) -> Iterator[Change]:
    """Changes of several messages; silent is none whose messages ``notices`` has, as nobody believes their bytes."""
    for change in changes:
        told = [notices[name] for name in change.messages if name in notices]
        is_dropped = change.is_silent and bool(told) and len(told) == len(change.messages)
        yield replace(change, notice=gravest(told)) if is_dropped else change
