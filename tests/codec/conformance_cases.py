"""Cases for comparing a generated codec with pymavlink: frames and values of pymavlink for every message of a dialect.

Everything that is expected comes from pymavlink: frames from pack(), values from decode(), layouts from the classes of
its modules, extensions and sentinels from its own reader of the XML. Of the codec nothing is used but the generator.
conform.py runs the cases on MicroPython.
"""

import contextlib
import importlib
import importlib.util
import inspect
import io
import json
import math
import os
import random
import re
import struct
import subprocess
import sys
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

from pymavlink.generator import mavgen, mavparse
from pymavlink.generator.mavcrc import x25crc

from codegen.codec import codec_files
from codegen.diagnostics import Report
from codegen.load.shipped import shipped_dialect_path

SYSTEM, COMPONENT = 42, 190
FORMS = ("viper", "plain")
CONFORM = Path(__file__).with_name("conform.py")
MICROPYTHON = Path(sys.executable).with_name("micropython")
CODES = {
    "char": "s",
    "uint8_t": "B",
    "int8_t": "b",
    "uint16_t": "H",
    "int16_t": "h",
    "uint32_t": "I",
    "int32_t": "i",
    "uint64_t": "Q",
    "int64_t": "q",
    "float": "f",
    "double": "d",
    "uint8_t_mavlink_version": "B",
}
PROTOCOLS = {1: mavparse.PROTOCOL_1_0, 2: mavparse.PROTOCOL_2_0}
STARTS = b"\xfd\xfe"
NO_START = bytes(byte for byte in range(256) if byte not in STARTS)
KEY = b"\x21" * 32

Case = list[Any]
Values = dict[str, Any]


@dataclass(frozen=True)
class Field:
    """A field as pymavlink has it. `unknown` are the values that mean unknown, empty without a sentinel.

    `initial` is what a caller of pymavlink's ..._encode() can leave out: the version of the dialect.
    """

    name: str
    code: str
    count: int  # 0: no array
    is_extension: bool
    form: str
    unknown: tuple[int | float, ...]
    initial: int = 0

    @property
    def size(self) -> int:
        """Bytes of one element."""
        return struct.calcsize("<" + self.code)

    @property
    def bounds(self) -> tuple[int, int]:
        """The smallest and the largest whole number that it carries."""
        bits = 8 * self.size
        return (-(1 << bits - 1), (1 << bits - 1) - 1) if self.code.islower() else (0, (1 << bits) - 1)


@dataclass(frozen=True)
class Message:
    """A message as pymavlink has it; fields in the order of the XML. `in_v1` is its class in MAVLink 1, if any."""

    name: str
    id: int
    fields: tuple[Field, ...]
    in_v2: Any
    in_v1: Any

    @property
    def length(self) -> int:
        """Bytes of payload with extensions."""
        return int(self.in_v2.unpacker.size)

    @property
    def base_length(self) -> int:
        """Bytes of payload without extensions."""
        if self.in_v1:
            return int(self.in_v1.unpacker.size)
        return sum(item.size * max(1, item.count) for item in self.fields if not item.is_extension)

    @property
    def has_extensions(self) -> bool:
        """Whether MAVLink 1 sends less of it."""
        return self.base_length != self.length

    @property
    def description(self) -> Case:
        """What conform.py has to know."""
        fields = [[item.name, item.code, item.count, item.form, item.is_extension] for item in self.fields]
        order = list(self.in_v2.ordered_fieldnames)
        return [self.name, self.id, self.in_v2.crc_extra, self.length, self.base_length, order, fields]


@dataclass(frozen=True)
class Dialect:
    """A dialect as pymavlink has it. `made` tells which modules had to be made, and why."""

    name: str
    messages: tuple[Message, ...]
    v2: ModuleType
    v1: ModuleType
    made: tuple[str, ...] = ()


@dataclass
class Outcome:
    """What the comparison of a dialect brought, all forms of the frames together."""

    counts: dict[str, int] = field(default_factory=dict)
    differences: list[str] = field(default_factory=list)
    different: int = 0

    def add(self, form: str, result: dict[str, Any]) -> None:
        """Add what one run of conform.py printed."""
        for kind, number in result["counts"].items():
            self.counts[kind] = self.counts.get(kind, 0) + number
        self.differences += [f"{form}: {difference}" for difference in result["differences"]]
        self.different += result["different"]


