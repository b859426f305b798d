"""The order of fields on the wire, as sentences tell it: "`a` comes before `b`", "the first field is `id`", lists."""

import re
from collections.abc import Iterator
from itertools import pairwise

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import COMPARED, DENIED, MISTAKEN, OWN, PAST, REPLACED, words
from codegen.claims.rules import ORDER, as_sure
from codegen.claims.statements.subjects import About, about
from codegen.diagnostics import Diagnostic
from codegen.pattern import pattern

_DENIED = words(DENIED[:2], REPLACED, PAST[:1], MISTAKEN[:1], OWN[:1], COMPARED[1:2])
_ORDER = pattern(
    r"(?P<first>[FP])(?: field)?(?: (?:of|in) M)?(?: itself)?(?: (?:then|also|really|always|still))? (?:comes?"
    r"|stands?|is|goes"
    r"|lies|sits|sent|is sent|is placed|is stored|are|appears?|sits in front|stands in front|travels?|directly"
    r"|right|immediately|follows"
    r"|precedes|leads)(?: (?:directly|right|immediately|placed|sent|stored))?"
    r" ?(?P<how>before|ahead of|in front of|of|precedes|after|behind|follows"
    r"|prior to)?(?: the)?(?: field)? (?P<second>[FP])\b"
)
_THEN = pattern(
    r"(?P<first>[FP]) (?:is |comes |goes |stands )?first,? (?:and )?(?:then|followed by) (?P<second>[FP])",
    needs="followed by F|followed by P|then F|then P",
)
_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")
_ORDINAL = "|".join(_ORDINALS)
_PLACED = pattern(
    rf"(?P<names>[FP](?:(?:, ?|,? and )[FP]){{0,6}})(?: (?:of|in) M)?,? (?:comes?|is|are|goes|go|stands?|sent|follows?)"
    rf" (?:on the wire )?(?:the )?(?P<places>(?:{_ORDINAL})(?:(?:, ?|,? and )(?:{_ORDINAL}))*)\b(?! (?:field|byte"
    rf"|bit|in the xml))"
)
_STARTS = pattern(
    r"\b(?:starts?|begins?|opens?) (?:on the wire )?with (?:the )?(?:field )?(?P<name>[FP])\b", needs="begin|open|start"
)
_IS_FIRST = pattern(
    r"(?P<name>[FP])(?: (?:of|in) M)? is the (?:very )?first (?:field|thing|member|one|byte)\b(?! of F)",
    needs="is the first|is the very first",
)
_WIRE = pattern(
    r"\bwire\b|\bpayload\b|\bbytes\b|\bserial|\bencoded\b|\breorder|\btransmi|\boffset|\bin memory\b|\bframe\b"
    r"|\bstruct\b|\bfirst byte\b"
)
_XML = pattern(r"\bxml\b|declar|defin|documentation|\bargument|\bfunction|\bcall\b")


_LIKE_XML = pattern(r"\b(?:just |exactly )?(?:like|as) in the (?:xml|definition|dialect)\b")


def _is_of_definition(sentence: str) -> bool:
    """Return whether a sentence tells of the order in the XML; one that says "like in the XML" tells of the wire."""
    return _XML.search(_LIKE_XML.sub("", sentence)) is not None


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "On the wire `device` stands before `timeout`"."""
    text = span.text
    yield from _sequence(reading, span)
    yield from _first(reading, span)
    yield from _placed(reading, span)
    for found in (*_ORDER.finditer(text), *_THEN.finditer(text)):
        low, high = span.bounds(found.start())
        how = (
            "before"
            if "how" not in found.re.groupindex
            else found["how"] or ("follows" if "follows" in found[0] else "precedes" if "precedes" in found[0] else "")
        )
        is_wire = "sent" in found[0] or _WIRE.search(text[max(low - 200, 0) : high]) is not None
        if not how or not is_wire or _is_of_definition(text[low:high]):
            continue
        first, second = about(reading, span, found.start("first")), about(reading, span, found.start("second"))
        if first is None or second is None or first.message is not second.message or first.field is second.field:
            continue
        is_before = how in ("before", "ahead of", "in front of", "of", "precedes", "prior to")
        if (first.field.offset < second.field.offset) == is_before:
            continue
        early, late = (second, first) if is_before else (first, second)
        words = f"{first.message.name}: {early.field.name} comes before {late.field.name} on the wire"
        order = ", ".join(field.name for field in first.message.fields)
        yield reading.found(
            ORDER, span.place(found.start()), f"{first.name} {how} {second.field.name}", words, f"on the wire: {order}"
        )


def _placed(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "`a` comes first, `b` and `c` come second and third", "NAME starts with `a`"."""
    for found in (form_found for form in (_PLACED, _STARTS, _IS_FIRST) for form_found in form.finditer(span.text)):
        low, high = span.bounds(found.start())
        if (
            not _WIRE.search(span.text, low, high)
            or _is_of_definition(span.text[low:high])
            or _DENIED.search(span.text[low:high])
        ):
            continue
        is_list = "names" in found.re.groupindex
        names = [at for at in range(*found.span("names" if is_list else "name")) if span.text[at] in "FP"]
        places = re.findall(_ORDINAL, found["places"]) if is_list else ["first"]
        for at, place in zip(names, places, strict=False):
            one = about(reading, span, at)
            index = _ORDINALS.index(place)
            if (
                one is None
                or _is_other(one)
                or index >= len(one.message.fields)
                or one.message.fields[index] is one.field
            ):
                continue
            text = (
                f"{one.message.name}: {one.message.fields[index].name} comes {place} on the wire, not {one.field.name}"
            )
            order = f"on the wire: {', '.join(field.name for field in one.message.fields)}"
            claim = f"{one.message.name} {place} {one.field.name}"
            yield reading.found(as_sure(ORDER, is_sure=one.is_sure), span.place(at), claim, text, order)


