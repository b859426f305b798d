"""Findings that are none: what a document cites, what it says of a nearer name, and what it says of its own types."""

import re
from bisect import bisect_right
from collections.abc import Iterator

from codegen.claims.enclosing import is_beside_type, is_of_other_type, members_of_type
from codegen.claims.other_subject import is_right_for_another
from codegen.claims.reading import Reading, parts_at, snake
from codegen.diagnostics import Diagnostic
from codegen.load.prose import CodeBlock, Passage, PassageKind
from codegen.once import once
from codegen.pattern import pattern
from codegen.source import Place

_CITED = pattern(r"(?:(?<=[\s(|\u2013\u2014])|^)[\"\u201c](?=\S)[^\"\u201c\u201d]{2,300}[\"\u201d](?=[\s.,;:!?)|]|$)")
_CAPITALS = pattern(r"(?<![\w.-])[A-Z][A-Z0-9]+(?:_[A-Z0-9]+)*(?![\w-])")
_GENERIC = pattern(
    r"(?:(?:MAVLINK|MSG|MESSAGE|IDS?|CRC|EXTRA|MIN|MAX|LEN|LENGTH|SIZE|BYTES|PAYLOAD|V[12]|[A-Z]|\d+)(?:_|$))+"
)
_OF_MEMBERS = frozenset(("claim-struct", "claim-unit", "claim-sentinel", "claim-offset"))
_NUMBERS = frozenset(("claim-message-id", "claim-crc-extra", "claim-message-size"))
_BETWEEN = pattern(
    r"[^\w.!?]*(?:(?:with|has|is|its|the|and|of|message|msg|number|no|id|crc|extra|crc_extra|seed|\d+)[^\w.!?]+)*",
    re.IGNORECASE,
)
_NEAR = 80
"""Characters before a number in which the name that it belongs to is looked for."""
_NEXT = 24
"""Characters behind a number in which its name may stand, "12 (NAME)"."""
_HALF = 2


def is_elsewhere(reading: Reading, finding: Diagnostic) -> bool:
    """Return whether a finding is about something other than the document's own statements about the dialect."""
    return (
        _is_cited(reading, finding.place)
        or finding.place.line in _lines_of_others(reading)
        or _is_number_of_section(reading, finding.place)
        or (finding.rule.id in _OF_MEMBERS and _is_taken_from(reading, finding.place))
        or (finding.rule.id in _NUMBERS and _is_of_nearer(reading, finding))
        or (finding.rule.id in (*_NUMBERS, "claim-struct") and is_right_for_another(reading, finding))
        or (finding.rule.id in _OF_MEMBERS and _is_own_member(reading, finding))
        or (finding.rule.id in _OF_MEMBERS and _is_own_argument(reading, finding))
        or (finding.rule.id in _OF_MEMBERS and _is_told_apart(reading, finding.place))
    )


@once
def _citations(reading: Reading) -> tuple[tuple[Place, Place], ...]:
    """Return the first and the last place of each passage of several words in quotation marks."""
    return tuple(
        (part.place_at(found.start()), part.place_at(found.end() - 1))
        for part in reading.prose.passages
        for found in _CITED.finditer(part.text)
        if " " in found[0].strip()
    )


@once
def _lines_of_others(reading: Reading) -> frozenset[int]:
    """The lines of sections and types that are said to be of no MAVLink message: "Raw frame (not MAVLink)"."""
    found: set[int] = set()
    level = 0
    for part in reading.prose.parts:
        if isinstance(part, Passage) and part.kind is PassageKind.HEADING and (not level or part.level <= level):
            level = part.level if _NO_MAVLINK.search(part.text) else 0
        elif level:
            found.update(range(part.place.line, part.last_line + 1))
        if isinstance(part, CodeBlock):
            found.update(_others_in(part))
    return frozenset(found)


def _others_in(code: CodeBlock) -> Iterator[int]:
    """The lines of the type below a comment of code that says so."""
    is_other = False
    for line in code.lines:
        is_other |= _NO_MAVLINK.search(line.text) is not None
        if is_other:
            yield line.place.line
            is_other = not line.text.lstrip().startswith("}")


_NO_MAVLINK = pattern(
    r"\b(?:not|no|non)[ -]MAVLink\b(?! (?:cameras?|components?|devices?|systems?|gimbals?|vehicles?)\b)", re.IGNORECASE
)


def _is_number_of_section(reading: Reading, place: Place) -> bool:
    """Return whether a number is the number of a section: "6.6 An unknown ..."."""
    parts = parts_at(reading, place.line)
    return any(isinstance(part, Passage) and part.place == place and _SECTION.match(part.text) for part in parts)


