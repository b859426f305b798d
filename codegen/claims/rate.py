"""Bytes per second at a rate: "BATTERY_STATUS at 2 Hz takes 96 bytes/s", "41 bytes at 2 Hz = 82 bytes/sec"."""

import re
from collections.abc import Iterator, Sequence
from fractions import Fraction

from codegen.claims.reading import Reading, between
from codegen.claims.size import SIGNATURE, SizeClaim, frame_bytes, is_possible, size_claims
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import Passage
from codegen.model.dialect.dialect import WireMessage
from codegen.model.price import HEAD_V1, HEAD_V2, Range

RULE = Rule(
    "claim-bytes-per-second",
    "A document gives a message that is sent at a rate more or fewer bytes per second than its frames can have, or its "
    "bytes multiplied with its rate are another number. Correct it: a frame of MAVLink 2 is the payload, without the "
    "zeros at its end, and 12 bytes.",
)

_PER_SECOND = re.compile(
    r"(?<![\w.,-])(\d{1,7}(?:\.\d{1,3})?) ?(?:bytes?|B) ?(?:/ ?s(?:ec(?:ond)?)?|per second|a second)\b", re.IGNORECASE
)
_COSTS = re.compile(
    r"(?<![\w.,-])(?P<rate>\d{1,4}(?:\.\d{1,3})?) ?Hz (?:costs?|takes?|needs?|makes?|is|are|means|=) (?:exactly )?$"
)
_RATE = re.compile(r"(?<![\w.,-])(\d{1,4}(?:\.\d{1,3})?) ?Hz\b")


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every rate in bytes per second that stands with one message and one rate in Hz."""
    for passage in reading.prose.passages:
        mentions = reading.mentioned(passage)
        claims: list[SizeClaim] | None = None
        for found in _PER_SECOND.finditer(passage.text):
            start, end = _row_or_sentence(passage.text, *passage.sentence(found.start(), found.end()))
            inside = between(mentions, start, end)
            rates = {rate[1] for rate in _RATE.finditer(passage.text, start, end)}
            lead = _COSTS.search(passage.text, max(start, found.start() - 40), found.start())
            if not inside and lead is not None and Fraction(lead["rate"]):
                yield from _unnamed(reading, passage, found, Fraction(lead["rate"]))
            if len({mention.name for mention in inside}) != 1 or len(rates) != 1:
                continue
            claims = list(size_claims(reading, passage, mentions)) if claims is None else claims
            sizes = between(claims, start, end)
            message, rate = reading.messages[inside[0].name], Fraction(rates.pop())
            if rate == 0 or any(not is_possible(claim) for claim in sizes):
                continue  # where a size is wrong, that finding says what follows
            said = _contradiction(found[1], message, rate, sizes, frame_bytes(message, reading))
            if said is not None:
                place, words = passage.place_at(found.start()), passage.text[start:end].strip()
                yield reading.found(RULE, place, words, f"{said[0]}, not {found[1]}", said[1])


def _unnamed(reading: Reading, passage: Passage, found: "re.Match[str]", rate: Fraction) -> Iterator[Diagnostic]:
    """ "2 Hz costs 96 bytes/s", of one of the messages that the document names."""
    size = Fraction(found[1]) / rate
    messages = [reading.messages[name] for name in dict.fromkeys(name for _, name in reading.sightings)]
    ranges = [frame_bytes(message, reading) for message in messages]
    if not messages or any(size.denominator == 1 and each.low <= size <= each.high for each in ranges):
        return
    own = "they are no whole bytes" if size.denominator > 1 else "no message of the document has frames of that size"
    text = f"{found[1]} bytes/s are {_shown(size)} bytes at {_shown(rate)} Hz: {own}"
    yield reading.found(RULE, passage.place_at(found.start()), f"{_shown(rate)} Hz {found[0]}", text)


def _contradiction(
    written: str, message: WireMessage, rate: Fraction, sizes: Sequence[SizeClaim], sent: Range
) -> tuple[str, str | None] | None:
    """What a number of bytes per second should be, and a hint; None where it may be right."""
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
    """Whether a number is size times rate, or a frame of that payload times rate, as precisely as it is written."""
    _, _, places = written.partition(".")
    precision = Fraction(1, 10 ** len(places))
    return any(abs(stated - (size + more) * rate) < precision for more in (0, HEAD_V1, HEAD_V2, HEAD_V2 + SIGNATURE))


def _shown(value: Fraction) -> str:
    return f"{float(value):g}"
