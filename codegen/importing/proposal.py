"""The answers that a document gives for one message, element by element, and the fields that it does not mention."""

from collections.abc import Iterable, Iterator, Sequence

from codegen.diagnostics import Report, Rule, Severity, did_you_mean
from codegen.frozen import dataclass
from codegen.importing.answer import UNREAD, Reading, Sources, Target
from codegen.importing.columns import Role
from codegen.importing.declared import check_declared
from codegen.importing.quantity import spills
from codegen.importing.stated import FieldList, StatedField
from codegen.importing.value import DOCUMENT_AMBIGUOUS, in_unit, leaves_open, read_value
from codegen.load.markdown_table import Table
from codegen.model.dialect.dialect import Kind, WireField, WireMessage
from codegen.source import Place

DOCUMENT_FIELD = Rule(
    "document-field",
    "A document answers for a field, or for an element of one, that the message does not have.",
    remedy="write the name of a field of the message, with an index for one element",
)
DOCUMENT_WITHOUT_VALUES = Rule(
    "document-without-values",
    "A table of a document describes the fields of a message, with type, unit and meaning, and does not say where "
    "their values come from. What the dialect says of a field does not decide that.",
)
DOCUMENT_ELEMENT = Rule(
    "document-element",
    "A document gives one number for a field of several elements, so it may be that of the first one, or of each.",
)
DOCUMENT_ROW_UNNAMED = Rule(
    "document-row-unnamed",
    "A row of a document's table gives a value and names no field: cells that were merged, or a row that goes on with "
    "the one above. Which field is meant cannot be told.",
    remedy="write the name of the field into the row, or what it says into the row above",
)
DOCUMENT_TABLE_UNREAD = Rule(
    "document-table-unread",
    "A table of a document names fields of the message, and none of its columns is known to hold what goes into them, "
    "so that nothing of it is read or compared.",
    Severity.WARNING,
    remedy="call its columns Field and Value",
)
DOCUMENT_TWICE = Rule("document-twice", "A document gives two different answers for one element of a field.")
DOCUMENT_UNANSWERED = Rule(
    "document-unanswered",
    "A document does not mention a field of the message, often an extension. A population table answers for every "
    "field: a field that nobody thought of is not the same as one that is unknown.",
    Severity.WARNING,
)


@dataclass(frozen=True, slots=True)
class ReadAnswer:
    """One answer: the elements, what the document says about them, and the lines (from 1) that say it."""

    target: Target
    reading: Reading
    written: str
    place: Place
    lines: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Unmentioned:
    """Elements that the document does not mention, and what may be meant: flow YAML, or None."""

    target: Target
    proposal: str | None


@dataclass(frozen=True, slots=True)
class Proposal:
    """The answers that a document proposes for a message; both lists are in the order of the dialect's XML."""

    message: WireMessage
    place: Place
    answers: tuple[ReadAnswer, ...]
    unmentioned: tuple[Unmentioned, ...]


