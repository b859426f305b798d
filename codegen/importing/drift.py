"""Where the tables of the project's own documents and its population tables, or the dialect, drift apart."""

import re
from collections.abc import Iterable, Iterator, Sequence

from codegen.diagnostics import Diagnostic, Report, Rule, Severity
from codegen.importing.answer import Target
from codegen.importing.columns import Role
from codegen.importing.comparison import Compared, Verdict, compare, place_of
from codegen.importing.existing import populated, sender
from codegen.importing.number import stated_number
from codegen.importing.of_system import answers_of, sources_of
from codegen.importing.proposal import propose, target_of
from codegen.importing.stated import FieldList, StatedField, StatedFields
from codegen.importing.subject import coverage, is_example, subjects
from codegen.load.markdown_table import Cell
from codegen.model.literals import same_number
from codegen.model.system import PopulatedMessage, System
from codegen.model.wire_types import WIRE_TYPES

DOCUMENT_DRIFT = Rule(
    "document-drift",
    "A document and the population table answer differently for a field. One of them is out of date: correct it, so "
    "that reviewers of the document see what the firmware sends.",
)
DOCUMENT_ROW_MISSING = Rule(
    "document-row-missing",
    "A document has a table of most fields of a message, but the population table answers for one that it leaves out.",
    Severity.WARNING,
)
DOCUMENT_TYPE = Rule("document-type", "A document states another type for a field than the dialect.")
DOCUMENT_UNIT = Rule("document-unit", "A document states another unit for a field than the dialect.")
DOCUMENT_UNKNOWN = Rule(
    "document-unknown",
    "A document states another value for unknown than the sentinel of the field in the dialect, corrections included, "
    "or one for a field that has none.",
)

_NO_UNIT = ("", "-", "\u2013", "\u2014", "none", "n/a", "1")
_TYPE = re.compile(r"(u?)int_?(\d{1,2})(?:_t)?|([uif])(\d{1,2})|(float|double|char)", re.IGNORECASE)


def drift(stated: StatedFields, systems: Sequence[System]) -> Iterator[Diagnostic]:
    """The findings about one document of a project, whose programs are ``systems``, the main one first.

    A message belongs to the first program that populates it. Of those that none does only the columns of types, units
    and sentinels are looked at.
    """
    report = Report()
    dialect = systems[0].dialect
    lists: dict[str, list[FieldList]] = {}
    for fields in stated.lists:
        about = subjects(fields, dialect)
        if len(about) == 1:
            lists.setdefault(about[0].name, []).append(fields)
    for name, found in lists.items():
        for fields in found:
            for row in fields.rows:
                target = target_of(row, dialect.messages[name], Report())
                if target is not None:
                    _check_columns(row, target, report)
        answered = [fields for fields in found if Role.VALUE in fields.roles and not is_example(fields)]
        system = sender(name, systems)
        if answered and system is not None:
            tables = populated(name, systems, answered[0].place.file)
            report.extend(_fewest(_differences(answered, table, system) for table in tables))
    yield from report


def _fewest(found: Iterable[list[Diagnostic]]) -> list[Diagnostic]:
    return min(found, key=len)


def _differences(lists: Sequence[FieldList], message: PopulatedMessage, system: System) -> list[Diagnostic]:
    """What the lists say otherwise than a table. Of several tables they are about the one that is most like them."""
    report = Report()
    sources = sources_of(system.dialect, system, message.component.name if message.component else None)
    proposal = propose(lists, message.wire, sources, report)
    covered = max(coverage(fields, message.wire) for fields in lists)
    is_whole = 2 * covered > len(message.wire.fields)
    for row in compare(proposal, answers_of(message), sources):
        if row.verdict is Verdict.DIFFERENT and row.document is not None:
            report.extend([_difference(row)])
        elif row.verdict is Verdict.ONLY_TABLE and is_whole and not all(one.by_others for one in row.table):
            text = f"the table leaves out {row.target.name}, which the population table answers"
            related = [(place, "it is answered here")] if (place := place_of(row)) else []
            report.add(DOCUMENT_ROW_MISSING, proposal.place, text, f"add a row: {row.tabled}", related)
    return list(report)


def _difference(row: Compared) -> Diagnostic:
    assert row.document is not None
    message = f"{row.target.name} is {row.stated} here, but {row.tabled} in the population table"
    place = place_of(row)
    related = ((place, "the population table answers here"),) if place else ()
    return Diagnostic(row.document.place, DOCUMENT_DRIFT, message, "correct the one that is out of date", related)


def _check_columns(row: StatedField, target: Target, report: Report) -> None:
    """Type, unit and sentinel of a row against the dialect."""
    definition = target.field.definition
    related = [(definition.place, f"{definition.name} is declared here")]
    written = row.cells.get(Role.TYPE)
    if written is not None and written.text:
        wanted = definition.type if definition.length is None else f"{definition.type}[{definition.length}]"
        if not _is_type(written.text, target):
            text = f"{target.name} is {wanted} in the dialect, not {written.text}"
            report.add(DOCUMENT_TYPE, written.place, text, f"write {wanted}", related)
    unit = row.cells.get(Role.UNIT)
    if unit is not None and unit.text.casefold() not in _NO_UNIT and unit.text != (definition.units or ""):
        wanted = definition.units or "nothing"
        text = (
            f"{target.name} is in {definition.units} in the dialect"
            if definition.units
            else f"{target.name} has no unit"
        )
        report.add(DOCUMENT_UNIT, unit.place, f"{text}, not in {unit.text}", f"write {wanted}", related)
    unknown = row.cells.get(Role.UNKNOWN)
    if unknown is not None and unknown.text:
        _check_unknown(unknown, target, report)


def _check_unknown(cell: Cell, target: Target, report: Report) -> None:
    """A cell with the value for unknown; words say nothing about the number."""
    stated = stated_number(cell.text, target)
    if stated is None or same_number(stated, target.sentinel):
        return
    sentinel = target.field.sentinel
    if sentinel is None or target.sentinel is None:
        text = f"{target.name} has no value for unknown in the dialect, and {cell.text} here"
        related = [(target.field.definition.place, f"{target.field.name} is declared here")]
        report.add(DOCUMENT_UNKNOWN, cell.place, text, "state it in a correction, or leave it out", related)
        return
    text = f"{target.name} is unknown when it is {sentinel.written}, not {cell.text}"
    related = [(sentinel.place, f"invalid={sentinel.written!r} is stated here")]
    report.add(DOCUMENT_UNKNOWN, cell.place, text, f"write {target.sentinel}", related)


def _is_type(text: str, target: Target) -> bool:
    """Whether a text is the type of the field, in the spelling of C, of Rust or of the dialect, with its length."""
    name, _, length = text.replace(" ", "").replace("\\", "").partition("[")
    definition = target.field.definition
    if length and length.rstrip("]") != str(definition.length):
        return False
    if not length and definition.length is not None and target.count == definition.length:
        return False
    match = _TYPE.fullmatch(name)
    if match is None:
        return name == definition.type
    unsigned, bits, letter, size, other = match.groups()
    if bits:
        spelt = f"{unsigned.lower()}int{bits}_t"
    elif letter:
        spelt = {"u": f"uint{size}_t", "i": f"int{size}_t", "f": "float" if size == "32" else "double"}[letter.lower()]
    else:
        spelt = other.lower()
    return WIRE_TYPES[spelt].name == target.field.type.name if spelt in WIRE_TYPES else False
