"""Claims that a message is never shortened on the wire: "will not be truncated"."""

import re
from collections.abc import Iterator

from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.load.prose import Passage
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.pattern import pattern

RULE = Rule(
    "claim-truncation",
    "A document says that a message is not truncated, but its last field on the wire is zero when there is nothing to "
    "say, and MAVLink 2 cuts the zeros at the end of a payload. Only a last field that cannot be zero prevents it. "
    "It is likely, not certain: what is sent may never be zero there.",
    Severity.WARNING,
    remedy="say that MAVLink 2 cuts the zeros at its end, or waive it if the field is never 0",
)

_NOT_CUT = pattern(
    r"(?P<name>\b[A-Z][A-Z0-9_]{2,60})?\s?(?:\(?#?\d{1,8}\)?\s)?(?P<message>(?<!\w)messages?)?\s"
    r"(?:will not|won't|cannot|can't|can not|is not|isn't|is never|are never|will never|never gets?)\s"
    r"(?:be\s)?(?:zero[- ]byte[- ]|zero[- ]|byte[- ])?truncat(?:ed|able)",
)
_ZERO_WORDS = pattern(r"\b(?:set to|value of|should be|filled with|is|are|use) (?:0|zeros?)\b", re.IGNORECASE)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every such statement about a message."""
    for passage in reading.prose.passages:
        if "truncat" not in passage.text:
            continue
        for found in _NOT_CUT.finditer(passage.text):
            if not (found["name"] or found["message"]):
                continue
            message = _subject(reading, passage, found)
            if message is None:
                continue
            last = message.fields[-1]
            reason = _why_zero(last)
            if reason is not None:
                text = f"{message.name} is truncated in MAVLink 2: it ends with {last.name}, {reason}"
                start = found.start("name") if found["name"] else found.start("message")
                related = [(last.definition.place, f"{last.name} is the last field on the wire")]
                if last.definition.place.file != reading.prose.path:
                    related = []
                words = f"{message.name} {found[0].strip()}"
                yield reading.found(RULE, passage.place_at(start), words, text, None, related)


def _subject(reading: Reading, passage: Passage, found: "re.Match[str]") -> WireMessage | None:
    """The message that is named, or else the one that the document has defined last."""
    if found["name"] and found["name"] in reading.messages:
        return reading.messages[found["name"]]
    if not found["message"]:
        return None
    line = passage.place_at(found.start()).line
    before = [message for message in reading.proposed if message.definition.place.line < line]
    return before[-1] if before else None


def _why_zero(field: WireField) -> str | None:
    """Return the reason why the last byte of a field can be zero, in words; None where none is known."""
    sentinel = field.sentinel
    if sentinel is not None and sentinel.values[-1] == 0:
        return "of which what is unknown is 0" if field.is_array else "which is 0 when it is unknown"
    if _ZERO_WORDS.search(field.definition.description):
        return "which its description sets to 0"
    if field.definition.is_extension:
        return "an extension, which is 0 when a sender does not know it"
    if field.definition.is_bitmask or (field.type.is_integer and field.type.size > 1):
        return f"a {field.type.name} whose highest byte is 0 for small values"
    return None