def propose(lists: Sequence[FieldList], message: WireMessage, sources: Sources, report: Report) -> Proposal:
    """Read every row of lists that are about ``message``."""
    answers: list[ReadAnswer] = []
    mentioned: set[str] = set()
    for fields in lists:
        if fields.is_descriptive:
            text = f"the table describes the fields of {message.name}, and does not say what goes into them"
            report.add(DOCUMENT_WITHOUT_VALUES, fields.place, text, "add a column such as | Value source |")
        for value in fields.unnamed:
            report.add(DOCUMENT_ROW_UNNAMED, value.place, f"{value.text!r} is said of no field")
    for row in (row for fields in lists for row in fields.rows):
        target = target_of(row, message, report)
        if target is None:
            continue
        mentioned.add(target.field.name)
        cell = row.cells.get(Role.VALUE)
        found = Report()
        reading = UNREAD if cell is None else read_value(in_unit(cell, row.unit, target), target, sources, found)
        if cell is not None and (note := row.cells.get(Role.NOTES)) and leaves_open(note):
            text = f"{note.text!r} beside {cell.text!r} leaves open what goes into {target.name}"
            found.add(DOCUMENT_AMBIGUOUS, note.place, text)
            reading = UNREAD
        if cell is not None and _leaves_element_open(row, target, reading):
            text = f"{cell.text} leaves open whether one element of {target.name} is meant or all {target.count}"
            found.add(
                DOCUMENT_ELEMENT, cell.place, text, f"name them: {row.name}[0] or {row.name}[0..{target.count - 1}]"
            )
            reading = UNREAD
        said = cell or row.cells.get(Role.NOTES)
        answer = ReadAnswer(target, reading, said.text if said else "", (cell or row).place, (row.place.line,))
        if not (is_known := _is_known(answer, answers, report)):
            answers.append(answer)
        if not is_known or reading.answer is None:
            report.extend(found)
    order = {field.name: index for index, field in enumerate(message.definition.fields)}
    answers.sort(key=lambda answer: (order[answer.target.field.name], answer.target.first))
    return Proposal(
        message, lists[0].place, tuple(_joined(answers)), tuple(_unmentioned(message, answers, mentioned, sources))
    )


def report_unread(tables: Iterable[Table], message: WireMessage, report: Report) -> None:
    """A finding for each table that names fields of the message in half of its rows or more, and is not read."""
    names = {field.name for field in message.fields}
    for table in tables:
        columns = zip(*(row.cells for row in table.rows if len(row.cells) == len(table.header.cells)), strict=True)
        named = max((sum(cell.text in names for cell in column) for column in columns), default=0)
        if named > 1 and 2 * named >= len(table.rows):
            text = f"the table names fields of {message.name}, and its columns are not known"
            report.add(DOCUMENT_TABLE_UNREAD, table.place, text)


def _leaves_element_open(row: StatedField, target: Target, reading: Reading) -> bool:
    """Return whether one number, other than 0, stands for a whole array of numbers."""
    is_number = reading.answer is not None and reading.answer.startswith("{constant: ") and not reading.is_whole
    return (
        is_number
        and row.first is None
        and target.count > 1
        and target.field.type.kind is not Kind.CHAR
        and (reading.answer != "{constant: 0}")
    )


def check_declarations(fields: FieldList, message: WireMessage, report: Report) -> None:
    """Report types, units and sentinels that a list states otherwise than the dialect."""
    for row in fields.rows:
        target = target_of(row, message, Report())
        if target is not None:
            check_declared(row, target, report)


def not_answered_by(proposal: Proposal, targets: Iterable[Target]) -> tuple[Unmentioned, ...]:
    """Return what the document does not mention and none of ``targets`` answers for."""
    answered = {(target.field.name, element) for target in targets for element in target.elements}
    return tuple(
        missing
        for missing in proposal.unmentioned
        if not all((missing.target.field.name, element) in answered for element in missing.target.elements)
    )


def report_unmentioned(unmentioned: Iterable[Unmentioned], place: Place, report: Report) -> None:
    """A finding at ``place`` for each field, or part of one, that a document does not mention."""
    for missing in unmentioned:
        definition = missing.target.field.definition
        kind = "the extension " if definition.is_extension else ""
        hint = "say where it comes from; the dialect has no value for unknown"
        if missing.proposal is not None:
            hint = f"if it is meant, `{missing.proposal}`"
        report.add(DOCUMENT_UNANSWERED, place, f"{kind}{missing.target.name} is not mentioned", hint)


