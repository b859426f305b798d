"""Further programs that come, go, and have another name: which of two versions is the same as which."""

import os
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from codegen.diff.change import Change, changed
from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.subject import cited
from codegen.frozen import dataclass
from codegen.model.system import System


@dataclass(frozen=True, slots=True)
class Paired:
    """The programs of the old version: ``known`` are those that the new one has, by the name that they have in it."""

    known: Mapping[str, System]
    gone: tuple[System, ...]
    renamed: tuple[Change, ...]


def paired(old: Sequence[System], new: Sequence[System]) -> Paired:
    """Return the programs of the old version as the new one calls them; the first of each is the project's own.

    A program is the one of the same folder and name, else of the same folder, the same name, the same component id, or
    the one that sends most of the same messages: what changed in one that was renamed would be told of neither name.
    """
    gone, come = list(old[1:]), list(new[1:])
    pairs: list[tuple[System, System]] = []
    for known_by in (_place, _folder, _name, _component):
        pairs += _taken(_alike(gone, come, known_by), gone, come)
    pairs += _taken(_sending_alike(gone, come), gone, come)
    known = {name: _called(before, name) for before, after in pairs for name in [after.spec.program]}
    renamed = tuple(_renamed(*pair) for pair in pairs if pair[0].spec.program != pair[1].spec.program)
    return Paired({new[0].spec.program: old[0], **known}, tuple(gone), renamed)


def added(system: System) -> Change:
    """A further program that is new."""
    return changed(rules.PROGRAM_ADDED, system.spec.program, None, _says(system), (None, system.spec.project.place))


def removed(system: System) -> Change:
    """A further program that is gone: with it, all that it sends and hears."""
    hears = bool(system.receptions) or system.program is not None
    effect = f"who listens to component {system.component_id} hears nothing any more" if system.sent else ""
    if hears and not effect:
        effect = f"who sends to component {system.component_id} is not heard any more"
    return changed(
        rules.PROGRAM_REMOVED,
        system.spec.program,
        _says(system),
        None,
        (system.spec.project.place, None),
        effect,
        breaks=None if effect else (),
        cited=dict.fromkeys(name for each in system.messages for name in cited(each.citation, each.aspects)),
        messages=dict.fromkeys(each.wire.name for each in system.messages),
    )


def _says(system: System) -> str:
    names = ", ".join(message.name for message in system.messages)
    return f"a further program, which sends {names or 'nothing'}"


def _renamed(old: System, new: System) -> Change:
    places = old.spec.project.place, new.spec.project.place
    return changed(rules.PROGRAM_RENAMED, new.spec.program, old.spec.program, new.spec.program, places)


def _called(system: System, name: str) -> System:
    """The program under another name, which none of its parts has changed for."""
    return replace(system, spec=replace(system.spec, program=name))


def _place(system: System) -> tuple[str, str]:
    return _folder(system), _name(system)


def _folder(system: System) -> str:
    return os.path.relpath(system.spec.own_folder, system.spec.folder)


def _name(system: System) -> str:
    return system.spec.program


def _component(system: System) -> int:
    return system.component_id


def _alike(
    gone: Sequence[System], come: Sequence[System], known_by: Callable[[System], Hashable]
) -> Iterator[tuple[System, System]]:
    """Return the pairs that have something in common which no other program of either version has."""
    for before in gone:
        known = known_by(before)
        found = [after for after in come if known_by(after) == known]
        if len(found) == 1 and sum(known_by(other) == known for other in gone) == 1:
            yield before, found[0]


def _sending_alike(gone: Sequence[System], come: Sequence[System]) -> Iterator[tuple[System, System]]:
    """Return the pairs of which both send at least half of what either does, the most alike first."""
    several = [(_common(before, after), before, after) for before in gone for after in come]
    left, right = list(gone), list(come)
    for share, before, after in sorted(several, key=lambda each: -each[0]):
        if 2 * share >= 1 and before in left and after in right:
            left.remove(before)
            right.remove(after)
            yield before, after


def _common(old: System, new: System) -> float:
    """Return the share of the messages of two programs that both send."""
    before, after = ({message.name for message in side.messages} for side in (old, new))
    return len(before & after) / len(before | after) if before | after else 0


def _taken(
    pairs: Iterable[tuple[System, System]], gone: list[System], come: list[System]
) -> list[tuple[System, System]]:
    """The pairs, which are no longer to be found."""
    found = list(pairs)
    for before, after in found:
        gone.remove(before)
        come.remove(after)
    return found