def _is_taken_from(reading: Reading, place: Place) -> bool:
    """Return whether a line of code copies a member of another object: its comment is about that object, then."""
    codes = (part for part in parts_at(reading, place.line) if isinstance(part, CodeBlock))
    return any(_TAKEN.match(code.lines[place.line - code.place.line].text) for code in codes)


def _is_told_apart(reading: Reading, place: Place) -> bool:
    """Return whether a comment tells what is on the wire behind a member's own unit, or before its own type."""
    for code in parts_at(reading, place.line):
        if isinstance(code, CodeBlock):
            at = place.line - code.place.line
            text = code.lines[at].text
            found = _ON_THE_WIRE.search(text)
            if found is not None and found.start() >= place.column - code.lines[at].place.column:
                return True
            above = code.lines[at - 1].text if at else ""
            if found is None and not _COMMENT.match(text) and _COMMENT.match(above) and _ON_THE_WIRE.search(above):
                return True
    return False


_ON_THE_WIRE = pattern(r"\b[Oo]n the wire (?:an?|it is|they are|in|as)\b", needs="n the wire")
_COMMENT = pattern(r"\s*(?://|#|\*|/\*)")
_SECTION = pattern(r"\d+(?:\.\d+)+\.?\s+(?:[A-Z][a-z]{2,}|An?) [a-z`]")
_TAKEN = pattern(r"\s*[A-Za-z_]\w*\s*[:=]\s*(?!self\.|this\.)[A-Za-z_]\w*\.[A-Za-z_]\w*\s*,")


def _is_cited(reading: Reading, place: Place) -> bool:
    if place.line in reading.cited:
        return True
    found = _citations(reading)
    index = bisect_right(found, place, key=lambda each: each[0]) - 1
    return index >= 0 and place <= found[index][1]


def _is_of_nearer(reading: Reading, finding: Diagnostic) -> bool:
    """Return whether a number stands beside another name, "OTHER_NAME (id 5)", than the finding gives it to."""
    before, behind = _around(reading, finding.place)
    own = finding.message.partition(" ")[0]
    names = [found for found in _CAPITALS.finditer(before) if not _GENERIC.fullmatch(found[0])]
    if not names or own in names[-1][0] or own in behind:
        return False
    return _BETWEEN.fullmatch(before, names[-1].end()) is not None


def _around(reading: Reading, place: Place) -> tuple[str, str]:
    """The characters before a place, of its passage or its block of code, and some of those behind it."""
    for part in parts_at(reading, place.line):
        if isinstance(part, Passage):
            if part.kind is PassageKind.ROW:
                continue
            offset = _offset(part, place)
            return part.text[max(offset - _NEAR, 0) : offset], part.text[offset : offset + _NEXT]
        index = place.line - part.place.line
        lines = part.lines[max(index - 2, 0) : index + 1]
        column = place.column - lines[-1].place.column
        before = "\n".join([*(line.text for line in lines[:-1]), lines[-1].text[:column]])
        return before[-_NEAR:], lines[-1].text
    return "", ""


def _offset(part: Passage, place: Place) -> int:
    """Return the offset of a place in the text of a passage, in characters."""
    start, at = part.anchors[max(bisect_right(part.anchors, place, key=lambda anchor: anchor[1]) - 1, 0)]
    return start + (place.column - at.column if place.line == at.line else 0)


def _is_own_member(reading: Reading, finding: Diagnostic) -> bool:
    """Return whether a declaration is in a type of the user's own, or in one whose members mostly are no fields."""
    message = reading.messages.get(finding.message.partition(".")[0])
    members = members_of_type(reading, finding.place)
    if message is None or not members:
        return False
    if is_beside_type(reading, finding.place, message.name):
        return True
    known = [name for name in members if message.field(name) or message.field(snake(name))]
    if len(known) < len(members) and is_of_other_type(reading, finding.place, message.name):
        return True
    return _HALF * len(known) < len(members)


@once
def _signatures(reading: Reading) -> tuple[tuple[int, frozenset[str]], ...]:
    """Return the line of each heading, with the names of the arguments if it is the signature of a function."""
    found = []
    for part in reading.prose.passages:
        if part.kind is PassageKind.HEADING:
            call = _SIGNATURE.search(part.text)
            names = frozenset(pattern(r"[A-Za-z_]\w*").findall(call["arguments"])) if call is not None else frozenset()
            found.append((part.place.line, names))
    return tuple(found)


_SIGNATURE = pattern(r"[a-z_]\w*\((?P<arguments>[^()]*)\)")


def _is_own_argument(reading: Reading, finding: Diagnostic) -> bool:
    """Return whether a name is that of an argument of the function that the section describes."""
    headings = _signatures(reading)
    index = bisect_right(headings, finding.place.line, key=lambda heading: heading[0]) - 1
    field = finding.message.partition(" ")[0].partition(".")[2]
    return index >= 0 and field in headings[index][1]
