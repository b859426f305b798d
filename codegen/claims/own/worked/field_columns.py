"""Tables of what fields carry: a column for a quantity, and others headed by elements of a message."""

from collections.abc import Iterator, Sequence
from fractions import Fraction

from codegen.claims.own.worked.examples import Examples, Row, Table
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.model.answers.answer import Answer
from codegen.model.answers.known import Known
from codegen.model.dialect.dialect import WireField
from codegen.model.system import PopulatedMessage
from codegen.model.vehicle import Quantity, QuantityKind
from codegen.pattern import pattern

_FIELD = pattern(r"(?P<name>[a-z][a-z0-9_]*)(?:\[(?P<low>\d{1,3})(?:\.\.(?P<high>\d{1,3}))?\])?")
_QUANTITY = pattern(r"(?P<name>[A-Za-z][A-Za-z0-9_ ]*?)(?: \([^()]*\))?")
_UNKNOWN = "unknown"


@dataclass(frozen=True, slots=True)
class _Column:
    """A column with elements of a field, from ``low`` to ``high``."""

    index: int
    field: WireField
    low: int
    high: int


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every table whose first heading is a quantity, and another one a field that carries it."""
    for table in examples.tables:
        named = _QUANTITY.fullmatch(table.heads[0])
        tables = [(each, found) for each in _messages(examples) if (found := _columns(table, each.wire.fields))]
        name = named["name"].casefold().replace(" ", "_") if named else ""
        for row in table.rows if name and tables else ():
            yield from _row(examples, table, row, name, tables)


def _messages(examples: Examples) -> Iterator[PopulatedMessage]:
    return (message for system in examples.systems for message in system.messages)


def _columns(table: Table, fields: Sequence[WireField]) -> tuple[_Column, ...]:
    known = {field.name: field for field in fields}
    found = []
    for index, head in enumerate(table.heads[1:], 1):
        named = _FIELD.fullmatch(head)
        field = known.get(named["name"]) if named else None
        if named is not None and field is not None:
            low = int(named["low"] or 0)
            found.append(_Column(index, field, low, int(named["high"] or low)))
    return tuple(found)


def _row(
    examples: Examples,
    table: Table,
    row: Row,
    name: str,
    tables: Sequence[tuple[PopulatedMessage, tuple[_Column, ...]]],
) -> Iterator[Diagnostic]:
    """The numbers of a row beside what each message would carry; a column is wrong where it is so for all of them."""
    expected: dict[int, list[Fraction]] = {}
    for message, columns in tables:
        for column in columns:
            for answer in message.answers:
                quantity = next((each for each in answer.carried if each.name.casefold() == name), None)
                covers = answer.covers
                if quantity is None or covers.field.name != column.field.name:
                    continue
                if not covers.first <= column.low <= column.high < covers.first + covers.count:
                    continue
                values = _values(table, row, answer, quantity)
                part = {values[place - covers.first] for place in range(column.low, column.high + 1)} if values else ()
                expected.setdefault(column.index, []).extend(Fraction(each) for each in part if len(part) == 1)
    for index, numbers in expected.items():
        found = row.only(index)
        if found is not None:
            yield from examples.judged(row.passage, found, numbers, f"{table.heads[index]} of {row.entries[0].text}")


def _values(table: Table, row: Row, answer: Answer, quantity: Quantity) -> tuple[int, ...]:
    """Return the raw values of an answer for the quantity of a row, all others unknown; empty where that is unsure."""
    amount, text = table.amount(row, 0), row.entries[0].text
    if quantity.kind is not QuantityKind.NUMBER or quantity.elements is not None:
        return ()
    known: dict[str, Fraction | int | None] = {each.path: None for each in answer.quantities}
    if text != _UNKNOWN:
        value = amount.in_unit(quantity.unit) if amount is not None else None
        stored = None if value is None else value * quantity.steps
        if stored is None or stored.denominator != 1:
            return ()
        known[quantity.path] = int(stored)
    elif quantity.initial is not None:
        return ()
    return _carried(answer, known)


def _carried(answer: Answer, known: Known) -> tuple[int, ...]:
    if answer.is_withheld(known):
        return ()
    values = answer.values(known, 0, 0)
    return (
        tuple(each for each in values if isinstance(each, int)) if all(isinstance(each, int) for each in values) else ()
    )
