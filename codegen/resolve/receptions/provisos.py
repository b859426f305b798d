"""The demands on other fields of a received message without which one is no value: ``when`` and ``unless``."""

from collections.abc import Iterator, Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.dialect.dialect import Dialect, EnumDefinition, WireField, WireMessage
from codegen.model.dialect.literals import whole_number
from codegen.model.reception import Proviso
from codegen.model.spec.receive import ReceivedFieldSpec, Said
from codegen.model.units.unit import decimal
from codegen.pattern import pattern
from codegen.resolve.population.elements import UNKNOWN_FIELD
from codegen.resolve.quantities.kept import UNKNOWN_ENTRY
from codegen.source import Place

BAD_PROVISO = Rule(
    "bad-proviso",
    "'when' and 'unless' of a received field name other fields of whole numbers, with flags (entries of a bitmask, or "
    "bit 2) or with numbers or entries that these have, of 16 bits at most. What the two ask for has to be possible, "
    "also beside 'where' of the table, and 'otherwise' says what becomes of the quantity where they do not hold.",
)
_BIT = pattern(r"bit ([0-9]{1,2})")
_WIDEST = 2
"""The bytes of a field of which whole numbers are compared; of wider ones flags can be asked for."""


def resolve_provisos(
    written: ReceivedFieldSpec,
    own: WireField,
    wire: WireMessage,
    conditions: Mapping[str, int],
    dialect: Dialect,
    report: Report,
) -> tuple[Proviso, ...]:
    """Return what ``when`` and ``unless`` ask for; ``conditions`` are the numbers that ``where`` demands by field."""
    found = [
        proviso
        for key, said in (("when", written.when), ("unless", written.unless))
        for proviso in _provisos(key, said or {}, written, own, wire, dialect, report)
    ]
    if "otherwise" in written.places and not (written.when or written.unless):
        message = f"otherwise of {own.name} says what becomes of it, and nothing says when it is no value"
        report.add(BAD_PROVISO, written.at("otherwise"), message, "leave it out, or write when or unless")
    for each in found:
        _check_possible(each, found, conditions, written, report)
    return tuple(found)


def _provisos(
    key: str,
    said: Mapping[str, Said],
    written: ReceivedFieldSpec,
    own: WireField,
    wire: WireMessage,
    dialect: Dialect,
    report: Report,
) -> Iterator[Proviso]:
    for name, listed in said.items():
        place = written.at(f"{key}.{name}")
        field = wire.field(name)
        if field is None:
            hint = did_you_mean(name, [each.name for each in wire.fields])
            report.add(UNKNOWN_FIELD, place, f"{wire.name} has no field {name}", hint)
            continue
        if field is own or field.is_array or not field.type.is_integer:
            what = "the field itself" if field is own else f"{field.type.name}{'[]' if field.is_array else ''}"
            message = f"{name} is {what}, and no other field of whole numbers"
            report.add(BAD_PROVISO, place, message, f"take it, for code to look at: {name}: {{state: ...}}")
            continue
        texts = [each if isinstance(each, str) else decimal(each) for each in _listed(listed)]
        numbers = _numbers(texts, field, dialect.enums.get(field.definition.enum or ""), place, report)
        if numbers is not None:
            yield Proviso(field, tuple(each for each, _ in numbers), tuple(texts), numbers[0][1], key == "unless")


def _listed(said: Said) -> tuple[str | Fraction, ...]:
    return said if isinstance(said, tuple) else (said,)


def _numbers(
    texts: list[str], field: WireField, enum: EnumDefinition | None, place: Place, report: Report
) -> list[tuple[int, bool]] | None:
    """The numbers, each with whether it is a mask of flags: all are, or none; None after a finding."""
    found = [_number(text, field, enum, place, report) for text in texts]
    if not found:
        report.add(BAD_PROVISO, place, f"nothing is listed that {field.name} could say", "list a flag or a number")
    numbers = [each for each in found if each is not None]
    if not found or len(numbers) != len(found):
        return None
    if len({is_flag for _, is_flag in numbers}) > 1:
        report.add(BAD_PROVISO, place, f"{field.name}: flags and numbers are mixed", "write all as bits, or as numbers")
        return None
    return numbers


def _number(
    text: str, field: WireField, enum: EnumDefinition | None, place: Place, report: Report
) -> tuple[int, bool] | None:
    """A mask of flags, or a number on the wire, and which of both it is; None after a finding."""
    is_flags = field.definition.is_bitmask or (enum is not None and enum.is_bitmask)
    bits = 8 * field.type.size
    if match := _BIT.fullmatch(text):
        if int(match[1]) < bits:
            return 1 << int(match[1]), True
        report.add(BAD_PROVISO, place, f"{field.name} has the bits 0 to {bits - 1}", "name one of these")
        return None
    entry = enum.entry(text) if enum else None
    number = entry.value if entry else whole_number(text)
    if number is None:
        known = [each.name for each in enum.entries] if enum else []
        hint = did_you_mean(text, known) or "write a whole number, bit 2, or an entry of its enum"
        report.add(UNKNOWN_ENTRY, place, f"{field.definition.enum or field.name} has no entry {text}", hint)
        return None
    if is_flags:
        if 0 < number < 1 << bits:
            return number, True
        hint = "name flags: that one is not set is said by unless"
        report.add(BAD_PROVISO, place, f"{text} is no flag of {field.name}, which are {bits} bits", hint)
        return None
    if field.type.size > _WIDEST:
        hint = f"write bits, or take it, for code to look at: {field.name}: {{state: ...}}"
        report.add(BAD_PROVISO, place, f"{field.name} is {field.type.name}: no number of up to 16 bits", hint)
        return None
    if not field.type.minimum <= number <= field.type.maximum:
        message = f"{field.name} carries whole numbers from {field.type.minimum} to {field.type.maximum}"
        report.add(BAD_PROVISO, place, message, "write a number that it carries")
        return None
    return number, False


def _check_possible(
    proviso: Proviso,
    all_of_them: list[Proviso],
    conditions: Mapping[str, int],
    written: ReceivedFieldSpec,
    report: Report,
) -> None:
    """Report what no message can meet."""
    name = proviso.field.name
    place = written.at(f"{'unless' if proviso.is_denied else 'when'}.{name}")
    demanded = conditions.get(name)
    if demanded is not None and not proviso.holds(demanded):
        message = f"where of the table takes messages with {name} {demanded} only: never {proviso.words}"
        report.add(BAD_PROVISO, place, message, "change where, or leave the field out")
    if not proviso.is_denied:
        return
    for other in all_of_them:
        if other.field is not proviso.field or other.is_denied:
            continue
        if other.is_of_flags != proviso.is_of_flags:
            hint = "write both as bits, or both as numbers"
            report.add(BAD_PROVISO, place, f"{name}: when and unless mix flags and numbers", hint)
        elif _exclude_each_other(other, proviso):
            report.add(BAD_PROVISO, place, f"never both: {other.words}, {proviso.words}", "keep one of them")


def _exclude_each_other(wanted: Proviso, denied: Proviso) -> bool:
    """Return whether no number of the field meets both, which name flags, or both numbers."""
    if wanted.is_of_flags:
        return any(mask & ~_all(wanted) == 0 for mask in denied.numbers)
    return set(wanted.numbers) <= set(denied.numbers)


def _all(proviso: Proviso) -> int:
    """Return the bits of all its flags."""
    bits = 0
    for mask in proviso.numbers:
        bits |= mask
    return bits
