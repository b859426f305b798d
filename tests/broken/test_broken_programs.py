"""Broken further programs: each is reported at its place and once, and generated/ stays as it was."""

import shutil
from pathlib import Path

import pytest
from short_documents import shorten_documents
from test_broken_tables import ROOT, Case, check_place, name_of

from codegen.cli import main

OWN = "smart_battery/codegen.yaml"
VEHICLE = "smart_battery/vehicle.yaml"
PARAMETERS = "smart_battery/parameters.yaml"
LIST = "  smart_battery: smart_battery/codegen.yaml"
FAILSAFE = (
    "failsafes:\n  battery:\n    watches: battery.voltage\n    levels: {low: {below: BATT_CAPACITY}}\n"
    "    requirement: FR-00020\n"
)


CASES = [
    Case("bad-program-list", "codegen.yaml", LIST, "  firmware: §smart_battery/codegen.yaml", "folder firmware already"),
    Case("bad-program-list", "codegen.yaml", LIST, "  receiver: §smart_battery/codegen.yaml", "folder receiver already"),
    Case("bad-program-list", "codegen.yaml", LIST, "  common: §smart_battery/codegen.yaml", "folder common already"),
    Case("bad-program-list", "codegen.yaml", LIST, "  aux: §smart_battery/codegen.yaml", "for a device"),
    Case("bad-program-list", "codegen.yaml", LIST, "  Smart-Battery: §smart_battery/codegen.yaml", "no name"),
    Case("bad-program-list", "codegen.yaml", LIST, "  twin: §codegen.yaml", "a folder of its own"),
    Case("bad-program-list", "codegen.yaml", LIST, "  twin: §messages/heartbeat.yaml", "a folder of its own"),
    Case("bad-program-list", "codegen.yaml", LIST, f"{LIST}\n  twin: §smart_battery/codegen.yaml", "folder of the program smart_battery"),
    Case("file-not-found", "codegen.yaml", LIST, "  smart_battery: §smart_batterie/codegen.yaml", exit_code=2),
    Case("bad-program-list", OWN, "base: ..", "base: §../messages", "not the folder of a project"),
    Case("bad-program-list", OWN, "base: ..", "base: §.", "base: .."),
    Case("unknown-key", OWN, "base: ..", "base: ..\n§programs: {more: more/codegen.yaml}"),
    Case("missing-key", OWN, "base: ..\n", "", at="smart_battery/codegen.yaml:3:1"),
    Case("no-table", OWN, "HEARTBEAT, ", "§HEARTBEET, ", "did you mean HEARTBEAT"),
    Case("no-table", "codegen.yaml", "  - dialects/battery_info_upstream.xml\n", "", "which is none of the overlays", at=f"{OWN}:6:78", is_alone=False),
    Case("unknown-enum-entry", OWN, "MAV_COMP_ID_BATTERY", "§MAV_COMP_ID_BATERY", "did you mean MAV_COMP_ID_BATTERY"),
    Case("bad-project", PARAMETERS, "default: 180", "default: §181", "MAV_COMP_ID_BATTERY (180)"),
    Case("bad-project", PARAMETERS, "default: 180\n    min: 1", "default: 180\n    min: 0", "component id from 1", at=f"{VEHICLE}:4:15"),
    Case("unknown-parameter", VEHICLE, "component_id: COMPID_BATT", "component_id: §COMPID", "COMPID_BATT"),
    Case("bad-failsafe", VEHICLE, "services:\n", f"{FAILSAFE}services:\n", "vehicle.yaml has no arming", at=f"{VEHICLE}:34:3", is_alone=False),
    Case("bad-program", VEHICLE, "services:\n", "actions:\n  - §{value: 1, call: stop, doc: Stop.}\nservices:\n", "is what a failsafe does, and there is none"),
    Case("bad-program", VEHICLE, "module: pack", "module: §vehicle", "cannot be the name of a module of yours: the firmware has one"),
    Case("bad-program", VEHICLE, "class: Pack", "class: §Vehicle", "cannot be the name of a class"),
    Case("bad-program", VEHICLE, "measure: 10 Hz", "measure: §0.001 Hz", "every 536 s"),
    Case("bad-program", "vehicle.yaml", "arming:\n  force: 21196\n  requirement: FR-00020.10\n", "", "cannot disarm what cannot be armed", at="vehicle.yaml:92:41", is_alone=False),
    Case("bad-watchdog", "vehicle.yaml", "timeout: 2 s", "timeout: §999 ms", "is less than a main loop may stand still"),
    Case("bad-watchdog", "vehicle.yaml", "timeout: 2 s", "timeout: §8389 ms", "takes 8388 ms at most, not 8389 ms"),
    Case("bad-watchdog", VEHICLE, "timeout: 2 s", "timeout: §20 s", "Raspberry Pi Pico takes 8388 ms at most"),
    Case("wrong-type", "vehicle.yaml", "timeout: 2 s", "timeout: §soon"),
    Case("unit-mismatch", "vehicle.yaml", "timeout: 2 s", "timeout: §2 V"),
    Case("unknown-aspect", "vehicle.yaml", "{hung: FR-00071.5, fed", "{hang: §FR-00071.5, fed", "did you mean hung"),
    Case("unknown-requirement", "vehicle.yaml", "told: FR-00071.7", "told: §FR-00071.17", "no criterion 17"),
    Case("missing-key", "vehicle.yaml", "  timeout: 2 s\n", "", at="vehicle.yaml:14:3"),
    Case("bad-program", "vehicle.yaml", "call: terminate", "call: §stop_motors", "a call of its own"),
    Case("bad-program", "vehicle.yaml", "force: 21196", "force: §0", "0 is what every command to arm has there"),
    Case("bad-program", "vehicle.yaml", "force: 21196", "force: §16777217", "nobody can send 16777217"),
    Case("bad-program", "vehicle.yaml", "force: 21196", "force: §-1000000000001", "nobody can send -1000000000001"),
    Case("program-alone", "codegen.yaml", "project: pico-trail", "project: pico-trail\nbase: §.."),
]  # fmt: skip


