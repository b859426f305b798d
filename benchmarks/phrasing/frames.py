"""Facts about a message on the wire: sizes, bandwidth, its id and its check, and the order of its fields."""

import random
from collections.abc import Mapping

from codegen.model.dialect.dialect import WireMessage
from phrasing.filling import ENOUGH, HALF, Fact, Maker, both, named, of_field, some_message


def _payload(chance: random.Random) -> Fact:
    message = some_message(chance)
    sizes = {message.base_length, message.length}
    possible = {size + more for size in sizes for more in (0, 8, 12, 21, 25)}
    wrong = next(size for size in (message.base_length + 3, message.base_length + 5, 200) if size not in possible)
    return both(named(message), chance.choice([*sizes]), wrong)


def _extended_message(chance: random.Random) -> WireMessage:
    while (message := some_message(chance)).base_length == message.length:
        pass
    return message


def _base(chance: random.Random) -> Fact:
    message = _extended_message(chance)
    return both(named(message), message.base_length, message.length)


def _extended(chance: random.Random) -> Fact:
    message = _extended_message(chance)
    return both(named(message), message.length, message.length + chance.choice([1, 3, 7]))


def _frame(chance: random.Random) -> Fact:
    while (message := some_message(chance)).base_length != message.length:
        pass
    return both(named(message), message.length + 12, message.length + chance.choice([10, 14, 16]))


def _bandwidth(chance: random.Random) -> Fact:
    while (message := some_message(chance)).base_length != message.length:
        pass
    rate, frame = chance.choice([2, 4, 5, 10, 20]), message.length + 12
    right, wrong = frame * rate, frame * rate + chance.choice([-rate * 9, 30 * rate, 100, frame * rate])
    fact = both({**named(message), "r": str(rate), "ms": str(1000 // rate)}, right, wrong)
    return {**fact[0], "v8": str(right * 8)}, {**fact[1], "v8": str(wrong * 8)}


def _id(chance: random.Random) -> Fact:
    message = some_message(chance)
    return both(named(message), message.id, message.id + chance.choice([1, 2, 10]))


def _crc(chance: random.Random) -> Fact:
    message = some_message(chance)
    return both(named(message), message.crc_extra, (message.crc_extra + chance.choice([1, 7, 100])) % 256)


def _offset(chance: random.Random) -> Fact | None:
    found = of_field(chance, lambda _: True)
    if found is None:
        return None
    _, field, words = found
    return both(words, field.offset, field.offset + chance.choice([1, 2, 4]))


def _order(chance: random.Random) -> Fact | None:
    message = some_message(chance)
    names = [field.name for field in message.fields if not field.definition.is_extension]
    if len(names) < ENOUGH:
        return None
    at = sorted(chance.sample(range(len(names)), ENOUGH))
    first, second, third = (names[index] for index in at)
    words = named(message)
    right = {"a": first, "b": second, "c": third, "a1": names[0]}
    return {**words, **right}, {**words, "a": second, "b": first, "c": third, "a1": names[-1]}


_EXTENSIONS = (
    (
        "an extension",
        "extensions",
        "extension",
        "ext",
        "yes",
        "the extensions",
        "extension",
        "extension field",
        "the later additions",
        "extension part",
        "one of the later additions",
    ),
    (
        "a base field",
        "base fields",
        "base",
        "base",
        "no",
        "the base payload",
        "base",
        "base field",
        "the original message",
        "base part",
        "part of the original message",
    ),
)


def _extension(chance: random.Random) -> Fact | None:
    is_extension = chance.random() < HALF
    message = _extended_message(chance)
    fields = [field for field in message.fields if field.definition.is_extension is is_extension and "_" in field.name]
    if not fields:
        return None
    words = {**named(message), "f": chance.choice(fields).name}
    keys = ("v", "w", "pp", "e", "y", "p", "e", "b", "o", "c", "t")
    sides = [dict(zip(keys, each, strict=True)) for each in _EXTENSIONS]
    right, wrong = sides if is_extension else sides[::-1]
    return {**words, **right}, {**words, **wrong}


MAKERS: Mapping[str, Maker] = {
    "payload": _payload,
    "base": _base,
    "extended": _extended,
    "frame": _frame,
    "bandwidth": _bandwidth,
    "id": _id,
    "crc": _crc,
    "extension": _extension,
    "offset": _offset,
    "order": _order,
}
"""By the kind of phrasing that each fills."""