# --- pymavlink's view of a dialect ---


@cache
def _parsed(path: str, version: int) -> Any:
    with contextlib.redirect_stdout(io.StringIO()):
        return mavparse.MAVXML(path, PROTOCOLS[version])


def xml_messages(path: str, version: int) -> dict[int, Any]:
    """The messages of an XML file and of those that it includes, as pymavlink reads them, by id."""
    found: dict[int, Any] = {}
    waiting, seen = [os.path.abspath(path)], set()
    while waiting:
        current = waiting.pop(0)
        if current in seen:
            continue
        seen.add(current)
        parsed = _parsed(current, version)
        for message in parsed.message:
            found.setdefault(message.id, message)
        waiting += [os.path.abspath(os.path.join(os.path.dirname(current), name)) for name in parsed.include]
    return found


def disagreement(module: ModuleType, expected: dict[int, Any]) -> str:
    """Why a module is not what pymavlink would make of the XML; empty if it is."""
    if module.mavlink_map.keys() != expected.keys():
        return "it has other messages than the XML"
    for number, message in expected.items():
        cls = module.mavlink_map[number]
        lengths = dict(zip(cls.ordered_fieldnames, cls.array_lengths, strict=True))
        has = [(name, type_, lengths[name]) for name, type_ in zip(cls.fieldnames, cls.fieldtypes, strict=True)]
        fields = [(item.name, item.type, item.array_length) for item in message.fields]
        if cls.msgname != message.name or has != fields or cls.crc_extra != message.crc_extra:
            return f"{message.name} is not as in the XML"
    return ""


def make_module(name: str, path: str, version: int, folder: Path) -> ModuleType:
    """Let pymavlink generate its module of an XML file."""
    target = folder / f"pymavlink_{name}_v{version}.py"
    with contextlib.redirect_stdout(io.StringIO()):
        mavgen.mavgen(mavgen.Opts(str(target), PROTOCOLS[version], "Python3", validate=False), [path])
    specification = importlib.util.spec_from_file_location(target.stem, target)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def _module(name: str, path: str, version: int, folder: Path) -> tuple[ModuleType, str]:
    """The module that pymavlink brings, or a new one and the reason."""
    expected = xml_messages(path, version)
    shipped = f"pymavlink.dialects.v{version}0.{name}"
    try:
        module = importlib.import_module(shipped)
        problem = disagreement(module, expected)
    except ImportError:
        problem = "it is missing"
    if not problem:
        return module, ""
    module = make_module(name, path, version, folder)
    assert not disagreement(module, expected)
    return module, f"{shipped}: {problem}"


def read_dialect(name: str, folder: Path) -> Dialect:
    """A dialect as pymavlink has it; `folder` is for modules that have to be made."""
    path = shipped_dialect_path(name)
    assert path is not None
    v2, problem_2 = _module(name, path, 2, folder)
    v1, problem_1 = _module(name, path, 1, folder)
    parsed = xml_messages(path, 2)
    messages = tuple(
        _message(parsed[number], v2.mavlink_map[number], v1.mavlink_map.get(number), v2) for number in sorted(parsed)
    )
    return Dialect(name, messages, v2, v1, tuple(problem for problem in (problem_2, problem_1) if problem))


def _message(parsed: Any, in_v2: Any, in_v1: Any, module: ModuleType) -> Message:
    start = len(parsed.fields) if parsed.extensions_start is None else parsed.extensions_start
    given = inspect.signature(getattr(module.MAVLink, f"{parsed.name.lower()}_encode")).parameters
    fields = []
    for index, item in enumerate(parsed.fields):
        code, is_extension, default = CODES[item.type], index >= start, given[item.name].default
        form, unknown = sentinel(item.invalid.strip(), code, item.array_length, module)
        initial = 0 if is_extension or default is inspect.Parameter.empty else default
        fields.append(Field(item.name, code, item.array_length, is_extension, form, unknown, initial))
    return Message(parsed.name, parsed.id, tuple(fields), in_v2, in_v1)


