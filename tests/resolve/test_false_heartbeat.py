"""A HEARTBEAT that cannot be right beside the program is refused: mode, state, version, flags, and its stream."""

import shutil
from pathlib import Path

import pytest
from edited_project import edited

from codegen.diagnostics import Severity

PROJECTS = Path(__file__).resolve().parents[1] / "projects"
TABLE = "messages/heartbeat.yaml"
MODE, STATUS = "custom_mode: {state: vehicle.mode}", "system_status: {state: vehicle.status}"
VERSION, FLAG = "mavlink_version: {dialect: version}", "MAV_MODE_FLAG_SAFETY_ARMED if vehicle.armed"
STREAM = "stream: PRESENCE\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A vehicle with modes, a failsafe and arming."""
    shutil.copytree(PROJECTS / "radio_rover" / "specs", tmp_path / "specs")
    return tmp_path / "specs"


def told(folder: Path, *changes: tuple[str, str, str]) -> list[tuple[str, str]]:
    _, found = edited(folder, *changes)
    assert all(each.hint for each in found)
    return [(each.rule.id, each.message) for each in found if each.rule.severity is not Severity.INFO]


def test_what_is_right(folder: Path) -> None:
    assert told(folder) == []
    assert told(folder, (TABLE, VERSION, "mavlink_version: {constant: 3}")) == []


CASES = [
    (
        MODE,
        "custom_mode: {constant: 77}",
        "HEARTBEAT.custom_mode is 77, always, and the action crawl changes the mode to 15",
    ),
    (
        STATUS,
        "system_status: {enum: MAV_STATE_BOOT}",
        "HEARTBEAT.system_status is MAV_STATE_BOOT, always, and not MAV_STATE_CRITICAL while a failsafe is up",
    ),
    (
        VERSION,
        "mavlink_version: {constant: 99}",
        "HEARTBEAT.mavlink_version is 99, and the version of MAVLink in the dialect is 3",
    ),
    (
        VERSION,
        "mavlink_version: {state: vehicle.mode}",
        "HEARTBEAT.mavlink_version is what can differ, and the version of MAVLink in the dialect is 3",
    ),
]


@pytest.mark.parametrize(("old", "new", "message"), CASES, ids=range(len(CASES)))
def test_a_field_that_says_something_else(folder: Path, old: str, new: str, message: str) -> None:
    assert ("false-heartbeat", message) in told(folder, (TABLE, old, new))


def test_modes_that_are_declared(folder: Path) -> None:
    """They are named."""
    modes = "modes: {15: {name: CRAWL, doc: Slowly.}, 0: {name: MANUAL, doc: By hand.}}\nactions:\n"
    assert told(folder, ("vehicle.yaml", "actions:\n", modes), (TABLE, MODE, "custom_mode: {constant: 77}"))[0] == (
        "false-heartbeat",
        "HEARTBEAT.custom_mode is 77, always, and the vehicle has the modes 15 (CRAWL), 0 (MANUAL)",
    )


def test_a_state_that_no_failsafe_and_no_mode_changes_may_be_constant(folder: Path) -> None:
    """Without them nothing is left untold."""
    vehicle = folder / "vehicle.yaml"
    vehicle.write_text(vehicle.read_text().partition("failsafes:")[0])
    found = told(folder, (TABLE, STATUS, "system_status: {enum: MAV_STATE_ACTIVE}"))
    assert "false-heartbeat" not in dict(found)


def test_a_flag_that_is_always_set_has_no_condition(folder: Path) -> None:
    name = FLAG.partition(" ")[0]
    message = f"{name} is always set, so that 'if vehicle.armed' decides nothing"
    assert told(folder, (TABLE, f"- {FLAG}", f"- {FLAG}\n      - {name}")) == [("void-condition", message)]


def test_a_heartbeat_that_nobody_is_sent(folder: Path) -> None:
    """Without a stream, in one of 0 Hz, and without a table."""
    text = "HEARTBEAT belongs to no stream, so that it is sent to nobody who does not ask"
    assert dict(told(folder, (TABLE, STREAM, "")))["false-heartbeat"] == text
    (folder / TABLE).unlink()
    assert dict(told(folder))["no-heartbeat"] == "no table of messages/ is for HEARTBEAT"


def test_a_heartbeat_in_a_stream_that_is_switched_off(folder: Path) -> None:
    """The default of its parameter is 0 Hz; a station that asks for it is told nothing until then."""
    rate = "PACK_RATE: {doc: Rate of the pack's messages., unit: Hz, type: uint8, default: "
    found = told(folder, ("parameters.yaml", f"{rate}2", f"{rate}0"), (TABLE, STREAM, "stream: PACK\n"))
    text = "HEARTBEAT is never sent: the stream PACK goes out at 0 Hz (PACK_RATE, by default)"
    assert ("false-heartbeat", text) in found
