"""The evidence of what is said of a message, of an entry of an enum, and of a field."""

import re

from codegen.claims.enclosing import is_of_type
from codegen.claims.evidence.borne_out import (
    is_amount_of_entries,
    is_column_of_entries,
    is_counted,
    is_mapping_of_entries,
)
from codegen.claims.evidence.heads import is_headed
from codegen.claims.evidence.kinds import Evidence
from codegen.claims.evidence.tied import around, closed, is_alone, is_beside, is_clause, message_of, near
from codegen.claims.parts.sentence import NamedField
from codegen.claims.parts.span import Span, head_of, is_data
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import is_own_column
from codegen.claims.rules import SCALING, SIZE
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.once import once
from codegen.pattern import pattern


def of_message(reading: Reading, span: Span, at: int, name: str, rule: str) -> Evidence:
    """Return that of what is said of a whole message: its id, CRC_EXTRA, size."""
    if not span.is_code and span.text.endswith("M [", 0, at):
        return Evidence.WORDS  # "NAME [3]" may refer to a list of sources
    named = [offset for offset, term in span.sentence.within(*near(at), "MF") if message_of(term.value) == name]
    if span.kind is PassageKind.ROW:
        alone = [offset for offset in named if is_alone(span, offset)]
        is_only = {str(term.value) for _, term in span.sentence.within(*near(at), "M")} == {name}
        is_amount = pattern(r"\s*N bytes\s*").fullmatch(span.text[slice(*around(span, at))]) is not None
        is_of_field = (
            rule == SIZE.id and _names_field(span, reading.messages[name]) and not _OF_MESSAGE.search(head_of(span, at))
        )
        if is_of_field:
            return Evidence.WORDS
        if is_only and ((alone and is_headed(span, at, rule)) or (is_amount and rule == SIZE.id)):
            return Evidence.COLUMN
    if any(is_beside(span, offset, at) for offset in named):
        return _kind_of(span, min(named), at)
    topic = span.topic
    low, _ = around(span, at)
    others = {str(message_of(term.value)) for _, term in span.sentence.within(*near(at), "MC")} - {name}
    if not others and not span.is_code and _is_bound_above(reading, span, name) and closed(span.text[low:at]):
        return Evidence.ITEM if span.kind is PassageKind.ITEM else Evidence.PASSAGE
    if span.is_code and not span.is_comment and _is_constant(span, at, name):
        return Evidence.CODE
    if span.is_code and _ENTRY_OF_TABLE.fullmatch(span.text) and named:
        return Evidence.CODE
    if span.is_code and not named and topic.above[:1] and topic.above[0].name == name and closed(span.text[:at]):
        return Evidence.CODE
    return Evidence.WORDS


_OF_MESSAGE = pattern(r"payload|frame|packet|message|wire", re.IGNORECASE)


def _names_field(span: Span, message: WireMessage) -> bool:
    """Return whether a cell of a row is the name of a field of a message."""
    return any(
        isinstance(term.value, NamedField) and message.field(term.value.name) is not None and is_alone(span, offset)
        for offset, term in span.sentence.within(0, len(span.text), "FP")
    )


def _is_constant(span: Span, at: int, name: str) -> bool:
    """Return whether a line gives a number to a constant named after the message: ``HEARTBEAT_CRC: u8 = 50``."""
    tail = r"(?:_[a-z_]+)?[\"']?\s*(?::\s*\w+\s*)?[=:\s(\[]*$"
    return re.search(name.lower() + tail, span.source_text(0, at).lower()) is not None


_ENTRY_OF_TABLE = pattern(r"[\s{(\[]*(?:[N\d_]+[\s,:]*){1,6}[\s})\],]*(?://|/\*|#|--)\s*M\s*(?:\*/)?\s*")
"""A line of a table of numbers, with the name behind it."""


