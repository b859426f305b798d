"""Types and units that sentences name for a field: "`temperature` is an int16_t in cdegC"."""

import re
from collections.abc import Iterator

from codegen.claims.reading import Reading
from codegen.claims.sentinel import UNIT
from codegen.claims.structure import RULE as TYPE
from codegen.diagnostics import Diagnostic
from codegen.load.prose import Passage
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.units.unit import Unit

_TYPES = r"(?:u?int(?:8|16|32|64)(?:_t)?|float|double)"
_DECLARED = re.compile(
    rf"(?<![\w.])(?P<field>[a-z][a-z0-9_]{{1,60}}) is (?:an? |of type )?(?P<type>{_TYPES})(?![\w\[])"
)
_IN_UNIT = re.compile(
    rf"(?<!\w)(?P<type>{_TYPES}) (?:in (?P<unit>[A-Za-z%][A-Za-z0-9/%]{{0,6}})(?=[\s.,;)|]|$)"
    r"|\((?P<held>[A-Za-z%/]{1,6})\))"
)
_WORD = re.compile(r"(?<![\w.])[a-z][a-z0-9]*(?:_[a-z0-9]+)*(?![\w(])")


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every type that is said of a field by its name, and every unit beside a type in a sentence about a field."""
    if not reading.sightings:
        return
    for passage in reading.prose.passages:
        for found in _DECLARED.finditer(passage.text):
            yield from _types(reading, passage, found)
        for found in _IN_UNIT.finditer(passage.text):
            yield from _units(reading, passage, found)


def _types(reading: Reading, passage: Passage, found: "re.Match[str]") -> Iterator[Diagnostic]:
    name = found["field"]
    if "_" not in name and not reading.mentioned(passage):
        return  # too common a word: many messages have an id
    holders = _holders(reading, passage, name, found.start())
    stated = _written(found["type"])
    if holders and all(field.type.name != stated for _, field in holders):
        message, field = holders[0]
        name = f"{message.name}.{field.name}"
        text = f"{name} is {field.type.name}, not {stated}"
        yield reading.found(TYPE, passage.place_at(found.start("type")), f"{name} {stated}", text)


def _units(reading: Reading, passage: Passage, found: "re.Match[str]") -> Iterator[Diagnostic]:
    group = "unit" if found["unit"] else "held"
    unit = found[group]
    if Unit.parse(unit) is None:
        return
    start, end = passage.sentence(found.start(), found.end())
    about = [
        (message, field)
        for word in dict.fromkeys(_WORD.findall(passage.text, start, end))
        for message, field in _holders(reading, passage, word, found.start())
        if field.type.name == _written(found["type"]) and field.definition.units
    ]
    if about and all(field.definition.units != unit for _, field in about):
        message, field = about[0]
        name = f"{message.name}.{field.name}"
        text = f"{name} is in {field.definition.units}, not {unit}"
        yield reading.found(UNIT, passage.place_at(found.start(group)), f"{name} in {unit}", text)


def _holders(reading: Reading, passage: Passage, name: str, offset: int) -> list[tuple[WireMessage, WireField]]:
    """The messages that the document names and that have a field of this name, nearest first."""
    near = reading.named_near(passage.place_at(offset).line)
    return [(message, field) for message in near if (field := message.field(name)) is not None]


def _written(text: str) -> str:
    """A type as the dialect writes it: int16 is int16_t."""
    return f"{text}_t" if text[-1].isdigit() else text