def sentinel(text: str, code: str, count: int, module: ModuleType) -> tuple[str, tuple[int | float, ...]]:
    """(form, values of all elements) of an attribute `invalid`, as MAVLink's guide defines it.

    The first element of `[V:]` speaks for the array; what it leaves open, and `[V1,,V3]`, is sent as 0.
    """
    if not text:
        return "", ()
    inner = text.strip("[]").strip()
    if inner.endswith(":"):
        return "first", (_constant(inner[:-1], code, module),) + (0,) * (count - 1)
    if "," in inner:
        values = [_constant(part, code, module) if part.strip() else 0 for part in inner.split(",")][:count]
        return "positions", (*values, *[0] * (count - len(values)))
    value = _constant(inner, code, module)
    return ("each" if count else "value"), (value,) * max(1, count)


def _constant(text: str, code: str, module: ModuleType) -> int | float:
    """A number, a limit of a type, NaN, or an entry of an enum, in the precision of the field."""
    text = text.strip()
    limit = re.fullmatch(r"(U?)INT(\d+)_(MIN|MAX)", text)
    value: int | float
    if limit:
        bits = int(limit[2])
        low, high = (0, (1 << bits) - 1) if limit[1] else (-(1 << bits - 1), (1 << bits - 1) - 1)
        value = low if limit[3] == "MIN" else high
    elif text.lower() == "nan":
        value = math.nan
    elif hasattr(module, text):
        value = getattr(module, text)
    else:
        try:
            value = int(text, 0)
        except ValueError:
            value = float(text)
    if code in "fd":
        return float(struct.unpack("<" + code, struct.pack("<" + code, value))[0])
    return int(value)


# --- values ---


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


def _stated(message: Message, values: Values) -> list[Any]:
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


def _json(item: Field, value: Any) -> Any:
    """A value as conform.py reads it."""
    if item.code == "s" and value is not None:
        return value.decode() if value.isascii() and 0 not in value else [value.hex()]
    if item.code in "fd" and value is not None:
        if item.count:
            return [None if part is None else _float_json(item.code, part) for part in value]
        return _float_json(item.code, value)
    return value


def _values_json(message: Message, values: Values) -> list[Any]:
    return [_json(item, values[item.name]) for item in message.fields]


# --- pymavlink's frames ---


class Side:
    """pymavlink's MAVLink objects of both versions."""

    def __init__(self, dialect: Dialect) -> None:
        self.dialect = dialect
        self.v2 = dialect.v2.MAVLink(None, srcSystem=SYSTEM, srcComponent=COMPONENT)
        self.v1 = dialect.v1.MAVLink(None, srcSystem=SYSTEM, srcComponent=COMPONENT)
        self.other = dialect.v2.MAVLink(None)

    def frame(self, message: Message, version: int, values: Values, sequence: int) -> bytes:
        """What pymavlink sends; MAVLink 1 by the module for it, since that for 2 would send extensions."""
        stated = _stated(message, values)
        if version == 2:
            self.v2.seq = sequence
            return bytes(message.in_v2(*stated).pack(self.v2))
        self.v1.seq = sequence
        base = [value for value, item in zip(stated, message.fields, strict=True) if not item.is_extension]
        return bytes(message.in_v1(*base).pack(self.v1))

    def framed(self, message: Message, payload: bytes, chance: random.Random) -> bytes:
        """What pymavlink makes of a payload, from any sender."""
        self.other.seq, self.other.srcSystem, self.other.srcComponent = chance.randbytes(3)
        blank = message.in_v2(*_stated(message, all_zero(message)))
        return bytes(blank._pack(self.other, message.in_v2.crc_extra, payload))

    def whole(self, message: Message, payload: bytes, chance: random.Random) -> bytes:
        """A frame of MAVLink 2 with a payload that is not truncated, which pymavlink only receives."""
        return raw_frame(message.id, payload, message.in_v2.crc_extra, chance)

    def heard(self, stream: bytes) -> list[list[Any]]:
        """The messages of the dialect that pymavlink finds in a stream, as conform.py tells them."""
        listener = self.dialect.v2.MAVLink(None)
        listener.robust_parsing = True
        by_name = {message.name: message for message in self.dialect.messages}
        found = [item for item in listener.parse_buffer(stream) or [] if item.get_type() in by_name]
        return [_arrived(by_name[item.get_type()], bytes(item.get_msgbuf())) for item in found]

    def decoded(self, message: Message, frame: bytes) -> list[Any]:
        """The values that pymavlink reads from a frame, as conform.py reads them."""
        found = self.other.decode(bytearray(frame))
        assert found.get_type() == message.name
        values = []
        for item in message.fields:
            value = getattr(found, item.name)
            if item.code == "s":
                text = getattr(found, f"_{item.name}_raw").split(b"\0")[0]
                value = text.decode() if text.isascii() else [text.hex()]
            else:
                value = _json(item, value)
            values.append(value)
        return values


