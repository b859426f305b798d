"""Rows with a column of factors: the unit beside them is the one that a number has after its factor."""

import re
from fractions import Fraction

from codegen.claims.parts.span import Span, head_of
from codegen.claims.statements.fields import number
from codegen.load.prose import PassageKind
from codegen.pattern import pattern

_TIMES = pattern(
    r"(?:(?:scal(?:e|ing)|conversion)(?: factor)?|factor|multipl(?:ier|y|ied)(?: (?:by|with))?|[*\u00d7x])",
    re.IGNORECASE,
)
_DIVIDED = pattern(r"(?:divisor|divided?(?: (?:by|with))?|[/\u00f7])", re.IGNORECASE)
_FACTOR = pattern(r"\s*(?P<how>[*\u00d7x/\u00f7]?) ?(?P<number>N)\s*")


def factor_beside(span: Span, at: int) -> Fraction | None:
    """Return what another cell of its row multiplies a number with, whose unit stands at an offset."""
    if span.kind is not PassageKind.ROW:
        return None
    for offset, term in span.sentence.within(0, len(span.text), "N"):
        head = head_of(span, offset).strip("*_` ")
        is_divided = _DIVIDED.fullmatch(head) is not None
        low, high = span.text.rfind("|", 0, offset) + 1, span.text.find("|", offset)
        found = _FACTOR.fullmatch(span.text, low, high if high >= 0 else len(span.text))
        value = number(term)
        if found is None or not value or low <= at < high or not (is_divided or _TIMES.fullmatch(head)):
            continue
        return 1 / Fraction(value) if is_divided or found["how"] in ("/", "\u00f7") else Fraction(value)
    return None
