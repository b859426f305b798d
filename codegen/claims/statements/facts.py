"""What is said of the place of fields in their message: extension or not, offset, order, and of their enum."""

import re
from collections.abc import Iterator, Sequence
from difflib import get_close_matches
from itertools import pairwise

from codegen.claims.reading import Reading
from codegen.claims.rules import ENUM_OF, EXTENSION, OFFSET, ORDER, as_sure
from codegen.claims.statements.fields import Said, each_about, made_of, number, said_of_fields
from codegen.claims.statements.spans import About, Span, about
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind

_NAMES = r"(?P<names>[FP](?:(?:,? and |,? or |, ?| ?/ ?| ?& ?)[FP]){0,20})"
_GROUP = re.compile(_NAMES)
_KIND = re.compile(
    r"\b(?:extensions?|extension fields?)\b(?! of (?!M))|\b(?:base fields?|the base|base payload)\b|\bno extensions?\b"
)
_VERBS = frozenset((
    "is", "are", "both", "all", "count", "counts", "were", "was", "came", "come", "comes", "later", "belong",
    "belongs", "among", "to", "in", "as",
))  # fmt: skip
_IDLE = _VERBS | frozenset((
    "field", "fields", "an", "a", "the", "only", "of", "really", "one", "fact", "added", "of", "M", "T", "U", "N",
    "type", "part", "mavlink", "v", "normal", "regular", "ordinary", "plain", "too", "also", "just", "not", "no",
))  # fmt: skip
_LIST = re.compile(
    rf"(?P<kind>extensions?(?: fields?)?|base fields?)(?: of M)?(?: are|:| is| \u2013| -"
    rf"|,){{1,4}}(?: the)?(?: fields?)? {_NAMES}"
)
_OFFSET = re.compile(
    r"(?:(?:at|from|has|is|begins? at|starts? at|sits at|lies at|stands at|comes at|is at|found at|,|\(|:|//|/\*"
    r"|#|\*|\|)\s?)+(?:the )?"
    r"(?:(?:byte )?offset(?: of| is|:| =)?|bytes?(?: number)?|position|index) ?(?P<number>N)(?!\s?(?:bytes"
    r"|,? ?(?:to|\.\.|-) ?N))"
)
_AT = re.compile(r"@ ?(?P<number>N)")
_ORDER = re.compile(
    r"(?P<first>[FP])(?: field)?(?: (?:of|in) M)?(?: itself)?(?: (?:then|also|really|always|still))? (?:comes?|stands?|is|goes"
    r"|lies|sits|sent|is sent|is placed|is stored|are|appears?|sits in front|stands in front|travels?|directly|right|immediately|follows"
    r"|precedes|leads)(?: (?:directly|right|immediately|placed|sent|stored))?"
    r" ?(?P<how>before|ahead of|in front of|of|precedes|after|behind|follows"
    r"|prior to)?(?: the)?(?: field)? (?P<second>[FP])\b"
)
_THEN = re.compile(
    r"(?P<first>[FP]) (?:is |comes |goes |stands )?first,? (?:and )?(?:then|followed by) (?P<second>[FP])"
)
_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")
_ORDINAL = "|".join(_ORDINALS)
_PLACED = re.compile(
    rf"(?P<names>[FP](?:(?:, ?|,? and )[FP]){{0,6}})(?: (?:of|in) M)?,? (?:comes?|is|are|goes|go|stands?|sent|follows?)"
    rf" (?:on the wire )?(?:the )?(?P<places>(?:{_ORDINAL})(?:(?:, ?|,? and )(?:{_ORDINAL}))*)\b(?! (?:field|byte|bit|in the xml))"
)
_STARTS = re.compile(r"\b(?:starts?|begins?|opens?) (?:on the wire )?with (?:the )?(?:field )?(?P<name>[FP])\b")
_WIRE = re.compile(
    r"\bwire\b|\bpayload\b|\bbytes\b|\bserial|\bencoded\b|\breorder|\btransmi|\boffset|\bin memory\b|\bframe\b"
    r"|\bstruct\b"
)
_XML = re.compile(r"\bxml\b|declar|defin|documentation|\bargument|\bfunction|\bcall\b")
_ENUM = re.compile(r"[^.;EC]{0,60}?(?P<enum>[EC])(?![\w*])")
_ENUM_IDLE = frozenset((
    "is", "are", "an", "a", "from", "of", "use", "uses", "the", "enum", "type", "taken", "see", "value", "values",
    "entry", "in", "one", "hold", "holds", "has", "contains", "as", "by", "bitmask", "bits", "flags", "list", "code",
    "codes", "T", "entries", "with", "its", "listed", "defined", "comes", "come", "given", "number", "field",
))  # fmt: skip
_NOT = re.compile(r"\bnot\b|n't\b|instead|unlike|\bwas\b|wrong|\bour\b|\blike\b")


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every such statement of a part."""
    yield from _extensions(reading, span)
    yield from _orders(reading, span)
    for said in said_of_fields(span):
        yield from _offset(reading, said)
        yield from _enum(reading, said)


def _extensions(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "`a` and `b` are extensions", "`c` belongs to the base fields", "the extensions are `a` and `b`"."""
    text = span.text
    for found in _LIST.finditer(text):
        names = [at for at in range(*found.span("names")) if text[at] in "FP"]
        yield from _kinds(reading, span, names, is_extension=found["kind"].startswith("ext"))
    for found in _THESE.finditer(text):
        value = number(span.sentence.term(found.start("many")))
        named = [at for at, _ in span.sentence.within(0, found.start(), "FP")]
        if value is not None and 1 < value <= len(named):
            is_extension = found["kind"].startswith("ext")
            yield from _kinds(reading, span, named[-int(value) :], found.start("kind"), is_extension=is_extension)
    for found in _MARKED.finditer(text) if span.kind is not PassageKind.ROW else ():
        yield from _kinds(reading, span, [found.start()], is_extension=found["kind"].startswith("ext"))
    for found in _GROUP.finditer(text) if _KIND.search(text) else ():
        kind = _KIND.search(text, found.end(), found.end() + _NEAR)
        gap = text[found.end() : kind.start()] if kind is not None else ""
        words = re.findall(r"[A-Za-z]+", gap)
        is_tied = bool(_VERBS & set(words)) or re.search(r"[:(,|\u2013]", gap) is not None
        if (
            kind is None
            or not is_tied
            or not made_of(gap, _IDLE)
            or text[max(found.start() - 2, 0) : found.start()].endswith("M.")
        ):
            continue
        names = [at for at in range(*found.span()) if text[at] in "FP"]
        is_of_all = {"are", "both", "all", "belong", "as", "were", "come"} & set(words) or kind[0].endswith("s")
        is_extension = "extension" in kind[0] and not kind[0].startswith("no")
        is_extension = not is_extension if {"not", "no"} & set(words) else is_extension
        far = kind.start() if span.place(kind.start()).line != span.place(names[-1]).line else None
        yield from _kinds(reading, span, names if is_of_all else names[-1:], far, is_extension=is_extension)


