"""Types and lengths that are said of fields: "an unsigned 16-bit integer", "array of 4 floats", "takes 64 bytes"."""

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from codegen.claims.layout import typed
from codegen.claims.reading import Reading
from codegen.claims.rules import TYPE, as_sure
from codegen.claims.statements.fields import Said, claimed, made_of, named, number, said_of_fields, stated_type
from codegen.claims.statements.sentence import StatedType
from codegen.claims.statements.spans import Span, about, is_data
from codegen.diagnostics import Diagnostic
from codegen.model.dialect.dialect import WireField

_IDLE = frozenset((
    "is", "are", "as", "an", "a", "of", "type", "types", "stored", "sent", "encoded", "coded", "in", "the", "field",
    "fields", "both", "all", "each", "every", "also", "only", "just", "declared", "defined", "transmitted", "carried",
    "array", "single", "M", "little", "endian", "now", "still", "really", "actually", "has", "have", "use", "uses",
    "with", "fits", "into", "be", "must", "should", "extension", "wire", "on", "its", "plain", "simple", "one",
    "three", "named", "value", "values", "number", "numbers", "member", "data", "set", "to", "travel", "travels", "u",
    "q", "U", "N", "E",
))  # fmt: skip
_NOT = re.compile(
    r"\bnot\b|n't\b|\bno longer\b|instead|rather|unlike|\bwas\b|\bwere\b|until|\bold\b|earlier|formerly|\bcast"
    r"|buffer|\bour\b|\bthan\b"
    r"|against|\bchanged\b|\bconvert|\bcopied\b|\bread into\b|\bwrong\b|\bif\b|\blike\b|\bwould\b|\bcould\b"
    r"|\bread as\b|\btaken as\b|\bfrom\b"
    r"|\bpack(?:ed)? into\b|\bmistake|\b(?:and|while|whereas|but) (?:the|its|their) |, the \w"
)
_BEFORE = re.compile(
    r"T (?:fields?|values?|arrays?|members?|called|named|in|for|[-\u2013:]|(?:fields?|arrays?|values?) (?:called"
    r"|named))? ?$|\bT $"
)
_AFTER = re.compile(r" (?:buffer|here in|in (?:our|my|the (?:log|app|csv|database|code))\b)")
_ELEMENTS = re.compile(
    r"N (?P<what>elements?|entries|values|items|numbers|slots|characters?|chars|letters|cells|cores|sectors"
    r"|bytes?|octets?|channels"
    r"|bins|places|components|samples|motors|sensors|measurements)\b(?! (?:of|per|behind|before|after|further"
    r"|more|a second|each|in a|at the|are|each))"
    r"(?P<per>(?:/| per | a )\w+)?"
)
_HOLDS = frozenset((
    "is", "are", "has", "have", "hold", "holds", "take", "takes", "carries", "contain", "contains", "with", "for",
    "an", "a", "array", "of", "up", "to", "at", "most", "all", "its", "the", "space", "room", "fixed", "length",
    "always", "exactly", "can", "carry", "list", "lists", "text", "string", "long", "limited", "cut", "maximum",
    "max", "field", "consists", "T", "U",
))  # fmt: skip
_LESS = re.compile(
    r"\b(?:first|last|lower|upper|only|some|least|more|less|fewer|about|other|remaining|own|our|often|used|uses"
    r"|not|never)\b|\busually\b"
)
_NO_WIRE = ("python", "py", "ts", "typescript", "js", "javascript", "tsx")


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every type and every length of a part."""
    for said in said_of_fields(span):
        yield from _type(reading, said)
        yield from _type_before(reading, said)
        yield from _length(reading, said)


def has_type(field: WireField, stated: StatedType) -> bool:
    """Whether a type is that of a field; of an array the type of its elements will do."""
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
    """Whether nothing stands between a name and its type but words that say so."""
    return made_of(gap, _IDLE) and re.search(r"[;.]", gap) is None


def _is_foreign(span: Span, stated: StatedType, offset: int) -> bool:
    """Whether a word is a type of the language of the code and not of the wire."""
    if span.language in ("kotlin", "java", "swift", "cs", "csharp", "dart") and stated.name in (
        "float",
        "double",
        "char",
    ):
        return True
    comment = re.search(r"//|#|/\*", span.text)
    is_comment = span.is_comment or (comment is not None and comment.start() < offset)
    return span.language in _NO_WIRE and not is_comment and stated.name in ("float", "double", "char")


def _type(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    span = said.span
    for offset, term in span.sentence.within(said.end, said.until, "T"):
        gap = span.text[said.end : offset]
        behind = span.text[offset + 1 :]
        is_bounded = (
            (said.is_listed or len(gap) < 40)
            and re.search(r"[,(|:\[#/*\u2013-]\s*$", gap)
            and re.match(r"\s*(?:[,)|;:.\]}]|$|\*/|U|in U)", behind)
        )
        if _NOT.search(gap) or _AFTER.match(behind) or not (_is_plain(gap) or is_bounded):
            return
        if (
            span.is_code
            and not span.is_comment
            and re.match(r"\s*=", gap)
            and not re.search(r"#|//|\*", gap)
            and not is_data(span)
        ):
            return
        if re.match(r"\s*[A-Za-z_]*\s?F", behind) and not re.match(r"\s*[,;]", behind) and "," in gap:
            return  # "`a`, uint16 `b`"
        if re.match(r"(?:,| or|/| ?\|)? ?T|,? (?:or|and) T", behind):
            return  # a choice of types
        stated = stated_type(term)
        if _is_foreign(span, stated, offset):
            continue
        yield from _found(reading, said, offset, stated, term.written)
        return


def _type_before(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """ "An int32_t `alt`", and declarations of C."""
    span = said.span
    lead = _BEFORE.search(span.text, max(said.before, said.start - 30), said.start)
    if lead is None or _NOT.search(span.text, max(said.before, lead.start() - 20), said.start):
        return
    offset = lead.start()
    stated = stated_type(span.sentence.term(offset))
    if _is_foreign(span, stated, offset):
        return
    elements = named(span.sentence.term(said.names[0])).elements
    if span.is_code and not span.is_comment and elements is not None:
        stated = StatedType(stated.name, stated.bits, stated.sign, elements)
    one = about(reading, span, said.names[0])
    if one is not None and one.is_wrong(lambda field: has_type(field, stated)):
        written = _spelled(stated, span.sentence.term(offset).written)
        text = f"{one.name} is {typed(one.field.definition)}, not {written}"
        yield reading.found(as_sure(TYPE, is_sure=one.is_sure), span.place(offset), f"{one.name} {written}", text)


def _spelled(stated: StatedType, written: str) -> str:
    if stated.name is None:
        return written
    return stated.name if stated.length is None else f"{stated.name}[{stated.length}]"


def _found(reading: Reading, said: Said, offset: int, stated: StatedType, words: str) -> Iterator[Diagnostic]:
    one = claimed(reading, said, offset, lambda field: has_type(field, stated))
    if one is not None:
        written = _spelled(stated, words)
        own = typed(one.field.definition)
        text = f"{one.name} is {own}, not {written}"
        yield reading.found(as_sure(TYPE, is_sure=one.is_sure), said.span.place(offset), f"{one.name} {written}", text)


def _length(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """Elements of an array, or bytes of a number."""
    span = said.span
    found = _ELEMENTS.search(span.text, said.end, said.until)
    is_all = found is not None and re.search(
        r"\b(?:all|array (?:with|of)|up to|at most) (?:its |the )?$", span.text[said.end : found.start()]
    )
    one = about(reading, span, said.names[-1]) if found is not None else None
    if found is None or one is None or len(said.names) > 1:
        return
    gap = span.text[said.end : found.start()]
    before = re.search(r"(?:\bin |\bthan )$", gap)
    is_listed = (
        said.is_listed
        and not re.search(r"\.\s", gap)
        and re.search(r"[,(|:/#*]\s*(?:up to |at most )?$", gap)
        and re.match(r"\s*(?:[,;.)|]|$|\*/|long)", span.text[found.end() :])
    )
    if (
        before
        or _LESS.search(gap)
        or _NOT.search(gap)
        or not ((made_of(gap, _HOLDS) and not re.search(r"[;.]", gap)) or is_listed or (is_all and one.field.is_array))
    ):
        return
    value = number(span.sentence.term(found.start()))
    what, field = found["what"], one.field
    if value is None or found["per"]:
        return
    if what.startswith(("byte", "octet")):
        is_right = lambda other: value in (other.size, other.type.size)  # noqa: E731
        own = f"has {field.size} bytes"
    elif field.is_array:
        is_text = what.startswith(("char", "letter")) and field.type.name == "char"  # with or without its zero
        is_right = lambda other: value == other.count or (is_text and value == other.count - 1)  # noqa: E731
        own = f"has {field.count} elements"
    else:
        return
    if one.is_wrong(is_right):
        written = span.sentence.term(found.start()).written
        text = f"{one.name} {own}, not {written}"
        yield reading.found(
            as_sure(TYPE, is_sure=one.is_sure), span.place(found.start()), f"{one.name} {found[0]}", text
        )


_SIZED = re.compile(r"N bytes?(?: (?:of|for|long))?(?: the)? (?P<name>[FP])(?!\w|,? and [FP]|, [FP]|/| ?[NQ])")


def _takes(field: WireField, size: float | Fraction) -> bool:
    return field.size == size


def sized(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "2 bytes `sequence`"."""
    for found in _SIZED.finditer(span.text):
        one = about(reading, span, found.start("name"))
        value = number(span.sentence.term(found.start()))
        low, high = span.bounds(found.start())
        is_word = span.text[found.start("name")] == "P"
        if is_word and (one is None or one.message.name not in [name for _, name in span.named(low, high)]):
            continue
        if (
            one is None
            or value is None
            or re.search(
                r"\b(?:first|last|only|lower|upper|up to) $", span.text[max(found.start() - 20, 0) : found.start()]
            )
        ):
            continue
        if one.is_wrong(partial(_takes, size=value)):
            text = f"{one.name} has {one.field.size} bytes, not {span.sentence.term(found.start()).written}"
            yield reading.found(
                as_sure(TYPE, is_sure=one.is_sure), span.place(found.start()), f"{one.name} {found[0]}", text
            )
