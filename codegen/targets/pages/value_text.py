"""Values of the wire in words: what the bytes of an element say to who reads them."""

import math
import re
from collections.abc import Mapping

from codegen.model.dialect.dialect import EnumDefinition, Kind, SentinelForm, WireField
from codegen.model.dialect.literals import same_number
from codegen.targets.suite.expected import Wire

_HEXADECIMAL = re.compile(r"0x%0?(\d?)x")

TYPE_CODES = {Kind.UNSIGNED: "u", Kind.SIGNED: "i", Kind.FLOAT: "f"}


def elements_of(value: Wire) -> list[int | float | str]:
    """The values of a field one by one; a text is one."""
    return list(value) if isinstance(value, list) else [value]


def is_unknown(field: WireField, index: int, value: Wire) -> bool:
    """Return whether the element ``index`` of a field says that it is unknown, by the dialect's sentinel."""
    sentinel = field.sentinel
    if sentinel is None:
        return False
    values = elements_of(value)
    if isinstance(values[0], str):
        return not values[0]
    if sentinel.form is SentinelForm.VALUE:
        return all(map(_same, values, sentinel.values))
    if sentinel.form is SentinelForm.FIRST:
        index = 0
    return _same(values[index], sentinel.values[index])


def _same(value: int | float | str, sentinel: int | float | None) -> bool:
    if sentinel is None or isinstance(value, str):
        return False
    return same_number(value, sentinel)


def value_text(field: WireField, value: int | float | str, enums: Mapping[str, EnumDefinition]) -> str:
    """``12000 mV``, ``MAV_BATTERY_TYPE_LIPO (1)``, the names of flags, or a text in quotes."""
    if isinstance(value, str):
        return f'"{value}"'
    enum = enums.get(field.definition.enum or "")
    if enum is not None and isinstance(value, int):
        return _entry(enum, value, is_bitmask=is_flags(field, enums))
    number = "NaN" if math.isnan(value) else f"{value:.7g}" if isinstance(value, float) else _whole(field, value)
    unit = field.unit_text
    return f"{number} {unit}" if unit and number != "NaN" else number


def _whole(field: WireField, value: int) -> str:
    """A whole number in the format of the dialect, where that is hexadecimal as in all of pymavlink's."""
    format_of = _HEXADECIMAL.fullmatch(field.definition.print_format or "")
    return f"0x{value:0{int(format_of[1] or 0)}x}" if format_of and value >= 0 else str(value)


def _entry(enum: EnumDefinition, value: int, *, is_bitmask: bool) -> str:
    if is_bitmask:
        names = [entry.name for entry in enum.entries if entry.value and entry.value & value == entry.value]
        return f"{' + '.join(names)} ({value:#x})" if names else f"no flag ({value:#x})"
    name = next((entry.name for entry in enum.entries if entry.value == value), None)
    return f"{name} ({value})" if name else str(value)


def is_flags(field: WireField, enums: Mapping[str, EnumDefinition]) -> bool:
    """Return whether a field holds flags rather than one entry of its enum."""
    enum = enums.get(field.definition.enum or "")
    return field.definition.is_bitmask or (enum is not None and enum.is_bitmask)


def kind_of(field: WireField, enums: Mapping[str, EnumDefinition]) -> str:
    """Return what the bytes of a field are, as pages colour and name them: a class of the style sheet."""
    if field.definition.enum in enums:
        return "flags" if is_flags(field, enums) else "enum"
    kind = field.type.kind
    return "text" if kind is Kind.CHAR else kind.value


def type_code(field: WireField, enums: Mapping[str, EnumDefinition]) -> str:
    """The type in the width of one byte's cell: u16, i8, f32, char, enum, bits."""
    kind = kind_of(field, enums)
    if kind in ("enum", "flags", "text"):
        return {"enum": "enum", "flags": "bits", "text": "char"}[kind]
    return f"{TYPE_CODES[field.type.kind]}{8 * field.type.size}"
