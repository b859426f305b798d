"""Units in comments of lines that read a field out of a payload or fill one: "alt: p.getInt16(14), // decimetres".

Where the line scales the number that it reads, the comment may tell the unit before or after that, so only what fits
neither is found: "distance: p.getUint16(18) * 100, // m" of a field in dam.
"""

from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from codegen.claims.parts.span import Span, is_data
from codegen.claims.reading import Reading
from codegen.claims.rules import UNIT, as_sure
from codegen.claims.statements.fields import named, number
from codegen.claims.statements.scaling.factors import turns
from codegen.claims.statements.scaling.field_units import has_unit, shown_units
from codegen.claims.statements.subjects import about
from codegen.diagnostics import Diagnostic
from codegen.model.dialect.dialect import WireField
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_COMMENT = pattern(r" ?(?://|/\*|# )[/!<*]?\s*")
_FILLED = pattern(r"\s?[:=](?!=)\s?")
_READS = pattern(
    r"(?:\bp|\bbuf\w*|\bdata|payload|bytes|view|\braw|msg|\bb)(?:\.(?:get|read)[a-z]*\d*(?:le|be)?\(|\[)N"
    r"|(?:get|read|unpack|_at|from|[lb]e|int|u|i|f)_?\w*\((?:[^()]*, )?N\b|unpack_from\([^()]*\bN\)"
)
"""A call or an index that takes a number out of some bytes."""
_BRACKETS = pattern(r"\([^()]*\)|\[[^\[\]]*\]")
_SCALED = pattern(r"(?: as [a-zT0-9]+)? ?(?P<how>[*/]) ?(?P<number>N)$")
_ARITHMETIC = pattern(r"[-+*/%&|?~^]|<<|>>")
_MEMBER = pattern(r"(?P<of>[a-z_]\w*)(?:\.|->)$")
_OWN_THINGS = frozenset((
    "self", "this", "state", "out", "result", "our", "cfg", "config", "ui", "row", "info", "log", "status", "own",
    "sample", "ctx", "store", "model", "view",
))  # fmt: skip
"""Objects whose members are somebody's own, whatever they are called."""
_SAID = pattern(
    r"(?:(?:message|raw|wire|field)(?: unit)? ?)?"
    r"(?:(?:->|\u2192|=|=>|in|now|to|gives|is|as|unit:|T,?) ?){0,3}(?P<unit>U)"
    r"(?=\s*(?:[,.;)]|\*/|$|and\b|as\b|above\b|from\b|[a-z]{3,}))"
)


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """The unit of a line of code that tells it in its comment."""
    if not span.is_code or span.is_comment or is_data(span):
        return
    comment = _COMMENT.search(span.text)
    said = _SAID.match(span.text, comment.end()) if comment is not None and comment.start() else None
    if comment is None or said is None:
        return
    names = [at for at, _ in span.sentence.within(0, comment.start(), "FP")]
    if not names or len({named(span.sentence.term(at)).name for at in names}) > 1:
        return
    at, unit = names[-1], span.sentence.term(said.start("unit")).value
    filled = _FILLED.match(span.text, at + 1)
    if filled is None or not isinstance(unit, Unit):
        return
    factor = _factor(span, at, filled.end(), comment.start())
    one = about(reading, span, at)
    if factor is None or one is None or one.message not in (*span.topic.above, *span.topic.headings):
        return
    if one.is_wrong(partial(_fits, unit=unit, factor=factor)):
        written = span.sentence.term(said.start("unit")).written
        scaled = f" and {factor} of that is none either" if factor not in (0, 1) else ""
        text = f"{one.name} is in {shown_units(one.field)}, not {written}{scaled}"
        place = span.place(said.start("unit"))
        yield reading.found(as_sure(UNIT, is_sure=False), place, f"{one.name} in {written}", text)


def _fits(field: WireField, unit: Unit, factor: Fraction) -> bool:
    """Return whether a unit is that of a field, or of its number times a factor; of no factor it is 0."""
    return has_unit(field, unit) or (factor not in (0, 1) and turns(field, unit, factor))


def _factor(span: Span, at: int, start: int, end: int) -> Fraction | None:
    """The factor of the number that a line reads out; 0 where it fills a field; None where it does neither."""
    code = span.text[start:end].rstrip(" ,;})" if span.text.count("(", start, end) == 0 else " ,;}")
    reads = _READS.search(code)
    if reads is None:
        member = _MEMBER.search(span.text, max(at - 24, 0), at)
        is_filled = member is not None and member["of"] not in _OWN_THINGS and "=" in span.text[at + 1 : start]
        return Fraction(0) if is_filled and pattern(r"[a-zN(]").search(code) else None
    bare = _BRACKETS.sub("", _BRACKETS.sub("", _BRACKETS.sub("", code)))
    scaled = _SCALED.search(bare)
    if _ARITHMETIC.search(bare, 0, scaled.start() if scaled is not None else len(bare)):
        return None
    if scaled is None:
        return Fraction(1)
    last = code.rindex("N")
    value = number(span.sentence.term(start + last))
    if not value or isinstance(value, float):
        return None
    return 1 / Fraction(value) if scaled["how"] == "/" else Fraction(value)
