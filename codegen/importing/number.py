"""Numbers, limits and entries of enums in a document, held against the dialect."""

import math
import re
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean, shortened_list
from codegen.importing.answer import UNREAD, Reading, Sources, Target
from codegen.load.markdown_table import Cell
from codegen.model.dialect.dialect import EnumDefinition, EnumEntry, Kind
from codegen.model.dialect.literals import LIMITS, same_number
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.spec.population import FieldAnswer
from codegen.model.units.unit import Measure, conversion, decimal
from codegen.source import Place

DOCUMENT_ENTRY = Rule(
    "document-entry",
    "A document names an entry of an enum beside another number than the dialect gives it, an entry of another enum, "
    "or a number that the field's enum does not have. Receivers go by the number, people by the name.",
    remedy="write the name or the number that the dialect has, or correct the dialect in a corrections file",
)
DOCUMENT_SENTINEL = Rule(
    "document-sentinel",
    "A document states a value for unknown that is not the sentinel of the field, so that receivers would take it for "
    "a real one. Where the dialect has none at all, a correction in dialects/*.yaml can state it.",
)
DOCUMENT_STEPS = Rule(
    "document-steps",
    "A document gives a plain number for a field that the dialect has a multiplier for, so it may be the value, or "
    "what is on the wire for it. Write the answer of a table, which is in the units of the field, or the unit.",
)
DOCUMENT_PLACEHOLDER = Rule(
    "document-placeholder",
    "A document gives a number such as 9999, which people write for a value that there is not. Receivers take it for a "
    "measurement, unless it is the sentinel of the field.",
)
DOCUMENT_RANGE = Rule(
    "document-range",
    "A document states a number that the type of the field cannot carry, or an amount in a unit of another dimension.",
)

_ENTRY = re.compile(r"\b[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+\b")
_WHOLE = re.compile(r"(?<![\w.])-?\d{1,10}(?![\w.])")


def unknown_answer(remark: str, cell: Cell, target: Target, sources: Sources, report: Report) -> Reading:
    """The cell says 'unknown': the sentinel, if the field has one and the remark names no other number."""
    if target.sentinel is None:
        return _without_sentinel(cell.text, cell.place, target, sources, report)
    stated = [number for text in _stated_numbers(remark) if (number := _number(text)) is not None]
    if stated and not any(same_number(_wire(number, target), target.sentinel) for number in stated):
        return _other_sentinel(remark, cell.place, target, report)
    return Reading("unknown")


def read_entry(head: str, remark: str, cell: Cell, target: Target, sources: Sources, report: Report) -> Reading | None:
    """An entry of an enum, with its number behind it or without; None if ``head`` names no entry."""
    if head in LIMITS or _ENTRY.fullmatch(head) is None:
        return None
    enum = target.enum(sources.dialect)
    entry = _entry(head, cell, target, sources, report)
    if entry is None:
        known = _home(head, sources) is not None or (enum is not None and _looks_like(head, enum))
        return UNREAD if known else None
    numbers = [int(text) for text in _WHOLE.findall(remark)]
    if numbers and entry.value not in numbers:
        _contradiction(entry, numbers[0], cell, target, sources, report)
        return UNREAD
    return Reading(_entry_answer(entry, target))


def read_number(
    head: str, remark: str, says_unknown: bool, cell: Cell, target: Target, sources: Sources, report: Report
) -> Reading | None:
    """A number or a limit: the sentinel, the number of an entry, or a constant; None if ``head`` is none."""
    number = _number(head)
    if number is None:
        return None
    value = _wire(number, target)
    names = [name for name in _ENTRY.findall(remark) if name not in LIMITS]
    for name in names:
        entry = _entry(name, cell, target, sources, report)
        if entry is None and _home(name, sources) is None:
            continue
        if entry is not None and entry.value != value:
            _contradiction(entry, number, cell, target, sources, report)
        return Reading(_entry_answer(entry, target)) if entry is not None and entry.value == value else UNREAD
    if target.sentinel is not None and same_number(value, target.sentinel):
        return Reading("unknown")
    enum = target.enum(sources.dialect)
    if enum is not None and isinstance(number, Fraction):
        other = _entry_in_words(remark, enum)
        if other is not None and other.value != value:
            _contradiction(other, number, cell, target, sources, report)
            return UNREAD
        return _numbered_entry(number, enum, cell, target, report)
    if head in LIMITS or says_unknown or isinstance(number, float):
        if target.sentinel is None:
            return _without_sentinel(head, cell.place, target, sources, report)
        return _other_sentinel(head, cell.place, target, report)
    return _constant(number, head, cell.place, target, sources, report)


