"""The messages that a statement may be about which names no field."""

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.statements.subjects import subjects
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.pattern import pattern

_MOST = 3
"""Messages that may be meant; of more than these nothing is said."""


def meant(reading: Reading, span: Span, offset: int) -> tuple[WireMessage, ...]:
    """Return the messages of the sentence or the row around a character, else those of the surroundings."""
    is_listed = span.kind in (PassageKind.ROW, PassageKind.ITEM)
    low, high = (0, len(span.text)) if is_listed else span.bounds(offset)
    if any(span.sentence.within(low, high, "CV")):
        return ()  # something else that has a name
    if span.kind is PassageKind.ROW and (pattern("[FP]").search(span.text) or not _FIRST_COLUMN.match(span.text)):
        return ()  # what is said of a field, or of something else
    own = tuple(dict.fromkeys(name for _, name in span.named(low, high)))
    if own:
        return tuple(reading.messages[name] for name in own) if len(own) <= _MOST else ()
    if not _SEVERAL.search(span.text, low, offset):
        return ()
    found, _ = subjects(reading, span, offset)
    return found if len(found) <= _MOST else ()


_FIRST_COLUMN = pattern(r"\|?\s*M\b")
_SEVERAL = pattern(r"\bP(?:, (?:and )?| and )P\b")
"""Several words that are names of fields: together they hardly are anything else."""
