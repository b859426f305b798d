"""The user's code is looked at before the board imports it: unfit-code."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.decode.driver_modules import driver_module
from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.project.systems import read_systems
from codegen.rules.unfit_code import check

BOAT = Path(__file__).resolve().parents[2] / "examples" / "boat"


@pytest.fixture(scope="module")
def boat() -> System:
    (system,) = read_systems(str(BOAT / "specs" / "codegen.yaml"), Report())
    return system


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("from vehicle import Vehicle\nclass {name}(Vehicle):\n    pass\n", []),
        ("from elsewhere import {name}\n", []),
        ("from elsewhere import *\n", []),
        ("from vehicle import Vehicle\nclass Base(Vehicle):\n    pass\nclass {name}(Base):\n    pass\n", []),
        ("class Other:\n    pass\n", ["app.py has no class {name}"]),
        ("", ["app.py has no class {name}"]),
        ("class {name}:\n    pass\n", ["{name} is not derived from Vehicle"]),
        ("class Base:\n    pass\n\nclass {name}(Base):\n    pass\n", ["{name} is not derived from Vehicle"]),
        ("class {name}(Vehicle)\n    pass\n", ["app.py is no Python: expected ':'"]),
    ],
)
def test_a_class_that_the_board_could_not_take_is_an_error(boat: System, text: str, expected: list[str]) -> None:
    """Where the source does not show the class, nothing is said of it."""
    assert boat.program is not None
    name = boat.program.class_name
    module = driver_module("/project/app.py", text.format(name=name))
    spec = replace(boat.spec, user_modules={boat.program.module: module})
    assert [each.message for each in check(replace(boat, spec=spec))] == [each.format(name=name) for each in expected]


@pytest.fixture
def copied(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    shutil.copytree(BOAT, tmp_path / "boat", ignore=shutil.ignore_patterns("generated"))
    monkeypatch.chdir(tmp_path / "boat")
    return tmp_path / "boat"


def test_the_module_in_the_folder_of_the_project_is_the_one(copied: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """As ``code`` in vehicle.yaml names it; one that is not there may lie on the board."""
    (system,) = read_systems("specs/codegen.yaml", Report())
    assert system.program is not None
    module = copied / f"{system.program.module}.py"
    module.write_text(module.read_text() + "def (\n")
    assert main(["check"]) == 1
    line = module.read_text().count("\n")
    assert f"{module.name}:{line}:1: error unfit-code: {module.name} is no Python: " in capsys.readouterr().out
    module.write_text(f"<<<<<<< HEAD\n{BOAT}\n=======\n>>>>>>> other\n")
    assert main(["check"]) == 1
    assert f"{module.name}:1:1: error unfit-code: " in capsys.readouterr().out, "a conflict of a merge"
    module.unlink()
    assert main(["check"]) == 0
