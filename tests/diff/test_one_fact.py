"""One edit of the rover is one finding, whatever follows from it: that stands below, and is reached."""

import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen.cli import main

SPECS = Path(__file__).parents[2] / "specs"

Run = Callable[..., tuple[list[str], str]]


@pytest.fixture
def edited(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Run:
    """The lines of the report, and the head line, for edits ``(file, old, new)`` of a copy of the rover's specs."""

    def command(*edits: tuple[str, str, str]) -> tuple[list[str], str]:
        before = Path(shutil.copytree(SPECS, tmp_path / "before" / "specs"))
        specs = Path(shutil.copytree(SPECS, tmp_path / "after" / "specs"))
        for file, old, new in edits:
            path = specs / file
            assert old in path.read_text()
            path.write_text(path.read_text().replace(old, new, 1))
        assert main(["diff", str(before), str(specs)]) == 1
        captured = capsys.readouterr()
        return captured.out.splitlines(), captured.err.splitlines()[-1].partition(": ")[2]

    return command


def findings(lines: list[str]) -> list[str]:
    return [match[1] for line in lines if (match := re.match(r"\S+: (?:error|warning) ([\w-]+: [\w.]+)", line))]


def followers(lines: list[str]) -> set[str]:
    return {match[1] for line in lines if (match := re.search(r"follows: [\w-]+: ([\w., ]+?):", line))}


ONE_FACT = {
    "cells of the pack": (
        ("board.yaml", "cells: 3", "cells: 4"),
        "component-fact-changed: board.battery.cells",
        {"BATTERY_INFO.nominal_voltage", "battery.under_voltage", "BATT_LOW_VOLT, BATT2_LOW_VOLT"},
    ),
    "name of the pack": (
        ("board.yaml", "generic_LiPo-3300", "other_LiPo-5000"),
        "component-fact-changed: board.battery.name",
        {"SMART_BATTERY_INFO.device_name", "BATTERY_INFO.name"},
    ),
    "weight of the pack": (
        ("board.yaml", "weight: 250 g", "weight: 300 g"),
        "component-fact-changed: board.battery.weight",
        {"SMART_BATTERY_INFO.weight", "BATTERY_INFO.weight"},
    ),
    "a divider of both packs": (
        ("parameters.yaml", "default: 3.95", "default: 4.95"),
        "parameter-default-changed: BATT_VOLT_MULT",
        set(),
    ),
    "a sentinel": (
        ("dialects/battery_upstream.xml", 'units="cdegC" invalid="INT16_MAX"', 'units="cdegC" invalid="INT16_MIN"'),
        "field-sentinel-changed: BATTERY_STATUS_V2.temperature",
        {"BATTERY_STATUS_V2.temperature"},
    ),
    "a reference": (
        ("board.yaml", "reference: 3.3 V", "reference: 3.0 V"),
        "adc-channel-changed: adc.battery_voltage",
        {"battery.voltage"},
    ),
}


@pytest.mark.parametrize("name", ONE_FACT)
def test_one_fact_is_one_finding(name: str, edited: Run) -> None:
    edit, finding, expected = ONE_FACT[name]
    lines, head_line = edited(edit)
    assert findings(lines) == [finding]
    assert head_line.startswith("1 change: 1 ")
    assert expected <= followers(lines)


def test_what_is_measured_by_a_default_reaches_messages_criteria_and_tests(edited: Run) -> None:
    """All that a byte goes through, not the table of parameters alone."""
    lines, _ = edited(("parameters.yaml", "default: 3.95", "default: 4.95"))
    hint = next(line for line in lines if line.startswith("  hint: "))
    for reached in ("FR-00068.3", "build_battery_status", "tests/test_frames.py", "tests/test_behaviour.py"):
        assert reached in hint


def test_what_was_changed_by_itself_follows_from_nothing(edited: Run) -> None:
    """A row that somebody edited beside the fact is a finding of its own."""
    lines, head_line = edited(
        ("board.yaml", "weight: 250 g", "weight: 300 g"),
        ("messages/battery_info.yaml", "weight: {board: battery.weight}", "weight: {constant: 310 g}"),
    )
    assert set(findings(lines)) == {"component-fact-changed: board.battery.weight", *findings(lines)}
    assert any(one.endswith(": BATTERY_INFO.weight") for one in findings(lines))
    assert followers(lines) == {"SMART_BATTERY_INFO.weight"}
    assert head_line.startswith("2 changes: ")
