"""Sizes that are said of messages: "a frame has 47 bytes", "36 bytes, 54 with extensions", "length 28"."""

import re
from collections.abc import Collection, Iterator
from dataclasses import replace
from fractions import Fraction

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import ASKED, DENIED, OWN, PAST, PROPOSED, REPLACED, words
from codegen.claims.rules import SIZE, as_sure
from codegen.claims.size import per_second, size_hint, sizes_of
from codegen.claims.statements.fields import number
from codegen.claims.statements.subjects import subjects
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.model.price import HEAD_V1, HEAD_V2, SIGNATURE
from codegen.pattern import pattern

_BYTES = pattern(
    r"N(?: |-)?(?P<what>payload |base )?(?:bytes?|octets?)\b(?!\s?(?:/(?!message|frame|packet)|per (?!message"
    r"|frame|packet)|a second|each second|of (?!(?:the )?(?:payload|base|air|M))|for each|behind|before|more|at the"
    r"|in front|further|header|left|free|above|less|every|later|longer|larger|bigger|shorter|extra"
    r"|short|too|off|missing|lost|dropped))"
)
_LENGTH = pattern(
    r"\b(?:(?P<base>base |minimum |min )?(?:payload )?(?:length|len|size|payload))(?: (?:of|is|in bytes|for|M|the"
    r"|its|payload)){0,8}(?:[:=,]| is| of){0,4} ?(?P<number>N)(?!\w| ?(?:bytes?|%|m\b|by\b|fields|elements|points"
    r"|samples|items|entries|messages|arrays|values|floats|numbers|words|parts|blocks|channels|integers|T\b)|[.-]\d)"
    r"|\bsizeof ?\([^()N]*\) ?(?:==|<=|=|is) ?(?P<sizeof>N)",
    needs="len|payload|size",
)
_LENGTHS = pattern(
    r"N bytes?[;,.]?(?: \()?(?:(?: and| or|,)? (?P<then>N)(?: bytes)? (?:with|including) (?:the |all "
    r"|its )?(?:extensions?|F|everything|them|it)\b"
    r"|[^.NF;]{0,30} (?:with|including) (?:the |all |its )*(?:extensions?|everything|them|F(?! ?N)"
    r"|all)(?: \w+)?,?(?: it is| they are| that is|:| is| has| are)* (?P<last>N)(?! ?(?:hz|%|[A-Za-z])))"
)
_WITH = (
    r"(?:with|including|incl\.?|plus) (?:the |all |its |all its )*(?:extensions?|extension fields?|everything|them|F)\b"
)
_PAIRS = (
    pattern(
        r"(?P<first>N) bytes?(?: (?:base|in base|as base|payload|of payload|without(?: (?:the |its )?extensions)?))?"
        rf"[,;:/]? ?(?:\(|and |or |but )*(?P<then>N)(?: bytes?)? {_WITH}",
        needs="incl|plus|with",
    ),
    pattern(rf"\bfrom (?P<first>N) (?:bytes )?to (?P<then>N) bytes,? (?:of payload )?(?:by |{_WITH})", needs="to N"),
    pattern(r"\bM (?:grew|grows|went|goes|grown) from (?P<first>N) (?:bytes )?to (?P<then>N) bytes", needs="to N"),
    pattern(r"(?P<first>N) ?/ ?(?P<then>N) bytes"),
    pattern(
        r"(?P<first>N) bytes?(?: (?:of payload|in base|base))?,? (?:and |but )?the (?:full|whole|complete|extended)"
        r"(?: one| payload| form)?(?: is| has|:)? (?P<then>N)\b"
    ),
    pattern(r"(?P<first>N) bytes?(?: base)?,? (?:plus|and|with) (?:the )?extensions?:? (?:it is )?(?P<then>N)\b"),
    pattern(
        r"(?P<first>N)(?: bytes)?(?: of payload)? (?:in|for|with|as|under|on|\() ?(?:v1|mavlink N)\)?"
        r"(?:,| and| or|;| but| /)* ?(?P<then>N)(?: bytes)?(?: of payload)? (?:in|for|with|as|under|on|\() ?(?:v2"
        r"|mavlink N)",
        needs="mavlink N|v1",
    ),
)
"""The size of a message without its extensions, and with them."""
_FRAMED = pattern(
    r"(?P<first>N) bytes?(?: (?:of )?payload| base)?(?:,|;| and| or| \(|:)+ ?(?P<then>N)(?: bytes?)? (?:in|as|per"
    r"|for|on|with)"
    r" (?:the |a |an |one |each |whole |full |its )*(?:v2 |mavlink N )?(?:frame|packet|wire|link|header|air)\b"
)
"""The payload, and the whole frame."""
_SHORT = pattern(
    r"\bso far\b|truncat|trimmed|\bcut\b|\bzeros?\b|recorded|captur|shorten|often|\bwithout trailing|\bat least\b"
    r"|\bat most\b|\bup to\b|\bonly\b(?= N)|\bplus\b|(?<!including )(?<!without the )(?<!with )(?<!with the"
    r" )(?<!including the )header|\bbuffer\b|\bon average|\bshrink|\bshorter\b|\bskip"
    r"|\bminus\b|\bfirst\b|\blast\b|becomes|\bcannot\b|\bannounce|\bwith (?:that|this) |\bfills?\b|complete(?!"
    r" (?:M|v2|frame|payload|packet))"
)
_KINDS = pattern(
    r"(?P<payload>payloads?|\bdata part|\bbase (?:length|part|size|message|form|fields)|^base\b|without (?:the"
    r" )?header)"
    r"|(?P<frame>frames?|on (?:the|a) (?:wire|line|link|air)|\bin the air\b)|(?P<message>messages?\b"
    r"|\bit\b|\bM\b|length|long|size|large|big|takes|struct|parser|fields|\btotal|\btogether|costs?\b)"
)
_OF_ELSE = pattern(
    r"\band $|[FP](?: of M)?[,(]? ?(?:(?:is|are|has|have|takes?|holds?|carries|with|the|of|up to|an?|array|length"
    r"|size) )*$|\b(?:values|arrays|fields|elements|words|numbers|parts|items|entries|pieces|floats|blocks"
    r"|names?) (?:of|with|has|have|at) $|\b(?:adds?|plus|header|overhead|checksum|crc|array|buffer|chunk|name"
    r"|text|string"
    r"|field|each(?! M)|element|of which|reads?|asks?|asked|requests?|only|first|last|another|more than|less than"
    r"|within|every|copies|memcpy|block|chunks|pieces|blocks|ram|flash|heap|stack"
    r"|(?<!without )(?<!without the )extensions? (?:adds?|are|is|have|has|takes?)|file|page"
    r"|line|sd|write|wrote|offset|than|from|after|to|by|in|grows?|with|saves?|frees?|leaves|byte|drops?|(?<!M"
    r" )(?<!mavlink N )carr(?:y"
    r"|ies)|holds?|brings?) (?:\w+ ){0,2}$"
)
_BESIDE = pattern(
    r"(?:\bM|\bmessages?|\bit|\bwhich|\blength|\bsize|\btotal|\btakes|\blen|\blarge|\bthat"
    r"|\btogether)\)?(?:,? ?\(?(?:id |#|number |message )*N\)?)?(?: (?:in|with|under|for) (?:v1|v2|mavlink"
    r" N))?(?: (?:is|has|have|takes?|needs?|are|of|with|only"
    r"|exactly|just|a|an|length|size|total|whole|the|in|itself|still|then"
    r"|base|payload|being|and|M|without|extensions?|up|to|long|expects|check|must|be|should|weighs?|=|comes?|counts?|uses?|carries|each"
    r"|means))*[ ,:(=|]*(?:N bytes[;,]? (?:and|or) )?N[ -]?\w*(?: bytes?)?$"
)
_VERSION = pattern(r"mavlink[ -]?(?:v|version )?N")
_BEHIND = pattern(
    r"(?: |-)?(?:long |of |in )?(?:the )?(?P<payload>payload|base\b)"
    r"|(?: |-)?(?:long )?(?:(?:on|in|as) (?:the|an?)(?: whole| full| complete"
    r"| v[12]| (?:un)?signed| mavlink N){0,4} (?:wire|link|line|frame|packet)|(?:of air )?per"
    r" frame|(?P<frame>frames?|packets?))"
    r"|(?: |-)(?P<message>long|large|in size|in total|in all\b|(?:[a-z]+ )?M\b)"
)
_CLAUSES = pattern(r", (?:and|but|so|while|the) ")
_EACH = pattern(r" ?(?:/|per |a )(?:message|frame|packet)")
_FIELD_OF = pattern(r"[FP] (?:of|in) M (?:is|has|takes|holds|carries|with)\b[^,;.NM]*$")
"""A field that a size is said of, whose message stands behind it."""
_FOREIGN = pattern(
    r"\b(?:rtcmN?|ubx|nmea|can ?fd|can|sbd|iN?c|spi|uart|serial|modbus|crsf|sbus|s\.bus|msp|udp|tcp|ip|ethernet|lora"
    r"|rtp|ais|ads-?b|wi-?fi|usb|ppp|slip|hdlc|lte|iridium|dronecan|uavcan|bluetooth|ble|xbee|mqtt|raw|video|image"
    r"|log)(?:[ -]N)?[ -](?:frames?|packets?|messages?|sentences?|datagrams?|payloads?)\b"
    r"|\b(?:frames?|packets?|messages?) (?:on|over) (?:the )?(?:can|uart|spi|i2c|iNc|serial|bus|radio|modbus)\b"
)
"""A frame of another protocol, whose size is told."""
_FRAMES_OF = pattern(
    r"[ -](?:[a-z]+ )?(?:frames?|packets?|messages?|sentences?|datagrams?|records?) (?:of|from) (?:an?|the|our|its|this"
    r"|each|every) (?!M\b)"
)
"""Behind a size: it is that of frames of something that is no message, "nine-byte frames of a lidar"."""
_CALCULATED = pattern(r"(?<!M )= ?$|[+*/\u00d7] ?$|[FNP] ?[-+*\u00d7] ?$")
_GOES_ON = pattern(r" ?(?:[=+*\u00d7]|\+|- N)|(?: of| for| each| in(?: the)?)? [FP]\b| (?:are|is|were) left\b")
_HYPOTHETICAL = words(
    ASKED, DENIED[:2], PROPOSED, REPLACED[:1], PAST[:1], OWN[:1], r"\bown\b", r"\bif\b",
    r"\bwould\b(?! (?:be|have|take|need) )", r"\b(?:another|more|second|new|extra|added|adding)\b.*\bwould\b",
)  # fmt: skip
_BEGINS = pattern(r"[\W]*(?:message|msg|id|M|number)?[ :=(]*(?:N\)?)?,? ?")
_ABOUT = pattern(
    r"(?:\babout|\broughly|\baround|\bca\.?|\bapproximately|\bapprox\.?|\bnearly|\balmost|\bsome|~|\u2248) ?$"
)
_TOLERANCE = Fraction(1, 10)
"""By how much a size may be off that is called about so many bytes."""
_BASE = pattern(r"\bbase\b|without (?:the |its |any )?extensions?|\bminimum\b")
_EXTENDED = pattern(
    r"\bwith (?:the |its |all )?(?:extensions?|everything|them)\b|\bwith F"
    r"|\b(?:full|whole|complete|extended|long) (?:one|payload|message|form|version)\b"
    r"|\bthe (?:latter|whole|rest)\b|\bin full\b"
)
_ARGUMENT = pattern(r"(?:\b(?:at|offset|from|start|index)[:=] ?N, [a-z]+[:=] ?|, ?)$")
"""Before the length of a part that a call reads or writes: "read(length, 16)", "data.string(at: 21, length: 16)"."""
_UNSIGNED = pattern(r"\bunsigned\b|(?:without|no) (?:the |a )?signature")


