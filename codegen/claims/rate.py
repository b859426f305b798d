"""Bytes per second at a rate: "BATTERY_STATUS at 2 Hz takes 96 bytes/s", "41 bytes at 2 Hz = 82 bytes/sec"."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.reading import Reading
from codegen.claims.size import SIGNATURE, frame_bytes, is_possible, size_claims
from codegen.diagnostics import Diagnostic, Rule
from codegen.model.price import HEAD_V1, HEAD_V2

RULE = Rule(
    "claim-bytes-per-second",
    "A document gives a message that is sent at a rate more or fewer bytes per second than its frames can have, or its "
    "bytes multiplied with its rate are another number. Correct it: a frame of MAVLink 2 is the payload, without the "
    "zeros at its end, and 12 bytes.",
)

_PER_SECOND = re.compile(
    r"(?<![\w.,-])(\d{1,7}(?:\.\d{1,3})?) ?(?:bytes?|B) ?(?:/ ?s(?:ec(?:ond)?)?|per second|a second)\b", re.IGNORECASE
)
_RATE = re.compile(r"(?<![\w.,-])(\d{1,4}(?:\.\d{1,3})?) ?Hz\b")


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every rate in bytes per second that stands with one message and one rate in Hz."""
    for passage, mentions in reading.passages_with_messages():
        for found in _PER_SECOND.finditer(passage.text):
            start, end = _row_or_sentence(passage.text, *passage.sentence(found.start(), found.end()))
            names = {mention.name for mention in mentions if start <= mention.start < end}
            rates = {rate[1] for rate in _RATE.finditer(passage.text, start, end)}
            if len(names) != 1 or len(rates) != 1:
                continue
            message, rate, stated = reading.messages[names.pop()], Fraction(rates.pop()), Fraction(found[1])
            if rate == 0:
                continue
            words = passage.text[start:end].strip()
            sizes = [claim for claim in size_claims(reading, passage, mentions) if start <= claim.start < end]
            sent = frame_bytes(message, reading)
            computed = f"frames of {sent} bytes are {sent.times(rate)} bytes/s at {_shown(rate)} Hz"
            if any(not is_possible(claim) for claim in sizes):
                continue  # the size is what is wrong, and that finding says what follows
            if len(sizes) == 1 and not _is_product(stated, sizes[0].bytes, rate, found[1]):
                text = f"{sizes[0].bytes} bytes at {_shown(rate)} Hz are {_shown(sizes[0].bytes * rate)} bytes/s"
            elif stated < rate * (HEAD_V1 + 1) or stated > rate * (HEAD_V2 + message.length + SIGNATURE):
                text = f"{message.name}: {computed}"
            else:
                continue
            place = passage.place_at(found.start())
            hint = None if text.endswith(computed) else computed
            yield reading.found(RULE, place, words, f"{text}, not {found[1]}", hint)


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
