"""Numbers that a document gives to one message while they are right for another one that it names."""

from codegen.claims.reading import Reading, parts_at
from codegen.diagnostics import Diagnostic
from codegen.load.prose import CodeBlock, PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.model.price import HEAD_V1, HEAD_V2
from codegen.pattern import pattern

_CLAIMED = pattern(r", not (\d+)\b")
_UNIT = pattern(r"\b(?:bytes?|octets?|B)\b|CRC|LEN|[Ll]en(?:gth)? ?[=:]")
_BYTES = pattern(r"\b(?:bytes?|octets?|long|length|size)\b")
_LINES = 4
"""Lines of code above a number in which the name of its type or constant may stand."""


def is_right_for_another(reading: Reading, finding: Diagnostic) -> bool:
    """Return whether the number of a finding is about another message than the one that was taken for its subject.

    It is where a length without a unit stands in a section that does not name the message; where neither its line nor
    the heading above names that one, and the number is right for another that the document names; or where a number
    taken for the id, or for the length of a field, is the length of the message, and bytes are spoken of.
    """
    claimed = _CLAIMED.search(finding.message)
    name, _, field = finding.message.partition(" ")[0].partition(".")
    message = reading.messages.get(name)
    if claimed is None or message is None:
        return False
    number, line = int(claimed[1]), _words_at(reading, finding)
    if (
        finding.rule.id == "claim-message-size"
        and _UNIT.search(line) is None
        and not _is_in_section(reading, name, finding)
    ):
        return True
    if field:
        return "bytes" in finding.message and number in (message.base_length, message.length)
    if finding.rule.id == "claim-message-id" and number in (message.base_length, message.length):
        return _BYTES.search(line) is not None
    if any(name in words for words in (line, *list(_headings_above(reading, finding.place.line).values())[-1:])):
        return False
    others = dict.fromkeys(each for _, each in reading.sightings if each != name)
    return any(_is_right(finding.rule.id, reading.messages[each], number) for each in others)


def _headings_above(reading: Reading, line: int) -> dict[int, str]:
    headings = (each for each in reading.prose.passages if each.kind is PassageKind.HEADING and each.place.line < line)
    return {each.place.line: each.text for each in headings}


def _is_in_section(reading: Reading, name: str, finding: Diagnostic) -> bool:
    """Return whether a heading names a message, or the text since the last one does."""
    line = finding.place.line
    headings = _headings_above(reading, line)
    since = max(headings, default=0)
    return any(since <= at <= line for at, each in reading.sightings if each == name) or any(
        name in text for text in headings.values()
    )


def _is_right(rule: str, message: WireMessage, number: int) -> bool:
    if rule == "claim-message-id":
        return message.id == number
    if rule == "claim-crc-extra":
        return message.crc_extra == number
    lengths = (message.base_length, message.length)
    return number in (*lengths, *(head + length for head in (HEAD_V1, HEAD_V2) for length in lengths))


def _words_at(reading: Reading, finding: Diagnostic) -> str:
    """Return the line of code with those above it, or the text of the passage, in which a finding is."""
    found = []
    for part in parts_at(reading, finding.place.line):
        if isinstance(part, CodeBlock):
            at = finding.place.line - part.place.line
            found += [line.text for line in part.lines[max(at - _LINES, 0) : at + 1]]
        else:
            found.append(part.text)
    return "\n".join(found)
