"""Judges changes of what the vehicle does by itself: actions of failsafes, and the program around them."""

from collections.abc import Iterator

from codegen.diff.change import Change
from codegen.diff.system.failsafes import is_chosen
from codegen.diff.system.judged import Sides, doubtful, silent
from codegen.model.program import Program

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
