"""Values for the fields of a message: random ones, the ends of the types, special floats, texts, unknown ones.

They are given to pymavlink by stated_values(), and to conform.py by values_json().
"""

import math
import random
import struct
from collections.abc import Callable, Iterator
from typing import Any

from conformance_oracle import Field, Message

Values = dict[str, Any]


def _float(code: str, bits: int) -> float:
    return float(struct.unpack("<" + code, struct.pack("<I" if code == "f" else "<Q", bits))[0])


def _special_floats(code: str) -> tuple[float, ...]:
    """NaN, infinities, negative zero, the ends of the denormal and of the normal numbers, next to one."""
    fraction, exponent = (23, 255) if code == "f" else (52, 2047)
    sign = 1 << (31 if code == "f" else 63)
    infinity = exponent << fraction
    one = struct.unpack("<I" if code == "f" else "<Q", struct.pack("<" + code, 1.0))[0]
    patterns = (infinity, sign | infinity, sign, 1, sign | 1, (1 << fraction) - 1, 1 << fraction, infinity - 1)
    more = (sign | (infinity - 1), one + 1, one - 1)
    return (math.nan, *(_float(code, bits) for bits in (*patterns, *more)))


SPECIAL_FLOATS = {code: _special_floats(code) for code in "fd"}


def random_float(code: str, chance: random.Random) -> float:
    """Any bit pattern; NaN is only one."""
    if chance.random() < 0.2:
        return chance.choice(SPECIAL_FLOATS[code])
    value = _float(code, chance.getrandbits(32 if code == "f" else 64))
    return math.nan if math.isnan(value) else value


def random_number(item: Field, chance: random.Random) -> int | float:
    """Any value of the type."""
    if item.code in "fd":
        return random_float(item.code, chance)
    low, high = item.bounds
    return chance.choice((low, high, 0)) if chance.random() < 0.15 else chance.randint(low, high)


def values_of(message: Message, element: Callable[[Field], Any], text: Callable[[Field], bytes]) -> Values:
    """Values of all fields, made element by element."""
    values: Values = {}
    for item in message.fields:
        if item.code == "s":
            values[item.name] = text(item)
        else:
            values[item.name] = [element(item) for _ in range(item.count)] if item.count else element(item)
    return values


def random_values(message: Message, chance: random.Random) -> Values:
    """Anything that the fields carry; text is printable or bytes of any kind."""

    def text(item: Field) -> bytes:
        size = chance.randint(0, max(1, item.count))
        if chance.random() < 0.5:
            return bytes(chance.randrange(1, 128) for _ in range(size))
        return chance.randbytes(size)

    return values_of(message, lambda item: random_number(item, chance), text)


def all_minimum(message: Message) -> Values:
    """The smallest value of every field."""
    return values_of(
        message, lambda item: -_largest(item.code) if item.code in "fd" else item.bounds[0], lambda _item: b"\x01"
    )


def all_maximum(message: Message) -> Values:
    """The largest value of every field."""
    return values_of(
        message,
        lambda item: _largest(item.code) if item.code in "fd" else item.bounds[1],
        lambda item: b"\xff" * max(1, item.count),
    )


def _largest(code: str) -> float:
    return SPECIAL_FLOATS[code][8]


def all_zero(message: Message) -> Values:
    """Nothing but zeros."""
    return values_of(message, lambda item: 0.0 if item.code in "fd" else 0, lambda _item: b"")


def shortened(message: Message, values: Values, chance: random.Random) -> Values:
    """The values, but zero from some field in the order of the wire on, within an array from some element on."""
    values = dict(values)
    names = list(message.in_v2.ordered_fieldnames)
    place = chance.randrange(len(names))
    by_name = {item.name: item for item in message.fields}
    for index in range(place, len(names)):
        item = by_name[names[index]]
        keep = chance.randint(0, item.count) if index == place else 0
        if item.code == "s":
            values[item.name] = values[item.name][:keep]
        elif item.count:
            zero = 0.0 if item.code in "fd" else 0
            values[item.name] = [*values[item.name][:keep], *[zero] * (item.count - keep)]
        else:
            values[item.name] = 0.0 if item.code in "fd" else 0
    return values


