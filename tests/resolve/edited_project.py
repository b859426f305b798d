"""Reads a project after a change of its files."""

from pathlib import Path

from codegen.diagnostics import Diagnostic, Report
from codegen.model.system import System
from codegen.project.systems import read_system


def system_of(folder: Path, report: Report) -> System:
    """The system of a specification that can be read."""
    system = read_system(str(folder / "codegen.yaml"), report)
    assert system is not None
    return system


def edited(folder: Path, *changes: tuple[str, str, str]) -> tuple[System, list[Diagnostic]]:
    """The project with changes, each (file, old, new) of a place that there is once, and what is reported."""
    for file, old, new in changes:
        path = folder / file
        assert path.read_text().count(old) == 1, old
        path.write_text(path.read_text().replace(old, new))
    report = Report()
    return system_of(folder, report), list(report)
