"""Compares a document's statements about a message with its population table, element by element."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from enum import Enum
from fractions import Fraction

from codegen.diagnostics import Report
from codegen.frozen import dataclass
from codegen.importing.answer import Sources, Target, field_answer
from codegen.importing.proposal import Proposal, ReadAnswer
from codegen.measure import read_amount, read_real
from codegen.model.dialect.dialect import Kind, WireField, WireMessage
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.spec.population import FieldAnswer
from codegen.resolve.population.elements import answered_ranges
from codegen.source import Place

Number = int | float
_SHOWN = 60
"""The number of characters of an answer that a line of a comparison shows."""


class Verdict(Enum):
    """The result of comparing a document with a table; the text is what people read."""

    SAME = "same"
    EQUAL = "same value"
    DIFFERENT = "different"
    UNREAD = "not read"
    ONLY_DOCUMENT = "only in the document"
    ONLY_TABLE = "only in the table"


@dataclass(frozen=True, slots=True)
class TableAnswer:
    """An answer of a table: the elements, the record, and the numbers that always go out, if they are known.

    ``by_others``: the table does not list the elements, but has something to say about all that it does not list.
    """

    target: Target
    answer: FieldAnswer
    fixed: tuple[Number | str, ...] | None = None
    by_others: bool = False

    @property
    def text(self) -> str:
        """The answer as flow YAML, and whether it is one of those for all others."""
        return f"{answer_text(self.answer)} (others)" if self.by_others else answer_text(self.answer)


@dataclass(frozen=True, slots=True)
class Compared:
    """One row of a comparison; ``stated`` and ``tabled`` are the answers as flow YAML or words."""

    target: Target
    verdict: Verdict
    document: ReadAnswer | None
    table: tuple[TableAnswer, ...]

    @property
    def stated(self) -> str:
        """Return what the document says, as it is understood or as it is written."""
        if self.document is None:
            return ""
        return self.document.reading.answer or " ".join(self.document.written.split())

    @property
    def tabled(self) -> str:
        """Return what the table says."""
        return ", ".join(one.text for one in self.table)


def table_answers(
    message: WireMessage, fields: Mapping[str, FieldAnswer], fixed: Mapping[str, tuple[Number | str, ...]]
) -> tuple[TableAnswer, ...]:
    """The answers of a table in the order of the file; ``fixed`` has numbers that are known, by key of the table."""
    return tuple(
        TableAnswer(Target(message, field, first, count), answer, fixed.get(key))
        for key, answer in fields.items()
        for field, first, count in answered_ranges(key, message)
    )


def compare(proposal: Proposal, table: Sequence[TableAnswer], sources: Sources) -> tuple[Compared, ...]:
    """Every answer of the document beside those of the table, then those that only the table has."""
    rows = [_compared(answer, table, sources) for answer in proposal.answers]
    mentioned = [answer.target for answer in proposal.answers]
    rows += [
        Compared(one.target, Verdict.ONLY_TABLE, None, (one,))
        for one in table
        if not any(_overlap(one.target, target) for target in mentioned)
    ]
    order = {field.name: index for index, field in enumerate(proposal.message.definition.fields)}
    return tuple(sorted(rows, key=lambda row: (order[row.target.field.name], row.target.first)))


def _compared(answer: ReadAnswer, table: Sequence[TableAnswer], sources: Sources) -> Compared:
    target = answer.target
    others = tuple(one for one in table if _overlap(one.target, target))
    stated = None
    if answer.reading.answer is not None:
        stated = field_answer(answer.reading.answer, answer.place, Report())
    if stated is None:
        return Compared(target, Verdict.UNREAD, answer, others)
    if not others:
        return Compared(target, Verdict.ONLY_DOCUMENT, answer, ())
    verdicts = {_verdict(stated, answer, one, sources) for one in others}
    verdict = Verdict.DIFFERENT
    if verdicts == {Verdict.SAME}:
        verdict = Verdict.SAME
    elif Verdict.DIFFERENT not in verdicts:
        verdict = Verdict.EQUAL
    covered = {element for one in others for element in one.target.elements}
    if not covered >= set(target.elements):
        verdict = Verdict.DIFFERENT
    return Compared(target, verdict, answer, others)


def _verdict(stated: FieldAnswer, answer: ReadAnswer, other: TableAnswer, sources: Sources) -> Verdict:
    is_alike = _bare(stated) == _bare(other.answer) if answer.reading.is_whole else _is_said(stated, other.answer)
    if is_alike:
        return Verdict.SAME
    number = fixed_number(stated, answer.target, sources)
    if number is not None and other.fixed is not None and set(other.fixed) == {number}:
        return Verdict.EQUAL
    return Verdict.DIFFERENT


def _bare(answer: FieldAnswer) -> FieldAnswer:
    """An answer without what documents say elsewhere."""
    return replace(answer, requirement=None, note=None)


def _is_said(stated: FieldAnswer, tabled: FieldAnswer) -> bool:
    """Return whether both have the same source.

    Limits and rounding are beyond what a document says in its own words.
    """
    return all(getattr(stated, key) == getattr(tabled, key) for key in (*FieldAnswer.SOURCES, "split", "first", "per"))


def fixed_number(answer: FieldAnswer, target: Target, sources: Sources) -> Number | str | None:
    """Return what always goes out for an answer, if it does not depend on the state or the board."""
    if answer.unknown:
        return target.sentinel
    if answer.enum is not None:
        enum = target.enum(sources.dialect)
        entry = enum.entry(answer.enum) if enum else None
        return entry.value if entry else None
    if answer.flags is not None:
        enum = target.enum(sources.dialect)
        entries = [enum.entry(name) if enum else None for name in answer.flags]
        return None if None in entries else sum(entry.value for entry in entries if entry)
    if isinstance(answer.constant, Fraction):
        is_whole = target.field.type.is_integer and answer.constant.denominator == 1
        return int(answer.constant) if is_whole else float(answer.constant)
    if answer.constant is None or target.field.type.kind is Kind.CHAR:
        return answer.constant
    return _amount(answer.constant, target.field)


def _amount(written: str, field: WireField) -> Number | None:
    """Return what goes out for an amount, such as 50 cm; None where the field does not carry it."""
    unit = wire_unit(field)
    if unit is None:
        return None
    if not field.type.is_integer:
        return read_real(written, unit, field.definition.place, Report())
    value = read_amount(written, unit, field.definition.place, Report())
    return None if value is None or value.denominator != 1 else int(value)


def answer_text(answer: FieldAnswer) -> str:
    """An answer as flow YAML, without the requirement and the note."""
    if answer.unknown:
        return "unknown"
    return "{" + ", ".join(_pairs(answer)) + "}"


def _pairs(answer: FieldAnswer) -> Iterator[str]:
    for key in FieldAnswer.SOURCES:
        value = getattr(answer, key)
        if isinstance(value, tuple):
            yield f"{key}: [{', '.join(value)}]"
        elif value is not None:
            yield f"{key}: {_scalar(value)}"
    if answer.first:
        yield f"from: {answer.first}"
    if answer.per is not None:
        yield f"per: {_scalar(answer.per)}"
    if answer.split:
        yield "split: true"
    for key in ("min", "max"):
        if getattr(answer, key) is not None:
            yield f"{key}: {_scalar(getattr(answer, key))}"
    if "rounding" in answer.places:
        yield f"rounding: {answer.rounding}"


def _scalar(value: object) -> str:
    return "true" if value is True else str(value)


def _overlap(first: Target, second: Target) -> bool:
    return first.field.name == second.field.name and bool(set(first.elements) & set(second.elements))


def place_of(compared: Compared) -> Place | None:
    """Return where the table answers, if it does."""
    return compared.table[0].answer.place if compared.table else None


def comparison_text(rows: Sequence[Compared]) -> str:
    """One line for each row: verdict, field, the lines of document and table, and what both say."""
    cells = [("verdict", "field", "line", "line", "document", "table")]
    for row in rows:
        place = place_of(row)
        stated_at = str(row.document.place.line) if row.document else "-"
        tabled_at = str(place.line) if place else "-"
        stated, tabled = _cut(row.stated) or "-", _cut(row.tabled) or "-"
        cells.append((row.verdict.value, row.target.label, stated_at, tabled_at, stated, tabled))
    widths = [max(len(line[column]) for line in cells) for column in range(6)]
    shown = ("  ".join(cell.ljust(width) for cell, width in zip(line, widths, strict=True)) for line in cells)
    return "\n".join(line.rstrip() for line in shown)


def _cut(text: str) -> str:
    return text if len(text) <= _SHOWN else f"{text[: _SHOWN - 3]}..."


def summary(rows: Sequence[Compared]) -> str:
    """Return how many rows there are of each verdict: ``3 same, 1 differs``."""
    counts = [(verdict.value, sum(row.verdict is verdict for row in rows)) for verdict in Verdict]
    return ", ".join(f"{count} {text}" for text, count in counts if count)
