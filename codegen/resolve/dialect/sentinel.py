"""The text of ``invalid`` becomes the value, or values, that mean "unknown" in a field."""

import math
import struct

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import EnumDefinition, FieldDefinition, Kind, Sentinel, SentinelForm, WireType
from codegen.model.dialect.literals import LIMITS, is_identifier
from codegen.pattern import pattern
from codegen.source import Place

SENTINEL_TEXT = Rule(
    "sentinel-text",
    "The attribute invalid is V, or for arrays [V], [V:] or [V1,,V3], where V is a number, NaN, a limit such as "
    "UINT16_MAX, or an entry of the field's enum. Correct it in the XML, or in a corrections file.",
    remedy="write a number, NaN, a limit such as UINT16_MAX, or an entry of the enum",
)
SENTINEL_RANGE = Rule(
    "sentinel-range",
    "The field cannot carry the value that is to mean unknown, so nobody could ever send it. Correct the value in the "
    "XML, or in a corrections file.",
)

# Lengths are bounded, so that a hostile number costs no more than an honest one.
_BESIDE_LIMIT = pattern(r"(\w+) ?- ?([0-9]{1,5})")
_WHOLE = pattern(r"[+-]?[0-9]{1,20}")
_HEXADECIMAL = pattern(r"0[xX][0-9a-fA-F]{1,16}")
_DECIMAL = pattern(r"[+-]?(?:[0-9]{1,40}\.?[0-9]{0,40}|\.[0-9]{1,40})(?:[eE][+-]?[0-9]{1,3})?")


@dataclass(frozen=True, slots=True)
class Problem:
    """The reason for which a value cannot be used."""

    rule: Rule
    message: str
    hint: str | None = None


def sentinel_of(
    definition: FieldDefinition, wire_type: WireType, enum: EnumDefinition | None, place: Place, report: Report
) -> Sentinel | None:
    """The sentinel of a field, or None where it has none (no ``invalid``, or an empty one) or after a diagnostic.

    Forms, as MAVLink's guide to the XML schema defines them: ``V`` for the whole field, ``[V]`` for every element that
    has it, ``[V:]`` for the whole array when element 0 has it, ``[V1,,V3]`` and ``[V1,]`` by position. The guide gives
    a bare V on an array no meaning, yet it occurs (``0`` on ``char[9]``): here every element has it when the field is
    unknown, which for 0 on text is the empty text; one that has it beside others that do not is a value. Brackets on
    a scalar are an error.

    A limit such as ``UINT16_MAX`` is just a number: on a float field it is 65535.0. Numbers of float fields are those
    that the wire's precision leaves of them. ``place`` is where ``invalid`` is written: the field, or a correction.
    """
    written = (definition.invalid or "").strip()
    if not written:
        return None
    count = 1 if definition.length is None else definition.length
    split = _parts(written, definition.length)
    if isinstance(split, Problem):
        report.add(split.rule, place, f"{definition.name}: {split.message}", split.hint)
        return None
    form, parts = split
    values: list[int | float | None] = []
    for part in parts:
        value = number_on_wire(part, wire_type, enum) if part else None
        if isinstance(value, Problem):
            report.add(value.rule, place, f"{definition.name}: {value.message}", value.hint)
            return None
        values.append(value)
    if form in (SentinelForm.VALUE, SentinelForm.EACH):
        values *= count
    else:
        values += [None] * (count - len(values))
    return Sentinel(form, tuple(values), written, place)


def _parts(written: str, length: int | None) -> tuple[SentinelForm, list[str]] | Problem:
    """The form of ``written`` and the texts of its values; an empty text stands for a position without a sentinel."""
    if not written.startswith("[") and not written.endswith("]"):
        return SentinelForm.VALUE, [written]
    inner = written[1:-1].strip()
    if not (written.startswith("[") and written.endswith("]") and inner):
        return _unreadable(written)
    if length is None:
        return Problem(SENTINEL_TEXT, f"invalid is {written!r}, but the field is no array", f"write {inner!r}")
    if inner.endswith(":"):
        first = inner[:-1].strip()
        return (SentinelForm.FIRST, [first]) if first else _unreadable(written)
    if "," not in inner:
        return SentinelForm.EACH, [inner]
    parts = [part.strip() for part in inner.split(",")]
    if not any(parts):
        return _unreadable(written)
    if not parts[-1]:
        parts.pop()
    if len(parts) > length:
        return Problem(
            SENTINEL_TEXT,
            f"invalid is {written!r} for {len(parts)} elements, but the array has {length}",
            hint=f"name {length} at most",
        )
    return SentinelForm.POSITIONS, parts


def _unreadable(written: str) -> Problem:
    return Problem(SENTINEL_TEXT, f"invalid is {written!r}, which cannot be read", "write V, [V], [V:] or [V1,,V3]")


def number_on_wire(text: str, wire_type: WireType, enum: EnumDefinition | None) -> int | float | Problem:
    """The number on the wire that one V stands for."""
    number = _number(text, enum)
    if isinstance(number, Problem):
        return number
    if wire_type.kind is Kind.FLOAT:
        try:
            carried: float = struct.unpack("<" + wire_type.code, struct.pack("<" + wire_type.code, number))[0]
        except OverflowError:
            carried = math.inf
        return _does_not_fit(text, wire_type) if math.isinf(carried) else carried
    if not math.isfinite(number) or number != int(number):
        return _does_not_fit(text, wire_type)
    whole = int(number)
    return whole if wire_type.minimum <= whole <= wire_type.maximum else _does_not_fit(text, wire_type)


def _does_not_fit(text: str, wire_type: WireType) -> Problem:
    hint = "NaN is what a float can be that is no number"
    if wire_type.kind is not Kind.FLOAT:
        hint = f"{wire_type.name} carries whole numbers from {wire_type.minimum} to {wire_type.maximum}"
    return Problem(SENTINEL_RANGE, f"a {wire_type.name} cannot carry {text}", hint)


def _number(text: str, enum: EnumDefinition | None) -> int | float | Problem:
    if text in LIMITS:
        return LIMITS[text]
    if (beside := _BESIDE_LIMIT.fullmatch(text)) and beside[1] in LIMITS:  # UINT16_MAX-1
        return LIMITS[beside[1]] - int(beside[2])
    if enum is not None and (entry := enum.entry(text)):
        return entry.value
    if _WHOLE.fullmatch(text):
        return int(text)
    if _HEXADECIMAL.fullmatch(text):
        return int(text, 16)
    if _DECIMAL.fullmatch(text):
        return float(text)
    if text.lower() == "nan":
        return math.nan
    names = [*LIMITS, "NaN", *(entry.name for entry in enum.entries)] if enum else [*LIMITS, "NaN"]
    if is_identifier(text):
        where = (
            f"no limit of a type and no entry of {enum.name}" if enum else "no limit of a type, and there is no enum"
        )
        return Problem(SENTINEL_TEXT, f"{text} is {where}", did_you_mean(text, names))
    return Problem(
        SENTINEL_TEXT,
        f"{text!r} is neither a number nor a name",
        hint="write a number, NaN, a limit such as UINT16_MAX, or an entry of the enum",
    )
