"""Sensors cost little where they have nothing to do, and lines of a receiver of satellites where they have."""

import shutil
from collections.abc import Mapping
from pathlib import Path

import cost
import pytest
from in_process import build

PROJECTS = Path(__file__).resolve().parents[1] / "projects"
KINDS = 7
"""The sensors of that project: one of each kind, a second one of the user's code, and a driver of its own."""
MOST_CYCLES = 300
MOST_LINE_US = 300


@pytest.fixture(scope="module")
def counted(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, float]:
    """The instructions of each workload, without those of the loop around it."""
    if shutil.which("valgrind") and cost.problem():
        pytest.skip(cost.problem())
    folder = tmp_path_factory.mktemp("cost")
    shutil.copytree(PROJECTS / "sensors" / "specs", folder / "specs")
    build(folder)
    modules = cost.compiled([folder / "generated" / name for name in ("firmware", "mocks")], folder / "compiled")
    costs, said = cost.instructions("cost_sources.py", 0, [modules], folder)
    assert {name: said[name] for name in ("gga", "rmc", "gsa", "vtg", "gsv")} == dict.fromkeys(
        ("gga", "rmc", "gsa", "vtg", "gsv"), 1
    )
    return {name: value - costs["nothing"] for name, value in costs.items()}


def test_a_sensor_that_is_not_due_takes_300_cycles_at_most(counted: Mapping[str, float]) -> None:
    """Of each look for what is due, whatever its kind is; by the upper bound of the prediction."""
    _, most = cost.cycles((counted["every_sensor"] - counted["no_sensor"]) / KINDS)
    assert 0 < most <= MOST_CYCLES


def test_a_receiver_that_says_nothing_takes_300_cycles_at_most(counted: Mapping[str, float]) -> None:
    """A turn without data asks a function in C, and that is all."""
    likely, _ = cost.cycles(counted["idle"] - counted["native"])
    assert 0 < likely <= MOST_CYCLES


@pytest.mark.parametrize("line", ["gga", "rmc", "gsa", "vtg", "gsv"])
def test_reading_a_line_takes_300_us_at_most(counted: Mapping[str, float], line: str) -> None:
    """From its bytes to whole numbers, by the upper bound of the prediction."""
    _, most = cost.cycles(counted[line])
    assert 10 < most / cost.MEGAHERTZ <= MOST_LINE_US


def test_a_whole_turn_with_a_line_takes_500_us_at_most(counted: Mapping[str, float]) -> None:
    """The values read go into the state, and the turn is timed."""
    likely, _ = cost.cycles(counted["turn"])
    assert counted["gga"] < counted["turn"]
    assert likely / cost.MEGAHERTZ <= 500
