"""Finds the message that a list of fields is about: the nearest text that names one with these fields."""

import re
from collections.abc import Iterable, Sequence

from codegen.importing.stated import FieldList
from codegen.model.dialect.dialect import Dialect, WireMessage

_NAME = re.compile(r"\b[A-Z][A-Z0-9_]{2,}\b")
_NUMBER = re.compile(r"#(\d{1,8})\b")
_EXAMPLE = re.compile(r"(?:\w+\s+){0,2}examples?\b", re.IGNORECASE)
_ENOUGH = 3
"""The number of names of fields that are needed to recognise a message that no text names."""


def subjects(fields: FieldList, dialect: Dialect) -> tuple[WireMessage, ...]:
    """The message, or several where the nearest text names more than one that fits equally; none if nothing does.

    A message fits if half of the rows, or more, are fields of it. One that has all of them goes before one that is
    mentioned nearer and lacks some.
    """
    mentioned = [tuple(_mentioned(text, dialect)) for text in fields.context]
    for needed in (len(fields.rows), -(-len(fields.rows) // 2)):
        found = _nearest(fields, mentioned, needed)
        if found:
            return found
    return ()


def _nearest(fields: FieldList, mentioned: Sequence[Sequence[WireMessage]], needed: int) -> tuple[WireMessage, ...]:
    """Return the messages with the most rows in the nearest text that has any with so many."""
    for messages in mentioned:
        fitting = [message for message in messages if coverage(fields, message) >= needed]
        if fitting:
            best = max(coverage(fields, message) for message in fitting)
            return tuple(message for message in fitting if coverage(fields, message) == best)
    return ()


def is_example(fields: FieldList) -> bool:
    """Return whether the nearest text begins by calling the list an example: what fields hold once, not where from."""
    match = _EXAMPLE.match(fields.context[0]) if fields.context else None
    return match is not None and not match[0].casefold().startswith("for ")


def is_about(fields: FieldList, message: WireMessage) -> bool:
    """Return whether half of the rows, or more, name fields of the message."""
    return 2 * coverage(fields, message) >= len(fields.rows)


def coverage(fields: FieldList, message: WireMessage) -> int:
    """Return how many rows name a field of the message."""
    names = {field.name for field in message.fields}
    return sum(row.name in names or row.name.rstrip("_") in names for row in fields.rows)


def lookalikes(fields: FieldList, dialect: Dialect) -> tuple[str, ...]:
    """The messages that have every field of the list, where no text names one."""
    names = {row.name for row in fields.rows}
    if len(names) < _ENOUGH:
        return ()
    return tuple(
        message.name for message in dialect.messages.values() if names <= {field.name for field in message.fields}
    )


def _mentioned(text: str, dialect: Dialect) -> Iterable[WireMessage]:
    """The messages that a text names, by name or as ``#147``, each once."""
    numbers = {int(number) for number in _NUMBER.findall(text)}
    found = {name: dialect.messages[name] for name in _NAME.findall(text) if name in dialect.messages}
    if numbers:
        found |= {name: message for name, message in dialect.messages.items() if message.id in numbers}
    return found.values()
