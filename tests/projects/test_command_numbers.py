"""Numbers of commands are taken as they were sent: limits of whole ones, and floats on a board, which have 24 bits."""

import importlib.util
import shutil
import struct
import sys
from fractions import Fraction
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from codegen.diagnostics import Report
from codegen.project.systems import read_system
from codegen.targets.firmware.program.commands import command_table_view

HERE = Path(__file__).resolve().parent
MODULE = HERE.parents[1] / "templates" / "firmware" / "program" / "own_commands.py"


class Single(float):
    """A float of a board: whatever comes of it is rounded to 32 bits, and so is what it is compared with."""

    def __new__(cls, value: float) -> "Single":
        return super().__new__(cls, struct.unpack("<f", struct.pack("<f", value))[0])

    __hash__ = float.__hash__

    def __eq__(self, other: object) -> bool:
        return float(self) == float(Single(other)) if isinstance(other, int | float) else False

    def __sub__(self, other: float) -> "Single":
        return Single(float(self) - float(Single(other)))

    def __mul__(self, other: float) -> "Single":
        return Single(float(self) * float(Single(other)))

    def __truediv__(self, other: float) -> "Single":
        return Single(float(self) / float(Single(other)))


@pytest.fixture
def own_commands(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The module of the firmware, without what it needs of others."""
    for name, content in (
        ("messages", {}),
        ("command_table", {"COMMANDS": {}}),
        ("guard", {"Guard": None}),
        ("heard", {"is_heard": None}),
        ("micropython", {"const": int}),
    ):
        monkeypatch.setitem(sys.modules, name, SimpleNamespace(**content))  # type: ignore[arg-type]
    spec = importlib.util.spec_from_file_location("own_commands_alone", MODULE)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def rounded(module: ModuleType, multiplier: int, divisor: int = 1) -> tuple[Any, ...]:
    return (5, -3.4e38, 3.4e38, multiplier, divisor, module._ROUNDED, None, None, "no")


@pytest.mark.parametrize("value", [-80.06306457519531, 47.3977432, 179.9999, 1e-6, -0.3, 0.0, 16777215.0, 1e30])
def test_a_board_loses_nothing_of_a_position(own_commands: ModuleType, value: float) -> None:
    """The whole number is that of the float that was sent, not of a product of 24 bits."""
    sent = Single(value)
    for multiplier, divisor in ((10**7, 1), (1000, 1), (5, 18)):
        got = own_commands._argument(rounded(own_commands, multiplier, divisor), sent, False)
        assert got == round(Fraction(float(sent)) * multiplier / divisor)
        assert type(got) is int


def test_halves_go_away_from_zero_as_those_of_messages_do(own_commands: ModuleType) -> None:
    param = rounded(own_commands, 1000)
    assert own_commands._argument(param, 1551.8125, False) == 1551813
    assert own_commands._argument(param, -1551.8125, False) == -1551813


def test_only_a_whole_number_of_command_int_stands_for_nan(own_commands: ModuleType) -> None:
    """On a board the float 2147483648 equals 2147483647."""
    param = (1, 0, 3e9, 1, 1, own_commands._WHOLE, None, 7, "no")
    assert own_commands._argument(param, Single(2147483648.0), True) == 2147483648
    assert own_commands._argument(param, 0x7FFFFFFF, True) == 7


@pytest.mark.parametrize(
    ("written", "row"),
    [
        ("unit: deg, min: -179.9999, max: 13.9876", "(6, -1799999000, 139876000, "),
        ("unit: degE7, min: -1799999001, max: 139876001", "(6, -1799999001, 139876001, "),
        ("unit: deg, unchanged: [99.9]", "(6, -1800000000, 1800000000, 1, 10000000, _REAL, None, None, "),
        ("unit: rad, min: -0.1, max: 3.1", "(6, -57295779, 1776169164, "),
    ],
)
def test_limits_of_whole_coordinates_are_not_those_of_floats(written: str, row: str, tmp_path: Path) -> None:
    """COMMAND_INT carries 1e-7 degrees: the limit itself is accepted, and the step beyond it is not."""
    shutil.copytree(HERE / "commanded" / "specs", tmp_path / "specs")
    commands = tmp_path / "specs" / "commands.yaml"
    text = commands.read_text(encoding="utf-8")
    commands.write_text(text.replace("6: {name: lon, unit: deg}", f"6: {{name: lon, {written}}}"), encoding="utf-8")
    system = read_system(str(tmp_path / "specs" / "codegen.yaml"), Report())
    assert system is not None
    assert system.program is not None
    (params,) = [each.int_params for each in command_table_view(system.program).commands if each.method == "go_to"]
    (found,) = [line for line in (" ".join(each.split()).replace("( ", "(") for each in params) if line.startswith(row)]
    assert "unchanged" not in written or "(999000000,)" in found  # not of the float beside 99.9