def has_entries(answer: FieldAnswer, cell: Cell, target: Target, sources: Sources, report: Report) -> bool:
    """Return whether the enum of the field has the entries that an answer names; those that it lacks are reported."""
    names = [entry.partition(" ")[0] for entry in answer.flags or answer.one_of or ()]
    names += [answer.enum] if answer.enum else []
    enum = target.enum(sources.dialect)
    missing = [name for name in names if enum is None or enum.entry(name) is None]
    for name in missing:
        text = f"{enum.name} has no entry {name}" if enum else f"{target.name} has no enum, and so no {name}"
        hint = did_you_mean(name, [entry.name for entry in enum.entries]) if enum else None
        report.add(DOCUMENT_ENTRY, cell.place, text, hint, [_declared(target)])
    return not missing


def carries(measure: Measure, written: str, place: Place, target: Target, report: Report) -> bool:
    """Return whether a field can carry an amount: one of another dimension, between its steps or beyond its type is
    reported.
    """
    unit, wire_type = wire_unit(target.field), target.field.type
    if unit is None:
        return True  # of a unit that is not known nothing can be said
    fits = conversion(measure.unit, unit) is not None
    number = measure.in_unit(unit)
    if fits and (number is None or not wire_type.is_integer or _is_whole(number, target)):
        return True
    units = target.field.unit_text
    message = f"{written} is nothing that {target.name} can carry ({wire_type.name}, {units})"
    hint = f"whole {units} from {wire_type.minimum} to {wire_type.maximum}" if fits else f"write it in {units}"
    report.add(DOCUMENT_RANGE, place, message, hint, [_declared(target)])
    return False


def _is_whole(number: Fraction, target: Target) -> bool:
    """Return whether a field of whole numbers has a number."""
    return number.denominator == 1 and target.field.type.minimum <= number <= target.field.type.maximum


def _is_made_up(number: Fraction) -> bool:
    """Return whether a number is one that people write for "no value": nothing but nines, three or more."""
    return number.denominator == 1 and re.fullmatch("-?9{3,}", str(number)) is not None


def _constant(number: Fraction, head: str, place: Place, target: Target, sources: Sources, report: Report) -> Reading:
    wire_type, units = target.field.type, target.field.definition.units
    if target.field.multiplier != 1 and number:
        steps, value = decimal(number / target.field.multiplier), decimal(number * target.field.multiplier)
        message = f"{head} leaves open whether {target.name} is {head} {units or ''}".rstrip()
        hint = f"write {{constant: {decimal(number)}}}, which is {steps} on the wire, or {{constant: {value}}}"
        report.add(DOCUMENT_STEPS, place, f"{message} or {head} {target.field.unit_text}", hint, [_declared(target)])
        return UNREAD
    if wire_type.is_integer and not _is_whole(number, target):
        message = f"{head} is nothing that {target.name} can carry ({wire_type.name})"
        hint = f"whole numbers from {wire_type.minimum} to {wire_type.maximum}"
        report.add(DOCUMENT_RANGE, place, message, hint, [_declared(target)])
        return UNREAD
    if _is_made_up(number):
        stated = target.field.sentinel
        sentinel = "no value for unknown" if stated is None else f"{stated.written} for unknown"
        message = f"{head} leaves open whether {target.name} is {head} or unknown; it has {sentinel}"
        choices = f"write {{constant: {decimal(number)}}}" + ("" if target.sentinel is None else ", or unknown")
        report.add(DOCUMENT_PLACEHOLDER, place, message, choices, [_declared(target)])
        return UNREAD
    usual = {0, -1, wire_type.maximum, wire_type.minimum}
    if units and target.sentinel is not None and number in usual:
        hint = f"if {head} {units} is meant, write it with its unit"
        return _other_sentinel(head, place, target, report, hint)
    if target.field.definition.is_instance and sources.for_each is not None and number == 0:
        return Reading(f"{{state: {sources.for_each}.instance}}")
    return Reading(f"{{constant: {decimal(number)}}}")


def _numbered_entry(number: Fraction, enum: EnumDefinition, cell: Cell, target: Target, report: Report) -> Reading:
    entry = next((entry for entry in enum.entries if entry.value == number), None)
    if entry is not None:
        return Reading(_entry_answer(entry, target))
    if _is_bitmask(target, enum):
        bits = [
            entry for entry in enum.entries if entry.value and number.denominator == 1 and entry.value & int(number)
        ]
        if sum(entry.value for entry in bits) == number:
            return Reading(f"{{flags: [{', '.join(entry.name for entry in bits)}]}}")
    entries = shortened_list(f"{entry.value} {entry.name}" for entry in enum.entries)
    message = f"{enum.name} has no entry {decimal(number)} for {target.name}"
    report.add(DOCUMENT_ENTRY, cell.place, message, f"it has {entries}", [_declared(target)])
    return UNREAD


def _entry_in_words(remark: str, enum: EnumDefinition) -> EnumEntry | None:
    """Return the one entry whose name ends with the words of a remark, such as LASER or laser; None for other words."""
    tail = "_" + "_".join(remark.upper().split())
    found = [entry for entry in enum.entries if entry.name.endswith(tail)]
    return found[0] if len(found) == 1 else None


