"""The oracle of the comparison: a dialect as pymavlink has it, its messages, fields and sentinels.

Layouts come from the classes of pymavlink's modules, extensions and sentinels from its own reader of the XML. A module
that pymavlink does not bring, or brings from another release of the XML, is made by pymavlink's generator.
"""

import contextlib
import importlib
import importlib.util
import inspect
import io
import math
import os
import re
import struct
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

from pymavlink.generator import mavgen, mavparse

from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_path

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
        """Return whether MAVLink 1 sends less of it."""
        return self.base_length != self.length

    @property
    def description(self) -> list[Any]:
        """Return its description for conform.py."""
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
    """Return why a module is not the one that pymavlink would make of the XML; empty if it is."""
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
    path = shipped_dialect_path(name, DISK)
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
