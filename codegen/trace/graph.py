"""The graph of a project: criteria, the rows of the tables that cite them, symbols made of these, and tests.

Criteria are named as tables cite them: ``FR-00068.3``, or ``FR-00068`` for a document as a whole.
"""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from enum import StrEnum
from typing import ClassVar, NamedTuple

from codegen.frozen import dataclass
from codegen.model.spec.spec import Criterion, Requirement
from codegen.model.test_record import MarkedTest
from codegen.source import Place

DECISION = "ADR"
"""Front of the ids of documents that decide rather than ask: their decisions are carried out by requirements."""


class Kind(StrEnum):
    """The kind of thing that a row of the specification is about."""

    MESSAGE = "message"
    FIELD = "field"
    RECEIVED = "received message"
    RECEIVED_FIELD = "received field"
    PARAMETER = "parameter"
    STREAM = "stream"
    GENERATIONS = "generations"
    LINK = "link"
    ADC = "ADC channel"
    SENSOR = "sensor"
    COMPONENT = "component"
    QUANTITY = "quantity"
    FAILSAFE = "failsafe"
    PROGRAM = "program"
    COMMAND = "command"
    MODE = "mode"
    RECEIVER = "receiver"


class Symbol(NamedTuple):
    """A name in a generated file: ``firmware/state.py`` below the output folder, ``BatteryState.voltage``."""

    file: str
    name: str

    def __str__(self) -> str:
        """``firmware/state.py: BatteryState.voltage``."""
        return f"{self.file}: {self.name}"


@dataclass(frozen=True, slots=True)
class Row:
    """A record of the specification, or one aspect of it, and the criterion that it cites.

    ``name`` is ``BATTERY_STATUS``, ``BATTERY_STATUS.voltages``, ``battery.voltage``, ``BATT_LOW_VOLT``...; ``part`` is
    what of it: ``[1..9]`` of a field's elements, the aspect ``stale_after``, or nothing.
    """

    kind: Kind
    name: str
    part: str
    criterion: str
    place: Place
    symbols: tuple[Symbol, ...]

    @property
    def label(self) -> str:
        """``BATTERY_STATUS.voltages[1..9]``, ``battery.voltage (stale_after)``."""
        if not self.part:
            return self.name
        is_field = self.kind in (Kind.FIELD, Kind.RECEIVED_FIELD)
        return f"{self.name}{self.part}" if is_field else f"{self.name} ({self.part})"


@dataclass(frozen=True, slots=True)
class Test:
    """A test function and the criterion that it shows.

    ``file`` is a path below the project's folder. ``cases`` are the parameters in brackets that pytest adds, each of
    which has to pass; a test without any has one case, or, written by hand, as many as the results say. ``about`` is
    the message that it is about, if it is about a single one. ``inputs`` is the hash of the specification that a
    generated test was made of. ``place`` is where a test that is written by hand says what it shows, and ``written`` is
    what is written there, which may be an alias.
    """

    __test__: ClassVar[bool] = False  # pytest takes classes of such names for tests

    file: str
    function: str
    criterion: str
    cases: tuple[str, ...] = ()
    about: str = ""
    inputs: str = ""
    place: Place | None = None
    written: str = ""

    @property
    def name(self) -> str:
        """Return pytest's name for it, without its parameters: ``generated/tests/test_frames.py::test_frames``."""
        return f"{self.file}::{self.function}"


@dataclass(frozen=True, slots=True)
class Trace:
    """A project: its documents in the order of their ids, rows and tests; ``uncited`` are rows that cite nothing.

    ``names`` has the id of each document by its id and each of its aliases, ``criteria`` every criterion by its name,
    in the order of the documents. ``rows_of`` and ``tests_of`` have, by name of a criterion or of a whole document, the
    rows that cite it and the tests that show it. ``depends_on`` has, of criteria that depend on others, the names of
    these, and ``needed_by`` the other way round.
    """

    requirements: tuple[Requirement, ...]
    rows: tuple[Row, ...]
    uncited: tuple[Row, ...]
    tests: tuple[Test, ...]
    names: Mapping[str, str]
    criteria: Mapping[str, tuple[Requirement, Criterion]]
    rows_of: Mapping[str, tuple[Row, ...]]
    tests_of: Mapping[str, tuple[Test, ...]]
    depends_on: Mapping[str, tuple[str, ...]]
    needed_by: Mapping[str, tuple[str, ...]]

    def called(self, name: str) -> str | None:
        """The criterion or document that a name means, which may be an alias; None if there is none."""
        document, dot, number = name.partition(".")
        known = self.names.get(document)
        if known is None or not dot:
            return known
        return f"{known}.{number}" if f"{known}.{number}" in self.criteria else None


