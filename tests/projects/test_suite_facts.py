"""Facts that the generated suite compares with: they are those of the specification, and made by no firmware."""

from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.project.systems import read_system
from codegen.targets.suite.facts.components import component_facts

ROVER = Path(__file__).resolve().parents[2] / "specs" / "codegen.yaml"


@pytest.fixture(scope="module")
def rover() -> System:
    system = read_system(str(ROVER), Report())
    assert system is not None
    return system


def test_another_pack_begins_with_sums_of_nothing_and_the_rest_as_it_starts(rover: System) -> None:
    battery = next(facts for facts in component_facts(rover) if facts.name == "battery")
    assert battery.returns is not None
    anew = dict(battery.returns.restarting)
    assert {name for name, value in anew.items() if value == "0"} == {"consumed_mah", "energy_hj"}
    assert (anew["counted_from_full"], anew["current_ma"]) == ("False", "None")