def _is_other(one: About) -> bool:
    """Return whether a field of another message may be meant."""
    return any(other is not one.field for other in one.others)


_FIRST = pattern(
    r"\b(?P<which>first|last) (?P<what>thing|field|member|array|one)\b(?: (?:on|in|of) (?:the )?(?:wire|payload|M"
    r"|frame)){0,3} (?:is|comes|:)(?: the)?(?: field)? (?P<name>[FP])(?! ?(?:[/*+]|of (?!M)))",
    needs="first|last",
)


def _first(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "The first field on the wire is `id`", "the first array in the payload of NAME is `voltage`"."""
    for found in _FIRST.finditer(span.text):
        low, high = span.bounds(found.start())
        one = about(reading, span, found.start("name"))
        if one is None or not _WIRE.search(span.text, low, high) or _XML.search(span.text, low, high):
            continue
        of_kind = [field for field in one.message.fields if field.is_array or found["what"] != "array"]
        if not of_kind:
            continue
        base = [field for field in of_kind if not field.definition.is_extension] or of_kind
        possible = of_kind[:1] if found["which"] == "first" else [of_kind[-1], base[-1]]
        if one.field in possible or any(other.offset == 0 and other is not one.field for other in one.others):
            continue
        words = f"{one.message.name}: the {found['which']} {found['what']} on the wire is {possible[0].name}"
        order = ", ".join(field.name for field in one.message.fields)
        yield reading.found(
            as_sure(ORDER, is_sure=one.is_sure),
            span.place(found.start("name")),
            f"{one.message.name} {found['which']} {one.field.name}",
            f"{words}, not {one.field.name}",
            f"on the wire: {order}",
        )


_SEQUENCE = pattern(
    r"[FP](?:(?:,? (?:and |then |and then |followed by )?(?:the )?|, ?| ?(?:->|\u2192|<|/) ?)[FP]){2,40}"
)
_IN_ORDER = pattern(
    r"on the wire|wire order|in this order|order (?:on|in|of)|payload (?:begins|starts|of M|is|:)|(?:sent|packed"
    r"|goes out|go out"
    r"|transmitted) as|byte order:|memory order|serialized"
)


def _sequence(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Three fields or more in a sentence that says that it is their order on the wire."""
    for found in _SEQUENCE.finditer(span.text):
        low, high = span.bounds(found.start())
        if (
            not _IN_ORDER.search(span.text, max(low - 120, 0), high)
            or _XML.search(span.text, low, high)
            or pattern(r"\bnot\b").search(span.text[low:high])
        ):
            continue
        fields = [about(reading, span, at) for at in range(found.start(), found.end()) if span.text[at] in "FP"]
        known = [one for one in fields if one is not None]
        if len({one.message.name for one in known}) != 1:
            continue
        for first, second in pairwise(known):
            if first.field.offset > second.field.offset:
                order = ", ".join(field.name for field in first.message.fields)
                text = f"{first.message.name}: {second.field.name} comes before {first.field.name} on the wire"
                yield reading.found(
                    ORDER,
                    span.place(found.start()),
                    f"{first.message.name} order {first.field.name}",
                    text,
                    f"on the wire: {order}",
                )
                break
