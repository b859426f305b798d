"""A document becomes a proposal: which message it is about is found, or asked for."""

import re
from collections.abc import Sequence

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.importing.columns import Role
from codegen.importing.stated import FieldList, StatedFields, stated_fields
from codegen.importing.subject import is_about, is_example, lookalikes, subjects
from codegen.load.markdown_blocks import BlockKind, parse_blocks
from codegen.load.markdown_table import Table
from codegen.model.dialect.dialect import Dialect, WireMessage
from codegen.source import Place

DOCUMENT_WITHOUT_FIELDS = Rule(
    "document-without-fields",
    "A document to be imported has a table with a column for fields (Field, Name) and one for their values (Value "
    "source, Value, Source), or a list with items of the form '- `field`: value', for a message of the dialect.",
    remedy="add a table with the columns Field and Value, or a list of items '- `field`: value'",
)
DOCUMENT_MESSAGE = Rule(
    "document-message",
    "It is not clear which message the fields of a document belong to: the text near them names none, or several. "
    "Name it above the table, or give it on the command line.",
    remedy="name the message above the table, or on the command line",
)

_ID = re.compile(r"[A-Z]{2,}-[0-9a-z]+")


@dataclass(frozen=True, slots=True)
class FoundFields:
    """The message that a document is about, and its lists of fields, in the order of the text.

    They have values, or else types, units and sentinels alone, if no list of the document has values. ``others`` are
    the document's tables that are no such lists.
    """

    message: WireMessage
    lists: tuple[FieldList, ...]
    others: tuple[Table, ...]


def find_fields(text: str, path: str, wanted: str | None, dialect: Dialect, report: Report) -> FoundFields | None:
    """Return what a document says about one message: the one called ``wanted``, or the only one that it is about.

    None, after a finding, if no message can be told.
    """
    stated = stated_fields(text, path)
    report.extend(stated.findings)
    found = _about(stated, dialect, wanted)
    if wanted is None:
        about = {message.name: message for _, messages in found for message in messages}
        if len(about) != 1:
            _ask(found, path, dialect, report)
            return None
        (message,) = about.values()
        return FoundFields(message, tuple(fields for fields, messages in found if messages), stated.others)
    named = dialect.messages.get(wanted)
    if named is None:
        hint = did_you_mean(wanted, dialect.messages)
        report.add(DOCUMENT_MESSAGE, Place(path), f"{dialect.name} has no message {wanted}", hint)
        return None
    own = [fields for fields, messages in found if named in (messages or (named,)) and is_about(fields, named)]
    if not own:
        report.add(DOCUMENT_WITHOUT_FIELDS, Place(path), f"the document has no table or list of fields of {wanted}")
        return None
    return FoundFields(named, tuple(own), stated.others)


def _about(
    stated: StatedFields, dialect: Dialect, wanted: str | None
) -> list[tuple[FieldList, tuple[WireMessage, ...]]]:
    """The lists with values, each with the messages that it may be about; without any, those that describe fields."""
    lists = [fields for fields in stated.lists if not is_example(fields)]
    found = [(fields, subjects(fields, dialect)) for fields in lists]
    valued = [(fields, messages) for fields, messages in found if Role.VALUE in fields.roles]
    named = dialect.messages.get(wanted or "")
    if any(is_about(fields, named) if named else messages for fields, messages in valued):
        return valued
    described = [
        (fields, messages)
        for fields, messages in found
        if fields.is_descriptive and (is_about(fields, named) if named else messages)
    ]
    return described or valued or [one for one in found if one[0].is_descriptive]


def document_id(text: str, path: str) -> str | None:
    """The id that the first heading of a document begins with, such as FR-00068; None if it has none."""
    for block in parse_blocks(text, path):
        if block.kind is BlockKind.HEADING and block.level == 1:
            match = _ID.match(block.written)
            return match[0] if match else None
    return None


def _ask(
    found: Sequence[tuple[FieldList, tuple[WireMessage, ...]]], path: str, dialect: Dialect, report: Report
) -> None:
    """Say why no message, or more than one, can be told, with what can be given on the command line."""
    named = [(fields, message) for fields, messages in found for message in messages]
    if named:
        names = sorted({message.name for _, message in named})
        related = [(fields.place, f"fields of {message.name}") for fields, message in named]
        text = f"the document is about {' and '.join(names)}"
        report.add(DOCUMENT_MESSAGE, named[0][0].place, text, f"choose one: --message {names[0]}", related)
        return
    for fields, _ in found:
        alike = lookalikes(fields, dialect)
        if alike:
            hint = f"they are fields of {' and '.join(alike[:8])}: --message NAME"
            report.add(DOCUMENT_MESSAGE, fields.place, "no text near these fields names a message", hint)
            return
    if found:
        text = f"no text near these fields names a message of {dialect.name} that has them"
        report.add(DOCUMENT_WITHOUT_FIELDS, found[0][0].place, text, "name it above them, or give --message NAME")
        return
    text = f"the document has no table or list of fields of a message of {dialect.name}"
    hint = "it has columns such as | Field | Value source |, or items of the form - `field`: value"
    report.add(DOCUMENT_WITHOUT_FIELDS, Place(path), text, hint)
