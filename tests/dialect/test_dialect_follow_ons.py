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


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ('id="50101"', 'id="60012"', "5:5: warning taken-elsewhere: TANK_LEVEL has the id 60012 of STORM32_GIMBAL_"),
        ('"TANK_STATE"', '"HERELINK_TELEM"', "warning taken-elsewhere: HERELINK_TELEM has the id 50003 elsewhere"),
        ('units="d%"', 'units="dx%"', "8:7: error unknown-unit: "),
    ],
)
def test_the_dialect_of_a_project_is_looked_at_as_overlays_are(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any, old: str, new: str, expected: str
) -> None:
    """What a project adds to the dialects of pymavlink is its own, in a file that includes one as well."""
    shutil.copytree(PROJECT / "specs", tmp_path / "specs")
    dialect = tmp_path / "specs" / "dialects" / "own.xml"
    assert old in dialect.read_text()
    dialect.write_text(dialect.read_text().replace(old, new))
    monkeypatch.chdir(tmp_path)
    main(["check"])
    told = capsys.readouterr().out
    assert expected in told, told


def test_a_copy_of_a_dialect_is_none_of_the_project(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any
) -> None:
    """An own copy of common.xml, for another release of it, is not what the project adds."""
    shutil.copytree(PROJECT / "specs", tmp_path / "specs")
    (tmp_path / "specs" / "dialects" / "cubepilot.xml").write_text(
        '<mavlink><messages><message id="50003" name="OTHER"><description>d</description>'
        '<field type="uint8_t" name="f">d</field></message></messages></mavlink>'
    )
    dialect = tmp_path / "specs" / "dialects" / "own.xml"
    dialect.write_text(dialect.read_text().replace("</include>", "</include><include>cubepilot.xml</include>", 1))
    monkeypatch.chdir(tmp_path)
    main(["check"])
    assert "taken-elsewhere" not in capsys.readouterr().out