def checksum(body: bytes, extra: int) -> bytes:
    """The checksum of a frame without its first byte, by pymavlink."""
    return int(x25crc(body + bytes([extra])).crc).to_bytes(2, "little")


def raw_frame(number: int, payload: bytes, extra: int, chance: random.Random, flags: int = 0) -> bytes:
    """A frame of MAVLink 2 put together by hand."""
    head = bytes([len(payload), flags, 0, chance.randrange(256), SYSTEM, COMPONENT])
    body = head + number.to_bytes(3, "little") + payload
    return b"\xfd" + body + checksum(body, extra)


def raw_frame_1(number: int, payload: bytes, extra: int, chance: random.Random) -> bytes:
    """A frame of MAVLink 1 put together by hand."""
    body = bytes([len(payload), chance.randrange(256), SYSTEM, COMPONENT, number]) + payload
    return b"\xfe" + body + checksum(body, extra)


# --- cases of one message ---


def message_cases(side: Side, message: Message, index: int, chance: random.Random, rounds: int) -> Iterator[Case]:
    """All cases of a message; `index` is its place among those that conform.py is told of."""
    yield ["classes", "class", index]
    for version in (2, 1) if message.in_v1 else (2,):
        for kind, values in _values(message, version, chance, rounds):
            sequence = chance.randrange(256)
            frame = side.frame(message, version, values, sequence)
            sent = _values_json(message, values)
            read = side.decoded(message, frame)
            yield ["both", kind, index, version, sequence, sent, frame.hex(), None if read == sent else read]
        yield from _default(side, message, index, version, chance)
        yield from _live(side, message, index, version, chance)
    yield from _received(side, message, index, chance, rounds)


def _values(message: Message, version: int, chance: random.Random, rounds: int) -> Iterator[tuple[str, Values]]:
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
            *("live", "live", index, version, sequence, names, [sent, read], _values_json(message, values)),
            *(frame.hex(), side.decoded(message, frame)),
        ]


def _signed(number: int) -> int:
    """What an array of int32 holds of it."""
    return number - (1 << 32) if number >= 1 << 31 else number


