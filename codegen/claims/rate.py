"""Bytes per second at a rate: "BATTERY_STATUS at 2 Hz takes 96 bytes/s", "41 bytes at 2 Hz = 82 bytes/sec"."""

import re
from collections.abc import Iterator, Sequence
from fractions import Fraction

from codegen.claims.reading import Reading, between
from codegen.claims.ruled_out import is_aside
from codegen.claims.rules import as_sure
from codegen.claims.size import SizeClaim, frame_bytes, is_possible, size_claims
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import Passage
from codegen.model.dialect.dialect import WireMessage
from codegen.model.price import HEAD_V1, HEAD_V2, SIGNATURE, Range
from codegen.pattern import pattern

RULE = Rule(
    "claim-bytes-per-second",
    "A document gives a message that is sent at a rate more or fewer bytes per second than its frames can have, or its "
    "bytes multiplied with its rate are another number. Correct it: a frame of MAVLink 2 is the payload, without the "
    "zeros at its end, and 12 bytes.",
    remedy="compute it anew: the rate times the payload and 12 bytes of MAVLink 2",
)

_PER_SECOND = pattern(
    r"(?<![\w.,-])(?P<number>\d{1,7}(?:\.\d{1,3})?) ?(?:(?P<bytes>bytes?|B)|(?P<bits>bits?|b))"
    r" ?(?:/ ?s(?:ec(?:ond)?)?|ps|per second|a second|each second|every second)\b",
)
_COSTS = pattern(
    r"(?<![\w.,-])(?P<rate>\d{1,4}(?:\.\d{1,3})?) ?Hz (?:costs?|takes?|needs?|makes?|is|are|means|=) (?:exactly )?$"
)
_NUMBER = r"(?<![\w.,-])(?P<{}>\d{{1,4}}(?:\.\d{{1,3}})?)"
_RATE = pattern(
    rf"{_NUMBER.format('hertz')} ?Hz\b"
    rf"|{_NUMBER.format('times')} (?:times |messages |frames |packets |of them )(?:per|a|each|every|in a|in each)"
    rf" second\b"
    rf"|\bevery {_NUMBER.format('ms')} ?(?:ms|milliseconds)\b|\bevery {_NUMBER.format('s')} ?(?:s|sec|seconds)\b"
    r"|(?P<once>\b(?:once|one) (?:per|a|each|every) second\b)"
)
_USED = pattern(r"\buse (?P<rate>\d{1,3})(?=[.,;]| now\b|$)")
_ABOUT = pattern(
    r"(?:about|roughly|around|approximately|approx\.?|ca\.?|nearly|almost|some|~|\u2248) ?$", re.IGNORECASE
)
_CUT = pattern(
    r"\benough\b|\bothers?\b|\btogether\b|\blink (?:has|gives|carries)\b|truncat|trimmed|\bcut\b|zeros|average|measured"
    r"|\bmost\b|\bless\b|\bbelow\b|\bup to\b",
    re.IGNORECASE,
)
_SEVERAL = pattern(r"\b\d+ [A-Za-z]+ (?:at|with) $")
"""Before a rate: several senders, whose bytes add up."""
_FRAMES = pattern(r"\bframes?\b|\bpackets?\b|on the wire", re.IGNORECASE)
_OFF = Fraction(1, 10)
"""By how much bytes per second may be off that are about so many."""
_BITS_OF_BYTE = (8, 10)
"""Bits of a byte, and with start and stop on a serial line."""


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every rate in bytes per second that stands with one message and one rate in Hz."""
    for passage in reading.prose.passages:
        mentions = reading.mentioned(passage)
        claims: list[SizeClaim] | None = None
        for found in _PER_SECOND.finditer(passage.text):
            start, end = _row_or_sentence(passage.text, *passage.sentence(found.start(), found.end()))
            if _OF_WHOLE.search(passage.text, start, found.start()) or _MORE.search(passage.text, start, end):
                continue
            inside = between(mentions, start, end)
            rates = _rates(passage.text, start, end) or _rates(passage.text, 0, start)
            lead = _COSTS.search(passage.text, max(start, found.start() - 40), found.start())
            is_of_several = lead is not None and _SEVERAL.search(passage.text, 0, lead.start("rate")) is not None
            if not inside and lead is not None and not is_of_several and Fraction(lead["rate"]) and found["bytes"]:
                yield from _unnamed(reading, passage, found, Fraction(lead["rate"]))
            if len({mention.name for mention in inside}) != 1 or not rates or _CUT.search(passage.text, start, end):
                continue
            claims = list(size_claims(reading, passage, mentions)) if claims is None else claims
            sizes = between(claims, start, end)
            message = reading.messages[inside[0].name]
            if any(not is_possible(claim) for claim in sizes):
                continue  # where a size is wrong, that finding says what follows
            said = _wrong(reading, passage, found, message, sorted(rates), sizes, (start, end))
            if said is not None:
                text, hint, is_sure = said
                place, words = passage.place_at(found.start()), passage.text[start:end].strip()
                yield reading.found(
                    as_sure(RULE, is_sure=is_sure), place, words, f"{text}, not {found['number']}", hint
                )


_OF_WHOLE = pattern(r"(?:%|\bper ?cent|\bpart|\bshare|\bfraction|\bout) of (?:the |an? |its |all )?$", re.IGNORECASE)
"""Before what a line can carry, of which a message takes a part: "7 % of the 5760 bytes/s"."""


_MORE = pattern(
    r"(?:/ ?s|\bps|per second|a second) (?:more|extra|less|on top|in addition|additional(?:ly)?)\b|\badds? (?:about "
    r"|another )?\d",
    re.IGNORECASE,
    needs="add|extra|less|more|on top",
)
"""Bytes per second that come on top of those of a message."""


def _rates(text: str, start: int, end: int) -> set[Fraction]:
    """The rates in Hz that a part of a text states."""
    found = set()
    for each in _RATE.finditer(text, start, end):
        if each["once"]:
            found.add(Fraction(1))
            continue
        kind = each.lastgroup or ""
        value = Fraction(each[kind])
        if value:
            found.add({"ms": 1000 / value, "s": 1 / value}.get(kind, value))
    found |= (
        {Fraction(each["rate"]) for each in _USED.finditer(text, start, end) if int(each["rate"])} if found else set()
    )
    return found


def _wrong(
    reading: Reading,
    passage: Passage,
    found: "re.Match[str]",
    message: WireMessage,
    rates: Sequence[Fraction],
    sizes: Sequence[SizeClaim],
    sentence: tuple[int, int],
) -> tuple[str, str | None, bool] | None:
    """Return the right bytes per second, a hint, and whether that is sure; None where the number may be right."""
    text, number = passage.text, Fraction(found["number"])
    stated = [number / bits for bits in _BITS_OF_BYTE] if found["bits"] else [number]
    sent, rate = frame_bytes(message, reading), rates[-1]
    if found["bytes"] and len(rates) == 1 and (said := _contradiction(found["number"], message, rate, sizes, sent)):
        return (*said, True)
    is_about = _ABOUT.search(text, max(found.start() - 16, 0), found.start()) is not None
    off = _OFF if is_about else Fraction(0)
    own = exact_sizes(message)
    if _FRAMES.search(text, max(sentence[0] - 120, 0), sentence[1]):
        own -= {message.base_length, message.length}
    fitting = [size * each for size in own for each in rates]
    if any(abs(total - one) <= off * total + _PRECISION for total in fitting for one in stated):
        return None
    if any(sent.low * each <= one <= sent.high * each for each in rates for one in stated) and reading.reference.sent:
        return None
    if sizes or is_aside(text[slice(*sentence)].lower()) or text[max(found.start() - 2, 0) : found.start()] == "= ":
        return None
    hertz = _shown(rate)
    bits = " bits" if found["bits"] else ""
    total = sent.times(rate * 8) if bits else sent.times(rate)
    said_of = f"{message.name}: frames of {sent} bytes are {total}{bits or ' bytes'}/s at {hertz} Hz"
    return said_of, "unless zeros at the end of its payload are cut", False


_PRECISION = Fraction(1, 2)


def exact_sizes(message: WireMessage) -> set[int]:
    """The bytes of a message that a document may count: of its payload, and of whole frames of either version."""
    payloads = {message.base_length, message.length}
    frames = {HEAD_V2 + each for each in payloads} | {HEAD_V1 + message.base_length}
    return payloads | frames | {HEAD_V2 + SIGNATURE + each for each in payloads}


def _unnamed(reading: Reading, passage: Passage, found: "re.Match[str]", rate: Fraction) -> Iterator[Diagnostic]:
    """ "2 Hz costs 96 bytes/s", of one of the messages that the document names."""
    size = Fraction(found["number"]) / rate
    messages = [reading.messages[name] for name in dict.fromkeys(name for _, name in reading.sightings)]
    ranges = [frame_bytes(message, reading) for message in messages]
    if not messages or any(size.denominator == 1 and each.low <= size <= each.high for each in ranges):
        return
    own = "they are no whole bytes" if size.denominator > 1 else "no message of the document has frames of that size"
    text = f"{found['number']} bytes/s are {_shown(size)} bytes at {_shown(rate)} Hz: {own}"
    yield reading.found(RULE, passage.place_at(found.start()), f"{_shown(rate)} Hz {found[0]}", text)


def _contradiction(
    written: str, message: WireMessage, rate: Fraction, sizes: Sequence[SizeClaim], sent: Range
) -> tuple[str, str | None] | None:
    """Return the right bytes per second, and a hint; None where the number may be right."""
    computed = f"frames of {sent} bytes are {sent.times(rate)} bytes/s at {_shown(rate)} Hz"
    stated = Fraction(written)
    if len(sizes) == 1 and not _is_product(stated, sizes[0].bytes, rate, written):
        return f"{sizes[0].bytes} bytes at {_shown(rate)} Hz are {_shown(sizes[0].bytes * rate)} bytes/s", computed
    if rate * (HEAD_V1 + 1) <= stated <= rate * (HEAD_V2 + message.length + SIGNATURE):
        return None
    return f"{message.name}: {computed}", None


def _row_or_sentence(text: str, start: int, end: int) -> tuple[int, int]:
    """A cell of a table belongs to its row, where the message stands."""
    return (0, len(text)) if text.startswith("|") and len(text) < 500 else (start, end)


def _is_product(stated: Fraction, size: int, rate: Fraction, written: str) -> bool:
    """Return whether a number is size times rate, as it is or with a frame's bytes around it, to its own decimals."""
    _, _, places = written.partition(".")
    precision = Fraction(1, 10 ** len(places))
    return any(abs(stated - (size + more) * rate) < precision for more in (0, HEAD_V1, HEAD_V2, HEAD_V2 + SIGNATURE))


def _shown(value: Fraction) -> str:
    return f"{float(value):g}"