@pytest.fixture
def specification(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of the shipped specification without its prose, with the working directory beside it."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    shorten_documents(tmp_path / "specs")
    monkeypatch.chdir(tmp_path)
    return tmp_path / "specs"


def errors(capsys: pytest.CaptureFixture[str]) -> list[str]:
    """The lines of the findings."""
    return [line for line in capsys.readouterr().out.splitlines() if ": error " in line]


@pytest.mark.parametrize("case", CASES, ids=name_of)
def test_is_reported_at_its_place(
    case: Case, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    check_place(case, tmp_path, monkeypatch, capsys)


def test_what_is_wrong_in_a_shared_file_is_reported_once(
    specification: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The table of BATTERY_STATUS belongs to both programs."""
    path = specification / "messages" / "battery_status.yaml"
    path.write_text(path.read_text().replace("{state: battery.temperature,", "{state: battery.temperatur,"))
    assert main(["check"]) == 1
    assert len(errors(capsys)) == 1


def test_a_finding_in_a_base_file_tells_for_which_program(
    specification: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The rover's table is right for the rover; the battery has no such stream."""
    path = specification / "smart_battery" / "codegen.yaml"
    path.write_text(path.read_text().replace("messages: [", "messages: [SYS_STATUS, "))
    assert main(["check"]) == 1
    printed = capsys.readouterr().out
    assert "specs/messages/sys_status.yaml:4:9: error unknown-stream" in printed
    assert "specs/codegen.yaml:17:18: found for the program smart_battery" in printed


def test_a_table_that_the_program_does_not_list_is_told(
    specification: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Nothing would come of it."""
    shutil.copy(specification / "messages" / "sys_status.yaml", specification / "smart_battery" / "messages")
    shutil.copy(specification / "scenarios.yaml", specification / "smart_battery")
    assert main(["check"]) == 0
    printed = capsys.readouterr().out
    assert printed.count("warning unread-file") == 2
    assert "hint: the program does not list its message" in printed


def test_an_empty_list_of_messages_is_an_error(specification: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It would be a program that sends nothing, and meant all tables, as if there were no list."""
    path = specification / "smart_battery" / "codegen.yaml"
    text = path.read_text()
    start = text.index("messages: [")
    path.write_text(text[:start] + "messages: []\n")
    line = text[:start].count("\n") + 1
    assert main(["check"]) == 1
    printed = capsys.readouterr().out
    told = f"specs/smart_battery/codegen.yaml:{line}:11: error no-messages: smart_battery lists no message"
    assert told in printed
    assert "hint: list its messages, or leave out messages: without it all tables are used" in printed


@pytest.mark.parametrize(("default", "warned"), [("2", 0), ("10", 0), ("10.1", 1)])
def test_a_rate_in_tenths_of_a_hertz_is_in_hertz(
    specification: Path, capsys: pytest.CaptureFixture[str], default: str, warned: int
) -> None:
    """The battery is updated at 10 Hz; the parameter of its status counts in steps of 0.1 Hz."""
    path = specification / PARAMETERS
    path.write_text(
        path.read_text().replace(
            "default: 0.5\n    min: 0\n    max: 10\n", f"default: {default}\n    min: 0\n    max: 20\n"
        )
    )
    document = specification / "requirements" / "FR-00074-smart-battery.md"
    document.write_text(document.read_text().replace("BATTERY_STATUS at 0.5 Hz", f"BATTERY_STATUS at {default} Hz"))
    assert main(["check"]) == 0
    found = [line for line in capsys.readouterr().out.splitlines() if " rate-above-update: " in line]
    assert [f"BATTERY_STATUS goes out at {default} Hz" in line for line in found] == [True] * warned


def test_a_program_is_not_built_alone(specification: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Its output lies in that of the project which lists it."""
    assert main(["--project", str(specification / "smart_battery" / "codegen.yaml"), "check"]) == 1
    assert len(errors(capsys)) == 1


def test_a_table_that_cannot_be_read_is_not_missed(specification: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A program that lists its message adds no finding to the one at the table."""
    path = specification / "smart_battery" / "messages" / "battery_info.yaml"
    path.write_text(path.read_text().replace("message:", "massage:", 1))
    assert main(["check"]) == 1
    printed = capsys.readouterr().out
    assert " error unknown-key: " in printed
    assert "no-table" not in printed
