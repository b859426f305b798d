"""What is said of whole messages: id, CRC_EXTRA, and sizes of payloads and frames."""

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from codegen.claims.reading import Reading
from codegen.claims.rules import CRC_EXTRA, MESSAGE_ID, SIZE
from codegen.claims.size import SIGNATURE, per_second, size_hint, sizes_of
from codegen.claims.statements.fields import number
from codegen.claims.statements.spans import Span, subjects
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.model.price import HEAD_V1, HEAD_V2

_ID = re.compile(
    r"(?P<own>\b(?:its |the |with |has |by |under |as |message |msg |numeric )*(?:(?:message|msg)[ _-]?(?:ids?|numbers?|no\.?|type)|msg_?id|id|packet (?:id|number)))\)?"
    r"(?P<of>(?: (?:of|for) (?:the )?M)?)(?: is| of|:| =| must be| should be| being|,)* ?#?(?P<number>N)(?!\w| ?(?:bytes?|hz|times|of|%|fields|messages|or more)\b|[-/.][\dN])"
    r"|(?:^|[.;:(|] ?|\bas |\bis |\bread |\brequest |\basks? for |\bsends? |//[/!]? ?|# ?|\* ?|, )(?P<word>messages?|msg|packet) (?:no\.? |number |#)?(?P<alone>N)(?=\s*(?:[,.;:)(|]|$|is\b|has\b|in\b|from\b|of the|carries|with|and\b|\*/))"
)
_OTHER = re.compile(
    r"component|system|array|compid|sysid|param|sensor|camera|target|instance|gimbal|device|command|server|client|node|vehicle|\bcan\b|node|\bjob|\bissue|\bticket|\bserial|\bpart|\bbattery|\bpack\b|\bmotor|\bpage|\bphone|\bversion|\bstream|\btag\b|\bfield\b|\bproduct|\bvendor|\brequirement|\buser"
)
_PAIR = re.compile(r"N \(M\)")
_HELD = re.compile(
    r"M(?: messages?)?(?:,? (?P<mark>id |#|message |msg )?\(? ?| ?\((?P<called>(?:message |msg )?(?:id[ :=]*|number |no\.? )?#?) ?)(?P<number>N)\)(?! ?(?:bytes|hz))"
)
_HEADED = re.compile(r"(?:\d[\d.]* |N )?M ?(?:,|:|-|\u2013|#|/)? ?(?:id:? |message |#|\()*(?P<number>N)\)?")
_LISTED = re.compile(r"\bids?(?: of both| of the two| are|:)* (?P<numbers>N(?:(?:, | and |,? and | / |/)N)+)")
_CRC = re.compile(
    r"\b(?:crc[_ -]?extra|extra[_ ]crc|crc|(?:crc[_ ])?seed|checksum seed|magic byte of the crc)\b(?: (?:byte|of|is|for|value|seed|must|should|be|has|to|M|the|it|extra|number|parameter|with))*[\s:=(,]*(?P<number>N)(?!\w|\.\d|\s?(?:bytes?|bits?)\b|-)"
    r"|(?P<first>N) (?:as|is) (?:the |its |for )?crc[_ -]?extra"
)
_BYTES = re.compile(
    r"N(?: |-)?(?P<what>payload |base )?(?:bytes?|octets?)\b(?!\s?(?:/(?!message|frame|packet)|per (?!message|frame|packet)|a second|each second|of (?!(?:the )?(?:payload|base|M))|for each|behind|before|more|at the|in front|further|header|left|free|above|less|every|later|longer|larger|bigger|shorter|extra))"
)
_LENGTH = re.compile(
    r"\b(?:(?P<base>base |minimum |min )?(?:payload )?(?:length|len|size|payload))(?: (?:of|is|in bytes|for|M|the|its|payload))*(?:[:=,]| is| of)* ?(?P<number>N)(?!\w| ?(?:bytes?|%|m\b|fields|elements)|[.-]\d)"
)
_LENGTHS = re.compile(
    r"N bytes?[;,.]?(?: \()?(?:(?: and| or|,)? (?P<then>N)(?: bytes)? (?:with|including) (?:the |all |its )?(?:extensions?|F|everything|them|it)\b"
    r"|[^.NF;]{0,30} (?:with|including) (?:the |all |its )*(?:extensions?|everything|them|F|all)(?: \w+)?,?(?: it is| they are| that is|:| is| has| are)* (?P<last>N)(?! ?(?:hz|%|[A-Za-z])))"
)
_SHORT = re.compile(
    r"truncat|trimmed|\bcut\b|\bzeros?\b|recorded|captur|shorten|often|\bwithout trailing|\bat least\b|\bat most\b|\bup to\b|\bonly\b(?= N)|\bplus\b|header|\bbuffer\b|\bon average|\bshrink|\bshorter\b|\bskip|\bminus\b|\bfirst\b|\blast\b|becomes|\bcannot\b|\bannounce|\bwith (?:that|this) |\bfills?\b|complete"
)
_KINDS = re.compile(
    r"(?P<payload>payloads?|\bdata part|\bbase (?:length|part|size)|^base\b|without (?:the )?header)|(?P<frame>frames?|packets?|on (?:the|a) (?:wire|line|link|air)|\bin the air\b)|(?P<message>messages?\b|\bit\b|\bM\b|length|long|size|large|big|takes|struct|parser|fields|\btotal|\btogether|costs?\b)"
)
_V1 = re.compile(r"mavlink[ -]?(?:v|version )?(?:1\b|N\b)|\bv1\b|\b0xfe\b")
_OF_ELSE = re.compile(
    r"[FP](?: of M)?[,(]? ?(?:(?:is|are|has|have|takes?|holds?|carries|with|the|of|up to|an?|array|length|size) )*$|\b(?:values|arrays|fields|elements|words|numbers|parts|items|entries|pieces|floats|blocks|names?) (?:of|with|has|have|at) $|\b(?:adds?|plus|header|checksum|crc|array|buffer|chunk|name|text|string|field|each|element|of which|reads?|only|first|last|another|more than|less than|within|every|copies|memcpy|block|chunks|pieces|blocks|ram|flash|heap|stack|extensions? (?:adds?|are|is|have|has|takes?)|and|file|page|line|sd|write|wrote|offset|than|from|after|to|by|in|grows?|with|saves?|frees?|leaves|byte|drops?|carr(?:y|ies)|holds?|brings?) (?:\w+ ){0,2}$"
)


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every such statement of a part."""
    span = replace(span, sentence=span.sentence.plain())
    yield from _ids(reading, span)
    yield from _crcs(reading, span)
    yield from _sizes(reading, span)


def _ids(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    text = span.text
    for found in _HELD.finditer(text):
        name = str(span.sentence.term(found.start()).value)
        offset = found.start("number")
        called = found["called"] or found["mark"] or ""
        is_discussed = "#" in called and "id" not in called and re.match(r"\)?[\s.,;]*$", text[offset + 1 :])
        if not is_discussed and ("_" in name or called or span.kind is PassageKind.HEADING):
            yield from _id(reading, span, offset, (reading.messages[name],))
    if span.kind is PassageKind.HEADING and (headed := _HEADED.fullmatch(text.strip())) is not None:
        offset = text.index("N", text.index("M"))
        yield from _id(reading, span, offset, (reading.messages[str(span.sentence.term(text.index("M")).value)],))
    for found in _PAIR.finditer(text):
        low, _ = span.bounds(found.start())
        if re.search(r"\b(?:ids?|messages?|numbers?)\b", text[low : found.start()]) and not _OTHER.search(
            text[low : found.start()]
        ):
            message = reading.messages[str(span.sentence.term(found.end() - 2).value)]
            yield from _id(reading, span, found.start(), (message,))
    for found in _LISTED.finditer(text):
        offsets = [offset for offset, _ in span.sentence.within(found.start("numbers"), found.end("numbers"), "N")]
        low, high = span.bounds(found.start())
        own = [reading.messages[name] for _, name in span.named(low, high)]
        for group in (own, list(span.topic.headings)[::-1]):
            if len(group) == len(offsets):
                for offset, message in zip(offsets, group, strict=True):
                    yield from _id(reading, span, offset, tuple(group) if message not in own else (message,))
                break
    for found in _ID.finditer(text):
        offset = found.start("number") if found["number"] else found.start("alone")
        low, high = span.bounds(offset)
        if _OTHER.search(text[low:offset]) or re.search(
            r"\b(?:not|n't|instead|was|old|our|free|private|unused|other)\b", text[low:offset]
        ):
            continue
        if text[found.end("own") if found["own"] else offset :].startswith("s ") or re.match(
            r" ?[FP]\b", text[offset + 1 : offset + 3]
        ):
            continue
        messages, is_sure = subjects(reading, span, offset)
        if not messages or (found["own"] and text[: found.start()].endswith(("F ", ".", "_"))):
            continue
        own = [name for at, name in span.named(low, high)]
        is_called = "message" in (found["own"] or "message") or "msg" in (found["own"] or "")
        if (
            not is_called
            and any(_has_id(message) for message in messages[:1])
            and not (text[:offset].rstrip().endswith("id") and own)
        ):
            continue
        if not own and span.kind is PassageKind.ROW:
            continue
        yield from _id(reading, span, offset, messages[:1] if own else messages)


def _has_id(message: WireMessage) -> bool:
    return any(field.name == "id" for field in message.fields)


def _id(reading: Reading, span: Span, offset: int, messages: Sequence[WireMessage]) -> Iterator[Diagnostic]:
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
    yield reading.found(MESSAGE_ID, span.place(offset), f"{messages[0].name} id {term.written}", text, hint, related)


def _crcs(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    text = span.text
    for found in _CRC.finditer(text):
        offset = found.start("number") if found["number"] else found.start("first")
        low, _ = span.bounds(offset)
        is_extra = "extra" in found[0] or "seed" in found[0]
        if (not is_extra and not span.is_code) or re.search(
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
        first, written = messages[0], span.sentence.term(offset).written
        words = f"{first.name} has the CRC_EXTRA {first.crc_extra}, not {written}"
        yield reading.found(CRC_EXTRA, span.place(offset), f"{first.name} crc {written}", words)


def _sizes(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    text = span.text
    found = [(each.start(), each.end(), each[0]) for each in _BYTES.finditer(text)]
    found += [
        (each.start("number"), each.end(), each[0])
        for each in _LENGTH.finditer(text)
        if "len" not in each[0] or not span.is_comment or "base" in each[0] or "M" in text
    ]
    doubled = {
        each.start("then") if each["then"] else each.start("last"): each.end() for each in _LENGTHS.finditer(text)
    }
    found = [each for each in found if each[0] not in doubled] + [(at, end, "size") for at, end in doubled.items()]
    for offset, end, words in found:
        low, high = span.bounds(offset)
        before, sentence = text[low:offset], text[low:high]
        is_first = (
            not before.strip(" -*/#|")
            or re.fullmatch(r"[\W]*(?:message|msg|id|M|number)?[ :=(]*(?:N\)?)?,? ?", before) is not None
        )
        kinds = ["message"] if words == "size" else []
        kinds += [
            kind for each in _KINDS.finditer(before + words) for kind in ("payload", "frame", "message") if each[kind]
        ]
        behind = re.match(
            r"(?: |-)?(?:long |of )?(?:the )?(?P<payload>payload)|(?: |-)?(?:long )?(?:on (?:the|a) (?P<frame>wire|link|line)|(?P<f>frames?|packets?))|(?: |-)(?P<long>long|large|in size|in total)",
            text[end:high],
        )
        if behind is not None:
            kinds.append("payload" if behind["payload"] else "frame" if behind["frame"] or behind["f"] else "message")
        if re.match(r" ?(?:/|per |a )(?:message|frame|packet)", text[end:high]):
            kinds = ["message"]
            before = f"{before} it is "
        if text.lstrip().startswith("}"):
            kinds = ["payload"]
        is_word = span.sentence.term(offset).written.isalpha()
        if not kinds and (not is_first or is_word or re.search("[FP]|\\?", text[:low])):
            continue
        if (
            _SHORT.search(sentence)
            or _OF_ELSE.search(before)
            or re.search(r"[=+*/\u00d7] ?$|[FNP] ?[-+*\u00d7] ?$", before)
        ):
            continue
        sentence = re.sub(r"\bnot signed\b|\bnot being signed\b", "unsigned", sentence)
        if re.search(r"\?|\bnot\b|n't|\binstead|\bwas\b|\bwould\b|\bour\b|\bown\b|\bif\b", sentence) or re.search(
            r"hz|/s\b", text[offset + 1 : offset + 14]
        ):
            continue
        if re.match(r" ?(?:[=+*\u00d7]|\+|- N)|(?: of| for| each)? F\b", text[end:high]):
            continue
        messages, _ = subjects(reading, span, offset)
        near = [each for each in span.named(low, high)]
        value = number(span.sentence.term(offset))
        if (
            value is None
            or not messages
            or (is_first and not near and span.kind is not PassageKind.TEXT and not span.is_comment)
        ):
            continue
        if near and len({name for _, name in near}) > 1:
            has_one_before = any(at < offset for at, _ in near)
            messages = messages[:1] if has_one_before else tuple(reading.messages[name] for _, name in near)
        kind = kinds[-1] if kinds else "message"
        if {"payload", "frame"} <= set(kinds) and behind is None:
            kind = "message"
        if (
            kind == "message"
            and words != "size"
            and behind is None
            and not is_first
            and not _BESIDE.search(before + text[offset:end])
        ):
            continue
        versions = {number(span.sentence.term(low + at.end() - 1)) for at in _VERSION.finditer(text[low:high])}
        versions = versions or {number(span.sentence.term(at.end() - 1)) for at in _VERSION.finditer(text[:low])}
        versions |= {Fraction(int(at[1])) for at in re.finditer(r"\bv([12])\b", sentence)}
        about = (
            Fraction(1, 10)
            if re.search(
                r"(?:\babout|\broughly|\baround|\bca\.?|\bapproximately|\bapprox\.?|\bnearly|\balmost|\bsome|~|\u2248) ?$",
                before,
            )
            else Fraction(0)
        )
        possible = [_possible(message, kind, sentence, versions) for message in messages]
        if any(message.id < 0 for message in messages) or any(
            abs(value - each) <= about * each for sizes in possible for each in sizes
        ):
            continue
        message, written = messages[0], span.sentence.term(offset).written
        text_ = f"{message.name} {sizes_of(message)}, not {written}{per_second(message, span.source_text(low, high))}"
        yield reading.found(
            SIZE, span.place(offset), f"{message.name} {kind} {written}", text_, size_hint(message, reading)
        )


_BESIDE = re.compile(
    r"(?:\bM|\bmessages?|\bit|\bwhich|\blength|\bsize|\btotal|\btakes|\blen|\blarge|\bthat|\btogether)\)?(?:,? ?\(?(?:id |#|number |message )*N\)?)?(?: (?:is|has|have|takes?|needs?|are|of|with|only|exactly|just|a|an|length|size|total|whole|the|in|itself|still|then"
    r"|base|payload|being|and|M|without|extensions?|up|to|long|expects|check|must|be|should|comes?|counts?|uses?|means))*[ ,:(=]*(?:N bytes[;,]? (?:and|or) )?N[ -]?\w*(?: bytes?)?$"
)


_VERSION = re.compile(r"mavlink[ -]?(?:v|version )?N")


def _possible(message: WireMessage, kind: str, sentence: str, versions: Collection[object]) -> set[int]:
    """The sizes of a message in a sense that the words leave open."""
    base, is_first = message.base_length, versions == {1}
    payloads = {base} if is_first else {base, message.length}
    if re.search(r"\bbase\b|without (?:the |its |any )?extensions?|\bminimum\b", sentence) and not re.search(
        r"\bwith (?:the |its |all )?extensions?|\bwith F", sentence
    ):
        payloads = {base}
    frames = {HEAD_V2 + each for each in payloads} if not is_first else set()
    frames |= {HEAD_V1 + base} if versions != {2} else set()
    if not re.search(r"\bunsigned\b|(?:without|no) (?:the |a )?signature", sentence):
        frames |= {each + SIGNATURE for each in frames}
    return payloads if kind == "payload" else frames if kind == "frame" else payloads | frames
