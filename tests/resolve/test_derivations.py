"""Derivations as written are resolved, by one kind for each quantity."""

from fractions import Fraction
from pathlib import Path
from typing import get_args

import pytest

from codegen.derivations import KINDS
from codegen.derivations.follows import Follows
from codegen.derivations.while_known import WhileKnown
from codegen.diagnostics import Report
from codegen.model.spec.derivation import FollowsSpec, WrittenDerivation
from codegen.model.spec.shape import keys_of
from codegen.model.spec.state import QuantitySpec
from codegen.model.system import System
from codegen.project.systems import read_systems
from codegen.source import Place

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "codegen"

KIND_MODULES = [path for path in (PACKAGE / "derivations").glob("*.py") if "(Derivation):" in path.read_text()]
"""The modules that have a kind."""


@pytest.fixture(scope="module")
def system() -> System:
    return read_systems(str(ROOT / "specs" / "codegen.yaml"), Report())[0]


def test_whatever_can_be_written_is_resolved() -> None:
    """A kind that the decoder takes and nothing resolves would end a build with an internal error."""
    assert set(get_args(WrittenDerivation)) == set(KINDS)


@pytest.mark.parametrize("kind", get_args(WrittenDerivation))
def test_a_kind_is_named_by_one_of_its_keys(kind: type) -> None:
    """The key that a finding about the whole of it points at."""
    keys = {key.name: key.group for key in keys_of(QuantitySpec)}
    group = keys[kind.KEY]
    assert group is not None
    assert group.model is kind


def test_no_key_belongs_to_two_kinds() -> None:
    names = [key.name for key in keys_of(QuantitySpec)]
    assert sorted(names) == sorted(set(names))


def test_no_stage_knows_a_kind() -> None:
    """A stage that asks of what kind a derivation is has to be changed for each further one."""
    told = {
        path.relative_to(PACKAGE).as_posix()
        for path in PACKAGE.rglob("*.py")
        for line in path.read_text().splitlines()
        if line.startswith(tuple(f"from codegen.derivations.{kind.stem} import " for kind in KIND_MODULES))
        and not line.endswith((" check_restart", " BAD_FOLLOWING"))  # rules, which stand in the module they are about
    }
    assert not {path for path in told if not path.startswith("derivations/")}


def test_every_kind_is_registered() -> None:
    """A kind that is written and not registered could not be used, and nobody would be told."""
    written = {resolve.__module__.rpartition(".")[2] for resolve in KINDS.values()}
    unwritten = {"set_by_code", "clock", "received"}  # of which state.yaml says nothing
    assert written | unwritten == {path.stem for path in KIND_MODULES}


@pytest.mark.parametrize(
    ("is_below", "stored", "instance", "holds"),
    [
        (False, 13, 0, True),
        (False, 12, 0, False),
        (False, 13, 1, False),
        (False, None, 0, False),
        (True, 11, 0, True),
        (True, 12, 0, False),
        (True, 25, 1, False),
        (True, 24, 1, True),
        (True, None, 0, False),
        (True, 11, 7, True),
    ],
)
def test_what_follows_a_limit_is_known_for_each_state(
    system: System, is_below: bool, stored: int | None, instance: int, holds: bool
) -> None:
    """By hand: at least 13 and 26, or below 12 and 25; unknown is never true; a single instance stands for all."""
    quantity = system.components["battery"].quantities["over_voltage"]
    limits = (12, 25) if is_below else (13, 26)
    follows = Follows("voltage", limits, is_below, FollowsSpec(place=Place("state.yaml")))
    assert follows.value(quantity, {"battery.voltage": stored}, instance) == int(holds)


def test_a_limit_is_told_in_the_unit_of_what_is_followed(system: System) -> None:
    """As codegen diff compares it: one amount has the same words in any steps, one count of other steps has others."""
    quantity = system.components["battery"].quantities["over_voltage"]
    spec = FollowsSpec(place=Place("state.yaml"))
    told = [
        Follows("air", limits, is_below=True, spec=spec, steps=steps, unit="degC").facts(quantity)
        for limits, steps in (((-200,), Fraction(100)), ((-20,), Fraction(10)), ((-200,), Fraction(10)))
    ]
    assert [fact.text for facts in told for fact in facts] == [
        "air is below -2 degC",
        "air is below -2 degC",
        "air is below -20 degC",
    ]


@pytest.mark.parametrize(
    ("stored", "instance", "holds"),
    [(11, 0, True), (12, 0, False), (4, 0, True), (3, 0, False), (None, 0, False), (4, 1, False), (8, 1, True)],
)
def test_what_lies_between_two_limits(system: System, stored: int | None, instance: int, *, holds: bool) -> None:
    """By hand: from 4 to below 12, or from 8 to below 25."""
    quantity = system.components["battery"].quantities["over_voltage"]
    follows = Follows("voltage", (12, 25), is_below=True, spec=FollowsSpec(place=Place("state.yaml")), floors=(4, 8))
    assert follows.value(quantity, {"battery.voltage": stored}, instance) == int(holds)
    assert set(follows.deciding(1, 7).values()) == {25, 24, 8, 7, None}


def test_what_is_true_while_another_is_known(system: System) -> None:
    quantity = system.components["battery"].quantities["healthy"]
    derivation = quantity.derivation
    assert derivation == WhileKnown("voltage")
    assert [derivation.value(quantity, {"battery.voltage": stored}, 0) for stored in (0, 12000, None)] == [1, 1, 0]


def test_the_values_that_decide_bring_about_what_they_are_called(system: System) -> None:
    """The names of cases: a value called set makes the boolean true, all others make it false."""
    for component in system.components.values():
        for quantity in component.quantities.values():
            for instance in range(component.instances) if quantity.kind.value == "boolean" else ():
                for name, stored in quantity.derivation.deciding(instance, 7).items():
                    value = quantity.derivation.value(quantity, {quantity.decided_by: stored}, instance)
                    assert bool(value) == name.startswith("set"), (quantity.path, instance, name)
