"""Rows about the intervals of a message: a time beside the rate that it is, and the rate of a stream."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.own.worked.amount import of_unit
from codegen.claims.own.worked.examples import Entry, Examples, Row, Table
from codegen.diagnostics import Diagnostic
from codegen.model.units.unit import unit_named
from codegen.pattern import pattern

_SECOND, _HERTZ = unit_named("s"), unit_named("Hz")
_INTERVAL = pattern(r"MESSAGE_INTERVAL\b")
_FASTEST = pattern(r"\b(?:highest|fastest) of the stream\b")
_NAME = pattern(r"(?<![\w-])[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+(?![\w-])")


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every table whose first heading is about the intervals of a message."""
    for table in examples.tables:
        if _INTERVAL.search(table.heads[0]):
            for row in table.rows:
                yield from _row(examples, table, row)


def _row(examples: Examples, table: Table, row: Row) -> Iterator[Diagnostic]:
    """Each time belongs to a rate of its own entry, or of the one before, or of the one behind the first."""
    rates = [_rates(examples, entry) for entry in row.entries]
    for index, entry in enumerate(row.entries):
        near = rates[index] or rates[max(index - 1, 0)] or (rates[1] if index == 0 and len(rates) > 1 else [])
        for time in of_unit(entry.amounts, _SECOND)[:1]:
            expected = [_SECOND.scale / (rate * time.unit.scale) for rate in near[:1] if rate]
            words = " or ".join(f"the interval of {float(rate):g} Hz" for rate in near[:1])
            yield from examples.judged(row.passage, time, expected, words)
        for rate in of_unit(entry.amounts, _HERTZ)[:1]:
            if _FASTEST.search(entry.text):
                factor = _HERTZ.scale / rate.unit.scale
                fastest = [each * factor for each in _fastest(examples, table)]
                yield from examples.judged(row.passage, rate, fastest, "the highest rate of the stream")
        set_by = _default(examples, entry)
        for rate in of_unit(entry.amounts, _HERTZ)[:1] if set_by is not None else ():
            factor = _HERTZ.scale / rate.unit.scale
            yield from examples.judged(row.passage, rate, [(set_by or 0) * factor], "the rate at first")


def _rates(examples: Examples, entry: Entry) -> list[Fraction]:
    """The rates of an entry in Hz; without any, the one that the parameter has that it names."""
    found = [each.in_unit(_HERTZ) for each in of_unit(entry.amounts, _HERTZ)]
    named = _default(examples, entry)
    return [each for each in found if each is not None] or ([named] if named is not None else [])


def _default(examples: Examples, entry: Entry) -> Fraction | None:
    """The default of the one rate that an entry names by its parameter."""
    for name in _NAME.findall(entry.text):
        for system in examples.systems:
            parameter = system.parameters.get(name)
            if parameter is not None and parameter.unit.dimension == _HERTZ.dimension:
                return parameter.default * parameter.step
    return None


def _fastest(examples: Examples, table: Table) -> list[Fraction]:
    """The highest rates of the messages that the first heading names."""
    names = set(_NAME.findall(table.heads[0]))
    messages = [each for system in examples.systems for each in system.messages if each.wire.name in names]
    return [each.stream.fastest for each in messages if each.stream is not None]
