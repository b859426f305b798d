"""Numbers that are said of whole messages: ids and CRC_EXTRA."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import DENIED, OWN, PAST, REPLACED, words
from codegen.claims.rules import CRC_EXTRA, MESSAGE_ID, as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.subjects import subjects
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.model.price import HEAD_V2
from codegen.pattern import pattern

_ID = pattern(
    r"(?P<own>\b(?:its |the |with |has |by |under |as |message |msg |numeric ){0,4}(?:(?:message"
    r"|msg)[ _-]?(?:ids?|numbers?|no\.?|type)|msg_?id|id|packet (?:id|number)))\)?"
    r"(?P<of>(?: (?:of|for) (?:the )?M)?)(?: is| of|:| =| must be| should be| being|,){0,4} ?#?(?P<number>N)(?!\w"
    r"| ?(?:bytes?|hz|times|of|%|fields|messages|or more)\b|[-/.][\dN])"
    r"|(?:^|[.;:(|] ?|\bas |\bis |\bread |\brequest |\basks? for |\bsends? |//[/!]? ?|# ?|\* ?"
    r"|, )(?P<word>messages?|msg|packet) (?:no\.? |number |#)?(?P<alone>N)(?=\s*(?:[,.;:)(|]|$|is\b|has\b|in\b"
    r"|from\b|of the|carries|with|and\b|\*/))"
)
_OTHER = pattern(
    r"component|system|array|compid|sysid|param|sensor|camera|target|instance|gimbal|device|command|server|client"
    r"|node|vehicle|\bcan\b|node|\bjob|\bissue|\bticket|\bserial|\bpart|\bbattery|\bpack\b|\bmotor|\bpage|\bphone"
    r"|\bversion|\bstream|\btag\b|\bfield\b|\bproduct|\bvendor|\brequirement|\buser"
)
_PAIR = pattern(r"N \(M\)")
_HELD = pattern(
    r"M(?: messages?)?(?:,? (?P<mark>id |#|message |msg )?\(? ?| ?\((?P<called>(?:message |msg )?(?:id[ :=]*"
    r"|number |no\.? )?#?) ?)(?P<number>N)\)(?! ?(?:bytes|hz))"
)
_HELD_FIRST = pattern(
    r"M(?: messages?)? ?\((?P<called>(?:message |msg )?(?:id[ :=]*|number |no\.? )?#?) ?(?P<number>N)(?P<mark>)"
    r"(?=[,;] ?(?!N ?(?:[,)]|hz|ms|U)))"
)
"""An id that other things stand behind in its parentheses."""
_HEADED = pattern(r"(?:\d[\d.]* |N )?M ?(?:,|:|-|\u2013|#|/)? ?(?:id:? |message |#|\()*(?P<number>N)\)?")
_PLAIN = pattern(
    r"(?:(?:^|[.:;] ?|\b(?:and|while|but|,) )(?P<lead>M) (?:is|=|has (?:the )?number) (?:number |no\.? |id"
    r" )?#?(?P<number>N)"
    r"|(?:^|[.;] )(?:messages?|msg)[ :]*(?P<called>M), ?#?(?P<then>N)"
    r"|^[\s*-]*# ?(?P<first>N):? (?P<last>M)(?=\s*$)"
    r"|^[\s*-]*(?P<own>M): ?# ?(?P<behind>N)(?=\s*$)|(?P<held>M) \[(?P<inside>N)\]|(?P<numbered>M), (?:number"
    r"|no\.?|msg|message) (?P<nth>N)"
    r"|\b(?:subscribe[sd]? to|listens? (?:to|for)|filters? (?:on|for)|asks? for|waits? for|requests?) (?:message "
    r"|id |#)*(?P<heard>N) \((?P<hearing>M)\)"
    r"|\bparam ?(?:N|one|\d)(?: must be| is| to| =|:|=)* ?(?P<set>N)(?: \(| for| means| of| asks for)+ (?:the"
    r" )?(?P<asked>M))"
    r"(?=\s*(?:[,.;)]|$|and\b|in\b|from\b))"
)
_OF_RATE = pattern(r"\b(?:rates?|hz|sizes?|bytes|lengths?|counts?|crc|seed|times|priority|times per|frequency)\b")
_LISTED = pattern(
    r"\bids?(?: of both| of the two| are|:)* (?P<numbers>N(?:(?:, | and |,? and | / |/)N)+)"
    r"(?! ?(?:bytes|octets|hz|fields)\b)"
)
_CRC = pattern(
    r"\b(?:crc[_ -]?extra|extra[_ ]crc|crc|(?:crc[_ ])?seed|checksum seed|magic byte of the crc|(?:crc )?extra"
    r" byte)\b(?: (?:byte|of"
    r"|is|for|value|seed|must|should|be|has|to|M|the|it|extra|number|parameter"
    r"|with)){0,8}[\s:=(,]*(?P<number>N)(?!\w|\.\d|\s?(?:bytes?|bits?)\b|-|\s?(?::|=|is) ?N)"
    r"|(?P<first>N) (?:as|is) (?:the |its |for )?crc[_ -]?extra",
    needs="crc|extra byte|seed",
)


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every such statement of a part."""
    span = replace(span, sentence=span.sentence.plain())
    yield from _ids(reading, span)
    yield from _crcs(reading, span)


