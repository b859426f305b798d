"""Lengths that are said of fields: "has 10 elements", "room for 72 values", "takes 64 bytes", "size of NAME.field"."""

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import (
    CHANGED,
    CONVERTED,
    DENIED,
    MISTAKEN,
    OWN,
    PAST,
    REPLACED,
    SUPPOSED,
    words,
)
from codegen.claims.rules import TYPE, as_sure
from codegen.claims.statements.fields import Said, made_of, named, number, said_of_fields
from codegen.claims.statements.subjects import About, about
from codegen.diagnostics import Diagnostic
from codegen.model.dialect.dialect import WireField
from codegen.pattern import pattern

_NOT = words(
    DENIED, REPLACED, PAST, CHANGED, CONVERTED, MISTAKEN, SUPPOSED, OWN[:1], r"buffer", r"\bthan\b", r"\bif\b",
    r"\b(?:and|while|whereas|but) (?:the|its|their) |, the \w",
)  # fmt: skip
_NOUN = (
    r"(?:elements?|entries|values|items|numbers|slots|characters?|chars|letters|cells|places|samples|points|floats|bytes"
    r"|distances|bins|sectors|channels)"
)
_HELD = (
    pattern(
        rf"N (?:more |of the )?(?P<noun>{_NOUN}) (?:(?:can be |are |will |may |do )?(?:fit|stored|held|kept|sent"
        rf"|there) )?(?:in|into|of|for|inside)"
        r" (?:the )?(?:array |field |list )*(?P<name>F|(?<=array )P|(?<=field )P|(?<=list )P)(?! ?(?:of (?!M)|[-+*/]))"
    ),
    pattern(rf"\b(?:up to|carry|carries|holds?|takes?|has) (?P<value>N) {_NOUN},? \((?P<name>F)\)"),
    pattern(
        rf"\b(?:with|all) (?:its |the |of its )?(?P<value>N) {_NOUN},? (?P<name>F)\b",
        needs="all|with",
    ),
    pattern(
        r"\b(?:only|at most|up to|exactly|just) (?P<value>N) (?:\w+ )?(?:fit|fits|are|can be)(?: \w+)? (?:in|into"
        r"|inside)"
        r" (?:the )?(?:array |field )*(?P<name>F|(?<=array )P|(?<=field )P)",
        needs="at most N|exactly N|just N|only N|up to N",
    ),
    pattern(
        r"\b(?:length|size|dimension|number of (?:elements|entries|values|items)|count|capacity) (?:of|for|in)"
        r" (?:the )?(?:array |field |list )*(?P<name>F)(?: (?:of|in) M)? ?(?:is|=|:|being|has to be|must be|,)+"
        r" ?(?P<value>N)"
        r"(?! ?(?:bytes?|hz|%|U|[-+*/]))",
        needs="capacity|count|dimension|length|number of|size",
    ),
    pattern(
        rf"\b(?:ends|stops|fills|closes|cuts) (?:its |the )?(?:array |field |list )?(?P<name>F) (?:after|at|with)"
        rf" (?P<value>N) (?P<noun>{_NOUN})",
        needs="F after N|F at N|F with N",
    ),
    pattern(
        r"(?P<name>F)(?: (?:of|in) M)? (?:ends|stops|is full|is cut|is over) (?:after|at|with) (?P<value>N)"
        rf" (?P<noun>{_NOUN})",
        needs="ends|is cut|is full|is over|stops",
    ),
    pattern(
        r"(?P<name>F)(?: (?:of|in) M)?(?: is|:|,| has| \()* ?(?:an |the )?(?:array|list|vector) (?:of|with)"
        r" (?P<value>N)"
        r"(?! ?(?:bytes? |bits|x\b|by\b|[A-Z*/]))",
        needs="array|list|vector",
    ),
)
_SIZED_IN_CODE = pattern(r"\b(?:size|length|len|elements|entries|dimension|count|as long as|long)\b")
_COUNT_IN_CODE = pattern(r"(?:\[ ?|\* ?|\( ?|= ?|, ?)(?P<value>N)(?= ?[\]);,]|\s*$)")
_COMMENT = pattern(r"#|//|/\*")


