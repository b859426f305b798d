"""Flags that are set under other conditions, or never, and lists of which other values go out, are no harmless news."""

from dataclasses import replace
from pathlib import Path

import pytest

from codegen.answers.each.answer import EachAnswer
from codegen.answers.flags import FlagsAnswer
from codegen.answers.live import LiveAnswer
from codegen.diagnostics import Report
from codegen.diff.change import Change
from codegen.diff.system.population import population_changes
from codegen.model.answers.answer import Answer
from codegen.model.system import PopulatedMessage, System
from codegen.model.vehicle import Quantity, QuantityKind
from codegen.project.systems import read_system

ROOT = Path(__file__).resolve().parents[2]
NEVER, ALWAYS = "never", "always"


@pytest.fixture(scope="module")
def rover() -> System:
    """The shipped specification."""
    found = read_system(str(ROOT / "specs" / "codegen.yaml"), Report())
    assert found is not None
    return found


def changes(system: System, message: PopulatedMessage, old: Answer, new: Answer) -> list[Change]:
    """The changes where one answer of a message is another one."""

    def with_answer(answer: Answer) -> System:
        answers = tuple(answer if each.covers.label == old.covers.label else each for each in message.answers)
        edited = replace(message, answers=answers)
        return replace(system, messages=tuple(edited if one is message else one for one in system.messages))

    return list(population_changes(with_answer(old), with_answer(new)))


def booleans(system: System) -> list[Quantity]:
    """Some that a flag may follow."""
    quantities = (one for component in system.components.values() for one in component.quantities.values())
    return [one for one in quantities if one.kind is QuantityKind.BOOLEAN]


def flags(system: System, covers: object, *said: str) -> FlagsAnswer:
    """Two bits, each never set, always, or while the first or the second boolean, or any of both, is true."""
    mask, conditional = 0, []
    for place, condition in enumerate(said):
        if condition == ALWAYS:
            mask |= 1 << place
        for number in (int(each) for each in condition.split("or") if each.isdigit()):
            conditional.append((f"FLAG_{place}", 1 << place, booleans(system)[number]))
    names = tuple(f"FLAG_{place}" for place, condition in enumerate(said) if condition == ALWAYS)
    return FlagsAnswer(covers, mask, names, tuple(conditional))


OTHER = "whether the flags still tell receivers of the same thing"
STATED = "whether receivers are to be told so at all times"


@pytest.mark.parametrize(
    ("old", "new", "weight", "said"),
    [
        ("0", NEVER, "silent", "0x1 is never set, which receivers take for what is so now"),
        ("0", ALWAYS, "silent", "0x1 is always set, which receivers take for what is so now"),
        ("0", "1", "person", OTHER),
        ("0", "0or1", "person", OTHER),
        ("0or1", "0", "person", OTHER),
        (ALWAYS, NEVER, "person", STATED),
        (NEVER, ALWAYS, "person", STATED),
        (ALWAYS, "0", "harmless", ""),
        (NEVER, "0", "harmless", ""),
    ],
)
def test_a_flag_that_tells_something_else_or_nothing(rover: System, old: str, new: str, weight: str, said: str) -> None:
    """A bit that stands still is taken for what is so; one that begins to tell something harms nobody."""
    message = next(each for each in rover.messages if each.name == "BATTERY_STATUS_V2")
    covers = next(each.covers for each in message.answers if each.covers.label == "status_flags")
    sides = [flags(rover, covers, one, "1") for one in (old, new)]
    (found,) = changes(rover, message, *sides)
    assert (found.rule.id, found.weight) == ("population-flags-changed", weight)
    assert (found.effect or found.doubt) == said


def test_other_values_of_a_list_are_taken_for_those_that_they_were(rover: System) -> None:
    """No receiver can see that cell 1 is where cell 11 was."""
    message, each = next(
        (table, one)
        for table in rover.messages
        for one in table.answers
        if isinstance(one, EachAnswer) and not one.first
    )
    (found,) = changes(rover, message, each, replace(each, first=each.first + 1))
    assert (found.rule.id, found.weight) == ("population-source-changed", "silent")
    assert "the same element holds another value of the list" in found.effect


def test_another_parameter_is_a_question(rover: System) -> None:
    """As another quantity is: nothing says that it is the same number."""
    message, live = next(
        (table, one)
        for table in rover.messages
        for one in table.answers
        if isinstance(one, LiveAnswer) and one.parameters
    )
    other = next(each for each in rover.parameters.values() if each.name != live.source.name)
    (found,) = [each for each in changes(rover, message, live, replace(live, source=other)) if each.doubt]
    assert (found.rule.id, found.weight) == ("population-source-changed", "person")


def test_a_narrower_limit_cuts_off_what_was_told(rover: System) -> None:
    """Beside its sentinel a field steps aside by one: that is none."""
    message, live = next(
        (table, one)
        for table in rover.messages
        for one in table.answers
        if isinstance(one, LiveAnswer) and one.quantities and one.covers.field.type.is_integer
    )
    for less, weight in ((10, "person"), (1, "harmless"), (-10, "harmless")):
        scaling = replace(live.scaling, high=live.scaling.high - less)
        (found,) = changes(rover, message, live, replace(live, scaling=scaling))
        assert (found.rule.id, found.weight) == ("population-limits-changed", weight)
