"""One mistake in an XML file is one finding, at its place, also where a table uses the field."""

import shutil
from pathlib import Path
from typing import Any

import pytest

from codegen.cli import main

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "own_dialect"


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ('units="d%"', 'units="d%" minValue="9" maxValue="2"', "8:7: error field-number: level: minValue 9 is above"),
        ('units="d%"', 'units="d%" multiplier="0"', "8:7: error field-number: level: multiplier is '0'"),
        ('units="d%"', 'units="d%" multiplier="360/0"', "8:7: error field-number: level: multiplier is '360/0'"),
        ('"TANK_CONTENT"', '"TANK_CONTNT"', "9:7: error field-unknown-enum: TANK_LEVEL.content: there is no enum"),
    ],
)
def test_a_mistake_in_a_field_has_one_finding(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any, old: str, new: str, expected: str
) -> None:
    shutil.copytree(PROJECT / "specs", tmp_path / "specs")
    dialect = tmp_path / "specs" / "dialects" / "own.xml"
    assert old in dialect.read_text()
    dialect.write_text(dialect.read_text().replace(old, new))
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 1
    told = capsys.readouterr().out
    assert f"specs/dialects/own.xml:{expected}" in told, told
    assert told.count(": error ") == 1, told
    assert "  hint: " in told, told
