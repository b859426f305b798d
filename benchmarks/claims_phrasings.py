# ruff: noqa: T201  what is printed is the answer
"""Tests how general the checker of documents is: many ways to say a thing, of many messages, once right, once wrong.

    python benchmarks/claims_phrasings.py [--each N] [--seed N] [--missed] [KIND...]

Printed is by kind which share of the wrong ones is found, and how many of the right ones have a finding. At the end
come sentences that are no claims, though what they name is wrong: none of them is to have a finding.
The phrasings are in claims_phrasings.yaml, what is no claim in claims_asides.yaml; what they are filled with comes from
the dialect common.
"""

import argparse
import math
import random
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path

import yaml

from codegen.claims import check_claims
from codegen.claims.reading import Reference, read_document
from codegen.claims.unknown_value import unknown_values
from codegen.commands.documents import dialect_reference, with_other_dialects
from codegen.diagnostics import Diagnostic, Report
from codegen.load.files import DISK
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.units.unit import Unit

PHRASINGS = Path(__file__).with_suffix(".yaml")
ASIDES = PHRASINGS.with_name("claims_asides.yaml")

Words = dict[str, str]
"""The words that fill a phrasing: by the name in its braces."""

Fact = tuple[Words, Words]
"""A true statement about a message, and the same with something wrong in it."""

Maker = Callable[[random.Random], Fact | None]


@dataclass(frozen=True)
class Twins:
    """One phrasing filled twice: a document that is right, and one that is wrong."""

    kind: str
    phrasing: str
    right: str
    wrong: str


@cache
def reference() -> Reference:
    """Return the dialect that phrasings are filled from."""
    found = dialect_reference("common", Report())
    assert found is not None
    return found


def findings(text: str) -> list[Diagnostic]:
    """Return what is found in a text."""
    return check_claims(with_other_dialects(read_document(text, "/phrasing.md", reference()), DISK))


@cache
def phrasings(path: Path = PHRASINGS) -> Mapping[str, list[str]]:
    """Return all phrasings of a file by kind."""
    found: Mapping[str, list[str]] = yaml.safe_load(path.read_text())
    return found


@cache
def _messages() -> tuple[WireMessage, ...]:
    """The messages with names that are no words."""
    return tuple(
        message
        for message in reference().dialect.messages.values()
        if "_" in message.name and not message.definition.lifecycle.wip and len(message.fields) > 1
    )


def _message(chance: random.Random) -> WireMessage:
    return chance.choice(_messages())


def _of_field(chance: random.Random, fits: Callable[[WireField], bool]) -> tuple[WireMessage, WireField, Words] | None:
    """A field with a property; its message, and the words for both."""
    for _ in range(400):
        message = _message(chance)
        fields = [field for field in message.fields if fits(field) and ("_" in field.name or len(field.name) > 3)]
        if fields:
            field = chance.choice(fields)
            return message, field, {**_named(message), "f": field.name, "t": field.type.name.removesuffix("_t")}
    return None


def _named(message: WireMessage) -> Words:
    return {
        "m": message.name,
        "ml": message.name.lower(),
        "id": str(message.id),
        "base": str(message.base_length),
        "frame": str(message.length + 12),
    }


def _with(words: Words, right: object, wrong: object, **more: str) -> Fact:
    return {**words, "v": str(right), **more}, {**words, "v": str(wrong), **more}


_TYPES = ("uint8_t", "int8_t", "uint16_t", "int16_t", "uint32_t", "int32_t", "uint64_t", "float")
_RUST = {"float": "f32", "double": "f64", "char": "u8"}
_WORDS = {
    "uint8_t": "an unsigned 8-bit integer", "int8_t": "a signed byte", "uint16_t": "an unsigned 16 bit integer",
    "int16_t": "a signed 16-bit number", "uint32_t": "an unsigned 32 bit value", "int32_t": "a signed 32-bit integer",
    "uint64_t": "a 64-bit unsigned integer", "float": "a 32-bit float", "int64_t": "a signed 64 bit integer",
}  # fmt: skip


def _type(chance: random.Random, spell: Mapping[str, str] | None = None) -> Fact | None:
    found = _of_field(chance, lambda field: not field.is_array and field.type.name in _TYPES)
    if found is None:
        return None
    _, field, words = found
    words = {**words, "n": field.name.replace("_", " ")}
    wrong = chance.choice([name for name in _TYPES if name != field.type.name])
    return _with(words, *((spell[name] if spell else name) for name in (field.type.name, wrong)))


