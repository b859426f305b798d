"""Statements of a dialect about when fields of a message are values: bits, flags and numbers of other fields of it.

It says so in words of the field ("Valid data if bit 2 of enabled_extensions field is set"), in words of the other one
("Position fields (x, y, z) contain valid ..."), in words of its flags ("The field vz contains valid data."), or by the
names of these (ADSB_FLAGS_VALID_COORDS).
"""

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from codegen.model.dialect.dialect import EnumDefinition, EnumEntry, FieldDefinition, Kind, WireField, WireMessage
from codegen.model.dialect.phrase import phrase


class StatedValidity(NamedTuple):
    """The ``judge``, a field of the message, says whether ``field`` is a value; ``words`` are those of the dialect.

    ``proviso`` is what a table can write of it, such as ``when: {flags: ADSB_FLAGS_VALID_COORDS}``; nothing where that
    does not follow from the words.
    """

    field: str
    judge: str
    words: str
    proviso: str = ""


_BIT = r"\b[Vv]alid(?: data)? if bit (\d+) of (?:the )?(\w+)(?: field)? is set"
_IGNORED = r"\bignored (?:if|when) (\w+) is non-zero"
_ELSE = r"[Ss]e(?:nd|t to) (-?\d+) to use the [^.]*?\(else (?:the )?(\w+(?: \w+)?) will be ignored\)"
_ENTRY = r"\b(?:[Ii]f|[Ww]hen|[Ww]hether)\b(?: [a-z]\w*)*?(?: not ready)?(?: ready)? \(?([A-Z][A-Z0-9_]{4,})\b"
_NO_CONDITION = r"\brequired if\b|\bshould be\b|\botherwise\)"
_LISTED = r"\b[Ff]ields?:? \(?(\w+(?:, (?:and )?\w+)*(?: and \w+)?)\)? contains? valid\b[^.;]*"
_UPDATED = r"\bvalue in the (\w+) field has been updated\b"
_WHICH = r"\bwhich [\w ]*(?:outputs?|fields?) are valid\b|\breporting capabilities\b|\bNumber of valid [\w ]*points\b"
_FAILS = r"(?<![\w.-])(-?\d+) ?[=:] ?(?:no valid \w+|invalid \w+|\w+ has failed)"
_TIMES = frozenset({"us", "ms", "s", "ns", "min", "h", "ds", "cs"})
_PLACES = {"COORDS": ("lat", "lon")}
"""Names of flags for more than one field, or by another word than theirs."""


def stated_validities(message: WireMessage, enums: Mapping[str, EnumDefinition]) -> Iterator[StatedValidity]:
    """Yield what is said of the fields of a message, each field and judge once, fields in wire order."""
    found: dict[tuple[str, str], StatedValidity] = {}
    names = {field.name for field in message.fields}
    for field in message.fields:
        ways = (_by_own_words(field, message, enums), _by_words(field, message), _by_flags(field, message, enums))
        for each in (each for way in ways for each in way):
            if each.field in names and each.judge in names and each.field != each.judge:
                found.setdefault((each.field, each.judge), each)
    order = [field.name for field in message.fields]
    yield from sorted(found.values(), key=lambda each: order.index(each.field))


def _by_own_words(
    field: WireField, message: WireMessage, enums: Mapping[str, EnumDefinition]
) -> Iterator[StatedValidity]:
    """Yield what the words of a field say of what makes it a value, or of what makes another one none."""
    text = field.definition.description
    if match := phrase(_BIT).search(text):
        yield StatedValidity(field.name, match[2], match[0], f"when: {{{match[2]}: bit {match[1]}}}")
    if match := phrase(_IGNORED).search(text):
        yield StatedValidity(field.name, match[1], match[0])
    if match := phrase(_ELSE).search(text):
        other = match[2].lower().replace(" ", "_")
        other = {"parameter_id": "param_id"}.get(other, other)
        yield StatedValidity(other, field.name, match[0], f"when: {{{field.name}: {match[1]}}}")
    if phrase(_NO_CONDITION).search(text):
        return
    for named in phrase(_ENTRY).finditer(text):
        for judge in message.fields:
            enum = enums.get(judge.definition.enum or "")
            if judge is not field and enum is not None and enum.entry(named[1]) is not None:
                yield StatedValidity(field.name, judge.name, named[0], f"when: {{{judge.name}: {named[1]}}}")


