"""Judges changes of what is done for a command or in a mode: the same number may stand for another deed."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from codegen.diff.change import Change
from codegen.diff.dialect.wire_rules import ENTRY_RENAMED
from codegen.diff.judging.wording import Likeness, name_likeness
from codegen.diff.system.judged import Sides, breaking, doubtful, is_narrower, joined, silent
from codegen.model.command import Command, CommandParam
from codegen.model.spec.command import Allowed, Sender
from codegen.model.system import System

_OTHER = {Allowed.DISARMED: "armed", Allowed.ARMED: "not armed"}
"""The state in which a command was refused."""


def command(change: Change, sides: Sides) -> Change:
    """A command that is done by other code, or is accepted from fewer or in fewer states: who gives it as before gets
    something else, or is refused and told so.
    """
    old, new = _both(change, sides)
    if old is None or new is None:
        return change
    change = _done_by(change, old, new, sides)
    for doubt in _arguments(old, new):
        change = doubtful(change, doubt)
    if change.is_breaking:
        return change
    if new.spec.sender not in (old.spec.sender, Sender.ANY):
        return breaking(change, f"only a sender that is {new.spec.sender.value} is obeyed; others are refused")
    if new.spec.allowed not in (old.spec.allowed, Allowed.ALWAYS):
        return breaking(change, f"it is refused unless the vehicle is {new.spec.allowed.value}")
    for doubt in _more(old, new):
        change = doubtful(change, doubt)
    return change


def _more(old: Command, new: Command) -> Iterator[str]:
    """Return what to ask where the vehicle obeys what it refused before, or answers otherwise."""
    if new.spec.sender is not old.spec.sender:
        yield "whether others than before may give it"
    if new.spec.allowed is not old.spec.allowed:
        yield f"whether the vehicle may do it while it is {_OTHER[old.spec.allowed]}"
    if new.spec.long is not old.spec.long:
        yield f"whether who gives it {'waits for its end' if new.spec.long else 'counts on its taking long'}"


def _both(change: Change, sides: Sides) -> tuple[Command | None, Command | None]:
    """A command in both versions: it is known by its number, and may have had another name."""
    new = next((each for each in _commands(sides.new) if each.name == change.subject), None)
    return next((each for each in _commands(sides.old) if new and each.number == new.number), None), new


def _commands(system: System) -> tuple[Command, ...]:
    return system.program.commands if system.program else ()


def _done_by(change: Change, old: Command, new: Command, sides: Sides) -> Change:
    """A method that did something else before does so now for this number; one that nobody knew is a question."""
    before, after = old.spec.method, new.spec.method
    if before == after:
        return change
    others = [each.name for each in _commands(sides.old) if each.spec.method == after]
    if others:
        did = f"{after}(), which did {others[0]} before"
        return silent(change, f"who sends {new.number} for {old.name} gets what is done by {did}")
    return doubtful(change, f"whether {after}() does what {before}() did")


def _arguments(old: Command, new: Command) -> Iterator[str]:
    """Return what to ask where the method gets its arguments in another order, or in other units."""
    kept = {param.name for param in old.params} & {param.name for param in new.params}
    before, after = ([(each.name, each.number) for each in side.params if each.name in kept] for side in (old, new))
    if before != after:
        order = ", ".join(param.name for param in new.params)
        yield f"whether what is sent as before is meant in the order {order}"
    for known, param in _params(old, new):
        if known.unit != param.unit:
            yield f"whether {new.spec.method}() takes {param.name} in {param.unit.name or 'plain numbers'}"


def _params(old: Command, new: Command) -> Iterator[tuple[CommandParam, CommandParam]]:
    before = {param.number: param for param in old.params}
    return ((before[param.number], param) for param in new.params if param.number in before)


def accepted(change: Change, sides: Sides) -> Change:
    """A command that takes fewer values, or another one for NaN."""
    old, new = _both(change, sides)
    if old is None or new is None:
        return change
    for known, param in _params(old, new):
        for doubt in _fewer(known, param):
            change = doubtful(change, doubt)
    return change


def _fewer(old: CommandParam, new: CommandParam) -> Iterator[str]:
    if old.wire_unit == new.wire_unit and _takes_less(old, new):
        yield f"whether {new.name} is sent that is refused now"
    if old.default is not None and _on_the_wire(old) != _on_the_wire(new):
        yield f"whether who sends NaN for {new.name} means the other value"


def _takes_less(old: CommandParam, new: CommandParam) -> bool:
    if is_narrower((old.minimum, old.maximum), (new.minimum, new.maximum)):
        return True
    # What an enum has lost, or numbers otherwise, is told of the dialect.
    is_other = new.enum is not None and (old.enum is None or old.enum.name != new.enum.name)
    return is_other or (new.is_whole and not old.is_whole)


def _on_the_wire(param: CommandParam) -> Fraction | None:
    ratio = param.scale.ratio
    return param.default if param.default is None or ratio is None else param.default / ratio


def refused(change: Change, sides: Sides) -> Change:
    """A command that is gone: it may have another number now."""
    now = next((each for each in _commands(sides.new) if each.name == change.subject), None)
    effect = f"it is {now.number} now, and what it was is refused" if now else ""
    return replace(change, effect=joined(effect, change.effect))


def mode(change: Change, sides: Sides) -> Change:
    """A mode whose number another one had, or whose name may mean another thing."""
    names = [
        {each.number: each.name for each in side.program.modes} if side.program else {}
        for side in (sides.old, sides.new)
    ]
    number = int(change.subject.removeprefix("mode "))
    old, new = (each.get(number) for each in names)
    if old is None or new is None or old == new:
        return change
    if new in names[0].values():
        return silent(change, f"who asks for {number} to get {old} gets {new}, which had another number")
    if name_likeness(old, new) in (Likeness.SAME, Likeness.NEAR):
        return change
    return doubtful(change, f"whether {new} is another name of {old}")


def renamed(change: Change, old: System, new: System) -> Change:
    """An entry of the dialect under another name: where it is a command and the vehicle goes on to do the same for its
    number, that breaks nobody.
    """
    before, after = ({each.name: (each.number, each.spec.method) for each in _commands(side)} for side in (old, new))
    if change.rule is not ENTRY_RENAMED or change.old not in before or change.new not in after:
        return change
    if before[change.old] != after[change.new]:
        return change
    return replace(change, effect="the vehicle does the same for its number", breaks=(), doubt="")
