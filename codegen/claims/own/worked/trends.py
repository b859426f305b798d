"""Trends of what is measured: the mean of the newer half of a window less that of the older half, over half of it."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.own.worked.amount import Amount, amounts, of_unit
from codegen.claims.own.worked.examples import Examples, Row, Statement, Table
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.model.units.unit import Unit, unit_named
from codegen.pattern import pattern

_SECOND = unit_named("s")
_TREND = pattern(r"trend\b.*", re.IGNORECASE)
_HOLDS = pattern(r"\bwindow holds (?=\d)")
_LAST = pattern(r"(?:.*, )?(?P<count>\d{1,4}) (?:at|on a ramp of (?=-?\d))")
_STEP = pattern(r"\bstep from (?=-?\d)")
_READINGS = pattern(r"readings after the step", re.IGNORECASE)
_FIRST = pattern(r"from the first reading to the first trend\b", re.IGNORECASE)
_MIDDLES = pattern(r"distance between the middles of the two halves\b", re.IGNORECASE)
_BETWEEN = pattern(r"trend from .* changes between the halves\b", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class _Trend:
    """A trend of the project: over so many ``readings``, each after ``period`` seconds, told in ``unit``."""

    readings: int
    period: Fraction
    unit: Unit

    @property
    def half(self) -> Fraction:
        """The seconds of half of the window."""
        return self.readings // 2 * self.period


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every table with a column "Trend", every statement about windows and trends; where the project has one trend."""
    found = set(_trends(examples))
    trend = found.pop() if len(found) == 1 else None
    if trend is None:
        return
    for table in examples.tables:
        yield from _table(examples, table, trend)
    for passage in examples.texts:
        for said in _HOLDS.finditer(passage.text):
            number = amounts(passage.text, said.end(), said.end() + 8)[0]
            yield from examples.judged(
                passage, number, [Fraction(trend.readings)], "the number of readings in a window"
            )
    for statement in examples.statements:
        yield from _statement(examples, statement, trend)


def _trends(examples: Examples) -> Iterator[_Trend]:
    for system in examples.systems:
        for component in system.components.values():
            for quantity in component.quantities.values():
                if quantity.derivation.kept_readings > 1 and component.period_ms:
                    period = Fraction(component.period_ms, 1000)
                    yield _Trend(quantity.derivation.kept_readings, period, quantity.unit)


def _table(examples: Examples, table: Table, trend: _Trend) -> Iterator[Diagnostic]:
    column = table.column(_TREND)
    step = _STEP.search(table.intro.text) if table.intro is not None else None
    ends = amounts(table.intro.text, step.end())[:2] if step is not None and table.intro is not None else ()
    for row in table.rows if column is not None else ():
        said, found = row.entries[0], table.amount(row, column)
        entry = row.at(column)
        last = _LAST.match(said.text)
        if len(ends) == 2 and _READINGS.fullmatch(table.heads[0]) and said.only is not None and found is not None:
            newer = min(said.only.value / (trend.readings // 2), Fraction(1))
            older = max(said.only.value / (trend.readings // 2) - 1, Fraction(0))
            change = (ends[1].value * ends[1].unit.scale - ends[0].value * ends[0].unit.scale) * (newer - older)
            yield from _judged(examples, row, found, change / trend.half, trend)
        elif last is not None and entry is not None:
            is_full = int(last["count"]) >= trend.readings
            if is_full != (entry.text != "unknown"):
                text = f"{last['count']} readings fill {'' if is_full else 'no '}window of {trend.readings}"
                yield examples.wrong(row.passage, said.start + last.start("count"), text)
            elif found is not None:
                ramp = said.amounts[-1] if " on a ramp of " in said.text else None
                change = ramp.value * ramp.unit.scale / trend.period if ramp is not None else Fraction(0)
                yield from _judged(examples, row, found, change, trend)


def _judged(examples: Examples, row: Row, found: Amount, change: Fraction, trend: _Trend) -> Iterator[Diagnostic]:
    """A trend of ``change`` base units per second."""
    if found.like(trend.unit):
        yield from examples.judged(row.passage, found, [change / found.unit.scale], "the trend")


def _statement(examples: Examples, statement: Statement, trend: _Trend) -> Iterator[Diagnostic]:
    label, value = statement.label, statement.value.alone
    if value is None:
        return
    if value.like(_SECOND) and _FIRST.match(label.text):
        seconds = (trend.readings - 1) * trend.period
        yield from examples.judged(statement.passage, value, [seconds / value.unit.scale], label.text)
    elif value.like(_SECOND) and _MIDDLES.match(label.text):
        yield from examples.judged(statement.passage, value, [trend.half / value.unit.scale], label.text)
    elif value.like(trend.unit) and _BETWEEN.match(label.text):
        change = [each for each in label.amounts if not each.is_plain and not of_unit([each], _SECOND)]
        if len(change) == 1:
            expected = change[0].value * change[0].unit.scale / trend.half / value.unit.scale
            yield from examples.judged(statement.passage, value, [expected], "the trend")