def _received(side: Side, message: Message, index: int, chance: random.Random, rounds: int) -> Iterator[Case]:
    """What others send: any bits, zeros left in or out, fewer and more extensions, a signature."""
    length = message.length

    def case(kind: str, frame: bytes) -> Case:
        return ["arrives", kind, index, frame.hex(), side.decoded(message, frame)]

    for _ in range(rounds):
        yield case("any bits", side.framed(message, chance.randbytes(length), chance))
    full = bytes(chance.randrange(1, 256) for _ in range(length))
    payloads = [full[:used] + bytes(length - used) for used in range(length + 1)]
    sequence = chance.randrange(256)
    blank = message.in_v2(*_stated(message, all_zero(message)))
    side.v2.seq = sequence
    frames = [bytes(blank._pack(side.v2, message.in_v2.crc_extra, payload)).hex() for payload in payloads]
    yield ["truncated", "every truncated length", index, sequence, full.hex(), frames]
    for used in sorted({0, 1, length // 2, length - 1}):
        yield case("zeros left in", side.whole(message, payloads[used], chance))
    if message.has_extensions:
        yield case("no extensions", side.whole(message, full[: message.base_length], chance))
        if message.in_v1:
            side.v2.seq = sequence
            frame = message.in_v2(*_stated(message, random_values(message, chance))).pack(side.v2, force_mavlink1=True)
            yield case("extensions in MAVLink 1", bytes(frame))
    for more in sorted({1, 255 - length, chance.randint(1, max(1, 255 - length))} if length < 255 else ()):
        tail = bytes(chance.randrange(1, 256) for _ in range(more))
        yield case("newer extensions", side.whole(message, chance.randbytes(length) + tail, chance))
    yield case("signed", _signed_frame(side, message, chance))


def _signed_frame(side: Side, message: Message, chance: random.Random) -> bytes:
    """A frame with a signature, which nobody checks here."""
    sender = side.dialect.v2.MAVLink(None, srcSystem=SYSTEM, srcComponent=COMPONENT)
    sender.seq = chance.randrange(256)
    sender.signing.secret_key, sender.signing.sign_outgoing = KEY, True
    return bytes(message.in_v2(*_stated(message, random_values(message, chance))).pack(sender))


# --- streams ---


def stream_cases(side: Side, messages: Collection[Message], chance: random.Random) -> Iterator[Case]:
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
                counters = _counters(crc_errors=(1, 99), unknown=(0, 9), dropped=(0, 99))
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
) -> Case:
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
            expected.append(_arrived(message, frame))
        frame = _signed_frame(side, message, chance)
        parts.append(frame)
        counted["signed"] += 1
        expected.append(_arrived(message, frame))
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


def _arrived(message: Message, frame: bytes) -> list[Any]:
    start, source = (10, (5, 6, 4)) if frame[0] == 0xFD else (6, (3, 4, 2))
    payload = frame[start : start + frame[1]]
    return [message.name, payload.ljust(message.length, b"\0").hex(), [frame[place] for place in source]]


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
    payload, extra = chance.randbytes(chance.randrange(256)), chance.randrange(256)
    while True:
        number = chance.choice((chance.randrange(256), chance.randrange(1 << 16), chance.randrange(1 << 24)))
        if number not in side.dialect.v2.mavlink_map:
            if number < 256 and chance.random() < 0.5:
                return raw_frame_1(number, payload, extra, chance)
            return raw_frame(number, payload, extra, chance)


# --- enums ---


def enum_cases(dialect: Dialect) -> Iterator[Case]:
    """The entries of every enum that has any, without the one that pymavlink adds at the end."""
    for entries in dialect.v2.enums.values():
        values = {entry.name: value for value, entry in entries.items() if not entry.name.endswith("_ENUM_END")}
        if values:
            yield ["enum", "enum entries", values]


# --- running ---


def generate(dialect: str, folder: Path, *, machine_code: bool) -> list[str]:
    """Write the codec with all messages of a dialect; the answer are the errors, if there are any."""
    report = Report()
    files = codec_files(dialect, ["all"], report, machine_code=machine_code)
    for path, text in files.items():
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    if files and not report.has_errors:
        return []
    return [f"{found.rule.id}: {found.message}" for found in report] or ["the codec is empty"]


def compare(
    dialect: Dialect,
    folder: Path,
    messages: Collection[Message],
    rounds: int,
    forms: Collection[str] = FORMS,
    seed: int = 1,
) -> Outcome:
    """Compare messages of a dialect, of which the codec has all, with pymavlink; the frames in each of `forms`."""
    outcome = Outcome()
    cases = folder / f"{dialect.name}.cases"
    write_cases(cases, dialect, messages, seed, rounds)
    for form in forms:
        codec = folder / form / dialect.name
        errors = generate(dialect.name, codec, machine_code=form == "viper")
        if errors:
            outcome.differences += errors
            outcome.different += len(errors)
            continue
        result = run_cases(codec, cases)
        assert result["form"] == form
        outcome.add(form, result)
    cases.unlink()
    return outcome


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


def run_cases(codec: Path, cases: Path) -> dict[str, Any]:
    """Run the cases on MicroPython with the codec of a folder."""
    done = subprocess.run(
        [str(MICROPYTHON), "-X", "heapsize=256m", str(CONFORM), str(cases)],
        env=os.environ | {"MICROPYPATH": str(codec)},
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    result: dict[str, Any] = json.loads(done.stdout)
    return result
