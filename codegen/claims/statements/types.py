"""Types that are said of fields: "an unsigned 16-bit integer", "array of 4 floats"."""

import re
from collections.abc import Collection, Iterator
from itertools import accumulate

from codegen.claims.layout import typed
from codegen.claims.parts.sentence import StatedType
from codegen.claims.parts.span import Span, is_data
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import (
    CHANGED,
    COMPARED,
    CONDITIONAL,
    DENIED,
    MISTAKEN,
    OWN,
    PAST,
    REPLACED,
    SUPPOSED,
    TEMPORARY,
    is_excepted,
    words,
)
from codegen.claims.rules import TYPE, as_sure
from codegen.claims.statements.fields import Said, claimed, made_of, named, said_of_fields, stated_type
from codegen.claims.statements.subjects import About, about
from codegen.diagnostics import Diagnostic
from codegen.model.dialect.dialect import WireField
from codegen.pattern import pattern

_IDLE = frozenset((
    "is", "are", "as", "an", "a", "of", "type", "types", "stored", "sent", "encoded", "coded", "in", "the", "field",
    "fields", "both", "all", "each", "every", "also", "only", "just", "declared", "defined", "transmitted", "carried",
    "array", "single", "M", "little", "endian", "now", "still", "really", "actually", "has", "have", "use", "uses",
    "with", "fits", "into", "be", "must", "should", "extension", "wire", "on", "its", "plain", "simple", "one",
    "three", "named", "value", "values", "number", "numbers", "member", "data", "set", "to", "travel", "travels", "u",
    "q", "U", "N", "E", "holds", "hold", "contains", "entries", "elements",
))  # fmt: skip
_NOT = words(
    DENIED, REPLACED, PAST, CHANGED[:2], MISTAKEN, SUPPOSED, COMPARED, CONDITIONAL[:1], OWN[:1], TEMPORARY[:1],
    r"\bcast", r"\bconvert", r"\bcopied\b", r"\bread (?:in|as)", r"\btaken as\b", r"\bnext to\b", r"\bbesides?\b",
    r"\bfrom\b", r"\bpack(?:ed)? into\b",
    r"\b(?:and|while|whereas|but) (?:the|its|their) ", r", the \w",
)  # fmt: skip
_BEFORE = pattern(
    r"T (?:fields?|values?|arrays?|members?|called|named|in|for|[-\u2013:]|(?:fields?|arrays?|values?) (?:called"
    r"|named)|(?:elements?|values?|entries) (?:of|in)(?: the)?)? ?$|\bT $"
)
_AFTER = pattern(r" (?:buffer|here in|in (?:our|my|the (?:log|app|csv|database|code))\b)")
_NO_WIRE = ("python", "py", "ts", "typescript", "js", "javascript", "tsx")


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every type of a part."""
    for said in said_of_fields(span):
        if is_excepted(span.text, said.start):
            continue
        yield from _type(reading, said)
        yield from _type_before(reading, said)


def has_type(field: WireField, stated: StatedType) -> bool:
    """Return whether a type is that of a field; for an array the type of its elements is enough."""
    own = field.type
    if stated.length is not None and (not field.is_array or stated.length != field.count):
        return False
    sign = {"u": "u", "i": "i", "f": "f", "d": "f", "c": None}[own.name[0]]
    if own.name == "char":
        return stated.bits == 8 and stated.sign != "f"
    if stated.name == "char":
        return False
    if stated.bits == 8 and stated.name is None and field.is_array:
        return own.size == 1
    return stated.bits == 8 * own.size and (stated.sign is None or stated.sign == sign)


def _is_plain(gap: str) -> bool:
    """Return whether only words that introduce a type, or that say nothing else, stand between a name and its type."""
    if pattern(r"[;.|]").search(gap):
        return False
    return made_of(gap, _IDLE) or (len(gap) < _LONG_GAP and _LEADS.search(gap) is not None and not _OTHER.search(gap))


_LONG_GAP = 70
_LEADS = pattern(r"(?:\b(?:is|as|are|an?|type|it is|comes|goes|arrives|travels|in|=|being|the) |[:,(=] ?)$")
_OTHER = pattern(
    r"[FPEVCNQS]|\b(?:copy|copied|keep|kept|store|stored|read|cast|log|logs|logged|written|saved|turn|turned|hold|held"
    r"|variable|local|our|we|us|by us|here|driver|sensor|register|message|struct|database|column|file|needs?|wants?"
    r"|expects?|treat|treated|give|gives|gave|takes?|sum|count|index|length|size|prefix|each|first|last|bit|enum)\b"
)


def _is_foreign(span: Span, stated: StatedType, offset: int) -> bool:
    """Return whether a word is a type of the code's own language, and not one of the wire."""
    if span.language in ("kotlin", "java", "swift", "cs", "csharp", "dart") and stated.name in (
        "float",
        "double",
        "char",
    ):
        return True
    comment = pattern(r"//|#|/\*").search(span.text)
    is_comment = span.is_comment or (comment is not None and comment.start() < offset)
    return span.language in _NO_WIRE and not is_comment and stated.name in ("float", "double", "char")


