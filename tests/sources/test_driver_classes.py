"""Classes of drivers are looked for in the source of their module, which is never imported."""

import shutil
from pathlib import Path
from typing import Any

import pytest

from codegen.cli import main
from codegen.load.defined_names import defined_names

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "minimal"
SONAR = "sonar: {driver: user, class: sonar.Sonar, unit: m, stored: mm, min: 0, max: 100}"
LASER = "laser: {driver: laser}"
DRIVER = "doc: A laser.\nclass: Laser\noutputs: {distance: {unit: m, stored: mm, min: 0, max: 100}}\n"
CLASS = """\
class Laser:
    def __init__(self):
        self.values = [0]

    def begin(self):
        pass

    def poll(self, now_ms):
        return True
"""
NEVER = "raise SystemExit('this was run')\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = Path(shutil.copytree(PROJECT, tmp_path / "project"))
    (folder / "specs" / "drivers").mkdir()
    (folder / "specs" / "drivers" / "laser.yaml").write_text(DRIVER)
    monkeypatch.chdir(folder)
    return folder


def check(folder: Path, source: str, capsys: Any) -> tuple[int, str]:
    (folder / "specs" / "board.yaml").write_text(f"sources:\n  {source}\n")
    return main(["check"]), capsys.readouterr().out


@pytest.mark.parametrize(
    "text",
    [
        "class Sonar:\n    def read(self): pass\n",
        "from maker import Sonar\n",
        "import maker as Sonar\n",
        "Sonar = __import__('maker').Sonar\n",
        "try:\n    from maker import Sonar\nexcept ImportError:\n    Sonar = None\n",
        "def Sonar():\n    return 5\n",
        "from maker import *\n",
        "globals()['Sonar'] = 5\n",
        "def __getattr__(name):\n    return 5\n",
        "def make():\n    global Sonar\n    Sonar = 5\nmake()\n",
        "\ufeffclass Sonar:\n    def read(self): pass\n",
    ],
)
def test_a_module_that_has_or_can_have_the_class_is_right(folder: Path, text: str, capsys: Any) -> None:
    (folder / "sonar.py").write_text(text + NEVER)
    code, told = check(folder, SONAR, capsys)
    assert (code, ": error " in told) == (0, False), told


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("class Sonr:\n    pass\n", "did you mean Sonr?"),
        ("class Echo:\n    class Sonar:\n        pass\n", "write class Sonar in sonar.py; it has Echo"),
        ("def read():\n    Sonar = 5\n", "write class Sonar in sonar.py"),
        ("'''class Sonar'''\n# class Sonar:\n", "write class Sonar in sonar.py"),
        ("", "write class Sonar in sonar.py"),
    ],
)
def test_a_class_that_the_module_does_not_have_is_an_error_with_a_hint(
    folder: Path, text: str, hint: str, capsys: Any
) -> None:
    (folder / "sonar.py").write_text(NEVER + text)
    code, told = check(folder, SONAR, capsys)
    assert code == 1, told
    assert "specs/board.yaml:2:32: error no-driver-class: sonar.py has no class Sonar\n" in told
    assert f"hint: {hint}\n" in told
    assert "sonar.py:1:1" in told, "where the module is"
    assert told.count(": error ") == 1, told


def test_a_module_that_is_not_in_the_project_may_lie_on_the_board(folder: Path, capsys: Any) -> None:
    assert check(folder, SONAR, capsys)[0] == 0


def test_a_class_of_a_package(folder: Path, capsys: Any) -> None:
    (folder / "parts").mkdir()
    (folder / "parts" / "__init__.py").write_text("from parts.sonar import Sonar\n")
    (folder / "parts" / "sonar.py").write_text("class Echo:\n    pass\n")
    assert check(folder, SONAR.replace("sonar.Sonar", "parts.Sonar"), capsys)[0] == 0
    code, told = check(folder, SONAR.replace("sonar.Sonar", "parts.sonar.Sonar"), capsys)
    assert (code, "sonar.py has no class Sonar" in told) == (1, True), told


def test_a_module_that_is_no_python_is_an_error_with_its_line(folder: Path, capsys: Any) -> None:
    (folder / "sonar.py").write_text("class Sonar:\n    def read(self)\n        return 5\n")
    code, told = check(folder, SONAR, capsys)
    assert code == 1
    assert "sonar.py:2:1: error broken-driver-module: sonar.py is no Python: expected ':'" in told
    assert told.count(": error ") == 1, told


def test_the_class_of_a_driver_of_the_project(folder: Path, capsys: Any) -> None:
    module = folder / "specs" / "drivers" / "laser.py"
    module.write_text(CLASS)
    assert check(folder, LASER, capsys)[0] == 0
    module.write_text(NEVER + "class Lasr:\n    pass\n")
    code, told = check(folder, LASER, capsys)
    assert code == 1
    assert "specs/drivers/laser.yaml:2:8: error no-driver-class: laser.py has no class Laser\n" in told
    assert "hint: did you mean Lasr?" in told
    assert told.count(": error ") == 1, told


def test_a_module_of_the_user_is_no_input_of_what_is_generated(folder: Path) -> None:
    """Its text can change without a build: no header of a generated file has it in its hash."""
    (folder / "specs" / "board.yaml").write_text(f"sources:\n  {SONAR}\n")
    (folder / "sonar.py").write_text("class Sonar:\n    def read(self):\n        return 4\n")
    assert main(["build"]) == 0
    (folder / "sonar.py").write_text("class Sonar:\n    def read(self):\n        return 5\n")
    assert main(["build", "--check"]) == 0


def test_names_of_all_kinds_of_statements() -> None:
    text = (
        "with open('x') as a:\n    for b, (c, *d) in a:\n        e: int = 1\nif (f := 1): pass\nasync def g(): h = 1\n"
    )
    assert defined_names(text).names == {"a", "b", "c", "d", "e", "f", "g"}


@pytest.mark.parametrize(("module", "owner"), [("receiver", "the firmware"), ("sim", "the simulation")])
def test_a_module_whose_name_is_taken_is_an_error(folder: Path, module: str, owner: str, capsys: Any) -> None:
    """On the board only one of two modules of a name can be there, and the program would miss the other one."""
    code, told = check(folder, SONAR.replace("sonar.Sonar", f"{module}.Sonar"), capsys)
    assert code == 1, told
    assert f"error bad-source-driver: {owner} has a module {module} already" in told
    assert f"rename yours: class: my_{module}.Sonar" in told


def test_a_module_of_micropython_may_have_the_class(folder: Path, capsys: Any) -> None:
    """It comes with drivers of its own."""
    code, told = check(folder, SONAR.replace("sonar.Sonar", "neopixel.Sonar"), capsys)
    assert code == 0, told


def test_a_driver_is_not_called_as_a_module_of_the_firmware(folder: Path, capsys: Any) -> None:
    """Its module would take the place of the other one."""
    drivers = folder / "specs" / "drivers"
    (drivers / "words.yaml").write_text(DRIVER)
    (drivers / "words.py").write_text(CLASS)
    code, told = check(folder, "laser: {driver: words}", capsys)
    assert code == 1, told
    assert "specs/drivers/words.yaml:1:1: error bad-source-driver: words cannot be the name of a driver" in told