TEXTS: dict[str, Callable[[int, random.Random], bytes]] = {
    "empty text": lambda _size, _chance: b"",
    "short text": lambda size, chance: bytes(chance.randrange(32, 127) for _ in range((size + 1) // 2)),
    "full text": lambda size, chance: bytes(chance.randrange(1, 127) for _ in range(size)),
    "text beyond ASCII": lambda size, chance: bytes(chance.randrange(128, 256) for _ in range(size)),
    "text with NUL inside": lambda size, chance: (b"a\0" + chance.randbytes(size))[:size],
}


def values_of_every_kind(
    message: Message, version: int, chance: random.Random, rounds: int
) -> Iterator[tuple[str, Values]]:
    """(kind of case, values) of everything that a version of MAVLink can send of a message."""
    for _ in range(rounds):
        yield "random", random_values(message, chance)
    for _ in range(rounds):
        yield "zeros at the end", shortened(message, random_values(message, chance), chance)
    yield "all minimum", all_minimum(message)
    yield "all maximum", all_maximum(message)
    yield "all zero", all_zero(message)
    codes = {item.code for item in message.fields}
    if codes & {"f", "d"} and version == 2:
        for shift in range(len(SPECIAL_FLOATS["f"])):
            places = iter(range(shift, 1000))
            values = values_of(
                message,
                lambda item, places=places: (
                    SPECIAL_FLOATS[item.code][next(places) % len(SPECIAL_FLOATS["f"])]
                    if item.code in "fd"
                    else random_number(item, chance)
                ),
                lambda item: chance.randbytes(max(1, item.count)),
            )
            yield "special floats", values
    if "s" in codes:
        for kind, text in TEXTS.items():
            values = random_values(message, chance)
            values |= {item.name: text(max(1, item.count), chance) for item in message.fields if item.code == "s"}
            yield kind, values
    if any(item.unknown for item in message.fields):
        values = random_values(message, chance)
        yield "unknown fields", values | {item.name: None for item in message.fields if item.unknown}
        each = [item for item in message.fields if item.form == "each" and item.code != "s"]
        for item in each:
            values[item.name] = [None if chance.random() < 0.5 else value for value in values[item.name]]
        if each:
            yield "unknown elements", values


def stated_values(message: Message, values: Values) -> list[Any]:
    """Values for pymavlink, in the order of the XML: what is None is what the sentinel says."""
    stated = []
    for item in message.fields:
        value = values[item.name]
        if value is None:
            value = bytes(item.unknown) if item.code == "s" else list(item.unknown) if item.count else item.unknown[0]
        elif item.code == "s" and not item.count:
            value = value or b"\0"
        elif isinstance(value, list):
            value = [item.unknown[index] if part is None else part for index, part in enumerate(value)]
        stated.append(value)
    return stated


def _float_json(code: str, value: float) -> Any:
    if value == 0 or not math.isfinite(value):
        return repr(value)
    bits = 24 if code == "f" else 53
    mantissa, exponent = math.frexp(value)
    return [int(mantissa * (1 << bits)), exponent - bits]


def field_json(item: Field, value: Any) -> Any:
    """A value as conform.py reads it."""
    if item.code == "s" and value is not None:
        return value.decode() if value.isascii() and 0 not in value else [value.hex()]
    if item.code in "fd" and value is not None:
        if item.count:
            return [None if part is None else _float_json(item.code, part) for part in value]
        return _float_json(item.code, value)
    return value


def values_json(message: Message, values: Values) -> list[Any]:
    """Values of all fields in the order of the XML, as conform.py reads them."""
    return [field_json(item, values[item.name]) for item in message.fields]
