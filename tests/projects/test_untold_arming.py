"""Vehicles that can be armed and whose HEARTBEAT does not tell it: a warning says so, and the check is green."""

import shutil
from pathlib import Path

import pytest
from generated_suite import suite_is_green
from in_process import codegen

GUARDED = Path(__file__).parent / "guarded" / "specs"
TOLD = "base_mode: {flags: [MAV_MODE_FLAG_SAFETY_ARMED if vehicle.armed]}"
WARNING = "specs/messages/heartbeat.yaml:1:1: warning untold-arming: HEARTBEAT tells that the vehicle is "


def built(folder: Path, base_mode: str) -> str:
    """Build the project with another base_mode; return what the command said."""
    shutil.copytree(GUARDED, folder / "specs")
    table = folder / "specs" / "messages" / "heartbeat.yaml"
    assert TOLD in table.read_text()
    table.write_text(table.read_text().replace(TOLD, f"base_mode: {base_mode}"))
    done = codegen(folder, "build")
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.parametrize(
    ("base_mode", "told"),
    [
        ("{constant: 81}", "disarmed"),
        ("{flags: [MAV_MODE_FLAG_CUSTOM_MODE_ENABLED if vehicle.armed]}", "disarmed"),
        ("{flags: [MAV_MODE_FLAG_SAFETY_ARMED]}", "armed"),
    ],
)
def test_what_is_told_in_every_state_is_warned_of_and_no_fault_of_the_firmware(
    tmp_path: Path, base_mode: str, told: str
) -> None:
    assert f"{WARNING}{told}, always\n" in built(tmp_path, base_mode)
    suite_is_green(tmp_path / "generated" / "tests", "test_program.py", only="arming_by_command")


@pytest.mark.parametrize(
    ("base_mode", "expected"),
    [
        ("{flags: [MAV_MODE_FLAG_SAFETY_ARMED if vehicle.armed]}", "(False, True)"),
        ("{flags: [MAV_MODE_FLAG_SAFETY_ARMED if vehicle.ready]}", "None"),
        ("{state: vehicle.mode}", "None"),
    ],
)
def test_what_tells_it_or_follows_another_quantity_is_not_warned_of(
    tmp_path: Path, base_mode: str, expected: str
) -> None:
    assert "untold-arming" not in built(tmp_path, base_mode)
    facts = (tmp_path / "generated" / "tests" / "program_facts.py").read_text()
    assert f"TOLD_ARMED = {expected} " in facts
    suite_is_green(tmp_path / "generated" / "tests", "test_program.py", only="arming_by_command")
