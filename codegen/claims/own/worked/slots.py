"""Tables of the passes of the main loop: when a slot begins, and which slots a long pass misses."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.own.worked.amount import Amount, of_unit
from codegen.claims.own.worked.examples import Examples, Row, Table
from codegen.diagnostics import Diagnostic
from codegen.model.units.unit import unit_named
from codegen.pattern import pattern

_SECOND = unit_named("s")
_SLOT, _TIME = pattern(r"slot", re.IGNORECASE), pattern(r"time", re.IGNORECASE)
_FEWEST = 2
"""Rows that have to agree before another one is wrong."""
_DURATION = pattern(r"duration\b.*", re.IGNORECASE)
_COLUMNS = {
    "next": pattern(r"next pass", re.IGNORECASE),
    "slot": pattern(r"its slot", re.IGNORECASE),
    "missed": pattern(r"slots missed|missed slots", re.IGNORECASE),
    "after": pattern(r"pass after that", re.IGNORECASE),
}


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every table of slots and their times, and of durations and the slots that they miss."""
    found = (system.program.control_us for system in examples.systems if system.program is not None)
    periods = [Fraction(each, 10**6) for each in dict.fromkeys(found)]
    for table in examples.tables if periods else ():
        slot, time = table.column(_SLOT), table.column(_TIME)
        duration = table.column(_DURATION)
        columns = {key: place for key, form in _COLUMNS.items() if (place := table.column(form)) is not None}
        if slot is not None and time is not None:
            told = [list(_times(examples, row, slot, time, periods)) for row in table.rows]
            if sum(not found for found in told) >= _FEWEST:  # it is about the slots of the main loop
                yield from (each for found in told for each in found)
        for row in table.rows:
            if duration is not None and len(columns) == len(_COLUMNS):
                yield from _missed(examples, table, row, row.only(duration), columns, periods)


def _times(examples: Examples, row: Row, slot: int, time: int, periods: list[Fraction]) -> Iterator[Diagnostic]:
    """ "1 to 39 | 2.5 ms to 97.5 ms"."""
    numbers, times = row.at(slot), row.at(time)
    slots = [each for each in numbers.amounts if each.is_plain] if numbers else []
    begins = of_unit(times.amounts, _SECOND) if times else ()
    for number, begin in zip(slots, begins, strict=False) if len(slots) == len(begins) else ():
        expected = [number.value * period / begin.unit.scale for period in periods]
        yield from examples.judged(row.passage, begin, expected, f"the begin of slot {number.written}")


def _missed(
    examples: Examples,
    table: Table,
    row: Row,
    duration: Amount | None,
    columns: dict[str, int],
    periods: list[Fraction],
) -> Iterator[Diagnostic]:
    """The pass after one that took a time: at the newest slot that has begun, at least the next one."""
    taken = duration.in_unit(_SECOND) if duration is not None else None
    if duration is None or taken is None:
        return
    stated = {key: found for key, column in columns.items() if (found := row.only(column)) is not None}
    made = [_pass_after(taken, period) for period in periods]
    fits = [[found.shows(_as(found, each[key])) for key, found in stated.items()].count(True) for each in made]
    nearest = made[fits.index(max(fits))]  # of several programs the one that the row is about
    for key, found in stated.items():
        words = f"{table.heads[columns[key]]} after {duration.written}"
        yield from examples.judged(row.passage, found, [_as(found, nearest[key])], words)


def _pass_after(taken: Fraction, period: Fraction) -> dict[str, Fraction]:
    """Return the slot, the missed slots and the start of the next pass (s) after a pass of ``taken`` seconds."""
    slot = max(int(taken // period), 1)
    made = {"slot": Fraction(slot), "missed": Fraction(slot - 1)}
    return made | {"next": max(taken, period), "after": (slot + 1) * period}


def _as(found: Amount, value: Fraction) -> Fraction:
    """A number of slots, or of seconds in the unit of what is stated."""
    return value if found.is_plain else value / found.unit.scale
