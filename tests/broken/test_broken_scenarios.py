"""Broken scenarios: several batteries, other programs, parameters and swaps, each reported at its place.

``§`` marks the place that the diagnostic must point at; it is taken out before the file is written.
"""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]
HEAD = "scenarios:\n  a:\n    doc: d\n    duration: 60 s\n"
PACK = "    courses: {battery.voltage: {value: 12 V}}\n"
SMART = "    with:\n      smart_battery: {courses: {battery.voltage: {value: 12 V}}}\n"

CASES = [
    ("unknown-key", "    §battery: {voltage: 12 V}\n", "courses: {component.quantity: {points"),
    ("scenario-course", "    courses: {§batery.voltage: {value: 12 V}}\n", "did you mean battery.voltage"),
    ("scenario-course", "    courses: {§\"battery[17].voltage\": {value: 12 V}}\n", "there is battery[0] to battery[1]"),
    ("scenario-course", "    courses: {§battery.over_voltage: {value: true}}\n", "makes it of others"),
    ("scenario-course", "    courses: {§vehicle.mode: {value: 3}}\n", "the program sets it"),
    ("scenario-course", "    courses: {§battery.health: {value: 0}}\n", "the failsafe sets it"),
    ("scenario-points", "    courses: {battery.voltage: {points: §[]}}\n", "there is no point"),
    ("unit-mismatch", "    courses: {battery.current: {value: §2 V}}\n", "give it in A"),
    ("scenario-parameter", PACK + "    parameters: {BATT_LOW_VOLTS: §10}\n", "did you mean BATT_LOW_VOLT"),
    ("scenario-parameter", PACK + "    parameters: {BATT_LOW_VOLT: §101}\n", "101 V is not from 0 to 100"),
    ("scenario-parameter", PACK + "    parameters: {BATT_LOW_TIMER: §2.5}\n", "between two steps of 1 s"),
    ("scenario-parameter", PACK + "    parameters: {BATT_MONITOR: §1}\n", "it takes 0 Disabled, 3 Analog"),
    ("wrong-type", PACK + "    parameters: {BATT_MONITOR: §on}\n", ""),
    ("scenario-program", PACK + "    with:\n      §smart_batery: {parameters: {}}\n", "did you mean smart_battery"),
    (
        "scenario-course",
        "    with: {smart_battery: {courses: {§battery.voltages: {value: 12 V}}}}\n",
        "did you mean battery.voltage",
    ),
    (
        "scenario-parameter",
        PACK + "    with: {smart_battery: {parameters: {BATT_ID: §99}}}\n",
        "99 is not from 0 to",
    ),
    ("scenario-program", PACK + "    events: [{at: 1 s, swap: §pico-trail, for: 1 s}]\n", "unknown, 0 V"),
    ("scenario-program", PACK + "    events: [{at: 1 s, swap: §smart_battery, for: 1 s}]\n", "does not run beside"),
    ("scenario-event", PACK + SMART + "    events: [{at: 1 s, swap: §smart_battery}]\n", "needs the time that it takes"),
    ("scenario-swap", PACK + SMART + "    events: [{at: §0 s, swap: smart_battery, for: 1 s}]\n", "at the start"),
    (
        "scenario-swap",
        PACK + SMART + "    events: [{at: 1 s, swap: smart_battery, for: 9 s}, {at: §5 s, swap: smart_battery, for: 1 s}]\n",
        "the swap before it ends at 10 s",
    ),
    ("scenario-event", PACK + "    events: [{at: 1 s, arm: true, courses: §{battery.voltage: {value: 12 V}}}]\n", "belong to a swap"),
    ("scenario-event", PACK + "    events: [{at: 1 s, arm: true, of: §battery.voltage}]\n", "belongs to a fault"),
    ("scenario-event", PACK + "    events: [{at: 1 s, fault: fail, of: §battery.voltag}]\n", "did you mean battery.voltage"),
    ("scenario-event", PACK + "    events: [{at: 1 s, fault: §fial, of: battery.voltage}]\n", "did you mean fail"),
    ("scenario-expect", "    expect: [{told: §battery.failsafe, is: 1}]\n", "no message carries battery.failsafe"),
]  # fmt: skip


@pytest.mark.parametrize(("rule", "rest", "says"), CASES)
def test_a_broken_scenario_is_reported_at_its_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], rule: str, rest: str, says: str
) -> None:
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    monkeypatch.chdir(tmp_path)
    text = HEAD + rest
    before, _, after = text.partition("§")
    (tmp_path / "own.yaml").write_text(before + after)
    assert main(["sim", "own.yaml"]) == 1
    out = capsys.readouterr().out
    place = f"{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}"
    findings = [line for line in out.splitlines() if line.startswith("own.yaml:")]
    assert [finding.split(": ")[:2] for finding in findings] == [[f"own.yaml:{place}", f"error {rule}"]], out
    assert says in out


def test_all_findings_come_in_one_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Those of the main program, of the other one, and of the events."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "own.yaml").write_text(
        HEAD
        + PACK
        + "    parameters: {NONE: 1}\n"
        + "    with: {smart_battery: {courses: {battery.voltage: {value: 1 A}}, parameters: {BATT_ID: 99}}}\n"
        + "    events: [{at: 0 s, swap: smart_battery, for: 1 s}, {at: 2 s, fault: fail, of: battery.trend}]\n"
    )
    assert main(["sim", "own.yaml"]) == 1
    rules = [line.split(": ")[1] for line in capsys.readouterr().out.splitlines() if line.startswith("own.yaml:")]
    assert sorted(rules) == [
        *("error scenario-event", "error scenario-parameter", "error scenario-parameter"),
        *("error scenario-swap", "error unit-mismatch"),
    ]
