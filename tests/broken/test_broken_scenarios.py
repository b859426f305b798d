"""Broken scenarios: several batteries, other programs, parameters and swaps, each reported at its place.

``§`` marks the place that the diagnostic must point at; it is taken out before the file is written.
"""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.project.systems import read_scenarios, read_systems

ROOT = Path(__file__).resolve().parents[2]
HEAD = "scenarios:\n  a:\n    doc: d\n    duration: 60 s\n"
PACK = "    courses: {battery.voltage: {value: 12 V}}\n"
SMART = "    with:\n      smart_battery: {courses: {battery.voltage: {value: 12 V}}}\n"

CASES = [
    ("unknown-key", "    §battery: {voltage: 12 V}\n", "courses: {component.quantity: {points"),
    ("scenario-course", "    courses: {§batery.voltage: {value: 12 V}}\n", "did you mean battery.voltage"),
    ("scenario-course", "    courses: {§\"battery[17].voltage\": {value: 12 V}}\n", "there is battery[0] to battery[1]"),
    ("scenario-course", "    courses: {§battery.over_voltage: {value: true}}\n", "has no course of its own"),
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
    ("scenario-course", "    courses: {battery.voltage: {value: 12 V}, §\"battery[0].voltage\": {value: 12 V}}\n", "another course"),
    ("scenario-course", "    courses: {§voltage: {value: 12 V}}\n", "voltage is no quantity write component.quantity"),
    ("scenario-points", "    courses: {battery.voltage: {value: 12 V, noise: §-1 mV}}\n", "noise is from 0 on"),
    ("scenario-points", "    courses: {battery.voltage: {value: 12 V, noise: §1e12 mV}}\n", "noise of 1e12 mV is more than"),
    ("scenario-points", "    courses: {battery.voltage: {value: 12 V, rate: §1001 Hz}}\n", "is not a rate up to"),
    ("scenario-points", "    courses: {battery.voltage: {value: 12 V, rate: §0 Hz}}\n", "is not a rate up to"),
    ("scenario-points", "    courses: {battery.voltage: {points: [[5 s, 12 V], [§4 s, 12 V]]}}\n", "before the point in front"),
    ("scenario-points", "    courses: {battery.voltage: {points: [§[5 s]]}}\n", "a point is a time and a value"),
    ("scenario-parameter", "    courses: {battery.voltage: {value: 12 V, wired: {BATT_NONE: §1}}}\n", "there is no parameter"),
    ("scenario-expect", "    expect: [{text: low, is: §1}]\n", "a text is said, or not"),
    ("scenario-expect", "    expect: [{no_text: low, between: §[1, 2]}]\n", "a text is said, or not"),
    ("scenario-expect", "    expect: [§{state: battery.voltage, is: 1 V, between: [1 V, 2 V]}]\n", "exactly one of is and"),
    ("scenario-expect", "    expect: [§{state: battery.voltage}]\n", "exactly one of is and between"),
    ("scenario-expect", "    expect: [{state: §battery.cells, is: 4 V}]\n", "battery.cells is a list"),
    ("scenario-expect", "    expect: [{state: battery.voltage, between: §[1 V]}]\n", "the least and the largest"),
    ("scenario-expect", "    expect: [{state: battery.voltage, between: §[2 V, 1 V]}]\n", "2 V is above 1 V"),
    ("scenario-expect", "    expect: [{state: battery.over_voltage, between: §[0, 1]}]\n", "the least and the largest"),
    ("scenario-time", "    expect: [{text: low, at: §60.001 s}]\n", "lies after the end"),
    ("scenario-time", PACK + "    events: [{at: §60.001 s, arm: true}]\n", "lies after the end, 60 s"),
    ("scenario-time", PACK + "    events: [{at: §0.5 ms, arm: true}]\n", "whole ms, from 0 ms to a day"),
    ("scenario-time", PACK + "    events: [{at: 1 s, fault: fail, of: battery.voltage, for: §0 s}]\n", "from 1 ms to a day"),
    ("scenario-points", "    expect: [{state: battery.over_voltage, is: §yes}]\n", "is true or false, not 'yes'"),
    ("scenario-event", PACK + "    events: [{at: 1 s, arm: true, for: §1 s}]\n", "for belongs to a fault"),
    ("scenario-event", PACK + "    events: [{at: 1 s, arm: true, every: §1 s}]\n", "every belongs to send"),
    ("scenario-event", PACK + "    events: [{at: 1 s, arm: true, fields: §{custom_mode: 1}}]\n", "fields belongs to send"),
    ("scenario-event", PACK + "    events: [{at: 1 s, reboot: §false}]\n", "a reboot that does not happen"),
    ("scenario-event", PACK + "    events: [{at: 1 s, fault: §slow, of: battery.voltage}]\n", "slow readings need a delay"),
    ("scenario-event", PACK + "    events: [{at: 1 s, fault: fail, of: battery.voltage, delay: §3 ms}]\n", "belongs to fault: slow"),
    ("scenario-event", PACK + "    events: [{at: 1 s, fault: slow, of: battery.voltage, delay: §1.1 s}]\n", "not from 1 us to 1 s"),
    ("scenario-event", PACK + "    events: [{at: 1 s, fault: §fail}]\n", "that has a course add of:"),
    ("scenario-send", PACK + "    events: [{at: 1 s, send: §HEARTBEET}]\n", "did you mean HEARTBEAT"),
    ("scenario-send", PACK + "    events: [{at: 1 s, send: HEARTBEAT, fields: {custom_mod: §1}}]\n", "did you mean custom_mode"),
    ("scenario-send", PACK + "    events: [{at: 1 s, send: HEARTBEAT, fields: {\"custom_mode[0]\": §1}}]\n", "custom_mode has 1 elements"),
    ("scenario-send", PACK + "    events: [{at: 1 s, send: BATTERY_STATUS, fields: {\"voltages[10]\": §1}}]\n", "voltages has 10 elements"),
    ("scenario-send", PACK + "    events: [{at: 1 s, send: HEARTBEAT, fields: {system_status: §256}}]\n", "carries 0 to 255, not 256"),
    ("scenario-send", PACK + "    events: [{at: 1 s, send: HEARTBEAT, fields: {system_status: §-1}}]\n", "carries 0 to 255, not -1"),
    ("scenario-send", PACK + "    events: [{at: 1 s, send: HEARTBEAT, fields: {system_status: §MAV_STATE_ACTIV}}]\n", "did you mean MAV_STATE_ACTIVE"),
    ("scenario-send", PACK + "    events: [{at: 1 s, send: PARAM_REQUEST_READ, fields: {param_id: §ABCDEFGHIJKLMNOPQ}}]\n", "more than the 16 bytes"),
    ("unit-mismatch", PACK + "    events: [{at: 1 s, send: BATTERY_STATUS, fields: {temperature: §2 V}}]\n", "2 V"),
    # digits of other scripts, and numbers that no float has
    ("scenario-course", "    courses: {§\"battery[\u0661].voltage\": {value: 12 V}}\n", "write component.quantity"),
    ("scenario-points", PACK + "    expect: [{state: vehicle.mode, is: §\u0663}]\n", "is a number without a unit"),
    ("scenario-points", PACK + "    expect: [{state: vehicle.mode, is: §1e400}]\n", "is a number without a unit"),
    ("scenario-points", PACK + "    expect: [{state: vehicle.mode, is: §1e999999999}]\n", "is a number without a unit"),
    ("scenario-send", PACK + "    events: [{at: 1 s, send: HEARTBEAT, fields: {system_status: §\u0663}}]\n", "has no entry"),
    ("bad-amount", PACK + "    events: [{at: 1 s, send: HEARTBEAT, fields: {custom_mode: §\u0663}}]\n", ""),
    ("scenario-send", PACK + "    events: [{at: 1 s, send: BATTERY_STATUS, fields: {\"voltages[\u0661]\": §1}}]\n", "has no field"),
    ("scenario-send", PACK + "    events: [{at: 1 s, send: ATTITUDE, fields: {roll: §1e39}}]\n", "up to 3.402823e+38"),
]  # fmt: skip

