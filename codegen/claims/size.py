"""Sizes of messages: "BATTERY_STATUS is 41 bytes", "a 27-byte BATTERY_STATUS_V2"."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.reading import Mention, Reading
from codegen.frozen import dataclass
from codegen.load.prose import Passage
from codegen.model.dialect.dialect import WireMessage
from codegen.model.price import HEAD_V1, HEAD_V2, SIGNATURE, Range
from codegen.pattern import pattern

_BYTES = pattern(
    r"(?<![\w.,-])(\d{1,4})(?:[ \u00a0]|-)?(?:payload )?(?:bytes?|octets?|B)\b(?![ ]?(?:/|per\b|a second))",
    re.IGNORECASE,
)
# What may stand between a message and its size without making the size that of something else.
_BETWEEN = pattern(
    r"(?:[\s,:=()|\u2013-]|\(#?\d{1,8}\)|(?:message |msg )?id[ :=]{0,2}#?\d{1,6}\b"
    r"|messages?|payload|frames?|packets?|size|length|total|whole|which|is|are|has|have|takes|needs|uses|of"
    r"|an?|the|with|without|only|exactly|base|full|complete|extensions?|v[12]|mavlink(?: ?[12])?|unsigned|signed|up to"
    r"|at most)*",
    re.IGNORECASE,
)
_BEFORE_NAME = pattern(r"[ ]?(?:(?:payload|frames?|packets?|long|of|for|the|an?)[ ]){0,5}", re.IGNORECASE)
_FRAME = pattern(r"frame|packet|wire|\bsent\b|truncat|trimmed|cut", re.IGNORECASE)
_PAYLOAD = pattern(r"payload", re.IGNORECASE)
_VERSION_1 = pattern(r"\bv1\b|mavlink ?1", re.IGNORECASE)
_VERSION_2 = pattern(r"\bv2\b|mavlink ?2", re.IGNORECASE)
_RATE = pattern(r"(\d{1,4}(?:\.\d{1,3})?) ?Hz\b")
_NEAR = 60
"""Characters between a message and its size."""


@dataclass(frozen=True, slots=True)
class SizeClaim:
    """``bytes`` at ``start`` of the passage's text, said of ``message``; ``words`` are the claim."""

    message: WireMessage
    bytes: int
    start: int
    end: int
    words: str
    is_version_1: bool = False


def size_claims(reading: Reading, passage: Passage, mentions: tuple[Mention, ...]) -> Iterator[SizeClaim]:
    """The sizes of a passage that are said of a message, possible or not."""
    text = passage.text
    position = 0
    for found in _BYTES.finditer(text):
        while position < len(mentions) and mentions[position].end <= found.start():
            position += 1
        before = mentions[position - 1] if position else None
        after = mentions[position] if position < len(mentions) else None
        if before is not None and _is_between(text, before.end, found.start()):
            low, high = before.start, found.end()
            message, start = reading.messages[before.name], found.start()
            yield SizeClaim(message, int(found[1]), start, high, text[low:high], _is_version_1(passage, low, high))
        elif after is not None and _BEFORE_NAME.fullmatch(text, found.end(), after.start):
            low, high = found.start(), after.end
            message = reading.messages[after.name]
            yield SizeClaim(message, int(found[1]), low, high, text[low:high], _is_version_1(passage, low, high))


def _is_version_1(passage: Passage, low: int, high: int) -> bool:
    """Return whether the sentence is about MAVLink 1 alone."""
    start, end = passage.sentence(low, high)
    text = passage.text[start:end]
    return _VERSION_1.search(text) is not None and _VERSION_2.search(text) is None


def _is_between(text: str, start: int, end: int) -> bool:
    return end - start <= _NEAR and _BETWEEN.fullmatch(text, start, end) is not None


def is_possible(claim: SizeClaim) -> bool:
    """Return whether the message can have that size in any sense that the words leave open."""
    message, words = claim.message, claim.words
    base, length = message.base_length, message.length
    if _PAYLOAD.search(words):
        return claim.bytes in ((base,) if claim.is_version_1 else (base, length))
    if claim.is_version_1 or _VERSION_1.search(words):
        return claim.bytes in (HEAD_V1 + base, base)
    if _FRAME.search(words):  # a frame of MAVLink 2 loses the zeros at the end of its payload
        return HEAD_V1 < claim.bytes <= HEAD_V2 + length + SIGNATURE
    frames = (HEAD_V2 + base, HEAD_V2 + length)
    return claim.bytes in (base, length, HEAD_V1 + base, *frames, *(frame + SIGNATURE for frame in frames))


def frame_bytes(message: WireMessage, reading: Reading) -> Range:
    """Bytes of a MAVLink 2 frame: as the project sends it, else whole without and with extensions."""
    low, high = Fraction(HEAD_V2 + message.base_length), Fraction(HEAD_V2 + message.length)
    return reading.reference.sent.get(message.name, Range(low, high))


def sizes_of(message: WireMessage) -> str:
    """The sizes of the payload of a message, in words."""
    extended = f", {message.length} with extensions" if message.length > message.base_length else ""
    return f"has a payload of {message.base_length} bytes{extended}"


def per_second(message: WireMessage, sentence: str) -> str:
    """Return the bytes per second of a message's frames at the sentence's rate, as a hint; empty without a rate."""
    rate = _RATE.search(sentence)
    if rate is None:
        return ""
    whole = HEAD_V2 + message.base_length
    return f"; frames of {whole} bytes (MAVLink 2) at {rate[1]} Hz are {_shown(whole * Fraction(rate[1]))} bytes/s"


def size_hint(message: WireMessage, reading: Reading) -> str:
    """The sizes of whole frames of a message, in words."""
    low, high = HEAD_V2 + message.base_length, HEAD_V2 + message.length
    both = f"{low} to {high}" if low != high else str(low)
    sent = reading.reference.sent.get(message.name)
    here = "" if sent is None else f"; this project sends {sent}"
    return f"whole frames have {both} bytes in MAVLink 2, {HEAD_V1 + message.base_length} in MAVLink 1{here}"


def _shown(value: Fraction) -> str:
    return f"{float(value):g}"
