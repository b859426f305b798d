"""Scenario files: what is right becomes plain numbers, what is wrong is reported at its place."""

from pathlib import Path

import pytest

from codegen.decode.scenario import decode_scenarios
from codegen.diagnostics import Report
from codegen.model.scenario import AdcFault, Arming, Battery, Fault, Point, Reboot, Scenario, battery_data, event_data
from codegen.pipeline import read_system
from codegen.resolve.scenario import resolve_scenarios

ROOT = Path(__file__).resolve().parents[2]

SYSTEM = read_system(str(ROOT / "specs" / "codegen.yaml"), Report())
assert SYSTEM is not None
HEAD = "scenarios:\n  a:\n    doc: d\n    duration: 10 s\n"


def resolved(path: Path, report: Report) -> dict[str, Scenario]:
    written = decode_scenarios(str(path), report)
    return {} if written is None else resolve_scenarios(written, SYSTEM, report)


def found(tmp_path: Path, text: str) -> tuple[dict[str, Scenario], list[tuple[str, int, int]]]:
    path = tmp_path / "scenarios.yaml"
    path.write_text(text)
    report = Report()
    scenarios = resolved(path, report)
    return scenarios, [(finding.rule.id, finding.place.line, finding.place.column) for finding in report]


def test_everything_that_can_be_written(tmp_path: Path) -> None:
    text = HEAD + (
        "    seed: 7\n"
        "    battery:\n      voltage: [[0 s, 12.6 V], [500 ms, 12600 mV], [10 s, 9.6 V]]\n"
        "      noise: 10 mV\n      divider: 4.01\n"
        "    events:\n      - {at: 2 s, adc: fail, for: 3 s}\n      - {at: 1 s, arm: true}\n"
        "      - {at: 3 s, arm: false}\n"
        "      - {at: 4 s, adc: slow, delay: 3 ms}\n      - {at: 0 s, adc: absent, for: 1 s}\n"
        "      - {at: 5 s, reboot: true}\n"
    )
    scenarios, findings = found(tmp_path, text)
    assert findings == []
    assert scenarios["a"] == Scenario(
        name="a",
        doc="d",
        duration_ms=10_000,
        seed=7,
        batteries=(Battery((Point(0, 12_600), Point(500, 12_600), Point(10_000, 9_600)), 10, 4_010_000),),
        events=(
            Fault(0, AdcFault.ABSENT, 1_000, 0),
            Arming(1_000, True),
            Fault(2_000, AdcFault.FAIL, 5_000, 0),
            Arming(3_000, False),
            Fault(4_000, AdcFault.SLOW, None, 3_000),
            Reboot(5_000),
        ),
    )


def test_one_voltage_stays_and_the_divider_is_that_of_the_parameter(tmp_path: Path) -> None:
    scenarios, findings = found(tmp_path, HEAD + "    battery: {voltage: 12 V}\n")
    assert findings == []
    assert scenarios["a"].batteries == (Battery((Point(0, 12_000),), 0, 3_950_000),)


def test_the_data_is_plain_numbers(tmp_path: Path) -> None:
    text = HEAD + (
        "    battery: {voltage: [[1 s, 12 V]]}\n"
        "    events: [{at: 1 s, arm: true}, {at: 2 s, adc: slow, delay: 2 ms, for: 1 s}, {at: 3 s, reboot: true}]\n"
    )
    scenario = found(tmp_path, text)[0]["a"]
    assert battery_data(scenario.batteries[0], 7) == {
        "seed": 7,
        "points": [[1_000, 12_000]],
        "noise_mv": 0,
        "divider_millionths": 3_950_000,
        "currents": [],
    }
    assert [event_data(event) for event in scenario.events] == [
        {"at_ms": 1_000, "arm": True},
        {"at_ms": 2_000, "adc": "slow", "until_ms": 3_000, "instance": 0, "delay_us": 2_000},
        {"at_ms": 3_000, "reboot": True},
    ]