# What is at its limit, and a part of what comes of it.
SOUND = [
    ("    courses: {battery.voltage: {points: [[5 s, 12 V], [5 s, 11 V]], noise: 0 V, rate: 1000 Hz}}\n", "every_ms=1"),
    ("    courses: {battery.voltage: {value: 12 V, rate: 3 Hz, noise: 20 mV}}\n", "noise=0.02, every_ms=333"),
    ("    expect: [{text: low, at: 60 s}]\n", "at_ms=60000"),
    ("    expect: [{state: battery.voltage, between: [1 V, 1 V]}]\n", "Fraction(1, 1)"),
    (PACK + "    events: [{at: 60 s, arm: true}]\n", "Arming(at_ms=60000"),
    (PACK + "    events: [{at: 1 s, fault: slow, of: battery.voltage, delay: 1 s}]\n", "1000000"),
    (PACK + "    events: [{at: 1 s, fault: slow, of: battery.voltage, delay: 1 us, for: 1 ms}]\n", "until_ms=1001"),
    (PACK + "    events: [{at: 1 s, send: HEARTBEAT, fields: {system_status: 255}, every: 1 s, for: 2 s}]\n",
     "payload=b'\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\xff', every_ms=1000, until_ms=3000"),
    (PACK + "    events: [{at: 1 s, send: HEARTBEAT, fields: {system_status: MAV_STATE_ACTIVE}}]\n", "\\x04'"),
    (PACK + "    events: [{at: 1 s, send: BATTERY_STATUS, fields: {\"voltages[9]\": 1 V, temperature: 2.5 degC}}]\n",
     "payload=b'\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\x00\\xfa" + "\\x00" * 19 + "\\xe8\\x03'"),
    (PACK + "    events: [{at: 1 s, send: PARAM_REQUEST_READ, fields: {param_id: ABCDEFGHIJKLMNOP}}]\n",
     "payload=b'\\x00\\x00\\x01\\x01ABCDEFGHIJKLMNOP'"),
]  # fmt: skip


