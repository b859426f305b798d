"""The messages of several dialect files become one of each name, and no two have one id."""

from collections.abc import Iterable, Mapping

from codegen.diagnostics import Report, Rule
from codegen.model.dialect.dialect import MAX_MESSAGE_ID, UNNUMBERED, DialectFile, MessageDefinition
from codegen.source import Place

MESSAGE_CONFLICT = Rule(
    "message-conflict",
    "Two files of the dialect define the same message name or id, and not alike, or names that differ in capital "
    "letters alone: pages and functions are called by them. Remove or renumber one of them; to change attributes of a "
    "message, use a corrections file.",
    remedy="remove or renumber one; to change attributes of a message, use a corrections file",
)
BAD_MESSAGE_ID = Rule(
    "message-id",
    "A message id is a decimal number of 24 bits: 0 to 16777215. Up to 255 the message can be sent in MAVLink 1. "
    "Write one in the XML, or, where the XML states what somebody else has drafted, in a correction.",
)


def merged_messages(files: Iterable[DialectFile], report: Report) -> dict[str, MessageDefinition]:
    """The messages by name; one that is stated twice alike is taken once. Ids may still be missing, or meet."""
    by_name: dict[str, MessageDefinition] = {}
    for file in files:
        for message in file.messages:
            first = by_name.setdefault(message.name.lower(), message)
            if first is not message and _stated(first) != _stated(message):
                is_respelt = first.name != message.name
                what = f"is there as {first.name} already" if is_respelt else "is defined twice, and not alike"
                problem = f"{message.name} {what}"
                report.add(MESSAGE_CONFLICT, message.place, problem, related=[(first.place, "the first definition")])
    return {message.name: message for message in by_name.values()}


def numbered_messages(messages: Mapping[str, MessageDefinition], report: Report) -> list[MessageDefinition]:
    """Return the messages with an id of their own, in its order.

    Corrections have been applied: a missing or taken id is reported where the XML or the correction states it.
    """
    by_id: dict[int, MessageDefinition] = {}
    for message in messages.values():
        if message.id == UNNUMBERED:
            problem, hint = f"{message.written_id!r} is not a message id", f"use a number from 0 to {MAX_MESSAGE_ID}"
            report.add(BAD_MESSAGE_ID, message.place, problem, hint)
            continue
        first = by_id.setdefault(message.id, message)
        if first is not message:
            problem = f"{message.name} has the id {message.id} of {first.name}"
            related = [(first.id_place or first.place, "the first definition")]
            report.add(MESSAGE_CONFLICT, message.id_place or message.place, problem, related=related)
    return sorted(by_id.values(), key=lambda message: message.id)


def _stated(message: MessageDefinition) -> tuple[object, ...]:
    """Return what has to agree where a message is stated twice: everything but places, descriptions and lifecycle."""
    anywhere = Place("")
    alike = (field._replace(place=anywhere, description="", print_format=None) for field in message.fields)
    return message.id, message.name, tuple(alike)
