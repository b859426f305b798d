"""Modules of the user go to the board, and missing ones are found."""

from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

from codegen.deploy.contents import missing_modules, module_names, own_modules
from codegen.deploy.findings import NO_MODULE
from codegen.diagnostics import Report
from codegen.source import Place


def system_with(*modules: str) -> Any:
    spec = SimpleNamespace(at=lambda _key: Place("/specs/board.yaml", 7, 3))
    sources = {
        name: SimpleNamespace(imported=name, own_modules={}, polling=SimpleNamespace(spec=spec)) for name in modules
    }
    return cast(Any, SimpleNamespace(program=SimpleNamespace(module="app"), sources=sources))


def test_modules_are_followed_through_what_they_import(tmp_path: Path) -> None:
    """Packages go whole; a module that is not imported, and one that MicroPython has, do not."""
    (tmp_path / "app.py").write_text("import machine, motors\n")
    (tmp_path / "motors.py").write_text("def f():\n    from parts.wheel import Wheel\n")
    (tmp_path / "parts/inner").mkdir(parents=True)
    for name in ("parts/__init__.py", "parts/wheel.py", "parts/inner/deep.py", "unused.py", "sonar.py"):
        (tmp_path / name).write_text("")
    found = own_modules(system_with("sonar"), str(tmp_path), ["main.py", "vehicle.py"], Report())
    assert set(found) == {
        *("app.py", "motors.py", "sonar.py"),
        *("parts/__init__.py", "parts/wheel.py", "parts/inner/deep.py"),
    }


def test_a_source_whose_module_is_nowhere() -> None:
    """A missing module is the finding no-module; one that mip has installed is there."""
    system = system_with("sonar", "lidar", "radar")
    missing = missing_modules(system, module_names(["sonar.mpy", "lidar/__init__.mpy", "main.py"]))
    assert missing == [(Place("/specs/board.yaml", 7, 3), "radar")]
    assert NO_MODULE.id == "no-module"