def _entry_answer(entry: EnumEntry, target: Target) -> str:
    return f"{{flags: [{entry.name}]}}" if target.field.definition.is_bitmask else f"{{enum: {entry.name}}}"


def _is_bitmask(target: Target, enum: EnumDefinition) -> bool:
    return target.field.definition.is_bitmask or enum.is_bitmask


def _entry(name: str, cell: Cell, target: Target, sources: Sources, report: Report) -> EnumEntry | None:
    """The entry of the field's enum; one that belongs elsewhere, or is misspelt, is reported."""
    enum = target.enum(sources.dialect)
    entry = enum.entry(name) if enum else None
    if entry is not None:
        return entry
    home = _home(name, sources)
    if home is not None:
        wanted = f"the enum of {target.name} is {enum.name}" if enum else f"{target.name} has no enum"
        related = [(home.place, f"{home.name} is declared here")]
        report.add(DOCUMENT_ENTRY, cell.place, f"{name} is an entry of {home.name}, but {wanted}", None, related)
    elif enum is not None and _looks_like(name, enum):
        hint = did_you_mean(name, [entry.name for entry in enum.entries])
        report.add(DOCUMENT_ENTRY, cell.place, f"{enum.name} has no entry {name}", hint, [_declared(target)])
    return None


def _home(name: str, sources: Sources) -> EnumDefinition | None:
    """The enum of the dialect that has an entry called ``name``."""
    return next((enum for enum in sources.dialect.enums.values() if enum.entry(name)), None)


def _looks_like(name: str, enum: EnumDefinition) -> bool:
    """Return whether a name is meant to be an entry of the enum: it begins as the enum's own name does."""
    return name.split("_")[:2] == enum.name.split("_")[:2]


def _contradiction(
    entry: EnumEntry, number: int | float | Fraction, cell: Cell, target: Target, sources: Sources, report: Report
) -> None:
    written = decimal(number) if isinstance(number, Fraction) else str(number)
    enum = target.enum(sources.dialect)
    other = next((one for one in enum.entries if one.value == number), None) if enum else None
    hint = f"{written} is {other.name}" if other else f"{enum.name if enum else 'the enum'} has no entry {written}"
    message = f"{written} stands beside {entry.name}, which is {entry.value}"
    report.add(DOCUMENT_ENTRY, cell.place, message, hint, [(entry.place, f"{entry.name} is declared here")])


def _other_sentinel(written: str, place: Place, target: Target, report: Report, hint: str = "write unknown") -> Reading:
    sentinel = target.field.sentinel
    assert sentinel is not None
    message = f"{target.name} is unknown when it is {sentinel.written}, not {written}"
    related = [(sentinel.place, f"invalid={sentinel.written!r} is stated here")]
    report.add(DOCUMENT_SENTINEL, place, message, hint, related)
    return Reading(proposal="unknown")


def _without_sentinel(written: str, place: Place, target: Target, sources: Sources, report: Report) -> Reading:
    message = f"{target.name} has no value for unknown in the dialect; the document says {written}"
    enum = target.enum(sources.dialect)
    zero = next((entry for entry in enum.entries if entry.value == 0), None) if enum else None
    hint = "state one in a correction, dialects/corrections.yaml"
    if zero is not None:
        hint = f"{zero.name} is 0: answer with `{{enum: {zero.name}}}` if that is meant"
    report.add(DOCUMENT_SENTINEL, place, message, hint, [_declared(target)])
    return Reading(proposal=f"{{enum: {zero.name}}}" if zero else None)


def _declared(target: Target) -> tuple[Place, str]:
    return target.field.definition.place, f"{target.field.name} is declared here"


def _stated_numbers(text: str) -> list[str]:
    return re.findall(r"(?<![\w.])(?:-?\d{1,20}|0[xX][0-9a-fA-F]{1,16}|U?INT\d+_M(?:IN|AX)|nan)(?![\w.])", text, re.I)


def stated_number(text: str, target: Target) -> int | float | None:
    """The number on the wire that a cell states, by itself or before a remark in brackets; None if it states none."""
    number = _number(re.sub(r"\s*\([^()]*\)$", "", text).strip())
    return None if number is None else _wire(number, target)


def _number(text: str) -> Fraction | float | None:
    """The exact number, or NaN, that a text is; None if it is none."""
    if text.upper() in LIMITS:
        return Fraction(LIMITS[text.upper()])
    if text.casefold() == "nan":
        return math.nan
    if re.fullmatch(r"[-+]?0[xX][0-9a-fA-F]+", text):
        return Fraction(int(text, 16))
    return Fraction(text) if re.fullmatch(r"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d{1,2})?", text) else None


def _wire(number: Fraction | float, target: Target) -> int | float:
    """The number as the field's type has it, as far as it can."""
    if target.field.type.kind is Kind.FLOAT or not isinstance(number, Fraction) or number.denominator != 1:
        return float(number)
    return int(number)