def of_entry(reading: Reading, span: Span, at: int, name: str, rule: str) -> Evidence:
    """Return that of the number of an entry."""
    terms = [(offset, term) for offset, term in span.sentence.within(*near(at), "VCM") if term.written == name]
    if span.kind is PassageKind.ROW:
        values = [offset for offset, _ in terms if is_alone(span, offset)]
        entries = [offset for offset, _ in span.sentence.within(*near(at), "V")]
        if values and len(entries) == 1 and (at in entries or is_headed(span, at, rule)):
            return Evidence.COLUMN if is_column_of_entries(reading, span, at) else Evidence.WORDS
    if not is_mapping_of_entries(reading, span):
        return Evidence.WORDS
    numbers = [offset for offset, _ in span.sentence.within(*near(at), "N")]
    places = [at] if at in numbers else numbers
    for offset, _ in terms:
        for number in places:
            if is_counted(span, number) or is_amount_of_entries(reading, span, number, offset):
                continue
            if is_beside(span, offset, number):
                return _kind_of(span, min(offset, number), at)
    return Evidence.WORDS


def of_field(reading: Reading, span: Span, at: int, message: str, field: str, rule: str) -> Evidence:
    """Return the evidence for a statement about a field, by how the place ``at`` is tied to the field's name."""
    terms = [
        (offset, term.value)
        for offset, term in span.sentence.within(*near(at), "FP")
        if isinstance(term.value, NamedField) and term.value.name == field
    ]
    for offset, value in terms:
        is_qualified = value.message == message or _is_of(span, offset, message)
        if value.message is not None and value.message != message:
            continue
        is_bound = is_qualified or _is_bound(reading, span, offset, message)
        if span.kind is PassageKind.ROW and is_bound and is_alone(span, offset) and is_headed(span, at, rule):
            return Evidence.COLUMN
        is_first = closed(span.text[:offset])
        is_listed = span.kind in (PassageKind.ITEM, PassageKind.ROW) or _DEFINES.match(span.text, offset) is not None
        is_own = is_bound and is_first and is_listed and not is_own_column(head_of(span, at))
        is_amount = span.kind is PassageKind.ROW and rule == SCALING.id  # one of two amounts is another thing's
        if is_own and not span.is_code and not is_amount and is_clause(span, offset, at):
            return Evidence.ITEM
        if not is_beside(span, offset, at, message):
            continue
        if is_qualified:
            return Evidence.BESIDE
        if is_bound and span.is_code:
            return Evidence.CODE
        if is_bound:
            return Evidence.SENTENCE if _names_before(span, offset, message) else Evidence.PASSAGE
    return Evidence.WORDS


_DEFINES = pattern(r"[FP](?: ?[,/&] ?[FP]| and [FP])* ?(?::|\u2013|- |= )")


def _is_of(span: Span, offset: int, message: str) -> bool:
    found = _OF.match(span.text, offset + 1)
    return found is not None and span.sentence.term(found.start("message")).value == message


_OF = pattern(r"(?: field)? of (?:the )?(?P<message>M)\b")


@once
def _headed(reading: Reading) -> frozenset[str]:
    """The messages that headings name: each for its own section, and not for the rest of the document."""
    headings = (part for part in reading.prose.passages if part.kind is PassageKind.HEADING)
    return frozenset(message.name for part in headings for message in reading.named(part))


def _is_bound_above(reading: Reading, span: Span, message: str) -> bool:
    """Return whether the headings, the words above a list, or else the whole document name only this message."""
    topic = span.topic
    if span.kind in (PassageKind.ITEM, PassageKind.ROW) and topic.above:
        return [each.name for each in topic.above] == [message]
    if topic.headings:
        return topic.headings[0].name == message
    return [each.name for each in topic.document] == [message] and message not in _headed(reading)


def _is_bound(reading: Reading, span: Span, offset: int, message: str) -> bool:
    """Return whether a field's name at this offset can only mean a field of this message."""
    names = [str(message_of(term.value)) for _, term in span.sentence.within(*near(offset), "MC")]
    if span.is_code:
        before = [str(message_of(term.value)) for _, term in span.sentence.within(0, offset, "MC")]
        if is_data(span) and before:
            return before[-1] == message
        return is_of_type(reading, span.place(offset), message)
    if names:
        return set(names) == {message}
    return _is_bound_above(reading, span, message)


def _names_before(span: Span, offset: int, message: str) -> bool:
    return any(message_of(term.value) == message for _, term in span.sentence.within(0, offset, "M"))


def _kind_of(span: Span, first: int, at: int) -> Evidence:
    if span.is_code:
        return Evidence.CODE
    is_item = span.kind in (PassageKind.ITEM, PassageKind.HEADING) and closed(span.text[: min(first, at)])
    return Evidence.ITEM if is_item else Evidence.BESIDE