@dataclass(frozen=True, slots=True)
class _Size:
    """A number of bytes at ``offset`` of the short text of ``span``, with its words up to ``end``.

    ``first`` is another size of the same message that it follows, as that with extensions does; ``is_frame`` says that
    it is that of a frame.
    """

    span: Span
    offset: int
    end: int
    words: str
    first: Fraction | None = None
    is_frame: bool = False

    @property
    def before(self) -> str:
        """The sentence up to the number."""
        low, _ = self.span.bounds(self.offset)
        return self.span.text[low : self.offset]

    @property
    def behind(self) -> str:
        """The sentence from the end of the words on."""
        _, high = self.span.bounds(self.offset)
        return self.span.text[self.end : high]

    @property
    def sentence(self) -> str:
        """The whole sentence."""
        low, high = self.span.bounds(self.offset)
        return pattern(r"\bnot (?:being )?signed\b").sub("unsigned", self.span.text[low:high])

    @property
    def clause(self) -> str:
        """The part of the sentence between conjunctions in which it stands."""
        before = self.before
        own = f"{before}\0{self.span.text[self.offset : self.span.bounds(self.offset)[1]]}"
        return (
            next(part for part in _CLAUSES.split(own) if "\0" in part)
            .replace("\0", "")
            .replace("not signed", "unsigned")
        )

    @property
    def is_first(self) -> bool:
        """Return whether only an id stands before the number in its sentence."""
        return not self.before.strip(" -*/#|") or _BEGINS.fullmatch(self.before) is not None


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every size of a part."""
    span = replace(span, sentence=span.sentence.plain())
    for size in _stated(span):
        kind = _kind(size)
        if kind is None or not _is_claim(size) or _is_amount(size):
            continue
        messages = _messages(reading, size)
        value = number(span.sentence.term(size.offset))
        if value is None or not messages or isinstance(value, float):
            continue
        possible = {each for message in messages for each in _meant(message, kind, size)}
        off = _TOLERANCE if _ABOUT.search(size.before) else Fraction(0)
        is_right = any(abs(Fraction(value) - each) <= off * each for each in possible)
        is_array = any(value == field.size for field in messages[0].fields if field.is_array)
        if not is_right and not is_array and not _is_room(size, messages[0], value):
            yield _finding(reading, size, messages[0], kind)


def _is_room(size: _Size, message: WireMessage, value: int | Fraction) -> bool:
    """Return whether a number is the size of an array of the message: "180 bytes in one message" of data."""
    is_held = pattern(r" (?:in|into|per|at) (?:one|a|an|each|every)? ?(?:message|packet|time)\b").match(size.behind)
    return is_held is not None and value in {field.size for field in message.fields if field.is_array}


def _stated(span: Span) -> Iterator[_Size]:
    """The numbers of bytes of a part."""
    paired = {
        each.start("then"): _Size(span, each.start("then"), each.end(), "size", _first(span, each.start("first")))
        for form in _PAIRS
        for each in form.finditer(span.text)
    }
    for each in _LENGTHS.finditer(span.text):
        at = each.start("then") if each["then"] else each.start("last")
        paired.setdefault(at, _Size(span, at, each.end(), "size", _first(span, each.start())))
    for each in _FRAMED.finditer(span.text):
        at = each.start("then")
        paired[at] = _Size(span, at, each.end(), "frame", _first(span, each.start("first")), is_frame=True)
    yield from paired.values()
    for each in _BYTES.finditer(span.text):
        if each.start() not in paired:
            yield _Size(span, each.start(), each.end(), each[0])
    for each in _LENGTH.finditer(span.text):
        is_of_frame = span.is_comment and "len" in each[0] and "base" not in each[0] and "M" not in span.text
        at = each.start("number") if each["number"] else each.start("sizeof")
        is_argument = span.is_code and not span.is_comment and _ARGUMENT.search(span.text, 0, at) is not None
        is_word = span.sentence.term(at).written.isalpha()  # "payload: five arrays" counts something else
        if at not in paired and not is_of_frame and not is_argument and not is_word:
            yield _Size(span, at, each.end(), each[0])


def _first(span: Span, offset: int) -> Fraction | None:
    value = number(span.sentence.term(offset))
    return None if value is None or isinstance(value, float) else Fraction(value)


def _kind(size: _Size) -> str | None:
    """Return what the size is of: "payload", "frame", or "message" for either; None if it may be something else."""
    if size.first is not None or _EACH.match(size.behind):
        return "frame" if size.is_frame else "message"
    if size.span.text.lstrip().startswith("}") or "sizeof" in size.words:
        return "payload"
    kinds = [found.lastgroup or "" for found in _KINDS.finditer(size.before + size.words)]
    behind = _BEHIND.match(size.behind)
    if behind is not None:
        return behind.lastgroup or ("frame" if behind[0].endswith(("frame", "packet")) else "message")
    if not kinds:
        low, _ = size.span.bounds(size.offset)
        is_word = size.span.sentence.term(size.offset).written.isalpha()
        return None if not size.is_first or is_word or pattern(r"[FP]|\?").search(size.span.text[:low]) else "message"
    kind = "message" if {"payload", "frame"} <= set(kinds) else "payload" if "payload" in kinds else kinds[-1]
    is_beside = size.is_first or _BESIDE.search(size.before + size.span.text[size.offset : size.end])
    return None if kind == "message" and not is_beside else kind


_OTHER_LINK = pattern(
    r"\b(?:baud|uart|rs-?(?:232|422|485)|i2c|spi|can bus|s\.?bus|crsf|modbus|nmea|n2k|ubx|rtcm|dshot|sbd|lora|ais)\b"
)
"""Words of a paragraph about the frames of something else, if it names no message."""


def _is_claim(size: _Size) -> bool:
    """Return whether the sentence states the size of a message, and not that of a part or of a supposed one."""
    span = size.span
    if not span.is_code and _OTHER_LINK.search(span.text) and not any(span.named(0, len(span.text))):
        return False
    before = size.before.rstrip(" /*#") if span.is_code else size.before
    if "sizeof" in size.words:
        return True
    if _FIELD_OF.search(before) or _FOREIGN.search(size.clause) or _FRAMES_OF.match(size.behind):
        return False
    if _WHOLE.match(size.behind) and not _SHORT.search(size.clause):
        return size.first is not None or not _HYPOTHETICAL.search(size.clause)
    if _FIRST_OF.search(before) and _OF_MESSAGE.match(size.behind):
        return _versions(size) == {1} or _BASE.search(size.sentence) is not None
    if _SHORT.search(size.clause) or _OF_ELSE.search(before) or _CALCULATED.search(before):
        return size.first is not None
    if _HYPOTHETICAL.search(size.clause) or re.search(r"hz|/s\b", span.text[size.offset + 1 : size.offset + 14]):
        return False
    return size.first is not None or _GOES_ON.match(size.behind) is None


_WHOLE = pattern(r" (?:in base|in all|in total|altogether|all in all)\b")
"""Behind the size of a whole message, whatever fields are listed before it."""
_FIRST_OF = pattern(r"\bfirst $")
_OF_MESSAGE = pattern(r" of (?:the )?M\b")


def _is_amount(size: _Size) -> bool:
    """Return whether a row of two columns, "NAME, frame | 44 bytes", states an amount, maybe without final zeros."""
    span = size.span
    return (
        span.kind is PassageKind.ROW
        and len(span.heads) == _CLAIM_AND_AMOUNT
        and pattern(r"\bM, [^|]*\bframe\b[^|]*\|\s*$").search(span.text[: size.offset]) is not None
    )


_CLAIM_AND_AMOUNT = 2


def _messages(reading: Reading, size: _Size) -> tuple[WireMessage, ...]:
    """The messages that a size may be said of."""
    span = size.span
    low, high = span.bounds(size.offset)
    near = [(at, name) for at, name in span.named(low, high)]
    is_row = span.kind is PassageKind.ROW
    if (is_row and not any(span.named(0, len(span.text)))) or (
        size.is_first and not near and span.kind is not PassageKind.TEXT and not span.is_comment
    ):
        return ()
    if near and all(at > size.offset for at, _ in near) and not is_row and (span.is_comment or not span.is_code):
        gap = span.text[size.end : near[0][0]]
        if re.search(r"[,;:]|\b(?:where|while|whereas|against|unlike)\b", gap) or _OTHER_ONE.match(span.text, size.end):
            return ()  # "it takes 340 bytes, so a NAME with its 42 ...", "it has 25 bytes, NAME 23"
    messages, is_sure = subjects(reading, span, size.offset)
    if size.is_first and not near and not is_sure and span.kind is PassageKind.TEXT and not span.is_code:
        return ()  # "20 bytes." answers what was asked before, which may be a field
    if len({name for _, name in near}) > 1:
        is_after_one = any(at < size.offset for at, _ in near)
        return messages[:1] if is_after_one else tuple(reading.messages[name] for _, name in near)
    return messages


_OTHER_ONE = pattern(r",? and (?:the |a )?M (?:has |is |takes |only |with )*N\b")
"""Behind a size: another message with its own one, "it has 64 bytes and NAME 62"."""


def _versions(size: _Size) -> set[object]:
    """The versions of MAVLink that a sentence is about, or else those that are named before it."""
    span = size.span
    low, high = span.bounds(size.offset)
    found: set[object] = {Fraction(int(at[1])) for at in pattern(r"\bv([12])\b").finditer(size.sentence)}
    found |= {number(span.sentence.term(low + at.end() - 1)) for at in _VERSION.finditer(span.text[low:high])}
    if found or _EXTENDED.search(size.sentence):  # extensions are of MAVLink 2, whatever was told of before
        return found
    return {number(span.sentence.term(at.end() - 1)) for at in _VERSION.finditer(span.text[:low])}


def _meant(message: WireMessage, kind: str, size: _Size) -> set[int]:
    """The sizes that a message may have where another one stands before it."""
    possible = _possible(message, kind, size.sentence, _versions(size))
    if size.first is None:
        return possible
    if size.is_frame:
        frames = {HEAD_V2 + message.base_length, HEAD_V2 + message.length, HEAD_V1 + message.base_length}
        return frames | {each + SIGNATURE for each in frames}
    extra = message.length - message.base_length
    return (
        {int(size.first) + extra} if size.first - message.base_length in (0, HEAD_V2, HEAD_V2 + SIGNATURE) else possible
    )


def _possible(message: WireMessage, kind: str, sentence: str, versions: Collection[object]) -> set[int]:
    """The sizes of a message in a sense that the words leave open."""
    base, is_first = message.base_length, versions == {1}
    is_base, is_extended = _BASE.search(sentence) is not None, _EXTENDED.search(sentence) is not None
    payloads = {base} if is_first or (is_base and not is_extended) else {base, message.length}
    is_only = is_extended and not is_base and not is_first and sentence.count("N") == 1
    payloads = {message.length} if is_only else payloads
    frames = set() if is_first else {HEAD_V2 + each for each in payloads}
    frames |= {HEAD_V1 + base} if versions != {2} else set()
    frames |= set() if _UNSIGNED.search(sentence) else {each + SIGNATURE for each in frames}
    return payloads if kind == "payload" else frames if kind == "frame" else payloads | frames


def _finding(reading: Reading, size: _Size, message: WireMessage, kind: str) -> Diagnostic:
    span = size.span
    written = span.sentence.term(size.offset).written
    rate = per_second(message, span.source_text(*span.bounds(size.offset)))
    text = f"{message.name} {sizes_of(message)}, not {written}{rate}"
    low, _ = span.bounds(size.offset)
    at = next((at for at, name in reversed([*span.named(low, size.offset)]) if name == message.name), None)
    words = span.source_text(at, size.end) if at is not None else f"{message.name} {kind} {written}"
    _, is_sure = subjects(reading, span, size.offset)
    return reading.found(
        as_sure(SIZE, is_sure=is_sure), span.place(size.offset), words, text, size_hint(message, reading)
    )
