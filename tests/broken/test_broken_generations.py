"""Broken generations and announcements: each is reported at its line and column, and generated/ stays as it was."""

import shutil

import pytest
from test_broken_tables import ROOT, Case, check_place, name_of

from codegen.cli import main

INFO, VERSION = "messages/smart_battery_info.yaml", "messages/autopilot_version.yaml"
OLD = "old: [BATTERY_STATUS, SMART_BATTERY_INFO]"
NEW = "new: [BATTERY_STATUS_V2, BATTERY_INFO]"
CHOICES = "    values: {0: Old, 1: New, 2: Both}\n"
BAD, SAID = "bad-generations", "bad-announcement"

CASES = [
    Case(BAD, "streams.yaml", OLD, "old: [§GPS_RAW_INT, SMART_BATTERY_INFO]", "has no population table"),
    Case(BAD, "streams.yaml", OLD, "old: [§BATERY_STATUS, SMART_BATTERY_INFO]", "did you mean BATTERY_STATUS"),
    Case(BAD, "streams.yaml", OLD, "old: [BATTERY_STATUS, §BATTERY_STATUS]", "belongs to a generation already"),
    Case(BAD, "streams.yaml", NEW, "new: [BATTERY_STATUS_V2, §BATTERY_STATUS]", "belongs to a generation already"),
    Case(
        BAD,
        "streams.yaml",
        "generations:\n",
        "generations:\n  vehicle: {doc: x, send: old, old: [HEARTBEAT], new: [SYS_STATUS, SMART_BATTERY_INFO]}\n",
        "belongs to a generation already",
        is_alone=False,
    ),
    Case(BAD, "streams.yaml", NEW, "new: [BATTERY_STATUS_V2, §HEARTBEAT]", "HEARTBEAT says nothing about a battery"),
    Case(BAD, "streams.yaml", OLD, "old: §[]", "has no message"),
    Case(BAD, "streams.yaml", "  battery:\n    doc: >-", "  §batery:\n    doc: >-", "no component", is_alone=False),
    Case(BAD, "streams.yaml", "parameter: BATT_REPORT", "parameter: §SYSID_THISMAV", "not 0, 1 and 2"),
    Case(
        "bad-parameter-family", "streams.yaml", "parameter: BATT_REPORT", "parameter: §BATT_CAPACITY", "one is needed"
    ),
    Case(BAD, "parameters.yaml", CHOICES, "", "give it the values 0 old, 1 new, 2 both", at="streams.yaml:41:16"),
    Case(BAD, "parameters.yaml", CHOICES, "    values: {0: Old, 1: New}\n", at="streams.yaml:41:16"),
    Case(BAD, "parameters.yaml", CHOICES, CHOICES + "    reboot: true\n", "after a restart", at="streams.yaml:41:16"),
    Case("unknown-parameter", "streams.yaml", "parameter: BATT_REPORT", "parameter: §BATT_REPORTS"),
    Case("unknown-requirement", "streams.yaml", "requirement: FR-00072.2", "requirement: §FR-00072.99"),
    Case("one-of-keys", "streams.yaml", "parameter: BATT_REPORT", "parameter: BATT_REPORT\n    §send: both"),
    Case("one-of-keys", "streams.yaml", "    parameter: BATT_REPORT\n", "", "parameter, send"),
    Case("unknown-choice", "streams.yaml", "parameter: BATT_REPORT", "send: §all", is_alone=False),
    # what is sent at once
    Case("unknown-quantity", INFO, "on_change: battery.swaps", "on_change: §battery.swap", "battery.swaps"),
    Case(SAID, INFO, "on_change: battery.swaps", "on_change: §vehicle.mode", "name a quantity of battery"),
    Case("bad-time", "vehicle.yaml", "silence: 10 s", "silence: §200000 s", is_alone=False),
]


@pytest.mark.parametrize("case", CASES, ids=name_of)
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    check_place(case, tmp_path, monkeypatch, capsys)


def changed(folder, *changes):
    """A copy of the shipped specification with changes of its files: (file, old, new)."""
    shutil.copytree(ROOT / "specs", folder / "specs")
    for name, old, new in changes:
        path = folder / "specs" / name
        text = path.read_text()
        assert old in text, (name, old)
        path.write_text(text.replace(old, new, 1))


def test_only_a_program_announces(tmp_path, monkeypatch, capsys):
    """Without vehicle.yaml nothing hears ground stations and nothing watches the state: both keys are reported."""
    changed(tmp_path)
    (tmp_path / "specs" / "vehicle.yaml").unlink()
    monkeypatch.chdir(tmp_path)
    assert main(["build"]) == 1
    out = capsys.readouterr().out
    lines = [line for line in out.splitlines() if f" {SAID}: " in line]
    for key in ("on connection", "on change"):
        assert any("smart_battery_info.yaml" in line and key in line for line in lines), out


@pytest.mark.requirement("FR-00072.8")
@pytest.mark.usefixtures("without_output")
@pytest.mark.parametrize(
    ("file", "old", "new", "place"),
    [
        ("parameters.yaml", "    default: 0\n    min: 0\n    max: 2\n", "    default: 2\n    min: 0\n    max: 2\n", ""),
        ("streams.yaml", "parameter: BATT_REPORT", "send: both", "specs/streams.yaml:41:11"),
    ],
)
def test_both_by_default_is_warned_about(file, old, new, place, tmp_path, monkeypatch, capsys):
    """A warning with the price of both, of the old and of the new one; it does not stop the build."""
    changed(tmp_path, (file, old, new))
    monkeypatch.chdir(tmp_path)
    assert main(["build"]) == 0
    warned = [line for line in capsys.readouterr().out.splitlines() if " both-generations: " in line]
    assert len(warned) == 1
    assert f"{place or 'specs/parameters.yaml'}" in warned[0]
    assert " bytes/s: " in warned[0]
    assert main(["explain", "BATTERY_STATUS"]) == 0
    told = capsys.readouterr().out
    price = warned[0].partition(" cost ")[2].partition(" bytes/s")[0]
    assert any(line.startswith("both ") and price in line for line in told.splitlines()), told


@pytest.mark.usefixtures("without_output")
def test_one_by_default_is_not(tmp_path, monkeypatch, capsys):
    """The shipped specification sends one generation, and so does a fixed one."""
    for name, changes in (("shipped", ()), ("fixed", [("streams.yaml", "parameter: BATT_REPORT", "send: new")])):
        changed(tmp_path / name, *changes)
        monkeypatch.chdir(tmp_path / name)
        assert main(["build"]) == 0
        assert "both-generations" not in capsys.readouterr().out
