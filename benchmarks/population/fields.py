"""The fields of a dialect, read by pymavlink's parser and from the XML alone: nothing of the generator decides here.

The corrections that come with codegen are data, each with the words of the dialect: they are read as what they say.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from fractions import Fraction
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any
from xml.etree import ElementTree

import pymavlink
import yaml
from conformance_oracle import CODES, sentinel, xml_messages

ROOT = Path(__file__).parents[2]
DIALECTS = Path(pymavlink.__file__).parent / "dialects" / "v20"
CORRECTIONS = ROOT / "codegen" / "corrections"
READ = ("units", "multiplier", "invalid", "minValue", "maxValue", "enum")


@dataclass(frozen=True)
class Enum:
    """An enum: its entries without pymavlink's mark of the end, and whether they are flags."""

    name: str
    entries: dict[int, str] = field(hash=False)
    is_bitmask: bool


@dataclass(frozen=True)
class Field:
    """A field as the XML has it. ``count`` is 0 where it is no array; ``unknown`` has the sentinel of each element.

    1 on the wire is ``multiplier`` of ``unit``; ``low`` and ``high`` are numbers on the wire.
    """

    message: str
    name: str
    type: str
    code: str
    count: int
    is_extension: bool
    unit: str
    multiplier: Fraction
    low: Fraction | None
    high: Fraction | None
    enum: Enum | None
    unknown: tuple[int | float | None, ...]

    @property
    def is_float(self) -> bool:
        """Return whether it carries IEEE 754 numbers."""
        return self.code in "fd"

    @property
    def bits(self) -> int:
        """Return the bits of one element."""
        return 8 * {"b": 1, "h": 2, "i": 4, "q": 8, "f": 4, "d": 8, "s": 1}[self.code.lower()]


@dataclass(frozen=True)
class Message:
    """A message with its fields in the order of the XML."""

    name: str
    id: int
    fields: tuple[Field, ...]

    @property
    def elements(self) -> int:
        """Return the number of values that it carries; a text is one."""
        return sum(1 if field.code == "s" else max(1, field.count) for field in self.fields)


def read_messages(dialect: str, module: ModuleType) -> dict[str, Message]:
    """All messages of a shipped dialect by name; ``module`` is pymavlink's for MAVLink 2."""
    paths = _files(DIALECTS / f"{dialect}.xml")
    stated, bitmasks = _stated(paths), _bitmasks(paths)
    for path in paths:
        _correct(stated, CORRECTIONS / f"{path.stem}.yaml")
    found = {}
    for parsed in xml_messages(str(DIALECTS / f"{dialect}.xml"), 2).values():
        start = len(parsed.fields) if parsed.extensions_start is None else parsed.extensions_start
        fields = tuple(
            _field(parsed.name, item, index >= start, stated[parsed.name][item.name], bitmasks, module)
            for index, item in enumerate(parsed.fields)
        )
        found[parsed.name] = Message(parsed.name, parsed.id, fields)
    return found


def _files(path: Path) -> list[Path]:
    """A dialect and all that it includes, each once."""
    found, waiting = [], [path]
    while waiting:
        current = waiting.pop(0)
        if current not in found:
            found.append(current)
            waiting += [path.parent / (element.text or "").strip() for element in _tree(current).iter("include")]
    return found


@cache
def _tree(path: Path) -> ElementTree.Element:
    return ElementTree.parse(path).getroot()  # noqa: S314 - pymavlink's own files


def _stated(paths: list[Path]) -> dict[str, dict[str, dict[str, str]]]:
    """The attributes of each field that say what its numbers mean."""
    found: dict[str, dict[str, dict[str, str]]] = {}
    for path in paths:
        for message in _tree(path).iter("message"):
            fields = {
                field.attrib["name"]: {key: field.attrib[key].strip() for key in READ if key in field.attrib}
                for field in message.iter("field")
            }
            found.setdefault(message.attrib["name"], fields)
    return found


def _bitmasks(paths: list[Path]) -> set[str]:
    elements = [element for path in paths for element in _tree(path).iter("enum")]
    return {element.attrib["name"] for element in elements if element.get("bitmask") == "true"}


def _correct(stated: dict[str, dict[str, dict[str, str]]], path: Path) -> None:
    """Add what words state: never in place of an attribute, unless the correction says which."""
    entries = yaml.load(path.read_text(), yaml.BaseLoader)["corrections"] if path.exists() else []  # noqa: S506 - strings only
    for entry in entries:
        for name, attributes in stated.get(entry["message"], {}).items():
            if fnmatchcase(name, entry["fields"]):
                for key, value in entry["set"].items():
                    if attributes.get(key, "") == entry.get("replaces", ""):
                        attributes[key] = value


def _field(
    message: str, item: Any, is_extension: bool, stated: dict[str, str], bitmasks: set[str], module: ModuleType
) -> Field:
    code, name = CODES[item.type], stated.get("enum", "")
    entries = {value: entry.name for value, entry in module.enums.get(name, {}).items()}
    entries = {value: entry for value, entry in entries.items() if not entry.endswith("_ENUM_END")}
    limits = [stated.get(key) for key in ("minValue", "maxValue")]
    return Field(
        message,
        item.name,
        item.type,
        code,
        item.array_length,
        is_extension,
        stated.get("units", ""),
        Fraction(stated.get("multiplier") or 1),
        *(None if limit is None else Fraction(limit) for limit in limits),
        Enum(name, entries, name in bitmasks) if entries else None,
        tuple(_unknown(stated.get("invalid", ""), code, item.array_length, module)),
    )


def _unknown(text: str, code: str, count: int, module: ModuleType) -> Iterator[int | float | None]:
    """The sentinel of each element, None where it has none: ``[V:]`` is about the first, ``[V1,,V3]`` by position."""
    length = max(1, count)
    form, values = sentinel(text, code, count, module)
    if not form:
        yield from [None] * length
    elif form == "first":
        yield from [values[0], *[None] * (length - 1)]
    elif form == "positions":
        parts = (text.strip("[]").split(",") + [""] * length)[:length]
        yield from (values[at] if part.strip() else None for at, part in enumerate(parts))
    else:
        yield from values
