"""Judges changes of what the vehicle does by itself: actions of failsafes, and the program around them."""

from collections.abc import Iterator

from codegen.diagnostics import shortened_list
from codegen.diff.change import Change
from codegen.diff.system.failsafes import is_chosen
from codegen.diff.system.judged import Sides, doubtful, silent
from codegen.model.failsafe import Failsafe
from codegen.model.program import Program
from codegen.model.system import System
from codegen.model.vehicle import Parameter

_ACTION = "failsafe action "


def failsafe(change: Change, sides: Sides) -> Change:
    """An action whose number another one had, or that comes before others that it came behind."""
    old, new = sides.old.program, sides.new.program
    if old is None or new is None or not change.subject.startswith(_ACTION) or None in (change.old, change.new):
        return change
    number = int(change.subject.removeprefix(_ACTION))
    calls = [{action.value: action.call for action in side.actions} for side in (old, new)]
    before, after = (each.get(number) for each in calls)
    if is_chosen(old) and is_chosen(new) and before is not None and after is not None and before != after:
        if after in calls[0].values():
            return silent(change, f"where {number} is stored for {before}, {after} is done")
        change = doubtful(change, f"whether {after}() does what {before}() did")
    for first, second in _exchanged(old, new):
        if calls[1][number] == first:
            change = doubtful(change, f"whether {first} is to come before {second}")
    return change


def decided(change: Change, sides: Sides) -> Change:
    """A default by which nobody is told another number, but failsafes watch, wait or act otherwise, or something else
    does: nothing here says what the code of the vehicle does with it.
    """
    if not change.weight.is_harmless:
        return change
    old, new = (side.parameters.get(change.subject) for side in (sides.old, sides.new))
    if old is None or new is None or _is_told_elsewhere(new, sides.new):
        return change
    name = new.siblings[0] if new.siblings else new.name
    failsafes = [each.name for side in (sides.old, sides.new) for each in _deciding(side, name)]
    if failsafes:
        shown = shortened_list(tuple(dict.fromkeys(failsafes)), 3)
        return doubtful(change, f"whether {shown} is to watch and act so, where no value is stored")
    return doubtful(change, "whether what it decides is meant, where no value is stored")


def _is_told_elsewhere(parameter: Parameter, system: System) -> bool:
    """Return whether it says nothing but what is judged by itself: the rate of a stream, who the vehicle is, which
    generation is sent.
    """
    chosen = (
        system.system_parameter,
        system.component_parameter,
        *(stream.parameter for stream in system.streams.values()),
        *(generations.parameter for generations in system.generations),
    )
    return any(each is not None and each.name == parameter.name for each in chosen)


def _deciding(system: System, name: str) -> Iterator[Failsafe]:
    """The failsafes that read a parameter."""
    for failsafe in system.program.failsafes if system.program else ():
        read = [each for level in failsafe.levels for each in level.parameters]
        read += [each for condition in failsafe.to_arm for each in condition.parameters]
        read += [failsafe.enabled_by] if failsafe.enabled_by else []
        if any(name in (each.name, *each.siblings) for each in read):
            yield failsafe


def _exchanged(old: Program, new: Program) -> Iterator[tuple[str, str]]:
    """Return the pairs of actions of which another one is the more severe now, that one first."""
    before, after = ([action.call for action in side.priority] for side in (old, new))
    for place, first in enumerate(after):
        for second in after[place + 1 :]:
            if first in before and second in before and before.index(first) > before.index(second):
                yield first, second


def program(change: Change, sides: Sides) -> Change:
    """A program that hears or answers less, or keeps less."""
    old, new = sides.old.program, sides.new.program
    if change.subject != "program" or old is None or new is None:
        return change
    for doubt in _less(old, new):
        change = doubtful(change, doubt)
    return change


def _less(old: Program, new: Program) -> Iterator[str]:
    unheard = _gone([message.name for message in old.services], [message.name for message in new.services])
    unsaid = _gone(old.sent, new.sent)
    if unheard:
        yield f"whether anybody still sends {', '.join(unheard)}"
    if unsaid:
        yield f"whether anybody waits for {', '.join(unsaid)}"
    if new.spec.storage.files != old.spec.storage.files:
        yield "whether what is stored on boards may be lost"
    if new.fastest < old.fastest:
        yield "whether what is asked for is sent often enough"
    if old.watchdog is not None and (new.watchdog is None or new.watchdog.timeout_ms > old.watchdog.timeout_ms):
        yield "whether a loop may stand still for so long"
    yield from _otherwise(old, new)
    yield from _keys(old, new)


def _otherwise(old: Program, new: Program) -> Iterator[str]:
    """Return what to ask where its code or failsafes are called at other times, or other code is."""
    if new.control_us != old.control_us:
        yield "whether code that is called so often counts on it"
    if new.checks_us > old.checks_us:
        yield "whether failsafes may look so seldom"
    if (new.module, new.class_name) != (old.module, old.class_name):
        yield f"whether {new.class_name} of {new.module} does what {old.class_name} of {old.module} did"
    if new.measure_us != old.measure_us:
        yield "whether code that measures so often gives the same numbers"


def _keys(old: Program, new: Program) -> Iterator[str]:
    if old.access is not None and new.access is not None:
        if new.access.spec.key != old.access.spec.key:
            yield f"whether {new.access.spec.key} is on boards"
        if new.access.spec.setup != old.access.spec.setup:
            yield "whether a new key is to come that way"


def _gone(before: "tuple[str, ...] | list[str]", after: "tuple[str, ...] | list[str]") -> list[str]:
    return [name for name in before if name not in after]
