"""One message decides where several carry a quantity."""

from dataclasses import replace
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.model.system import Generations, System
from codegen.project.systems import read_system
from codegen.targets.receiver.view import receiver_view

ROOT = Path(__file__).resolve().parents[2]


def order(system: System, generations: tuple[Generations, ...]) -> list[str]:
    """The messages that carry the voltage, the one that decides first."""
    system = replace(system, generations=generations)
    assert system.receiver is not None
    kinds = dict(receiver_view(system, system.receiver).carriers)["voltage"]
    return [system.receiver.messages[int(kind)].name for kind in kinds.strip("()").split(",") if kind]


@pytest.mark.requirement("FR-00075.2")
def test_the_declared_generation_goes_before_the_higher_id() -> None:
    """The new one of streams.yaml, though its id were the lower one; without a declaration the higher id."""
    system = read_system(str(ROOT / "specs" / "codegen.yaml"), Report())
    assert system is not None
    old, new = "BATTERY_STATUS", "BATTERY_STATUS_V2"
    assert order(system, system.generations) == [new, old]
    assert order(system, ()) == [new, old]
    swapped = tuple(replace(each, old=each.new, new=each.old) for each in system.generations)
    assert order(system, swapped) == [old, new]