_OF_ANOTHER = pattern(r", (?:\w+ )*[a-z]{3,} = ?$|\band (?:[a-z]+ )*[a-z]{3,}: ?$|\bone of (?:the )?$")
"""Another thing that is named behind fields, "x y z, covariance = 36 doubles", or several, "one of three bytes"."""


_MEANS = pattern(r"\bN (?:is|means|=|:) (?:an? )?$")
"""Between a field and a word that is a value's meaning: "`fix_type`: 5 is float", which is a kind of a solution."""


def _is_path(span: Span, offset: int) -> bool:
    """Return whether code converts to a type, ``u32::from(x)``, ``sum::<u32>()``, ``(T)(x)``, and declares nothing."""
    if not span.is_code or span.is_comment:
        return False
    if span.text.endswith("(", 0, offset) and _CASTS.match(span.text, offset + 1):
        return True
    return span.text.startswith("::", offset + 1) or span.text.endswith("::<", 0, offset)


_CASTS = pattern(r"\) ?[(\w&*]")
_TURNED = pattern(
    r"\b(?:widen|enlarg|extend|shrink|narrow|promot|convert|cast|turn|chang|mak|grow)\w* "
    r"(?:up )?(?:the |both |field |type of )*$"
)
"""Before a name of what is to be given another type: "may we widen F to T"."""
_TO = pattern(r"(?: (?:of|in) (?:the )?M)? (?:in)?to (?:an? )?$")


