"""Streams: frames among garbage, unknown messages, unknown flags and damaged frames, and what a receiver counts."""

import random
from collections.abc import Callable, Collection, Iterator
from typing import Any

from conformance_frames import Side, arrived, raw_frame, raw_frame_1, signed_frame
from conformance_oracle import Message
from conformance_values import random_values

STARTS = b"\xfd\xfe"
NO_START = bytes(byte for byte in range(256) if byte not in STARTS)


def stream_cases(side: Side, messages: Collection[Message], chance: random.Random) -> Iterator[list[Any]]:
    """Streams with frames of each message among garbage, unknown messages and damaged frames.

    What is no frame has no byte in it that starts one: so it is certain what there is to count. Frames that have such
    a byte for their id or length come damaged on their own.
    """
    known = list(messages)
    for start in range(0, len(known), 12):
        yield _stream(side, known[start : start + 12], chance, _bad_checksum, "wrong checksums")
        yield _stream(side, known[start : start + 12], chance, _bad_length, "wrong lengths")
    for message in known:
        for damage in (_bad_checksum, _bad_length):
            if _clean(lambda message=message, damage=damage: damage(message, chance)) is None:
                counters = _counters(crc_errors=(1, 99), unknown=(0, 99), dropped=(0, 99))
                yield ["stream", "damaged frames", [(damage(message, chance) + bytes(300)).hex()], [], counters]


def _counters(**bounds: tuple[int, int]) -> dict[str, tuple[int, int]]:
    names = ("received", "signed", "refused", "unknown", "crc_errors", "dropped")
    return {name: bounds.get(name, (0, 0)) for name in names}


def _stream(
    side: Side,
    messages: list[Message],
    chance: random.Random,
    damage: Callable[[Message, random.Random], bytes],
    kind: str,
) -> list[Any]:
    parts: list[bytes] = []
    expected: list[list[Any]] = []
    counted = dict.fromkeys(("signed", "unknown", "crc_errors", "dropped"), 0)
    for message in messages:
        for counter, make in (("crc_errors", damage), ("dropped", _flagged)):
            bad = _clean(lambda message=message, make=make: make(message, chance))
            if bad is not None:
                parts += [_garbage(chance), bad]
                counted[counter] += 1
        parts += [_garbage(chance), _unknown(side, chance)]
        counted["unknown"] += 1
        for version in (2, 1) if message.in_v1 else (2,):
            frame = side.frame(message, version, random_values(message, chance), chance.randrange(256))
            parts += [_garbage(chance), frame]
            expected.append(arrived(message, frame))
        frame = signed_frame(side, message, chance)
        parts.append(frame)
        counted["signed"] += 1
        expected.append(arrived(message, frame))
    stream = b"".join(parts)
    # A length that is too long hides the next frames from pymavlink: it does not look into what it took for a frame.
    if damage is _bad_checksum:
        assert side.heard(stream) == expected
    bounds = {name: (number, number) for name, number in counted.items()}
    counters = _counters(received=(len(expected), len(expected)), **bounds)
    return ["stream", kind, [piece.hex() for piece in _cut(stream + bytes(300), chance)], expected, counters]


def _cut(stream: bytes, chance: random.Random) -> Iterator[bytes]:
    longest = chance.choice((7, 60, 1000))
    while stream:
        size = chance.randint(1, longest)
        yield stream[:size]
        stream = stream[size:]


def _garbage(chance: random.Random) -> bytes:
    return bytes(chance.choices(NO_START, k=chance.randrange(20)))


def _clean(make: Callable[[], bytes]) -> bytes | None:
    """A frame without a byte that starts one, but for the first; None if there is none."""
    for _ in range(60):
        frame = make()
        if not any(start in frame[1:] for start in STARTS):
            return frame
    return None


def _whole(message: Message, chance: random.Random) -> bytearray:
    """A frame of either version without needless bytes that start one."""
    payload = bytes(chance.choices(NO_START[1:], k=message.length))
    extra = message.in_v2.crc_extra
    if message.in_v1 and chance.random() < 0.5:
        return bytearray(raw_frame_1(message.id, payload[: message.base_length], extra, chance))
    return bytearray(raw_frame(message.id, payload, extra, chance))


def _bad_checksum(message: Message, chance: random.Random) -> bytes:
    """A frame with one wrong bit, in the checksum or before it."""
    frame = _whole(message, chance)
    frame[chance.choice((-1, -2, -3))] ^= 1 << chance.randrange(8)
    return bytes(frame)


def _bad_length(message: Message, chance: random.Random) -> bytes:
    """A frame that says that it is shorter or longer than it is, so that it hides what follows."""
    frame = _whole(message, chance)
    length = frame[1]
    frame[1] = length - 1 if length == 255 else chance.choice((length - 1, length + 1, 255))
    return bytes(frame)


def _flagged(message: Message, chance: random.Random) -> bytes:
    """A frame with an incompatible flag that nobody knows."""
    payload = bytes(chance.choices(NO_START, k=message.length))
    return raw_frame(message.id, payload, message.in_v2.crc_extra, chance, flags=chance.choice((2, 0x80)))


def _unknown(side: Side, chance: random.Random) -> bytes:
    """A frame of a message that the dialect does not have, with any CRC_EXTRA."""
    extra = chance.randrange(256)
    while True:
        payload = bytes(chance.choices(NO_START, k=chance.randrange(256)))  # whose length may be a start, too
        number = chance.choice((chance.randrange(256), chance.randrange(1 << 16), chance.randrange(1 << 24)))
        if number not in side.dialect.v2.mavlink_map:
            if number < 256 and chance.random() < 0.5:
                frame = raw_frame_1(number, payload, extra, chance)
            else:
                frame = raw_frame(number, payload, extra, chance)
            if not any(start in frame[1:] for start in STARTS):
                return frame