def linked(requirements: Iterable[Requirement], rows: Iterable[Row], tests: Iterable[Test]) -> Trace:
    """The graph of documents, rows and tests, which know one another by the names of criteria."""
    requirements = tuple(sorted(requirements, key=lambda each: each.id))
    names = {name: each.id for each in requirements for name in (each.id, *each.aliases)}
    every, tests = tuple(rows), tuple(_by_id(test, names) for test in tests)
    rows = tuple(row for row in every if row.criterion)
    rows_of: dict[str, list[Row]] = {}
    for row in rows:
        rows_of.setdefault(row.criterion, []).append(row)
    tests_of: dict[str, list[Test]] = {}
    for test in tests:
        tests_of.setdefault(test.criterion, []).append(test)
    criteria = {f"{each.id}.{one.number}": (each, one) for each in requirements for one in each.criteria}
    depends_on = dict(_dependencies(criteria, names))
    return Trace(
        requirements=requirements,
        rows=rows,
        uncited=tuple(row for row in every if not row.criterion),
        tests=tests,
        names=names,
        criteria=criteria,
        rows_of={criterion: tuple(found) for criterion, found in rows_of.items()},
        tests_of={criterion: tuple(found) for criterion, found in tests_of.items()},
        depends_on=depends_on,
        needed_by=_turned(depends_on),
    )


def _dependencies(
    criteria: Mapping[str, tuple[Requirement, Criterion]], names: Mapping[str, str]
) -> Iterator[tuple[str, tuple[str, ...]]]:
    """The criteria that depend on others, with the names of these; a rule reports names that mean none."""
    for name, (_, criterion) in criteria.items():
        parts = (written.partition(".") for written in criterion.depends_on)
        meant = [f"{names.get(document, document)}{dot}{number}" for document, dot, number in parts]
        found = tuple(dict.fromkeys(each for each in meant if each in criteria))
        if found:
            yield name, found


def _turned(depends_on: Mapping[str, tuple[str, ...]]) -> dict[str, tuple[str, ...]]:
    needed_by: dict[str, list[str]] = {}
    for name, needed in depends_on.items():
        for each in needed:
            needed_by.setdefault(each, []).append(name)
    return {name: tuple(found) for name, found in needed_by.items()}


def _by_id(test: Test, names: Mapping[str, str]) -> Test:
    """The test with the id of its document where it names an alias."""
    document, dot, number = test.criterion.partition(".")
    known = names.get(document, document)
    return test if known == document else replace(test, criterion=f"{known}{dot}{number}", written=test.criterion)


def hand_written(marked: Iterable[MarkedTest], folder: str) -> tuple[Test, ...]:
    """Tests that say what they show, once for each criterion; ``folder`` is that of the project."""
    tests: dict[tuple[str, str, str], Test] = {}
    for one in marked:
        file = os.path.relpath(one.place.file, folder).replace(os.sep, "/")
        tests.setdefault((file, one.function, one.shows), Test(file, one.function, one.shows, place=one.place))
    return tuple(tests.values())


def is_decision(requirement: Requirement) -> bool:
    """Return whether a document decides, and asks for nothing itself: then nothing of it is uncovered."""
    return requirement.id.partition("-")[0] == DECISION


@dataclass(frozen=True, slots=True)
class Reached:
    """The criteria, symbols and tests that depend on a part of the specification."""

    criteria: tuple[str, ...]
    symbols: tuple[Symbol, ...]
    tests: tuple[Test, ...]


def reached(trace: Trace, name: str, is_meant: Callable[[Row], bool] = lambda _: True) -> Reached:
    """Return what a row reaches: ``name`` is that of a message, a field (``BATTERY_STATUS.voltages``), a parameter...

    A message reaches what its fields do. Of tests about a single message only those about this one count, and of
    several rows of one name, as programs may have, those that are meant.
    """
    rows = [row for row in trace.rows if (row.name == name or _is_field_of(row, name)) and is_meant(row)]
    criteria = sorted({row.criterion for row in rows})
    message = name.partition(".")[0]
    fields = any(row.kind in (Kind.MESSAGE, Kind.FIELD) for row in rows)
    tests = [
        test
        for criterion in criteria
        for test in trace.tests_of.get(criterion, ())
        if not fields or test.about in ("", message)
    ]
    return Reached(tuple(criteria), tuple(sorted({symbol for row in rows for symbol in row.symbols})), tuple(tests))


def _is_field_of(row: Row, message: str) -> bool:
    return row.kind is Kind.FIELD and row.name.startswith(f"{message}.")
