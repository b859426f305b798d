"""Facts about a field: its type and length, which of its values means unknown, and what its elements are."""

import math
import random
from collections.abc import Mapping

from codegen.claims.unknown_value import unknown_values
from phrasing.filling import Fact, Maker, both, named, of_field, reference

_TYPES = ("uint8_t", "int8_t", "uint16_t", "int16_t", "uint32_t", "int32_t", "uint64_t", "float")


_WORDS = {
    "uint8_t": "an unsigned 8-bit integer", "int8_t": "a signed byte", "uint16_t": "an unsigned 16 bit integer",
    "int16_t": "a signed 16-bit number", "uint32_t": "an unsigned 32 bit value", "int32_t": "a signed 32-bit integer",
    "uint64_t": "a 64-bit unsigned integer", "float": "a 32-bit float", "int64_t": "a signed 64 bit integer",
}  # fmt: skip


def _type(chance: random.Random, spell: Mapping[str, str] | None = None) -> Fact | None:
    found = of_field(chance, lambda field: not field.is_array and field.type.name in _TYPES)
    if found is None:
        return None
    _, field, words = found
    words = {**words, "n": field.name.replace("_", " ")}
    wrong = chance.choice([name for name in _TYPES if name != field.type.name])
    return both(words, *((spell[name] if spell else name) for name in (field.type.name, wrong)))


def _length(chance: random.Random) -> Fact | None:
    found = of_field(chance, lambda field: field.count > 2 and field.type.name != "char")
    if found is None:
        return None
    _, field, words = found
    words = {**words, "n": field.name.replace("_", " ")}
    return both(words, field.count, chance.choice([field.count - 1, field.count * 2, field.count + 4]))


def _element(chance: random.Random) -> Fact | None:
    found = of_field(
        chance,
        lambda field: (
            field.count > 1
            and field.type.name != "char"
            and field.type.is_integer
            and field.sentinel is not None
            and field.sentinel.values[0] is not None
        ),
    )
    if found is None:
        return None
    message, field, words = found
    known = unknown_values(field)
    assert known is not None
    taken = {value for each in message.fields if (own := unknown_values(each)) for value in own[0]}
    wrong = [
        value
        for value in (0, field.type.maximum // 2, field.type.maximum, field.type.maximum - 1)
        if value not in taken
    ]
    return both(words, int(known[0][0]), chance.choice(wrong))


def _sentinel(chance: random.Random) -> Fact | None:
    found = of_field(
        chance,
        lambda field: (
            not field.is_array
            and not field.definition.enum
            and field.sentinel is not None
            and field.sentinel.values[0] is not None
        ),
    )
    if found is None:
        return None
    _, field, words = found
    known = unknown_values(field)
    assert known is not None
    value, name = known[0][0], known[1]
    shown = chance.choice([name, name if math.isnan(value) else str(int(value))])
    tops = ["-1", "0", str(field.type.maximum), f"{field.type.name.removesuffix('_t').upper()}_MAX"]
    wrong = [text for text in tops if text not in (name, shown, str(value)) and not (text == "0" and value == 0)]
    if field.type.name == "float":
        wrong = [text for text in ("0", "-1", "9999") if text != str(value) and float(text) != value]
    elif value == field.type.maximum:
        wrong = ["0", "9999", str(field.type.maximum - 1)] if field.type.maximum > 10000 else ["0", "-1"]
    return both(words, shown, chance.choice(wrong))


def _unfilled(chance: random.Random) -> Fact | None:
    found = of_field(chance, lambda field: field.is_array and (unknown_values(field) or ([], ""))[1].isupper())
    if found is None:
        return None
    _, field, words = found
    known = unknown_values(field)
    assert known is not None
    return both(words, known[1], chance.choice(["0", "-1", "9999"]))


def _effect(chance: random.Random) -> Fact:
    """A value of one of the first eight channels, which no other message describes so, and another one."""
    message = reference().dialect.messages["RC_CHANNELS_OVERRIDE"]
    return both({**named(message), "c": str(chance.randrange(1, 9))}, 0, chance.choice([65535, 65534]))


MAKERS: Mapping[str, Maker] = {
    "type": _type,
    "words_type": lambda chance: _type(chance, _WORDS),
    "length": _length,
    "sentinel": _sentinel,
    "unfilled": _unfilled,
    "effect": _effect,
    "element": _element,
}
"""By the kind of phrasing that each fills."""