_ELEMENTS = pattern(
    r"N (?P<what>elements?|entries|values|items|numbers|slots|characters?|chars|letters|cells|cores|sectors"
    r"|bytes?|octets?|channels"
    r"|bins|places|components|samples|motors|sensors|measurements)\b(?! (?:of (?!T)|per|behind|before|after|further"
    r"|more|a second|each|in a|in base|in payload|in total|in all|at the|are|each))"
    r"(?P<per>(?:/| per | a )\w+)?"
)
_HOLDS = frozenset((
    "is", "are", "has", "have", "hold", "holds", "take", "takes", "carries", "contain", "contains", "with", "for",
    "an", "a", "array", "of", "up", "to", "at", "most", "all", "its", "the", "space", "room", "fixed", "length",
    "always", "exactly", "can", "carry", "list", "lists", "text", "string", "long", "limited", "cut", "maximum",
    "max", "field", "consists", "T", "U", "M", "in", "provides", "reserves", "offers", "fits", "fit", "stores", "made",
    "there", "are", "room", "which",
))  # fmt: skip
_REST = pattern(
    r"[,;:.]? ?(?:and |while |but |so )?(?:(?:all|any) )?(?:the )?(?:other|others|remaining|rest|remainder)\b"
)
"""Behind elements that are used, and not all that there are: "six cells, the other four are unknown"."""
_LESS = pattern(
    r"\b(?:first|last|lower|upper|only|some|least|more|less|fewer|about|other|remaining|own|our|often|used|uses"
    r"|not|never)\b|\busually\b"
)


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every length of a part."""
    for said in said_of_fields(span):
        yield from _length(reading, said)
        yield from _index(reading, said)
    yield from _held(reading, span)
    if span.is_code and not span.is_comment:
        yield from _in_code(reading, span)


_VALUE_OF = pattern(
    r"\b(?:value|maximum|minimum|largest|limit|range) (?:value |number )?(?:of|in|for) (?:the )?(?:field )?$"
)


def _index(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """``distances[80]`` of an array that has less than that: neither an element nor its length."""
    for at in said.names if not said.span.is_code or said.span.is_comment else ():
        elements = named(said.span.sentence.term(at)).elements
        one = about(reading, said.span, at) if elements is not None else None
        if one is not None and elements is not None and one.is_wrong(partial(_has_room, value=elements)):
            written = said.span.sentence.term(at).written
            text = f"{one.name} has {one.field.count} elements, 0 to {one.field.count - 1}: there is no {elements}"
            yield reading.found(as_sure(TYPE, is_sure=one.is_sure), said.span.place(at), f"{one.name} {written}", text)


def _has_room(field: WireField, value: int) -> bool:
    return value <= field.count


def _held(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "Room for 72 values in `distances`", "the length of `distances` is 72"."""
    for form in _HELD:
        for found in form.finditer(span.text):
            low, high = span.bounds(found.start())
            one = about(reading, span, found.start("name"))
            if one is None or not one.field.is_array or _UNLIKELY.search(span.text, low, high):
                continue
            at = found.start("value") if "value" in form.groupindex else found.start()
            is_bytes = "noun" in form.groupindex and found["noun"].startswith("byte")
            yield from _counted(reading, span, one, at, is_bytes=is_bytes)


_UNLIKELY = words(
    DENIED, REPLACED, PAST, MISTAKEN, SUPPOSED, OWN, r"\bbuffer", r"\bthan\b", r"\bfirst\b", r"\blast\b", r"\bfilled\b",
    r"\buses?\b", r"\bused\b", r"\bfill\b", r"\bsome\b", r"\bother\b", r"\bremaining\b", r"\?",
)  # fmt: skip


def _in_code(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """``distances = [0] * 72  # size of OBSTACLE_DISTANCE.distances``."""
    comment = _COMMENT.search(span.text)
    if (
        comment is None
        or not _SIZED_IN_CODE.search(span.text, comment.end())
        or _UNLIKELY.search(span.text, comment.end())
    ):
        return
    names = [at for at, _ in span.sentence.within(comment.end(), len(span.text), "F")]
    counts = [found.start("value") for found in _COUNT_IN_CODE.finditer(span.text, 0, comment.start())]
    one = about(reading, span, names[0]) if len(names) == 1 else None
    if one is not None and one.field.is_array and counts:
        yield from _counted(reading, span, one, counts[-1], is_bytes=False)


def _counted(reading: Reading, span: Span, one: About, at: int, *, is_bytes: bool) -> Iterator[Diagnostic]:
    """The finding about a number of elements, or of bytes, that an array does not have."""
    value = number(span.sentence.term(at))
    if value is None or not one.is_wrong(partial(_has_length, value=value, is_bytes=is_bytes)):
        return
    written = span.sentence.term(at).written
    text = f"{one.name} has {one.field.count} elements, not {written}"
    yield reading.found(as_sure(TYPE, is_sure=one.is_sure), span.place(at), f"{one.name} {written} elements", text)


def _has_length(field: WireField, value: float | Fraction, *, is_bytes: bool) -> bool:
    is_text = field.type.name == "char"  # with or without its zero
    return value == field.count or (is_text and value == field.count - 1) or (is_bytes and value == field.size)


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
    if _VALUE_OF.search(span.text, max(said.start - 40, 0), said.start):
        return
    gap = span.text[said.end : found.start()]
    before = pattern(r"(?:\bin |\bthan )$").search(gap)
    is_listed = (
        said.is_listed
        and not pattern(r"\.\s").search(gap)
        and pattern(r"[,(|:/#*]\s*(?:up to |at most )?$").search(gap)
        and pattern(r"\s*(?:[,;.)|]|$|\*/|long)").match(span.text[found.end() :])
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
    if value is None or found["per"] or _REST.match(span.text, found.end()):
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


_SIZED = pattern(
    r"N bytes?(?: (?:of|for|long))?(?: the)? (?P<name>[FP])"
    r"(?!\w|,? (?:and|to|through|up to) [FP]|, [FP]|/| ?(?:-|\u2013|\.\.\.?|\u2026) ?[FP]| ?[NQ])",
    needs="N byte",
)


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
