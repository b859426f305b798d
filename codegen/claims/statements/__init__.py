"""Statements about messages, fields and entries, read wherever they stand: sentences, items, rows, comments, data.

``terms`` makes a short text of each part in which names, types, units and numbers are single letters; ``spans`` says
which messages a part may be about; the other modules each know what is said of one kind of thing and compare it.
"""

from bisect import bisect_left
from collections.abc import Callable, Iterator

from codegen.claims.parts.span import Span, head_of
from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import is_aside, is_denial, is_own_column
from codegen.claims.rules import MESSAGE_ID, SCALING
from codegen.claims.statements import (
    absent,
    amounts,
    commands,
    entries,
    epochs,
    facts,
    lengths,
    limits,
    masks,
    messages,
    nouns,
    order,
    placed,
    sizes,
    tables,
    types,
    units,
    unknown,
)
from codegen.claims.statements.no_field import units as units_of_none
from codegen.claims.statements.scaling import by_frame, read_out, steps
from codegen.claims.statements.senses import stated
from codegen.claims.statements.unnamed import described, elements
from codegen.claims.statements.values import effects, short_names, special, tenfold, unfilled, worded
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.pattern import pattern
from codegen.source import Place

_CHECKS: tuple[tuple[Callable[[Reading, Span], Iterator[Diagnostic]], str, str], ...] = (
    (types.check, "FP", "T"),
    (lengths.check, "FP", ""),
    (units.check, "FP", "UNQ"),
    (read_out.check, "FP", "U"),
    (steps.check, "FP", "UQ"),
    (by_frame.check, "FP", "U"),
    (epochs.check, "FP", "N"),
    (unknown.check, "FP", "NS"),
    (absent.check, "FP", "NS"),
    (unfilled.check, "NS", ""),
    (effects.check, "NS", ""),
    (amounts.check, "Q", "N"),
    (limits.check, "FP", "NQ"),
    (facts.check, "FP", ""),
    (stated.check, "FPM", ""),
    (order.check, "FP", ""),
    (masks.check, "V", "N"),
    (messages.check, "N", ""),
    (sizes.check, "N", ""),
    (nouns.check, "UTN", ""),
    (described.check, "T", ""),
    (elements.check, "U", ""),
    (lengths.sized, "FP", "N"),
)
"""The checks, each with letters of terms: a part needs one of the first, and one of the second if there are any."""
_HELD = pattern(r"M \((?:id )?#?$")
_FURTHER = pattern(r", (?:of which|so|(?:and )?we|(?:and |but |while )?[FP] (?:is|are|has|have|goes|comes)) ")
"""The beginning of a further statement in a sentence."""


def _is_aside(span: Span, found: Diagnostic) -> bool:
    """Return whether the sentence of a finding is about other things than the messages of the dialect."""
    if span.is_code and not span.is_comment:
        return False
    offsets = span.sentence.offsets
    at = bisect_left(offsets, found.place, key=span.place)  # places follow one another as offsets do
    if at == len(offsets) or span.place(offsets[at]) != found.place:
        return False
    offset = offsets[at]
    if span.kind is PassageKind.ROW:
        return is_own_column(head_of(span, offset))
    if found.rule is MESSAGE_ID and _HELD.search(span.text, max(offset - len("M (id "), 0), offset):
        return False  # whatever the sentence says, "NAME (5)" gives it that id
    low, high = span.bounds(offset)
    further = _FURTHER.search(span.text, offset, high)
    high = further.start() if further is not None else high  # what somebody does besides is not what is said
    return is_aside(span.text[low:high]) or is_denial(span.text[low:high])


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every statement of a document that the dialect contradicts."""
    parts = spans(reading)
    scaled: set[Place] = set()
    for span in parts:
        letters = {term.letter for term in span.sentence.terms.values()}
        for find, names, facts_of in _CHECKS:
            if not letters.isdisjoint(names) and (not facts_of or not letters.isdisjoint(facts_of)):
                said = [found for found in find(reading, span) if not _is_aside(span, found)]
                scaled.update(found.place for found in said if found.rule.id == SCALING.id)
                yield from said
    yield from tables.check(reading, parts)
    yield from placed.check(reading, parts)
    yield from commands.check(reading, parts)
    values = [*entries.check(reading, parts)]
    yield from values
    told = {found.place for found in values}
    yield from entries.constants(reading, parts)
    yield from short_names.check(reading, parts)
    for span in parts:
        further = (
            *units_of_none.check(reading, span),
            *tenfold.check(reading, span, scaled),
            *worded.check(reading, span, told),
            *special.check(reading, span),
        )
        yield from (found for found in further if not _is_aside(span, found))