@pytest.fixture(scope="module")
def rover() -> tuple[System, ...]:
    """The programs of the rover, which is read once: no case changes it."""
    return read_systems(str(ROOT / "specs" / "codegen.yaml"), Report())


@pytest.mark.parametrize(("rule", "rest", "says"), CASES)
def test_a_broken_scenario_is_reported_at_its_place(
    tmp_path: Path, rover: tuple[System, ...], rule: str, rest: str, says: str
) -> None:
    """And nothing else; there is no such scenario then."""
    text = HEAD + rest
    before, _, after = text.partition("§")
    (tmp_path / "own.yaml").write_text(before + after)
    report = Report()
    found = read_scenarios(str(tmp_path / "own.yaml"), rover, report)
    assert bool(found) is (rule in ("unknown-key", "wrong-type"))  # which are not about what it means
    place = before.count("\n") + 1, len(before) - before.rfind("\n")
    told = [(each.rule.id, each.place.line, each.place.column) for each in report]
    assert told == [(rule, *place)], list(report)
    assert says in " ".join(f"{each.message} {each.hint}" for each in report)


@pytest.mark.parametrize(("rest", "says"), SOUND)
def test_a_scenario_at_its_limits_is_one(tmp_path: Path, rover: tuple[System, ...], rest: str, says: str) -> None:
    """The last value, time and element that may be."""
    (tmp_path / "own.yaml").write_text(HEAD + rest)
    report = Report()
    found = read_scenarios(str(tmp_path / "own.yaml"), rover, report)
    assert list(report) == []
    assert says in repr(found)


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