def _type(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    span = said.span
    for offset, term in span.sentence.within(said.end, said.until, "T"):
        if _is_path(span, offset):
            continue
        gap = span.text[said.end : offset]
        behind = span.text[offset + 1 :]
        if _MEANS.search(gap):
            continue
        is_turned = _TO.fullmatch(gap) and _TURNED.search(span.text, max(said.before, said.start - 40), said.start)
        if is_turned or _OF_ANOTHER.search(gap) or _is_of_line(said, offset, gap):
            return
        is_bounded = (
            (said.is_listed or len(gap) < 40)
            and pattern(r"[,(|:\[#/*\u2013-]\s*(?:(?:and )?(?:thus|hence|so|that is) )?$").search(gap)
            and pattern(r"\s*(?:[,)|;:.\]}]|$|\*/|U|in U)").match(behind)
        )
        if _NOT.search(gap) or _AFTER.match(behind) or not (_is_plain(gap) or is_bounded):
            return
        if (
            span.is_code
            and not span.is_comment
            and pattern(r"\s*=").match(gap)
            and not pattern(r"#|//|\*").search(gap)
            and not is_data(span)
        ):
            return
        if pattern(r"\s*[A-Za-z_]*\s?F").match(behind) and not pattern(r"\s*[,;]").match(behind) and _NEXT.search(gap):
            return  # "`a`, uint16 `b`", "`a` and a uint16 `b`"
        if pattern(r"(?:,| or|/| ?\|)? ?T|,? (?:or|and) T|::").match(behind):
            return  # a choice of types, or a conversion
        stated = stated_type(term)
        if _is_foreign(span, stated, offset):
            continue
        yield from _found(reading, said, offset, stated, term.written)
        return


_LEADING = pattern(r"\s*(?://+|\*|#)?\s*F ")
"""The name with which a comment of code begins."""


def _is_of_line(said: Said, offset: int, gap: str) -> bool:
    """Return whether a type in code belongs to another name of its line, or to another argument."""
    if not said.span.is_code:
        return False
    return ends_other(said.span, said.names, offset) if said.span.is_comment else _leaves_call(gap)


def ends_other(span: Span, names: Collection[int], offset: int) -> bool:
    """Return whether a type ends a comment that begins with another name: "// `a` the first, see `b` uint8_t"."""
    if span.text[offset + 1 :].strip():
        return False
    led = _LEADING.match(span.text)
    return led is not None and led.end() - 2 not in names


def _leaves_call(gap: str) -> bool:
    """Return whether brackets end behind a name that began before it: "[x a], [array of uint8_t]"."""
    return any(low < 0 for pair in ("[]", "()") for low in accumulate(_depths(gap, *pair)))


def _depths(text: str, start: str, end: str) -> Iterator[int]:
    return ((letter == start) - (letter == end) for letter in text)


_IS_ARRAY = pattern(r"\[|;")
_NEXT = pattern(r",|\b(?:and|plus|with)\b")


def _type_before(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """ "An int32_t `alt`", and declarations of C."""
    span = said.span
    lead = _BEFORE.search(span.text, max(said.before, said.start - 30), said.start)
    if lead is None or _NOT.search(span.text, max(said.before, lead.start() - 20), said.start):
        return
    offset = lead.start()
    stated, term_text = stated_type(span.sentence.term(offset)), span.sentence.term(offset).written
    if _is_path(span, offset) or _is_foreign(span, stated, offset):
        return
    is_of_several = len(said.names) > 1 or re.match(r" ?/ ?[a-z]\b", span.text[said.end : said.end + 4]) is not None
    if is_of_several and stated.length is not None and not _IS_ARRAY.search(term_text):
        stated = StatedType(stated.name, stated.bits, stated.sign)  # "two floats `a` and `b`" counts the fields
    elements = named(span.sentence.term(said.names[0])).elements
    if span.is_code and not span.is_comment and elements is not None:
        stated = StatedType(stated.name, stated.bits, stated.sign, elements)
    one = about(reading, span, said.names[0])
    if one is not None and _counts_fields(span, offset, one, stated):
        return
    if one is not None and one.is_wrong(lambda field: has_type(field, stated)):
        written = _spelled(stated, span.sentence.term(offset).written)
        text = f"{one.name} is {typed(one.field.definition)}, not {written}"
        yield reading.found(as_sure(TYPE, is_sure=one.is_sure), span.place(offset), f"{one.name} {written}", text)


def _spelled(stated: StatedType, written: str) -> str:
    if stated.name is None:
        return written
    return stated.name if stated.length is None else f"{stated.name}[{stated.length}]"


_AGAINST = pattern(r" (?:against|instead of|rather than|where|while) ")


def _is_contrast(said: Said, offset: int, one: About) -> bool:
    """Return whether the field's own type is told before another one: "32 bit here; in the report they are 16 bit"."""
    if _AGAINST.match(said.span.text, offset + 1) and not said.span.is_code:
        return True
    others = said.span.sentence.within(said.start - _BESIDE, offset, "T")
    return not said.is_listed and any(has_type(one.field, stated_type(term)) for _, term in others)


_BESIDE = 80


def _counts_fields(span: Span, offset: int, one: About, stated: StatedType) -> bool:
    """Return whether a number of elements counts fields: "`a`, `b` and `c`: three floats", "three floats `d_x/y/z`"."""
    if stated.length is None or one.field.is_array or pattern(r"\[|;").search(span.sentence.term(offset).written):
        return False
    single = StatedType(stated.name, stated.bits, stated.sign)
    alike = [field for field in one.message.fields if not field.is_array and has_type(field, single)]
    named_here = {term.written for _, term in span.sentence.within(0, len(span.text), "FP")}
    return has_type(one.field, single) and stated.length in (len(alike), len(named_here))


def _found(reading: Reading, said: Said, offset: int, stated: StatedType, words: str) -> Iterator[Diagnostic]:
    one = claimed(reading, said, offset, lambda field: has_type(field, stated))
    if one is not None and _counts_fields(said.span, offset, one, stated):
        return
    if one is not None and not _is_contrast(said, offset, one):
        written = _spelled(stated, words)
        own = typed(one.field.definition)
        text = f"{one.name} is {own}, not {written}"
        yield reading.found(as_sure(TYPE, is_sure=one.is_sure), said.span.place(offset), f"{one.name} {written}", text)
