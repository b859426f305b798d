"""Softens changes that had been announced: of work in progress, and removals of what was deprecated."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from codegen.diff.change import Change
from codegen.diff.dialect import wire_rules as rules
from codegen.model.dialect.dialect import Dialect, Lifecycle

_ENDS = (rules.MESSAGE_REMOVED, rules.ENTRY_REMOVED, rules.ENUM_REMOVED)


def softened(changes: Iterable[Change], old: Dialect) -> Iterator[Change]:
    """The changes of a dialect, those softened that ``old``, its version of before, gave notice of."""
    for change in changes:
        reason = "" if change.weight.is_harmless else _reason(change, old)
        yield replace(change, softened=reason, breaks=(), doubt="") if reason else change


def _reason(change: Change, old: Dialect) -> str:
    standings = [_lifecycle(change, old)] if change.enum is not None else _messages(change, old)
    if standings and all(each.wip for each in standings):
        return "it was work in progress"
    if change.rule not in _ENDS or not standings:
        return ""
    for each in standings:
        since = each.deprecated_since if each.deprecated_since is not None else each.superseded_since
        if since is None:
            return ""
    first = standings[0]
    word = "deprecated" if first.deprecated_since is not None else "superseded"
    day = first.deprecated_since or first.superseded_since
    instead = f", {first.replaced_by} taking its place" if first.replaced_by else ""
    return f"it was {word}{f' since {day}' if day else ''}{instead}"


def _lifecycle(change: Change, old: Dialect) -> Lifecycle:
    """Return what the old version says of the entry, or where it says nothing of its enum."""
    enum = old.enums.get(change.enum or "")
    if enum is None:
        return Lifecycle()
    names = (change.entry, change.old)
    entry = next((each for each in enum.entries if each.name in names), None)
    return entry.lifecycle if entry is not None and entry.lifecycle != Lifecycle() else enum.lifecycle


def _messages(change: Change, old: Dialect) -> list[Lifecycle]:
    found = (old.messages.get(name) for name in change.messages)
    return [message.definition.lifecycle for message in found if message is not None]