def _length(chance: random.Random) -> Fact | None:
    found = _of_field(chance, lambda field: field.count > 2 and field.type.name != "char")
    if found is None:
        return None
    _, field, words = found
    words = {**words, "n": field.name.replace("_", " ")}
    return _with(words, field.count, chance.choice([field.count - 1, field.count * 2, field.count + 4]))


_UNITS = {
    "cm/s": ["m/s", "mm/s"], "m/s": ["cm/s", "km/h"], "mV": ["V", "cV"], "cA": ["mA", "A"], "cdegC": ["degC"],
    "mm": ["cm", "m"], "cm": ["mm", "m"], "m": ["cm", "mm"], "degE7": ["degE5", "deg"], "rad": ["deg", "mrad"],
    "rad/s": ["deg/s", "mrad/s"], "deg": ["rad", "cdeg"], "cdeg": ["deg", "mrad"], "ms": ["us", "s"],
    "us": ["ms", "ns"], "hPa": ["Pa", "kPa"], "degC": ["cdegC", "K"], "mAh": ["Ah", "cAh"], "hJ": ["J", "kJ"],
    "mG": ["G", "m/s/s"], "dm": ["m", "cm"], "deg/s": ["rad/s", "cdeg/s"], "s": ["ms", "min"],
}  # fmt: skip
_SPELLED = {
    "mV": "millivolts", "cm": "centimetres", "mm": "millimeters", "ms": "milliseconds", "us": "microseconds",
    "V": "volts", "deg": "degrees", "rad": "radians", "cdeg": "centidegrees", "rad/s": "radians per second",
    "m": "metres", "m/s": "metres per second", "cm/s": "centimetres per second", "degC": "degrees Celsius",
    "cA": "centiamps", "A": "amperes", "mA": "milliamps",
}  # fmt: skip


def _unit(chance: random.Random) -> Fact | None:
    found = _of_field(chance, lambda field: (field.definition.units or "") in _UNITS and field.multiplier == 1)
    if found is None:
        return None
    _, field, words = found
    own = field.definition.units or ""
    pair = own, chance.choice(_UNITS[own])
    is_spelled = chance.random() < _HALF
    right, wrong = (_SPELLED.get(unit, unit) if is_spelled else unit for unit in pair)
    rust = _RUST.get(field.type.name) or field.type.name.replace("uint", "u").replace("int", "i").removesuffix("_t")
    return _with(words, right, wrong, rt=rust, n=field.name.replace("_", " "))


_HALF = 0.5
_PLAIN = {
    "mV": ("V", 1000), "cA": ("A", 100), "cdegC": ("degC", 100), "mm": ("m", 1000), "cm/s": ("m/s", 100),
    "cm": ("m", 100), "cdeg": ("deg", 100), "degE7": ("deg", 10**7), "ms": ("s", 1000), "hJ": ("kJ", 10),
    "dm": ("m", 10), "mG": ("G", 1000), "mrad/s": ("rad/s", 1000),
}  # fmt: skip
_ALSO = {"V": "volts", "A": "amps", "m": "metres", "deg": "degrees", "s": "seconds"}


def _scaled(chance: random.Random) -> tuple[WireField, Words, str, int] | None:
    found = _of_field(
        chance,
        lambda field: (field.definition.units or "") in _PLAIN and field.type.is_integer and field.multiplier == 1,
    )
    if found is None:
        return None
    _, field, words = found
    plain, factor = _PLAIN[field.definition.units or ""]
    return field, words, plain, factor


