"""The evidence for a finding: how the words that were compared are tied to the name that they are said of.

A finding is certain only where the structure of the document ties them: a cell below a heading that says what is in it,
an item or a declaration that begins with the name, or a name and a value with nothing between them but a few words of a
closed list. Whatever else was understood of a text is likely at best.
"""

from bisect import bisect_left
from collections.abc import Iterator

from codegen.claims.evidence.heads import is_headed
from codegen.claims.evidence.kinds import FIRM, Evidence
from codegen.claims.evidence.names import of_entry, of_field, of_message
from codegen.claims.evidence.tied import around
from codegen.claims.parts.span import Span
from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import ASKED, CHANGED, MISTAKEN, OWN, PAST, PROPOSED, REPLACED, SUPPOSED, words
from codegen.claims.rules import ENTRY_VALUE, SENTINEL
from codegen.claims.statements.entries import is_borne_out
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.once import once
from codegen.pattern import pattern

__all__ = ["FIRM", "Evidence", "evidence_of", "spans_at"]

_OWN_RULES = frozenset((
    "claim-arithmetic", "claim-field", "claim-id-taken", "claim-unsendable-message", "claim-flag-of-several-bits",
    "claim-text-contradicts-invalid", "claim-defined-twice", "claim-cast-to-sentinel",
))  # fmt: skip
_SUBJECT = pattern(r"(?P<first>[A-Z][A-Za-z0-9_]*)(?:\.(?P<field>\w+))?(?:: (?P<entry>[A-Z][A-Z0-9_]+) is\b)?")
_IN = pattern(r"\bin (?P<first>[A-Z][A-Z0-9_]*)\.(?P<field>\w+)(?P<entry>\b)")
_HEDGED = words(
    *(REPLACED, PAST, CHANGED, MISTAKEN, SUPPOSED, ASKED, r"\bclaim", r"\baccording\b", r"\bno longer\b"),
    *(r"\bprivate\b", r"\bcustom\b", r"\binternal"),
)
"""Words of a sentence that make it doubtful whether it claims a value of the dialect's field."""
_DENIED = words(
    r"\bnot (?!known|available|used|provided|set|supported|measured|given|present|valid|fitted|signed|needed)",
    *(r"n't\b", r"\bnever\b"),
)
"""Words that deny the clause in which they stand."""
_PLANNED = words(PROPOSED)
"""The same, unless the document defines the message itself."""
_OWN = words(OWN)
"""Words of somebody's own things: the name of a message or an entry beside a number goes for itself."""
_COMPARED = words(r"\blike\b", r"\bthan\b", r"\bvs\b", r"\binto\b", r"\bonly\b", r"\bhere\b", r"\bthere\b")
"""The same up to the end of a clause."""
_COMMA = pattern(r"[,;]")
_CLAUSE = pattern(r"[,;.()|]")
_ABSENT = pattern(
    r"\b(?:unknown|invalid|missing|absent|unused|unset|n/a|no (?:data|value|sensor|estimate|fix|\w+)"
    r"|not (?:known|available|provided|used|supplied|measured|set|supported|valid|fitted|present))\b"
)


def evidence_of(reading: Reading, finding: Diagnostic) -> Evidence:
    """Return the firmest kind of evidence for a finding among the parts of the document at its place."""
    if finding.rule.id in _OWN_RULES or finding.message.startswith(("the struct of ", "the fields of ")):
        return Evidence.DEFINITION
    found = [_of_span(reading, span, at, finding) for span, at in spans_at(reading, finding)]
    return min(found, key=list(Evidence).index, default=Evidence.WORDS)


@once
def _by_line(reading: Reading) -> dict[int, list[Span]]:
    """The parts of a document by each of their lines."""
    lines: dict[int, list[Span]] = {}
    for span in spans(reading):
        ends = [span.place(offset).line for offset in (*span.sentence.offsets, 0, len(span.text) - 1)]
        for line in range(min(ends), max(ends) + 1):
            lines.setdefault(line, []).append(span)
    return lines


def spans_at(reading: Reading, finding: Diagnostic) -> Iterator[tuple[Span, int]]:
    """The parts in which a finding is, each with the offset of the term there, or of the first behind it."""
    for span in _by_line(reading).get(finding.place.line, []):
        terms = span.sentence.offsets
        index = bisect_left(terms, finding.place, key=span.place)  # places follow one another as offsets do
        if index < len(terms) and span.place(terms[index]).line == finding.place.line:
            yield span, terms[index]


def _of_span(reading: Reading, span: Span, at: int, finding: Diagnostic) -> Evidence:
    low, high = around(span, at)
    end = _CLAUSE.search(span.text, at + 1, high)
    clause = end.start() if end is not None else high
    start = max((each.end() for each in _COMMA.finditer(span.text, low, at)), default=low)
    if _HEDGED.search(span.text, low, high) or _DENIED.search(span.text, start, clause):
        return Evidence.WORDS
    if not reading.proposed and _PLANNED.search(span.text, low, high):
        return Evidence.WORDS
    if finding.rule.id == SENTINEL.id and not _says_unknown(span, at):
        return Evidence.WORDS
    subject = _SUBJECT.match(finding.message) or _IN.search(finding.message)
    if subject is None:
        return Evidence.WORDS
    name, field, entry = subject.group("first", "field", "entry")
    if finding.rule.id == ENTRY_VALUE.id:
        if entry and is_borne_out(reading, span, name, field):
            return Evidence.LIST
        return of_entry(reading, span, at, entry or name, finding.rule.id)
    if field is not None and (_COMPARED.search(span.text, low, clause) or _OWN.search(span.text, low, clause)):
        return Evidence.WORDS
    if field is not None:
        return of_field(reading, span, at, name, field, finding.rule.id)
    return of_message(reading, span, at, name, finding.rule.id)


def _says_unknown(span: Span, at: int) -> bool:
    """Return whether the heading of a column, the row or the sentence says that a value means unknown."""
    is_row = span.kind is PassageKind.ROW
    if is_row and is_headed(span, at, SENTINEL.id):
        return True
    low, high = (0, len(span.text)) if is_row else around(span, at)
    return _ABSENT.search(span.text, low, high) is not None
