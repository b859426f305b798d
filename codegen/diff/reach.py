"""The reach of a change: the requirements, symbols of the firmware and tests that it touches, in either version."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace

from codegen.diff.change import Area, Change, Reach, joined
from codegen.diff.system.carrying import carried_on
from codegen.frozen import dataclass
from codegen.model.program_folders import COMMON
from codegen.model.system import System
from codegen.trace.graph import Row, Symbol, Test, Trace, reached


@dataclass(frozen=True, slots=True)
class Traces:
    """The traces of both versions, and what the numbers of parameters, channels and quantities make, by their names.

    That is known by program: ``sent_in`` has all programs of both versions, by the names that they have there.
    """

    old: Trace
    new: Trace
    sent_in: Mapping[str, Mapping[str, tuple[str, ...]]]

    def is_of(self, file: str, programs: Collection[str]) -> bool:
        """Return whether a file below the output folder is one of the programs, or common to all; without any, all."""
        folder = file.partition("/")[0]
        return not programs or folder == COMMON or (folder if folder in self.sent_in else "") in programs

    def shows(self, test: Test, programs: Collection[str]) -> bool:
        """Return whether a test is one of the programs, or written by hand, which nobody knows of what it is."""
        return not test.inputs or self.is_of("/".join(test.file.split("/")[-3:]), programs)


def traces(old: Trace, new: Trace, systems: Iterable[System]) -> Traces:
    """Return what reach is looked up in; ``systems`` are those of both versions."""
    sent_in: dict[str, dict[str, dict[str, None]]] = {}
    for system in systems:
        own = sent_in.setdefault(system.spec.program, {})
        for source, reached_from in carried_on(system).items():
            own.setdefault(source, {}).update(dict.fromkeys(reached_from))
        for message in system.messages:
            if message.stream is not None:
                own.setdefault(message.stream.name, {})[message.name] = None
    found = {program: {name: tuple(fields) for name, fields in own.items()} for program, own in sent_in.items()}
    return Traces(old, new, found)


_Known = dict[tuple[str, tuple[str, ...]], Reach]
"""The reaches that are known, by the name of a row or of a criterion, and the programs."""


def with_reach(changes: Iterable[Change], found: Traces) -> tuple[Change, ...]:
    """The changes with what each of them touches."""
    known: _Known = {}
    return tuple(replace(change, reach=_reach(change, found, known)) for change in changes)


def _reach(change: Change, found: Traces, known: _Known) -> Reach:
    programs = change.programs
    carried = [found.sent_in.get(program, {}) for program in programs] if programs else list(found.sent_in.values())
    subject = change.subject
    for program in programs:
        subject = subject.removeprefix(f"{program}: ") if program else subject
    names = list(dict.fromkeys((*change.rows, *((subject,) if any(subject in each for each in carried) else ()))))
    names += dict.fromkeys(field for name in names for each in carried for field in each.get(name, ()))
    parts = [_of_row(name, programs, found, known) for name in names]
    if change.rule.area is Area.TRACE:
        parts += [_of_criterion(name, found, known) for name in change.cited]
    return joined([Reach(requirements=change.cited), *parts])


def _of_row(name: str, programs: tuple[str, ...], found: Traces, known: _Known) -> Reach:
    """Return what the rows of a name reach in some programs: others may have a row of that name, too."""

    def is_own(symbol: Symbol) -> bool:
        return found.is_of(symbol.file, programs)

    def is_meant(row: Row) -> bool:
        return not row.symbols or any(map(is_own, row.symbols))

    key = name, programs
    if key not in known:
        sides = [reached(trace, name, is_meant) for trace in (found.old, found.new)]
        known[key] = joined(
            Reach(
                side.criteria,
                tuple(map(str, filter(is_own, side.symbols))),
                tuple(test.name for test in side.tests if found.shows(test, programs)),
            )
            for side in sides
        )
    return known[key]


def _of_criterion(name: str, found: Traces, known: _Known) -> Reach:
    """Return what answers to a criterion and shows it, whoever cites it."""
    key = f"criterion {name}", ()
    if key not in known:
        rows = [row for trace in (found.old, found.new) for row in trace.rows_of.get(name, ())]
        tests = [test for trace in (found.old, found.new) for test in trace.tests_of.get(name, ())]
        known[key] = Reach(
            symbols=tuple(str(symbol) for row in rows for symbol in row.symbols),
            tests=tuple(test.name for test in tests),
        )
    return known[key]
