"""The literals that attributes of a dialect are written with: booleans, names, entry values, limits of types."""

import math
import re
from fractions import Fraction

from codegen.model.dialect.dialect import Kind
from codegen.model.dialect.wire_types import WIRE_TYPES

LIMITS: dict[str, int] = {
    f"{wire_type.name.removesuffix('_t').upper()}_{end}": value
    for wire_type in WIRE_TYPES.values()
    if wire_type.kind in (Kind.UNSIGNED, Kind.SIGNED)
    for end, value in (("MIN", wire_type.minimum), ("MAX", wire_type.maximum))
}
"""Value by name: ``UINT16_MAX`` and its kin, for every integer type of the wire."""

# Lengths are bounded, so that a hostile number costs no more than an honest one.
_DECIMAL = re.compile(r"0|[1-9][0-9]{0,19}")
_HEXADECIMAL = re.compile(r"0[xX][0-9a-fA-F]{1,16}")
_BINARY = re.compile(r"0[bB][01]{1,64}")
_POWER_OF_TWO = re.compile(r"2\*\*([0-9]{1,2})")
_ARRAY = re.compile(r"(\w+)\[(.*)\]", re.ASCII | re.DOTALL)
_EXACT = re.compile(r"[+-]?(?:[0-9]{1,40}(?:\.[0-9]{0,40})?|\.[0-9]{1,40})(?:[eE][+-]?[0-9]{1,3})?")
_BOOLEANS = {"true": True, "1": True, "false": False, "0": False}


def boolean(text: str) -> bool | None:
    """An XML Schema boolean (``true``, ``false``, ``1``, ``0``), or None."""
    return _BOOLEANS.get(text.strip())


def is_identifier(text: str) -> bool:
    """Return whether ``text`` can be a name in C and Python alike."""
    return text.isascii() and text.isidentifier()


def entry_value(text: str) -> int | None:
    """The value of an enum entry: decimal, ``0x``, ``0b`` or ``2**n``, up to 64 bits; None if it is none of these."""
    text = text.strip()
    if _DECIMAL.fullmatch(text):
        value = int(text)
    elif _HEXADECIMAL.fullmatch(text):
        value = int(text, 16)
    elif _BINARY.fullmatch(text):
        value = int(text, 2)
    elif power := _POWER_OF_TWO.fullmatch(text):
        value = 1 << int(power[1])
    else:
        return None
    return value if value <= LIMITS["UINT64_MAX"] else None


def exact_number(text: str) -> Fraction | None:
    """A decimal number, or a quotient of two (``1E-2``, ``360/255``), exactly; None if it is none."""
    above, slash, below = (part.strip() for part in text.partition("/"))
    if not _EXACT.fullmatch(above) or (slash and not _EXACT.fullmatch(below)):
        return None
    divisor = Fraction(below or "1")
    return Fraction(above) / divisor if divisor else None


def named_number(text: str) -> int | float | None:
    """The number of a sentinel as texts name it: ``NaN``, a limit of a type in any case, decimal; None otherwise."""
    if text.lower() == "nan":
        return math.nan
    if text.upper() in LIMITS:
        return LIMITS[text.upper()]
    return whole_number(text)


def same_number(first: int | float | None, second: int | float | None) -> bool:
    """Return whether two numbers on the wire are the same; NaN is itself, and None is no number."""
    if first is None or second is None:
        return first is second
    return first == second or (math.isnan(first) and math.isnan(second))


def type_and_length(text: str) -> tuple[str, str | None]:
    """Name of the element type and, for an array, the text of its length, as a field's ``type`` writes them."""
    array = _ARRAY.fullmatch(text) if text.endswith("]") else None
    return (array[1], array[2]) if array else (text, None)


def whole_number(text: str) -> int | None:
    """A decimal number of up to 20 digits, with a minus or without, or None."""
    digits = text.removeprefix("-")
    return int(text) if digits.isascii() and digits.isdigit() and len(digits) <= 20 else None


def bounded_number(text: str, maximum: int) -> int | None:
    """A decimal number from 0 to ``maximum``, or None."""
    text = text.strip()
    value = None if text.startswith("-") else whole_number(text)
    return value if value is not None and value <= maximum else None