def _encoded(chance: random.Random) -> Fact | None:
    found = _scaled(chance)
    if found is None:
        return None
    field, words, plain, factor = found
    if field.is_array:
        return None
    steps = chance.randrange(11, 120)
    encoded = steps * factor // 10
    if not 0 < encoded <= field.type.maximum or factor == 10:
        return None
    shown = f"{Fraction(encoded, factor).__float__():g} {chance.choice([plain, _ALSO.get(plain, plain)])}"
    return _with(words, encoded, chance.choice([encoded * 10, max(encoded // 10, 1), encoded * 100]), q=shown)


def _is_bounded_by_its_type(field: WireField) -> bool:
    """Return whether a field is one short whole number of which the dialect states no other range."""
    return (
        field.type.is_integer
        and field.type.size in (1, 2)
        and not field.definition.enum
        and not field.definition.maximum
        and not field.is_array
    )


def _maximum(chance: random.Random) -> Fact | None:
    found = _of_field(chance, _is_bounded_by_its_type)
    if found is None:
        return None
    _, field, words = found
    top = field.type.maximum
    wrong = {127: 255, 255: 127, 32767: 65535, 65535: 32767}[top]
    unit = field.definition.units or ""
    if unit in _PLAIN and chance.random() < _HALF:
        plain, factor = _PLAIN[unit]
        return _with(words, *(f"{float(Fraction(value, factor)):g} {plain}" for value in (top, wrong)))
    unit = unit if Unit.parse(unit) and chance.random() < _HALF else ""
    return _with(words, *(f"{value} {unit}".strip() for value in (top, wrong)))


def _range(chance: random.Random) -> Fact | None:
    found = _of_field(chance, _is_bounded_by_its_type)
    if found is None:
        return None
    _, field, words = found
    top = field.type.maximum
    return _with(words, top, {127: 255, 255: 256, 32767: 65535, 65535: 65536}[top], lo=str(field.type.minimum))


def _scaling(chance: random.Random) -> Fact | None:
    found = _scaled(chance)
    if found is None:
        return None
    _, words, plain, factor = found
    return _with(words, factor, factor * 10 if factor < _LARGE else factor // 100, w=plain)


_LARGE = 10**6


def _payload(chance: random.Random) -> Fact:
    message = _message(chance)
    sizes = {message.base_length, message.length}
    possible = {size + more for size in sizes for more in (0, 8, 12, 21, 25)}
    wrong = next(size for size in (message.base_length + 3, message.base_length + 5, 200) if size not in possible)
    return _with(_named(message), chance.choice([*sizes]), wrong)


def _extended_message(chance: random.Random) -> WireMessage:
    while (message := _message(chance)).base_length == message.length:
        pass
    return message


def _base(chance: random.Random) -> Fact:
    message = _extended_message(chance)
    return _with(_named(message), message.base_length, message.length)


def _extended(chance: random.Random) -> Fact:
    message = _extended_message(chance)
    return _with(_named(message), message.length, message.length + chance.choice([1, 3, 7]))


def _frame(chance: random.Random) -> Fact:
    while (message := _message(chance)).base_length != message.length:
        pass
    return _with(_named(message), message.length + 12, message.length + chance.choice([10, 14, 16]))


def _bandwidth(chance: random.Random) -> Fact:
    while (message := _message(chance)).base_length != message.length:
        pass
    rate, frame = chance.choice([2, 4, 5, 10, 20]), message.length + 12
    right, wrong = frame * rate, frame * rate + chance.choice([-rate * 9, 30 * rate, 100, frame * rate])
    fact = _with({**_named(message), "r": str(rate), "ms": str(1000 // rate)}, right, wrong)
    return {**fact[0], "v8": str(right * 8)}, {**fact[1], "v8": str(wrong * 8)}


def _id(chance: random.Random) -> Fact:
    message = _message(chance)
    return _with(_named(message), message.id, message.id + chance.choice([1, 2, 10]))


def _crc(chance: random.Random) -> Fact:
    message = _message(chance)
    return _with(_named(message), message.crc_extra, (message.crc_extra + chance.choice([1, 7, 100])) % 256)


def _sentinel(chance: random.Random) -> Fact | None:
    found = _of_field(
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
    return _with(words, shown, chance.choice(wrong))


def _unfilled(chance: random.Random) -> Fact | None:
    found = _of_field(chance, lambda field: field.is_array and (unknown_values(field) or ([], ""))[1].isupper())
    if found is None:
        return None
    _, field, words = found
    known = unknown_values(field)
    assert known is not None
    return _with(words, known[1], chance.choice(["0", "-1", "9999"]))


def _effect(chance: random.Random) -> Fact:
    """A value of one of the first eight channels, which no other message describes so, and another one."""
    message = reference().dialect.messages["RC_CHANNELS_OVERRIDE"]
    return _with({**_named(message), "c": str(chance.randrange(1, 9))}, 0, chance.choice([65535, 65534]))


def _element(chance: random.Random) -> Fact | None:
    found = _of_field(
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
    return _with(words, int(known[0][0]), chance.choice(wrong))


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
    is_extension = chance.random() < _HALF
    message = _extended_message(chance)
    fields = [field for field in message.fields if field.definition.is_extension is is_extension and "_" in field.name]
    if not fields:
        return None
    words = {**_named(message), "f": chance.choice(fields).name}
    keys = ("v", "w", "pp", "e", "y", "p", "e", "b", "o", "c", "t")
    sides = [dict(zip(keys, each, strict=True)) for each in _EXTENSIONS]
    right, wrong = sides if is_extension else sides[::-1]
    return {**words, **right}, {**words, **wrong}


def _offset(chance: random.Random) -> Fact | None:
    found = _of_field(chance, lambda _: True)
    if found is None:
        return None
    _, field, words = found
    return _with(words, field.offset, field.offset + chance.choice([1, 2, 4]))


def _order(chance: random.Random) -> Fact | None:
    message = _message(chance)
    names = [field.name for field in message.fields if not field.definition.is_extension]
    if len(names) < _ENOUGH:
        return None
    at = sorted(chance.sample(range(len(names)), _ENOUGH))
    first, second, third = (names[index] for index in at)
    words = _named(message)
    right = {"a": first, "b": second, "c": third, "a1": names[0]}
    return {**words, **right}, {**words, "a": second, "b": first, "c": third, "a1": names[-1]}


_ENOUGH = 3


def _entry_field(chance: random.Random) -> tuple[Words, list[tuple[str, int]]] | None:
    enums = reference().dialect.enums
    found = _of_field(
        chance,
        lambda field: (
            (field.definition.enum or "") in enums
            and not field.definition.is_bitmask
            and field.definition.enum != "MAV_CMD"
            and len(enums[field.definition.enum or ""].entries) > _ENOUGH
        ),
    )
    if found is None:
        return None
    _, field, words = found
    return words, [(entry.name, entry.value) for entry in enums[field.definition.enum or ""].entries]


def _enum(chance: random.Random) -> Fact | None:
    found = _entry_field(chance)
    if found is None:
        return None
    words, entries = found
    name, value = chance.choice(entries)
    return _with({**words, "e": name}, value, chance.choice([value + 1, value + 2, max(value - 1, value + 3)]))


def _short(chance: random.Random) -> Fact | None:
    """Three entries of a field by the ends of their names, of which the first has another value in the wrong twin."""
    found = _entry_field(chance)
    if found is None:
        return None
    words, entries = found
    names = [name.split("_") for name, _ in entries]
    shared = next((at for at in range(10) if len({tuple(each[: at + 1]) for each in names}) > 1), 0)
    ends = [" ".join(each[shared:]).lower() for each in names]
    told = [(end, name, value) for end, (name, value) in zip(ends, entries, strict=True) if _is_wordy(end)]
    if len(told) < _ENOUGH:
        return None
    (s, _, v), (sb, eb, vb), (sc, ec, vc) = chance.sample(told, _ENOUGH)
    more = {"s": s, "S": s.capitalize(), "sb": sb, "sc": sc, "eb": eb, "ec": ec, "vb": str(vb), "vc": str(vc)}
    return _with(words, v, v + 20, **more)


def _is_wordy(end: str) -> bool:
    return all(len(word) > 3 for word in end.split()) and end.replace(" ", "").isalpha()


def _misspelled(chance: random.Random, name: str) -> str:
    """A name with a word left out, a word more, a letter less or two words swapped."""
    words = name.split("_")
    how = chance.randrange(3)
    if how == 0 and len(words) > 1:
        at = chance.randrange(len(words) - 1)
        words[at], words[at + 1] = words[at + 1], words[at]
        return "_".join(words)
    at = chance.randrange(1, len(name) - 1)
    return name[:at] + name[at + 1 :] if how == 1 and name[at] != "_" else name + ("s" if name.islower() else "S")


def _no_field(chance: random.Random) -> Fact | None:
    found = _of_field(chance, lambda field: "_" in field.name and not field.name[-1].isdigit() and len(field.name) > 7)
    if found is None:
        return None
    message, field, words = found
    wrong = _misspelled(chance, field.name)
    others = [other.name for other in message.fields if other is not field]
    if message.field(wrong) or not others:
        return None
    return _with({**words, "f": chance.choice(others)}, field.name, wrong)


def _no_message(chance: random.Random) -> Fact | None:
    message = _message(chance)
    wrong = _misspelled(chance, message.name)
    if wrong in reference().dialect.messages or message.name[-1].isdigit():
        return None
    return _with(_named(message), message.name, wrong)


def _no_entry(chance: random.Random) -> Fact | None:
    found = _entry_field(chance)
    if found is None:
        return None
    words, entries = found
    name, other = (each[0] for each in chance.sample(entries, 2))
    wrong = _misspelled(chance, name)
    if wrong == name or name[-1].isdigit() or "_" not in name:
        return None
    return _with({**words, "e": other}, name, wrong)


@cache
def _commands() -> tuple[tuple[str, int, tuple[tuple[str, str, str], ...]], ...]:
    found = []
    for entry in reference().dialect.enums["MAV_CMD"].entries:
        parameters = []
        for parameter in entry.parameters:
            stated = dict(parameter.attributes)
            if stated.get("label") and not stated.get("reserved"):
                parameters.append((parameter.number, stated["label"].lower(), stated.get("units", "")))
        if not entry.lifecycle.wip:
            found.append((entry.name, entry.value, tuple(parameters)))
    return tuple(found)


def _command(chance: random.Random) -> Fact:
    name, value, _ = chance.choice(_commands())
    return _with({"c": name}, value, value + chance.choice([1, 2, 100]))


def _parameter(chance: random.Random) -> Fact | None:
    name, _, parameters = chance.choice(_commands())
    if len(parameters) <= 1:
        return None
    number, label, _ = chance.choice(parameters)
    wrong = chance.choice([other[0] for other in parameters if other[0] != number])
    return _with({"c": name, "l": label}, number, wrong)


def _parameter_unit(chance: random.Random) -> Fact | None:
    name, _, parameters = chance.choice(_commands())
    known = [each for each in parameters if each[2] in _UNITS]
    if not known:
        return None
    number, label, unit = chance.choice(known)
    return _with({"c": name, "l": label, "n": number}, unit, chance.choice(_UNITS[unit]))


MAKERS: Mapping[str, Maker] = {
    "type": _type,
    "words_type": lambda chance: _type(chance, _WORDS),
    "length": _length,
    "unit": _unit,
    "encoded": _encoded,
    "maximum": _maximum,
    "range": _range,
    "scaling": _scaling,
    "payload": _payload,
    "base": _base,
    "extended": _extended,
    "frame": _frame,
    "bandwidth": _bandwidth,
    "id": _id,
    "crc": _crc,
    "sentinel": _sentinel,
    "unfilled": _unfilled,
    "effect": _effect,
    "element": _element,
    "extension": _extension,
    "offset": _offset,
    "order": _order,
    "enum": _enum,
    "short": _short,
    "no_field": _no_field,
    "no_message": _no_message,
    "no_entry": _no_entry,
    "command": _command,
    "param": _parameter,
    "param_unit": _parameter_unit,
}


def twins(kind: str, each: int, seed: int = 0, path: Path = PHRASINGS) -> Iterator[Twins]:
    """Yield each phrasing of a kind, filled so many times with messages that the seed chooses."""
    for phrasing in phrasings(path)[kind]:
        chance = random.Random(f"{seed} {phrasing}")  # noqa: S311  which messages fill it
        made = 0
        while made < each:
            fact = MAKERS[kind](chance)
            if fact is not None:
                made += 1
                yield Twins(kind, phrasing, phrasing.format(**fact[0]) + "\n", phrasing.format(**fact[1]) + "\n")


def main() -> int:
    """Print the shares, and what is missed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kinds", nargs="*", metavar="KIND", choices=[*MAKERS, []])
    parser.add_argument("--each", type=int, default=5, help="how many messages fill a phrasing")
    parser.add_argument("--seed", type=int, default=0, help="which messages fill them")
    parser.add_argument("--missed", action="store_true", help="list what is missed, and what is found wrongly")
    arguments = parser.parse_args()
    total = [0, 0, 0]
    for kind in arguments.kinds or MAKERS:
        missed: dict[str, list[str]] = {}
        false = []
        count = 0
        for each in twins(kind, arguments.each, arguments.seed):
            count += 1
            false += [(each.right, one) for one in findings(each.right)]
            if not findings(each.wrong):
                missed.setdefault(each.phrasing, []).append(each.wrong)
        found = count - sum(map(len, missed.values()))
        total = [total[0] + found, total[1] + count, total[2] + len(false)]
        print(f"{kind:<12} {found:>4} of {count:<4} found, {len(false)} findings on as many that are right")
        for phrasing, texts in missed.items() if arguments.missed else ():
            print(f"  missed {len(texts)} of {arguments.each}: {phrasing!r}\n      such as {texts[0]!r}")
        for text, one in false if arguments.missed else ():
            print(f"  false  {text!r}\n      {one.rule.id}: {one.message}")
    asides = [each.wrong for kind in phrasings(ASIDES) for each in twins(kind, arguments.each, arguments.seed, ASIDES)]
    taken = [(text, one) for text in asides if not arguments.kinds for one in findings(text)]
    for text, one in taken if arguments.missed else ():
        print(f"  no claim {text!r}\n      {one.rule.id}: {one.message}")
    share = 100 * total[0] / total[1]
    print(f"all: {total[0]} of {total[1]} found ({share:.1f} %), {total[2]} findings on as many that are right")
    if not arguments.kinds:
        print(f"no claims: {len(taken)} findings on {len(asides)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