def target_of(row: StatedField, message: WireMessage, report: Report) -> Target | None:
    """The elements that a row names; None, after a finding, if the message does not have them."""
    field = message.field(row.name) or message.field(row.name.rstrip("_"))
    if field is None:
        hint = did_you_mean(row.name, [field.name for field in message.fields])
        report.add(DOCUMENT_FIELD, row.place, f"{message.name} has no field {row.name}", hint)
        return None
    if row.first is None or row.last is None:
        return Target(message, field, 0, field.count)
    related = [(field.definition.place, f"{field.name} is declared here")]
    if not field.is_array or field.type.kind is Kind.CHAR:
        text = f"{message.name}.{field.name} is no array of numbers, so it has no element {row.first}"
        report.add(DOCUMENT_FIELD, row.place, text, f"write {field.name}", related)
        return None
    if not row.first <= row.last < field.count:
        text = f"{message.name}.{field.name} has the elements 0 to {field.count - 1}, not {row.label[len(row.name) :]}"
        hint = f"write {field.name} for all of them" if row.first == row.last == field.count else None
        report.add(DOCUMENT_FIELD, row.place, text, hint, related)
        return None
    return Target(message, field, row.first, row.last - row.first + 1)


def _is_known(answer: ReadAnswer, earlier: Iterable[ReadAnswer], report: Report) -> bool:
    """Return whether an earlier row answers for one of these elements; another answer is reported."""
    for known in earlier:
        target = known.target
        if target.field is answer.target.field and set(target.elements) & set(answer.target.elements):
            if (
                None not in (known.reading.answer, answer.reading.answer)
                and known.reading.answer != answer.reading.answer
            ):
                message = (
                    f"{answer.target.name} is {answer.written!r} here and {known.written!r} in line {known.lines[0]}"
                )
                related = [(known.place, "the first answer is here")]
                report.add(DOCUMENT_TWICE, answer.place, message, "keep one of them", related)
            return True
    return False


def _joined(answers: Sequence[ReadAnswer]) -> Iterator[ReadAnswer]:
    """The answers; a quantity in element 0 and unknown ones behind it are one where the dialect lets it spill."""
    position = 0
    while position < len(answers):
        first = answers[position]
        parts = [one for one in answers if one.target.field is first.target.field]
        joined = _split(first, parts[1:])
        yield joined or first
        position += len(parts) if joined else 1


def _split(first: ReadAnswer, others: Sequence[ReadAnswer]) -> ReadAnswer | None:
    field = first.target.field
    answer = first.reading.answer
    covered = first.target.count + sum(other.target.count for other in others)
    if not others or covered != field.count or first.target.count != 1 or first.target.first:
        return None
    if answer is None or not answer.startswith("{state: ") or any(one.reading.answer != "unknown" for one in others):
        return None
    target = Target(first.target.message, field, 0, field.count)
    if not spills(target):
        return None
    lines = tuple(sorted({line for one in (first, *others) for line in one.lines}))
    return ReadAnswer(target, Reading(f"{answer[:-1]}, split: true}}"), first.written, first.place, lines)


def _unmentioned(
    message: WireMessage, answers: Sequence[ReadAnswer], mentioned: set[str], sources: Sources
) -> Iterator[Unmentioned]:
    for definition in message.definition.fields:
        field = message.field(definition.name)
        if field is None:
            continue
        taken = {element for answer in answers if answer.target.field is field for element in answer.target.elements}
        if not taken and definition.name in mentioned:
            continue  # what it says was reported
        for first, count in _gaps(field, taken):
            target = Target(message, field, first, count)
            yield Unmentioned(target, likely_answer(target, sources))


def _gaps(field: WireField, taken: set[int]) -> Iterator[tuple[int, int]]:
    """The runs of elements that nothing answers for: first element and number."""
    start = None
    for element in range(field.count + 1):
        is_free = element < field.count and element not in taken
        if is_free and start is None:
            start = element
        elif not is_free and start is not None:
            yield start, element - start
            start = None


def likely_answer(target: Target, sources: Sources) -> str | None:
    """Return what is sent for a field that nobody thinks of: its sentinel, no flag, or the entry 0 of its enum."""
    if target.sentinel is not None:
        return "unknown"
    enum = target.enum(sources.dialect)
    if enum is None:
        return None
    if target.field.definition.is_bitmask:
        return "{flags: []}"
    return next((f"{{enum: {entry.name}}}" for entry in enum.entries if entry.value == 0), None)
