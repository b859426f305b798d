"""The reach of a change: the requirements, symbols of the firmware and tests that it touches, in either version."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from codegen.diff.change import Area, Change, Reach, joined
from codegen.diff.system.carrying import carried_on
from codegen.frozen import dataclass
from codegen.model.system import System
from codegen.trace.graph import Trace, reached


@dataclass(frozen=True, slots=True)
class Traces:
    """The traces of both versions, and what the numbers of parameters, channels and quantities make, by their names."""

    old: Trace
    new: Trace
    sent_in: Mapping[str, tuple[str, ...]]


def traces(old: Trace, new: Trace, systems: Iterable[System]) -> Traces:
    """Return what reach is looked up in; ``systems`` are those of both versions."""
    sent_in: dict[str, dict[str, None]] = {}
    for system in systems:
        for source, reached_from in carried_on(system).items():
            sent_in.setdefault(source, {}).update(dict.fromkeys(reached_from))
        for message in system.messages:
            if message.stream is not None:
                sent_in.setdefault(message.stream.name, {})[message.name] = None
    return Traces(old, new, {name: tuple(fields) for name, fields in sent_in.items()})


def with_reach(changes: Iterable[Change], found: Traces) -> tuple[Change, ...]:
    """The changes with what each of them touches."""
    known: dict[str, Reach] = {}
    return tuple(replace(change, reach=_reach(change, found, known)) for change in changes)


def _reach(change: Change, found: Traces, known: dict[str, Reach]) -> Reach:
    names = list(dict.fromkeys((*change.rows, *((change.subject,) if change.subject in found.sent_in else ()))))
    names += [field for name in names for field in found.sent_in.get(name, ()) if field not in names]
    parts = [_of_row(name, found, known) for name in names]
    if change.rule.area is Area.TRACE:
        parts += [_of_criterion(name, found, known) for name in change.cited]
    return joined([Reach(requirements=change.cited), *parts])


def _of_row(name: str, found: Traces, known: dict[str, Reach]) -> Reach:
    if name not in known:
        sides = [reached(trace, name) for trace in (found.old, found.new)]
        known[name] = joined(
            Reach(side.criteria, tuple(map(str, side.symbols)), tuple(test.name for test in side.tests))
            for side in sides
        )
    return known[name]


def _of_criterion(name: str, found: Traces, known: dict[str, Reach]) -> Reach:
    """Return what answers to a criterion and shows it, whoever cites it."""
    key = f"criterion {name}"
    if key not in known:
        rows = [row for trace in (found.old, found.new) for row in trace.rows_of.get(name, ())]
        tests = [test for trace in (found.old, found.new) for test in trace.tests_of.get(name, ())]
        known[key] = Reach(
            symbols=tuple(str(symbol) for row in rows for symbol in row.symbols),
            tests=tuple(test.name for test in tests),
        )
    return known[key]
