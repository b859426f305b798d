"""Changes of commands and modes: each attribute of them is told, and what breaks whom."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from test_every_attribute_of_a_system import mutants, siblings_of

from codegen.diagnostics import Report
from codegen.diff.system.system import compare_systems
from codegen.model.system import System
from codegen.project.systems import read_systems

SPECS = Path(__file__).resolve().parents[1] / "projects" / "commanded" / "specs"
FOUND_BY = {"Command.name", "Mode.number", "CommandParam.number"}


@pytest.fixture(scope="module")
def boat() -> System:
    return read_systems(str(SPECS / "codegen.yaml"), Report())[0]


def test_each_attribute_of_a_command_and_of_a_mode_is_told(boat: System) -> None:
    """One that is missed would be a change that nobody reviews."""
    program = boat.program
    assert program is not None
    tried = set()
    siblings = siblings_of(boat)
    for kind in ("commands", "modes"):
        for place, record in enumerate(getattr(program, kind)):
            for name, changed in mutants(record, siblings, set()):
                each = (*getattr(program, kind)[:place], changed, *getattr(program, kind)[place + 1 :])
                other = replace(boat, program=replace(program, **{kind: each}))
                tried.add(name)
                assert compare_systems((boat,), (other,)).changes, name
    assert tried >= FOUND_BY | {
        "Command.params",
        "AffineMap.factor",
        "CommandParam.default",
        "Mode.base",
        "Mode.name",
    }


EDITS = [
    ("commands.yaml", "min: 0, max: 60", "min: 0, max: 30", {"command-range-changed"}),
    ("commands.yaml", "max: 100, default: 50", "max: 100, default: null", {"command-range-changed", "command-unit-changed"}),
    ("commands.yaml", "unchanged: [-1], ", "", {"command-unit-changed"}),
    ("commands.yaml", "unchanged: [-1, -2, NaN]", "unchanged: [-1, NaN]", {"command-unit-changed"}),
    ("commands.yaml", "max: 100, default: 50", "max: 100", {"command-range-changed"}),
    ("commands.yaml", "name: duration, unit: s", "name: duration, unit: min", {"command-unit-changed", "command-range-changed", "command-changed"}),
    ("commands.yaml", "unit: km/h, default: 3.6, max: 36", "unit: m/s, default: 1, max: 10", {"command-changed"}),
    ("commands.yaml", "unit: km/h, default: 3.6, max: 36", "unit: m/s, default: 1, max: 36", {"command-range-changed", "command-changed"}),
    ("commands.yaml", "unit: km/h, default: 3.6, max: 36", "unit: km/h, default: 3.60, max: 36.0", set()),
    ("commands.yaml", "allowed: armed", "allowed: always", {"command-changed"}),
    ("commands.yaml", "allowed: armed", "allowed: disarmed", {"command-changed!"}),
    ("commands.yaml", "    from: ground_station\n", "", {"command-changed"}),
    ("commands.yaml", "    method: pump\n", "    method: pump\n    from: ground_station\n", {"command-changed!"}),
    ("commands.yaml", "method: sound_horn", "method: honk", {"command-changed"}),
    ("commands.yaml", "MAV_CMD_USER_3", "MAV_CMD_WAYPOINT_USER_1", {"command-removed", "command-added"}),
    ("vehicle.yaml", "  11: {name: RTL", "  12: {name: RTL", {"mode-removed", "mode-added"}),
    ("vehicle.yaml", "name: RTL", "name: RETURN", {"mode-changed"}),
    ("vehicle.yaml", "It comes back., base: [guided]", "It comes back.", {"mode-changed"}),
]  # fmt: skip
BREAKING = {"command-removed", "command-unit-changed", "mode-removed"}


@pytest.mark.parametrize(("file", "old", "new", "rules"), EDITS)
def test_an_edit_has_its_weight(boat: System, tmp_path: Path, file: str, old: str, new: str, rules: set[str]) -> None:
    """A command that a ground station can no longer give, or not then, breaks it; another limit does not."""
    shutil.copytree(SPECS, tmp_path / "specs")
    path = tmp_path / "specs" / file
    assert old in path.read_text()
    path.write_text(path.read_text().replace(old, new, 1))
    (changed,) = read_systems(str(tmp_path / "specs" / "codegen.yaml"), Report())
    changes = compare_systems((boat,), (changed,)).changes
    assert {change.rule.id for change in changes} == {rule.removesuffix("!") for rule in rules}
    breaking = BREAKING | {rule.removesuffix("!") for rule in rules if rule.endswith("!")}
    assert all(bool(change.breaks) is (change.rule.id in breaking) for change in changes)
