"""Lists of places on the wire without a word for it: "33 `type`", "8..9 `temperature`", one number before each field.

What the numbers are, most of them tell: where more than half are the offsets of their fields, all are meant to be.
"""

from collections.abc import Iterator, Sequence
from itertools import groupby

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.rules import OFFSET, as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.subjects import About, about
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.pattern import pattern

_PLACED = pattern(
    r"[\s*/#|-]*(?:bytes? |offset )?(?P<at>N)(?:\s?(?:\.\.\.?|-|\u2013"
    r"|to) ?N)?[\s:|.)=\u2013-]{0,5}(?:T )?(?P<name>[FP])(?!\w)"
)
_FEWEST = 3
"""Right ones that make a list one of offsets."""


def check(reading: Reading, parts: Sequence[Span]) -> Iterator[Diagnostic]:
    """Every wrong one of a list of offsets."""
    for _, run in groupby(parts, lambda span: (span.is_code, span.is_comment or span.kind, span.topic.above[:1])):
        told = [each for span in run if (each := _told(reading, span)) is not None]
        wrong = [each for each in told if not _is_right(*each[:2])]
        if len(told) - len(wrong) < _FEWEST or 2 * len(wrong) >= len(told):
            continue
        for one, value, span, at in wrong:
            text = f"{one.name} begins at byte {one.field.offset}, not {value}"
            yield reading.found(as_sure(OFFSET, is_sure=one.is_sure), span.place(at), f"{one.name} at {value}", text)


def _is_right(one: About, value: int) -> bool:
    return not one.is_wrong(lambda field: field.offset == value)


def _told(reading: Reading, span: Span) -> tuple[About, int, Span, int] | None:
    """The field that a line begins with behind a number."""
    if span.is_code and not span.is_comment:
        return None
    if not span.is_comment and span.kind not in (PassageKind.ITEM, PassageKind.ROW):
        return None
    found = _PLACED.match(span.text)
    value = number(span.sentence.term(found.start("at"))) if found is not None else None
    one = about(reading, span, found.start("name")) if found is not None else None
    if found is None or one is None or value is None or value != int(value) or value < 0:
        return None
    return one, int(value), span, found.start("at")
