"""Changes of a sensor are told to reviewers."""

import shutil
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.diff.system.system import compare_systems
from codegen.model.system import System
from codegen.project.systems import read_systems

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "sensors"

SOLAR = "i2c: 0, sda: 4, scl: 5, address: 0x41, shunt: 100 mOhm, average: "
EDITS = [
    ("baud rate", "uart: 1,", "uart: 1, baud: 38400,"),
    ("pin", "rx: 9", "rx: 21"),
    ("a fix", "uart: 1,", "uart: 1, fixes: 5 Hz,"),
    ("silence", "uart: 1,", "uart: 1, silence: 9 s,"),
    ("address", "address: 0x41", "address: 0x42"),
    ("shunt", "100 mOhm", "50 mOhm"),
    ("average", "average: 8", "average: 16"),
    ("frequency", "sda: 4, scl: 5", "sda: 4, scl: 5, frequency: 100 kHz"),
    ("rate", "rate: 20 Hz", "rate: 25 Hz"),
    ("limit", "max: 40, rate: 10 Hz, limit: 2 ms", "max: 40, rate: 10 Hz, limit: 3 ms"),
    ("retry", "max: 40,", "max: 40, retry: 5 s,"),
    ("class", "imu.Imu", "imu.Other"),
    ("range", "max: 40", "max: 30"),
    ("step", "stored: mm", "stored: cm"),
    ("pull", "pull: up", "pull: down"),
    ("gate", "pull: up", "pull: up, gate: 5 s"),
    ("key of an own driver", "offset: 2.5", "offset: 3.5"),
    ("driver", f"driver: ina219, {SOLAR}8", f"driver: ina226, {SOLAR}16"),
]


def read(folder: Path) -> list[System]:
    report = Report()
    systems = read_systems(str(folder / "specs" / "codegen.yaml"), report)
    assert not report.has_errors, list(report)
    return list(systems)


@pytest.fixture(scope="module")
def before() -> list[System]:
    return read(PROJECT)


@pytest.mark.parametrize(("old", "new"), [edit[1:] for edit in EDITS], ids=[edit[0] for edit in EDITS])
def test_is_told(before: list[System], old: str, new: str, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(PROJECT, tmp_path / "project"))
    board = folder / "specs" / "board.yaml"
    text = board.read_text()
    assert text.count(old) >= 1
    board.write_text(text.replace(old, new))
    told = {change.rule.id for change in compare_systems(before, read(folder)).changes}
    assert "sensor-changed" in told


def test_nothing_is_told_of_the_same(before: list[System]) -> None:
    assert not compare_systems(before, read(PROJECT)).changes