BROKEN = [
    ("scenarios: {}\n", [("empty-mapping", 1, 12)]),
    ("scenarios:\n  a: {doc: d, duration: 1 s}\n", [("scenario-instance", 2, 3)]),
    (HEAD + "    battery: {voltage: 12 V}\n    batteries: [{voltage: 12 V}]\n", [("scenario-instance", 6, 16)]),
    (HEAD + "    battery: {volts: 12 V}\n", [("unknown-key", 5, 15)]),
    (HEAD + "    battery: {voltage: 12}\n", [("wrong-type", 5, 24)]),
    (HEAD + "    battery: {voltage: []}\n", [("scenario-points", 5, 24)]),
    (HEAD + "    battery: {voltage: 12 A}\n", [("unit-mismatch", 5, 24)]),
    (HEAD + "    battery: {voltage: [[0 s]]}\n", [("scenario-points", 5, 25)]),
    (HEAD + "    battery: {voltage: [0 s, 12 V]}\n", [("wrong-type", 5, 25), ("wrong-type", 5, 30)]),
    (HEAD + "    battery: {voltage: [[5 s, 12 V], [1 s, 11 V]]}\n", [("scenario-points", 5, 39)]),
    (
        HEAD + "    battery: {voltage: [[0 V, 12 V], [1 s, -1 V]]}\n",
        [("unit-mismatch", 5, 26), ("scenario-points", 5, 44)],
    ),
    (HEAD + "    battery: {voltage: 12 V, noise: -1 mV}\n", [("scenario-battery", 5, 37)]),
    (HEAD + "    battery: {voltage: 12 V, divider: 0}\n", [("scenario-battery", 5, 39)]),
    (HEAD.replace("10 s", "0 s") + "    battery: {voltage: 12 V}\n", [("scenario-time", 4, 15)]),
    (HEAD.replace("10 s", "10 sec") + "    battery: {voltage: 12 V}\n", [("bad-amount", 4, 15)]),
]

EVENTS = [
    ("at: 1 s", [("one-of-keys", 6, 14)]),
    ("at: 1 s, arm: true, adc: fail", [("one-of-keys", 6, 35)]),
    ("at: 1 s, adc: broken", [("unknown-choice", 6, 29)]),
    ("at: 1 s, adc: absent", [("scenario-event", 6, 19)]),
    ("at: 1 s, adc: slow", [("scenario-event", 6, 29)]),
    ("at: 1 s, adc: fail, delay: 1 ms", [("scenario-event", 6, 42)]),
    ("at: 1 s, arm: true, for: 1 s", [("scenario-event", 6, 40)]),
    ("at: 1 s, reboot: false", [("scenario-event", 6, 32)]),
    ("at: 11 s, arm: true", [("scenario-time", 6, 19)]),
    ("at: -1 s, arm: true", [("scenario-time", 6, 19)]),
    ("at: 1 s, adc: slow, delay: 2 s, for: 0 s", [("scenario-event", 6, 42), ("scenario-time", 6, 52)]),
]


@pytest.mark.parametrize(("text", "findings"), BROKEN)
def test_what_is_wrong_is_reported_at_its_place(tmp_path: Path, text: str, findings: list[object]) -> None:
    assert found(tmp_path, text) == ({}, findings)


@pytest.mark.parametrize(("event", "findings"), EVENTS)
def test_what_is_wrong_with_an_event_is_reported_at_its_place(
    tmp_path: Path, event: str, findings: list[object]
) -> None:
    text = HEAD + f"    battery: {{voltage: 12 V}}\n    events: [{{{event}}}]\n"
    assert found(tmp_path, text)[1] == findings


def test_all_findings_come_in_one_run(tmp_path: Path) -> None:
    text = HEAD + "    battery: {voltage: 12 A, noise: 1 s}\n    events: [{at: 1 V, arm: true}]\n"
    assert [rule for rule, _, _ in found(tmp_path, text)[1]] == ["unit-mismatch"] * 3


def test_the_shipped_scenarios() -> None:
    """Those that the documents name, and what the failsafe needs to be seen; each begins with a full enough pack."""
    report = Report()
    scenarios = resolved(ROOT / "specs" / "scenarios.yaml", report)
    assert list(report) == []
    assert set(scenarios) >= {
        *("nominal", "discharge", "sag", "charging", "sensor_loss"),
        *("adc_fault", "rising", "falling", "low", "critical"),
        *("two_batteries", "smart_battery", "swap", "swap_on_the_autopilot"),
    }
    for name in ("low", "critical", "discharge", "sag", "falling"):
        events = scenarios[name].events
        assert events[0] == Arming(5_000, True), name
        assert scenarios[name].batteries[0].millivolts(5_000) >= 11_000, name


def test_the_voltage_between_points() -> None:
    points = (Point(1_000, 12_000), Point(2_000, 10_000), Point(2_000, 11_000), Point(4_000, 11_500))
    battery = Battery(points, 0, 1)
    found = [battery.millivolts(at_ms) for at_ms in (0, 1_000, 1_500, 1_999, 2_000, 3_000, 4_000, 9_000)]
    assert found == [12_000, 12_000, 11_000, 10_002, 11_000, 11_250, 11_500, 11_500]
