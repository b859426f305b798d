"""Cases for comparing a generated codec with pymavlink: those of every message of a dialect, of streams and of enums.

A case is a line of JSON for conform.py: the operation, the kind of case, and what is given and expected. Everything
that is expected comes from pymavlink, nothing from the codec.
"""

import json
import random
from collections.abc import Collection, Iterable, Iterator
from pathlib import Path
from typing import Any

from conformance_frames import COMPONENT, SYSTEM, Side, signed_frame
from conformance_oracle import Dialect, Field, Message
from conformance_streams import stream_cases
from conformance_values import (
    all_maximum,
    all_minimum,
    all_zero,
    random_values,
    stated_values,
    values_json,
    values_of_every_kind,
)

Case = list[Any]


def write_cases(path: Path, dialect: Dialect, messages: Collection[Message], seed: int, rounds: int) -> None:
    """Write the cases of some of a dialect's messages; the codec has them all."""
    chance = random.Random(f"{dialect.name} {seed}")
    side = Side(dialect)
    head = {
        "ids": sorted(message.id for message in dialect.messages),
        "messages": [message.description for message in messages],
        "system": SYSTEM,
        "component": COMPONENT,
    }
    with path.open("w", encoding="utf-8") as file:
        file.write(json.dumps(head) + "\n")
        for case in _cases(side, messages, chance, rounds):
            file.write(json.dumps(case, separators=(",", ":")) + "\n")


def _cases(side: Side, messages: Collection[Message], chance: random.Random, rounds: int) -> Iterable[Case]:
    yield from enum_cases(side.dialect)
    for index, message in enumerate(messages):
        yield from message_cases(side, message, index, chance, rounds)
    yield from stream_cases(side, messages, chance)


def message_cases(side: Side, message: Message, index: int, chance: random.Random, rounds: int) -> Iterator[Case]:
    """All cases of a message; `index` is its place among those that conform.py is told of."""
    yield ["classes", "class", index]
    for version in (2, 1) if message.in_v1 else (2,):
        for kind, values in values_of_every_kind(message, version, chance, rounds):
            sequence = chance.randrange(256)
            frame = side.frame(message, version, values, sequence)
            sent = values_json(message, values)
            read = side.decoded(message, frame)
            yield ["both", kind, index, version, sequence, sent, frame.hex(), None if read == sent else read]
        yield from _default(side, message, index, version, chance)
        yield from _live(side, message, index, version, chance)
    yield from _received(side, message, index, chance, rounds)


def _default(side: Side, message: Message, index: int, version: int, chance: random.Random) -> Iterator[Case]:
    values = all_zero(message) | {item.name: item.initial for item in message.fields if item.initial}
    values |= {item.name: None for item in message.fields if item.unknown}
    sequence = chance.randrange(256)
    frame = side.frame(message, version, values, sequence)
    yield ["default", "new message", index, version, sequence, frame.hex(), side.decoded(message, frame)]


def _live(side: Side, message: Message, index: int, version: int, chance: random.Random) -> Iterator[Case]:
    """Live fields: all that can be, in any order, or some elements of them."""
    able = [item for item in message.fields if item.code in "BHIbhi"]
    for values in (random_values(message, chance), all_minimum(message), all_maximum(message)) if able else ():
        places: list[tuple[Field, int | None]] = []
        for item in chance.sample(able, len(able)):
            if item.count and chance.random() < 0.5:
                elements = range(item.count)
                places += [(item, element) for element in chance.sample(elements, chance.randint(1, item.count))]
            else:
                places.append((item, None))
        sequence = chance.randrange(256)
        frame = side.frame(message, version, values, sequence)
        names = [item.name if element is None else f"{item.name}[{element}]" for item, element in places]
        sent: list[int] = []
        read: list[int] = []
        for item, element in places:
            value = values[item.name]
            numbers = value[element] if element is not None else value
            numbers = numbers if isinstance(numbers, list) else [numbers]
            sent += [_signed(number) for number in numbers]
            is_there = version == 2 or not item.is_extension
            read += [_signed(number) if is_there else 0 for number in numbers]
        yield [
            *("live", "live", index, version, sequence, names, [sent, read], values_json(message, values)),
            *(frame.hex(), side.decoded(message, frame)),
        ]


def _signed(number: int) -> int:
    """Return the number that an array of int32 holds of it."""
    return number - (1 << 32) if number >= 1 << 31 else number


def _received(side: Side, message: Message, index: int, chance: random.Random, rounds: int) -> Iterator[Case]:
    """Yield frames as others send them: any bits, zeros left in or out, fewer and more extensions, a signature."""
    length = message.length

    def case(kind: str, frame: bytes) -> Case:
        return ["arrives", kind, index, frame.hex(), side.decoded(message, frame)]

    for _ in range(rounds):
        yield case("any bits", side.framed(message, chance.randbytes(length), chance))
    full = bytes(chance.randrange(1, 256) for _ in range(length))
    payloads = [full[:used] + bytes(length - used) for used in range(length + 1)]
    sequence = chance.randrange(256)
    blank = message.in_v2(*stated_values(message, all_zero(message)))
    side.v2.seq = sequence
    frames = [bytes(blank._pack(side.v2, message.in_v2.crc_extra, payload)).hex() for payload in payloads]
    yield ["truncated", "every truncated length", index, sequence, full.hex(), frames]
    for used in sorted({0, 1, length // 2, length - 1}):
        yield case("zeros left in", side.whole(message, payloads[used], chance))
    if message.has_extensions:
        yield case("no extensions", side.whole(message, full[: message.base_length], chance))
        if message.in_v1:
            side.v2.seq = sequence
            frame = message.in_v2(*stated_values(message, random_values(message, chance))).pack(
                side.v2, force_mavlink1=True
            )
            yield case("extensions in MAVLink 1", bytes(frame))
    for more in sorted({1, 255 - length, chance.randint(1, max(1, 255 - length))} if length < 255 else ()):
        tail = bytes(chance.randrange(1, 256) for _ in range(more))
        yield case("newer extensions", side.whole(message, chance.randbytes(length) + tail, chance))
    yield case("signed", signed_frame(side, message, chance))


def enum_cases(dialect: Dialect) -> Iterator[Case]:
    """The entries of every enum that has any, without the one that pymavlink adds at the end."""
    for entries in dialect.v2.enums.values():
        values = {entry.name: value for value, entry in entries.items() if not entry.name.endswith("_ENUM_END")}
        if values:
            yield ["enum", "enum entries", values]