def _ids(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """The ids beside names, in headings, in lists of both, and in words."""
    text = span.text
    for found in (*_HELD.finditer(text), *_HELD_FIRST.finditer(text)):
        name = str(span.sentence.term(found.start()).value)
        offset = found.start("number")
        called = found["called"] or found["mark"] or ""
        is_discussed = "#" in called and "id" not in called and pattern(r"\)?[\s.,;]*$").match(text[offset + 1 :])
        is_told = "_" in name or called or span.kind is PassageKind.HEADING or _is_id(span, offset)
        if not is_discussed and is_told:
            yield from _id(reading, span, offset, (reading.messages[name],))
    if span.kind is PassageKind.HEADING and _HEADED.fullmatch(text.strip()):
        offset = text.index("N", text.index("M"))
        yield from _id(reading, span, offset, (reading.messages[str(span.sentence.term(text.index("M")).value)],))
    for found in _PAIR.finditer(text):
        lead = text[span.bounds(found.start())[0] : found.start()]
        if pattern(r"\b(?:ids?|messages?|numbers?)\b").search(lead) and not _OTHER.search(lead):
            message = reading.messages[str(span.sentence.term(found.end() - 2).value)]
            yield from _id(reading, span, found.start(), (message,))
    yield from _plain(reading, span)
    for found in _LISTED.finditer(text):
        yield from _listed(reading, span, *found.span("numbers"))
    for found in _ID.finditer(text):
        yield from _worded(reading, span, found)


def _is_id(span: Span, offset: int) -> bool:
    """Return whether a number behind a plain word is so great that it can hardly be anything but an id."""
    value = number(span.sentence.term(offset))
    return value is not None and value >= _GREAT


_GREAT = 100
_BESIDE = 16
"""Characters around a number in which words say that it is a rate or a size."""


def _plain(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "RADIO_STATUS is 109, RADIO is 166", "Message: ODOMETRY, 331.", "param1 = 33 (GLOBAL_POSITION_INT)"."""
    text = span.text
    for found in _PLAIN.finditer(text) if not span.is_code or span.is_comment else ():
        named = next(group for group in _TOLD if found[group])
        told = _TOLD[named]
        low, high = span.bounds(found.start())
        is_else = (
            _OF_RATE.search(text, max(low, found.start() - _BESIDE), min(high, found.end() + _BESIDE))
            or _UNSURE.search(text, low, high)
            or _OTHER.search(text, low, found.start())
        )
        message = reading.messages[str(span.sentence.term(found.start(named)).value)]
        value = number(span.sentence.term(found.start(told)))
        sizes = {message.base_length, message.length, message.length + HEAD_V2, message.crc_extra}
        if named == "asked" and not _IS_ASKED.search(span.source_text(0, len(text))):
            continue
        if is_else is None and (value not in sizes or named in ("called", "asked", "numbered", "hearing")):
            yield from _id(reading, span, found.start(told), (message,), is_sure=named not in ("lead", "last"))


_TOLD = {
    "lead": "number", "called": "then", "last": "first", "asked": "set", "own": "behind", "numbered": "nth",
    "held": "inside",
    "hearing": "heard",
}  # fmt: skip
"""The groups of a message, and those of its number."""
_IS_ASKED = pattern(r"MESSAGE_INTERVAL|REQUEST_MESSAGE|\bparam ?1\b|\brequest", re.IGNORECASE)


def _listed(reading: Reading, span: Span, start: int, end: int) -> Iterator[Diagnostic]:
    """ "Ids: 158 and 284", as many as messages of the sentence or of the heading."""
    offsets = [offset for offset, _ in span.sentence.within(start, end, "N")]
    own = [reading.messages[name] for _, name in span.named(*span.bounds(start))]
    group = next((each for each in (own, list(span.topic.headings)[::-1]) if len(each) == len(offsets)), [])
    for offset, message in zip(offsets, group, strict=False):
        yield from _id(reading, span, offset, (message,) if group is own else tuple(group))


def _worded(reading: Reading, span: Span, found: "re.Match[str]") -> Iterator[Diagnostic]:
    """ "Its id is 117", "message 128"."""
    text = span.text
    offset = found.start("number") if found["number"] else found.start("alone")
    low, high = span.bounds(offset)
    lead, called = text[low:offset], found["own"] or "message"
    if _OTHER.search(lead) or _UNSURE.search(lead) or pattern(r" ?[FP]\b").match(text[offset + 1 : offset + 3]):
        return
    messages, is_sure = subjects(reading, span, offset)
    own = [name for _, name in span.named(low, high)]
    if not messages or text[: found.start()].endswith(("F ", ".", "_")) or (not own and span.kind is PassageKind.ROW):
        return
    if not is_sure or ("type" in called and not own):
        return
    is_told = "message" in called or "msg" in called or (bool(own) and text[:offset].rstrip().endswith("id"))
    if is_told or not _has_id(messages[0]):
        yield from _id(reading, span, offset, messages[:1] if own else messages, is_sure=is_sure)


_UNSURE = words(
    DENIED[:1], REPLACED[:1], PAST[:1], r"\bold\b", OWN[:1], r"\bfree\b", r"\bprivate\b", r"\bunused\b", r"\bother\b"
)


def _has_id(message: WireMessage) -> bool:
    return any(field.name == "id" for field in message.fields)


def _id(
    reading: Reading, span: Span, offset: int, messages: Sequence[WireMessage], *, is_sure: bool = True
) -> Iterator[Diagnostic]:
    term = span.sentence.term(offset)
    value = number(term)
    if (
        value is None
        or not term.written.isdigit()
        or any(message.id in (value, -1) or message.id < 0 for message in messages)
    ):
        return
    text = f"{messages[0].name} has the id {messages[0].id}, not {term.written}"
    others = [other.name for other in reading.messages.values() if other.id == value]
    hint = f"{term.written} is {others[0]}" if others else None
    place = messages[0].definition.place
    related = [(place, "it is defined here")] if place.file == reading.prose.path else []
    yield reading.found(
        as_sure(MESSAGE_ID, is_sure=is_sure),
        span.place(offset),
        f"{messages[0].name} id {term.written}",
        text,
        hint,
        related,
    )


_CRC_LIST = pattern(
    r"\bcrc[_ -]?extra\b[^.;:|]{0,60}:"
    r"(?P<pairs>(?: M:? ?=? ?N,?(?: and)?){2,60}|(?: N (?:for|of|is) M,?(?: and)?){2,60})"
)
_IN_TURN = pattern(r"\b(?:former|latter|respectively)\b")


def _crcs(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    text = span.text
    for found in _CRC_LIST.finditer(text):
        listed = [*span.sentence.within(*found.span("pairs"), "MN")]
        for one, other in zip(listed[::2], listed[1::2], strict=True):
            (_, name), (at, term) = (one, other) if one[1].letter == "M" else (other, one)
            message = reading.messages[str(name.value)]
            if number(term) != message.crc_extra and message.id >= 0:
                words = f"{message.name} has the CRC_EXTRA {message.crc_extra}, not {term.written}"
                yield reading.found(CRC_EXTRA, span.place(at), f"{message.name} crc {term.written}", words)
    for found in _CRC.finditer(text):
        offset = found.start("number") if found["number"] else found.start("first")
        low, high = span.bounds(offset)
        if _IN_TURN.search(text, low, high):
            continue
        is_extra = "extra" in found[0] or "seed" in found[0]
        is_listed = span.kind is PassageKind.ITEM and any(span.named(0, offset))
        if (not is_extra and not span.is_code and not is_listed) or re.search(
            r"\b(?:not|n't|instead|was|old|our|other|wrong)\b", text[low:offset]
        ):
            continue
        messages, is_sure = subjects(reading, span, offset)
        value = number(span.sentence.term(offset))
        own = [reading.messages[name] for at, name in span.named(low, len(text)) if low <= at < span.bounds(offset)[1]]
        if span.kind is PassageKind.ROW and not any(span.named(0, len(text))):
            continue
        if (
            value is None
            or not messages
            or any(message.crc_extra == value or message.id < 0 for message in (own or messages))
        ):
            continue
        if pattern(r" of (?!M)").match(text[offset + 1 :]):
            continue
        first, written = messages[0], int(value)
        words = f"{first.name} has the CRC_EXTRA {first.crc_extra}, not {written}"
        yield reading.found(
            as_sure(CRC_EXTRA, is_sure=is_sure), span.place(offset), f"{first.name} crc {written}", words
        )