def _by_words(judge: WireField, message: WireMessage) -> Iterator[StatedValidity]:
    """Yield what the words of a field say of others: of those that they name, or of all that are measured."""
    text = judge.definition.description
    for listed in phrase(_LISTED).finditer(text):
        flag = "MAV_BOOL_TRUE" if judge.definition.enum == "MAV_BOOL" else ""
        proviso = f"when: {{{judge.name}: {flag}}}" if flag else ""
        for name in _names(listed[1]):
            yield StatedValidity(name, judge.name, listed[0].strip(), proviso)
    if not judge.type.is_integer:
        return
    if match := phrase(_WHICH).search(text):
        for field in message.fields:
            if is_measured(field) and (field.is_array or field.definition.units is not None):
                yield StatedValidity(field.name, judge.name, match[0])
    if match := phrase(_FAILS).search(text):
        proviso = f"unless: {{{judge.name}: {match[1]}}}"
        for field in _of_what_fails(match[0], judge, message):
            yield StatedValidity(field.name, judge.name, match[0], proviso)


def _of_what_fails(words: str, judge: WireField, message: WireMessage) -> list[WireField]:
    """Return the fields of which such words speak: those that have the last one, or are current, or else all."""
    measured = [field for field in message.fields if field is not judge and is_measured(field)]
    for word in (words.rsplit(maxsplit=1)[-1], "current"):
        named = [field for field in measured if re.search(rf"\b{word}\b", field.definition.description, re.IGNORECASE)]
        if named:
            return named
    return measured


def _by_flags(judge: WireField, message: WireMessage, enums: Mapping[str, EnumDefinition]) -> Iterator[StatedValidity]:
    """Yield what the flags of a field say of others, by their words or by their names."""
    enum = enums.get(judge.definition.enum or "")
    if enum is None or not enum.is_bitmask:
        return
    for entry in enum.entries:
        when = f"when: {{{judge.name}: {entry.name}}}"
        for listed in phrase(_LISTED).finditer(entry.description):
            for name in _names(listed[1]):
                yield StatedValidity(name, judge.name, f"{entry.name}: {listed[0].strip()}", when)
        if match := phrase(_UPDATED).search(entry.description):
            yield StatedValidity(match[1], judge.name, f"{entry.name}: {match[0]}", f"{when}, otherwise: unchanged")
    for field in message.fields:
        if field is judge:
            continue
        flag = _named_for(field.definition, enum)
        if flag is not None:
            yield StatedValidity(field.name, judge.name, flag.name, f"when: {{{judge.name}: {flag.name}}}")
        unhealthy = next((each for each in enum.entries if each.name.endswith("_UNHEALTHY")), None)
        if unhealthy is not None and is_measured(field):
            proviso = f"unless: {{{judge.name}: {unhealthy.name}}}"
            yield StatedValidity(field.name, judge.name, f"{unhealthy.name}: {unhealthy.description}", proviso)


def _names(listed: str) -> list[str]:
    return [name for name in re.split(r",? and |, ", listed) if name]


def _named_for(field: FieldDefinition, enum: EnumDefinition) -> EnumEntry | None:
    """Return the flag that says by its name that a field is valid; of several the one that has most of its words."""
    if field.enum is not None:
        return None
    best: tuple[int, EnumEntry | None] = (0, None)
    for entry in enum.entries:
        if match := re.search(r"(?:^|_)VALID_(\w+)$|_(\w+?)_VALID$", entry.name):
            words = match[1] or _own_part(match[2], entry, enum)
            best = max(best, (_alike(words, field.name), entry), key=lambda each: each[0])
    return best[1]


def _own_part(words: str, entry: EnumEntry, enum: EnumDefinition) -> str:
    """Return the words of a name that ends in VALID without those that all flags of its enum begin with."""
    start = 0
    while all(each.name.startswith(entry.name[: start + 1]) for each in enum.entries):
        start += 1
    prefix = entry.name[: entry.name.rfind("_", 0, start) + 1]
    return entry.name.removeprefix(prefix).removesuffix("_VALID") if prefix else words


def _alike(words: str, name: str) -> int:
    """Return how many words of a flag a field is named with, 0 where one of them is missing: ``VELOCITY`` is one of
    ``hor_velocity``, and ``VERTICAL_VELOCITY`` are two of ``ver_velocity``.
    """
    if name in _PLACES.get(words, ()):
        return 2
    parts = name.lower().split("_")
    found = [
        any(
            word == part or word.removesuffix("s") == part or (len(part) > 2 and word.startswith(part))
            for part in parts
        )
        for word in words.lower().split("_")
    ]
    return len(found) if all(found) else 0


def is_measured(field: WireField) -> bool:
    """Return whether a field carries something that is measured: neither a time, nor an identity, nor a kind."""
    definition = field.definition
    if definition.enum is not None or definition.is_instance or field.type.kind is Kind.CHAR:
        return False
    if definition.units in _TIMES or definition.units == "%":
        return False
    return definition.units is not None or field.type.kind is Kind.FLOAT
