"""Changes between two versions of a specification, with those of the dialect that concern it."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from fractions import Fraction

from codegen.diff.change import Change
from codegen.diff.dialect.dialect import dialect_changes
from codegen.diff.dialect.hearing import dropped, heard_in
from codegen.diff.dialect.used import used_of
from codegen.diff.judging.softening import softened
from codegen.diff.own_places import at_own_places
from codegen.diff.system.bandwidth import Bandwidth, bandwidth_changes, compare_bandwidth, order_changes
from codegen.diff.system.board import board_subjects
from codegen.diff.system.carrying import carried_on, fed_by_facts, written_otherwise
from codegen.diff.system.commanded_otherwise import renamed
from codegen.diff.system.drivers import driver_changes
from codegen.diff.system.heard_otherwise import heard_otherwise
from codegen.diff.system.population import population_changes
from codegen.diff.system.program import program_subjects
from codegen.diff.system.programs import added, paired, removed
from codegen.diff.system.reception import reception_subjects
from codegen.diff.system.requirements import as_called_now, coverage_changes, renamed_ids, requirement_changes
from codegen.diff.system.state import parameter_subjects, state_subjects
from codegen.diff.system.subject import Subject, cited, subject_changes
from codegen.diff.system.trace_rules import CITATION
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import Dialect
from codegen.model.system import System

THRESHOLD = Fraction(5)
"""The growth of the telemetry, in %, from which on it is a change of its own."""


@dataclass(frozen=True, slots=True)
class Comparison:
    """Two versions compared.

    ``changes`` concern what is compared; ``elsewhere`` are those of a project's dialect that touch nothing that the
    project sends, receives or names. ``bandwidth`` has an entry for each program that both versions have, by its name,
    which is "" for the project's own. ``carried`` is what takes numbers from parameters, ADC
    channels and quantities, each as changes call it: what is of a further program begins with the name of that.
    """

    changes: tuple[Change, ...]
    elsewhere: tuple[Change, ...] = ()
    bandwidth: tuple[tuple[str, Bandwidth], ...] = ()
    carried: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


def compare_dialects(old: Dialect, new: Dialect) -> Comparison:
    """Two dialects, each on its own."""
    changes = at_own_places(dialect_changes(old, new), old, new)
    return Comparison(tuple(softened(changes, old)))


def compare_systems(old: Sequence[System], new: Sequence[System], threshold: Fraction = THRESHOLD) -> Comparison:
    """Two versions of a project with its further programs; the first system of each is the project's own."""
    pairs = paired(old, new)
    used = used_of((*old, *new))
    dialects = old[0].dialect, new[0].dialect
    of_dialect = at_own_places(dialect_changes(*dialects), *dialects, old, new)
    found: list[Change] = [*pairs.renamed]
    elsewhere: list[Change] = []
    for change in (renamed(change, old[0], new[0]) for change in of_dialect):
        (found if used.is_concerned(change) else elsewhere).append(change)
    before = pairs.known
    called_before = {each.new: each.old or "" for each in pairs.renamed}
    after = {system.spec.program: system for system in new}
    said_before = {name: _subjects(system) for name, system in before.items()}
    said_after = {name: _subjects(system) for name, system in after.items()}
    notices = dropped(old[0].dialect.messages, new[0].dialect.messages)
    bandwidth = []
    carried: dict[str, tuple[str, ...]] = {}
    for name, system in after.items():
        known = before.get(name)
        if known is None:
            found.append(added(system))
            continue
        for source, reached in _carried(known, system).items():
            carried[_called_in(name, source)] = tuple(_called_in(name, target) for target in reached)
        compared = compare_bandwidth(known, system)
        bandwidth.append((name, compared))
        own = [
            *population_changes(known, system),
            *subject_changes(said_before[name], said_after[name]),
            *driver_changes(known, system),
            *bandwidth_changes(compared, system, known, threshold),
            *order_changes(compared, known, system),
        ]
        judged = heard_in(heard_otherwise(own, known, system), notices)
        called = tuple(dict.fromkeys((name, called_before.get(name, name))))
        found += [replace(_named(change, name), programs=called) for change in judged]
    found += [removed(system) for system in pairs.gone]
    found += requirement_changes(old[0], new[0])
    said_once = (*said_before.values(), *(_subjects(system) for system in pairs.gone))
    found += coverage_changes(old[0], new[0], _cited(old, said_once), _cited(new, said_after.values()))
    ids = renamed_ids(old[0], new[0])
    found = [change for change in found if not _is_only_renamed(change, ids)]
    return Comparison(_once(found), tuple(softened(elsewhere, old[0].dialect)), tuple(bandwidth), carried)


def _is_only_renamed(change: Change, ids: Mapping[str, str]) -> bool:
    """Return whether a part answers to the same document as before, which has another id."""
    return change.rule is CITATION and as_called_now(change.old or "", ids) == change.new


def _carried(old: System, new: System) -> dict[str, tuple[str, ...]]:
    """Return what takes numbers from each part of a program, in either version; what a fact feeds only if it is
    written as before.
    """
    carried = {**carried_on(old), **carried_on(new)}
    own_edits = set(written_otherwise(old, new))
    for fact, fed in fed_by_facts(new).items():
        carried[fact] = (*carried.get(fact, ()), *(name for name in fed if name not in own_edits))
    return carried


def _named(change: Change, program: str) -> Change:
    is_named = change.subject == program
    return change if is_named else replace(change, subject=_called_in(program, change.subject))


def _called_in(program: str, subject: str) -> str:
    return f"{program}: {subject}" if program else subject


def _subjects(system: System) -> tuple[Subject, ...]:
    return (
        *parameter_subjects(system),
        *state_subjects(system),
        *board_subjects(system),
        *program_subjects(system),
        *reception_subjects(system),
    )


def _cited(systems: Sequence[System], said: Iterable[Sequence[Subject]]) -> set[str]:
    """The names of every document and criterion that a part of the systems answers to; ``said`` are their subjects."""
    found = {name for subjects in said for subject in subjects for name in subject.cited}
    for system in systems:
        for message in system.messages:
            found.update(
                cited(message.citation, message.aspects, *(answer.covers.citation for answer in message.answers))
            )
    return found


def _once(changes: Sequence[Change]) -> tuple[Change, ...]:
    """The changes; of several programs those as one, the first, that stand at the same place and say the same."""
    found: dict[tuple[object, ...], Change] = {}
    for change in changes:
        key = change.rule.id, change.place, change.old, change.new, change.subject.rpartition(": ")[2]
        first = found.get(key)
        if first is None:
            found[key] = change
        elif first.programs:
            several = dict.fromkeys((*first.programs, *change.programs)) if change.programs else ()
            found[key] = replace(first, programs=tuple(several))
    return tuple(found.values())