_THESE = re.compile(
    r"\b(?:these|those|all|the last) (?P<many>N)(?: fields)? are (?:all |also )?(?P<kind>extension|base)(?: field)?s?\b"
)
_MARKED = re.compile(r"F ?[(\[](?:T,? |U,? )*(?P<kind>ext\.?|extension|base)(?: field)?[)\]]")
_NEAR = 60
"""Characters between names and what kind of fields they are."""


def _kinds(
    reading: Reading, span: Span, names: Sequence[int], kind_at: int | None = None, *, is_extension: bool
) -> Iterator[Diagnostic]:
    """The fields that are not of the kind that is said of them."""
    low, high = span.bounds(names[0])
    if re.search(r"\bwithout\b|\bpropos|\bwould\b|\bshould\b|\bmake\b|\?", span.text[low:high]):
        return
    for offset in names:
        one = about(reading, span, offset)
        if one is not None and one.is_wrong(lambda field: field.definition.is_extension == is_extension):
            kind = "an extension" if one.field.definition.is_extension else "a base field"
            yield reading.found(
                as_sure(EXTENSION, is_sure=one.is_sure),
                span.place(offset if kind_at is None else kind_at),
                f"{one.name} {is_extension}",
                f"{one.name} is {kind}",
            )


def _orders(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "On the wire `device` stands before `timeout`"."""
    text = span.text
    yield from _sequence(reading, span)
    yield from _first(reading, span)
    yield from _placed(reading, span)
    for found in (*_ORDER.finditer(text), *_THEN.finditer(text)):
        low, high = span.bounds(found.start())
        how = (
            "before"
            if found.re is _THEN
            else found["how"] or ("follows" if "follows" in found[0] else "precedes" if "precedes" in found[0] else "")
        )
        if not how or not _WIRE.search(text[max(low - 200, 0) : high]) or _XML.search(text[low:high]):
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
    for found in (*_PLACED.finditer(span.text), *_STARTS.finditer(span.text)):
        low, high = span.bounds(found.start())
        if (
            not _WIRE.search(span.text, low, high)
            or _XML.search(span.text, low, high)
            or _NOT.search(span.text[low:high])
        ):
            continue
        names = [at for at in range(*found.span("names" if found.re is _PLACED else "name")) if span.text[at] in "FP"]
        places = re.findall(_ORDINAL, found["places"]) if found.re is _PLACED else ["first"]
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
    """Whether a field of another message may be meant."""
    return any(other is not one.field for other in one.others)


_FIRST = re.compile(
    r"\b(?P<which>first|last) (?P<what>thing|field|member|array|one)\b(?: (?:on|in|of) (?:the )?(?:wire|payload|M"
    r"|frame)){0,3} (?:is|comes|:)(?: the)?(?: field)? (?P<name>[FP])(?! ?(?:[/*+]|of (?!M)))"
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


_SEQUENCE = re.compile(
    r"[FP](?:(?:,? (?:and |then |and then |followed by )?(?:the )?|, ?| ?(?:->|\u2192|<|/) ?)[FP]){2,40}"
)
_IN_ORDER = re.compile(
    r"on the wire|wire order|in this order|order (?:on|in|of)|payload (?:begins|starts|of M|is|:)|(?:sent|packed"
    r"|transmitted) as|byte order:|memory order|serialized"
)


def _sequence(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Three fields or more in a sentence that says that it is their order on the wire."""
    for found in _SEQUENCE.finditer(span.text):
        low, high = span.bounds(found.start())
        if (
            not _IN_ORDER.search(span.text, max(low - 120, 0), high)
            or _XML.search(span.text, low, high)
            or re.search(r"\bnot\b", span.text[low:high])
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


def _offset(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    span, text = said.span, said.span.text
    found = _OFFSET.search(text, said.end, said.until) or _AT.search(text, said.end, said.until)
    if (
        found is None
        or len(said.names) > 1
        or _NOT.search(text[said.end : found.start()])
        or found.start() - said.end > 90
    ):
        return
    value = number(span.sentence.term(found.start("number")))
    one = about(reading, span, said.names[0])
    low, high = span.bounds(found.start())
    element = span.sentence.term(said.names[0]).written
    if one is None or value is None or "[" in element or re.search(r"\bframe\b|\bheader\b|\bbit\b", text[low:high]):
        return
    if one.is_wrong(lambda field: field.offset == value):
        written = span.sentence.term(found.start("number")).written
        words = f"{one.name} begins at byte {one.field.offset}, not {written}"
        yield reading.found(
            as_sure(OFFSET, is_sure=one.is_sure), span.place(found.start("number")), f"{one.name} at {written}", words
        )


def _enum(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """The enum that a field is said to have."""
    span, text = said.span, said.span.text
    found = _ENUM.match(text, said.end, said.until)
    if found is None or not made_of(found[0][:-1], _ENUM_IDLE):
        return
    offset = found.start("enum")
    written = span.sentence.term(offset).written
    for at, one in each_about(reading, said)[-1:]:
        own = one.field.definition.enum
        enums = [field.definition.enum for field in (one.field, *one.others)]
        if at not in said.names or own is None or written in enums:
            continue
        is_known = written in reading.enums
        if (
            not is_known
            and not get_close_matches(written, [own], n=1, cutoff=0.6)
            and written.split("_")[0] != own.split("_")[0]
        ):
            continue
        if not is_known and ("_" not in written or written in reading.messages):
            continue
        hint = None if is_known else f"there is no enum {written}"
        if own.startswith(f"{written}_") or (not is_known and _is_entry(reading, own, written)):
            continue
        words = f"{one.name} has the enum {own}, not {written}"
        yield reading.found(
            as_sure(ENUM_OF, is_sure=one.is_sure), span.place(offset), f"{one.name} {written}", words, hint
        )


def _is_entry(reading: Reading, enum: str, written: str) -> bool:
    """Whether a name is, or nearly is, that of an entry: another rule tells it."""
    entries = [entry.name for entry in reading.enums[enum].entries] if enum in reading.enums else []
    return any(entry.endswith(written) for entry in entries) or bool(
        get_close_matches(written, entries, n=1, cutoff=0.75)
    )
