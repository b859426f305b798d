"""Scenario files: what is right becomes plain numbers, what is wrong is reported at its place."""

import re
from fractions import Fraction
from pathlib import Path

import pytest
from packs import rover

from codegen.decode.scenario import decode_scenarios
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.model.quantities.precision import Precision
from codegen.model.quantities.simulated import SimulatedInput
from codegen.model.scenario import (
    Arming,
    Course,
    Expectation,
    Fault,
    Point,
    Reboot,
    Scenario,
    course_data,
    event_data,
)
from codegen.project.systems import read_scenarios, read_systems
from codegen.resolve.scenarios.scenario import resolve_scenarios

ROOT = Path(__file__).resolve().parents[2]
HEAD = "scenarios:\n  a:\n    doc: d\n    duration: 10 s\n"
WHOLE = Precision(Fraction(1))
PACK = "    courses: {battery.voltage: {value: 12 V}}\n"


def resolved(path: Path, report: Report) -> dict[str, Scenario]:
    written = decode_scenarios(str(path), DISK, report)
    return {} if written is None else resolve_scenarios(written, rover(), report)


def found(tmp_path: Path, text: str) -> tuple[dict[str, Scenario], list[tuple[str, int, int]]]:
    path = tmp_path / "scenarios.yaml"
    path.write_text(text)
    report = Report()
    scenarios = resolved(path, report)
    return scenarios, [(finding.rule.id, finding.place.line, finding.place.column) for finding in report]


def through_adc(full: float = 3.3 * 3.95, gpio: int = 26) -> SimulatedInput:
    """The ADC input of a pack."""
    faults = {"fail": "ADC readings fail", "absent": "ADC absent", "slow": "ADC readings take longer"}
    settings = {"gpio": gpio, "zero": 0.0, "full": pytest.approx(full, rel=1e-12)}
    return SimulatedInput("adc", settings, faults | {"stuck": "ADC readings stay as they were"})


def test_everything_that_can_be_written(tmp_path: Path) -> None:
    text = HEAD + (
        "    seed: 7\n"
        "    parameters: {BATT2_VOLT_PIN: 28}\n"
        "    courses:\n"
        "      battery.voltage:\n        points: [[0 s, 12.6 V], [500 ms, 12600 mV], [7 s, unknown], [10 s, 9.6 V]]\n"
        "        noise: 10 mV\n        wired: {BATT_VOLT_MULT: 4.01}\n"
        "      battery[1].voltage: {value: 11 V}\n"
        "      battery.temperature: {value: 25 degC, rate: 20 Hz}\n"
        "      battery.protected: {points: [[0 s, false], [1 s, true]]}\n"
        "    events:\n      - {at: 2 s, fault: fail, of: battery.voltage, for: 3 s}\n      - {at: 1 s, arm: true}\n"
        "      - {at: 3 s, arm: false}\n"
        "      - {at: 4 s, fault: slow, of: 'battery[1].voltage', delay: 3 ms}\n"
        "      - {at: 0 s, fault: absent, of: 'battery[0].voltage', for: 1 s}\n"
        "      - {at: 5 s, reboot: true}\n"
        "    expect:\n      - {at: 9 s, state: battery.failsafe, is: 1}\n"
        "      - {told: battery.voltage, between: [9.5 V, 9700 mV]}\n"
        "      - {at: 1 s, no_text: Crash}\n"
    )
    scenarios, findings = found(tmp_path, text)
    assert findings == []
    first = (Point(0, 12.6), Point(500, 12.6), Point(7_000, None), Point(10_000, 9.6))
    settings = {"component": "battery", "instance": 0}
    temperature = {**settings, "attribute": "temperature_cdegc", "steps": 100.0, "is_whole": True}
    protected = {**settings, "attribute": "protected", "steps": 1.0, "is_whole": False}
    by_code = {"fail": "nothing sets it", "stuck": "it is set to what it was"}
    assert scenarios["a"] == Scenario(
        name="a",
        doc="d",
        duration_ms=10_000,
        seed=7,
        parameters={"BATT2_VOLT_PIN": 28.0},
        courses=(
            Course("battery.voltage", first, through_adc(3.3 * 4.01), 0.01),
            Course("battery[1].voltage", (Point(0, 11.0),), through_adc(gpio=28)),
            Course("battery.temperature", (Point(0, 25.0),), SimulatedInput("state", temperature, by_code), 0.0, 50),
            Course(
                "battery.protected",
                (Point(0, False), Point(1_000, True)),
                SimulatedInput("state", protected, by_code),
                is_line=False,
            ),
        ),
        events=(
            Fault(0, "absent", "battery.voltage", 1_000, "ADC absent"),
            Arming(1_000, True),
            Fault(2_000, "fail", "battery.voltage", 5_000, "ADC readings fail"),
            Arming(3_000, False),
            Fault(4_000, "slow", "battery[1].voltage", None, "ADC readings take longer", 3_000),
            Reboot(5_000),
        ),
        expected=(
            Expectation("state battery.failsafe is 1 at 9 s", 9_000, "battery.failsafe", value=1.0, precision=WHOLE),
            Expectation(
                "told battery.voltage between 9.5 V and 9700 mV at the end",
                None,
                "battery.voltage",
                told=True,
                low=Fraction("9.5"),
                high=Fraction("9.7"),
                precision=Precision(Fraction(1, 1000)),
            ),
            Expectation("no text with 'Crash' by 1 s", 1_000, text="Crash", is_absent=True),
        ),
    )


def test_a_scenario_needs_no_course(tmp_path: Path) -> None:
    scenarios, findings = found(tmp_path, HEAD)
    assert findings == []
    assert scenarios["a"].courses == ()


def test_the_data_is_plain_numbers(tmp_path: Path) -> None:
    text = HEAD + (
        "    courses: {battery.voltage: {points: [[1 s, 12 V]]}}\n"
        "    events: [{at: 1 s, arm: true}, {at: 2 s, fault: slow, of: battery.voltage, delay: 2 ms, for: 1 s}, "
        "{at: 3 s, reboot: true}]\n"
    )
    scenario = found(tmp_path, text)[0]["a"]
    assert course_data(scenario.courses[0], 7) == {
        "label": "battery.voltage",
        "kind": "adc",
        "settings": {"gpio": 26, "zero": 0.0, "full": pytest.approx(3.3 * 3.95)},
        "seed": 7,
        "points": [[1_000, 12.0]],
        "noise": 0.0,
        "every_ms": 100,
        "is_line": True,
    }
    assert [event_data(event) for event in scenario.events] == [
        {"at_ms": 1_000, "arm": True},
        {"at_ms": 2_000, "fault": "slow", "of": "battery.voltage", "until_ms": 3_000, "delay_us": 2_000},
        {"at_ms": 3_000, "reboot": True},
    ]


COURSE = HEAD + "    courses: {battery.voltage: {%s}}\n"
BROKEN = [
    ("scenarios: {}\n", [("empty-mapping", 1, 12)]),
    (HEAD + "    courses: {battery.volts: {value: 12 V}}\n", [("scenario-course", 5, 15)]),
    (HEAD + "    courses: {battery: {value: 12 V}}\n", [("scenario-course", 5, 15)]),
    (HEAD + "    courses: {'battery[2].voltage': {value: 12 V}}\n", [("scenario-course", 5, 15)]),
    (HEAD + "    courses: {battery.healthy: {value: true}}\n", [("scenario-course", 5, 15)]),
    (HEAD + "    courses: {battery.trend: {value: 1 V/s}}\n", [("scenario-course", 5, 15)]),
    (HEAD + "    courses: {battery.cells: {value: 4 V}}\n", [("scenario-course", 5, 15)]),
    (HEAD + "    courses: {battery.failsafe: {value: 1}}\n", [("scenario-course", 5, 15)]),
    (HEAD + "    courses: {vehicle.armed: {value: true}}\n", [("scenario-course", 5, 15)]),
    (
        HEAD + "    courses: {battery.voltage: {value: 1 V}, 'battery[0].voltage': {value: 2 V}}\n",
        [("scenario-course", 5, 46)],
    ),
    (HEAD + "    battery: {voltage: 12 V}\n", [("unknown-key", 5, 5)]),
    (COURSE % "volts: 12 V", [("one-of-keys", 5, 15), ("unknown-key", 5, 33)]),
    (COURSE % "value: 12 V, points: [[0 s, 12 V]]", [("one-of-keys", 5, 46)]),
    (COURSE % "value: 12", [("bad-amount", 5, 40)]),
    (COURSE % "points: []", [("scenario-points", 5, 41)]),
    (COURSE % "value: 12 A", [("unit-mismatch", 5, 40)]),
    (COURSE % "points: [[0 s]]", [("scenario-points", 5, 42)]),
    (COURSE % "points: [0 s, 12 V]", [("wrong-type", 5, 42), ("wrong-type", 5, 47)]),
    (COURSE % "points: [[5 s, 12 V], [1 s, 11 V]]", [("scenario-points", 5, 56)]),
    (COURSE % "points: [[0 V, 12 V], [1 s, 1 A]]", [("unit-mismatch", 5, 43), ("unit-mismatch", 5, 61)]),
    (COURSE % "value: 12 V, noise: -1 mV", [("scenario-points", 5, 53)]),
    (COURSE % "value: 12 V, rate: 0 Hz", [("scenario-points", 5, 52)]),
    (COURSE % "value: 12 V, wired: {BATT_VOLT_MUL: 4}", [("scenario-parameter", 5, 69)]),
    (HEAD + "    courses: {battery.protected: {value: maybe}}\n", [("scenario-points", 5, 42)]),
    (HEAD + "    courses: {battery.protected: {value: true, noise: 1}}\n", [("scenario-points", 5, 55)]),
    (HEAD + "    courses: {battery.current: {value: 12 V}}\n", [("unit-mismatch", 5, 40)]),
    (HEAD.replace("10 s", "0 s") + PACK, [("scenario-time", 4, 15)]),
    (HEAD.replace("10 s", "10 sec") + PACK, [("bad-amount", 4, 15)]),
]

EVENTS = [
    ("at: 1 s", [("one-of-keys", 6, 14)]),
    ("at: 1 s, arm: true, fault: fail", [("one-of-keys", 6, 35)]),
    ("at: 1 s, adc: fail", [("one-of-keys", 6, 14), ("unknown-key", 6, 24)]),
    ("at: 1 s, fault: fail", [("scenario-event", 6, 31)]),
    ("at: 1 s, fault: broken, of: battery.voltage", [("scenario-event", 6, 31)]),
    ("at: 1 s, fault: fail, of: battery.current", [("scenario-event", 6, 41)]),
    ("at: 1 s, fault: absent, of: battery.voltage", [("scenario-event", 6, 19)]),
    ("at: 1 s, fault: slow, of: battery.voltage", [("scenario-event", 6, 31)]),
    ("at: 1 s, fault: fail, of: battery.voltage, delay: 1 ms", [("scenario-event", 6, 65)]),
    ("at: 1 s, arm: true, of: battery.voltage", [("scenario-event", 6, 39)]),
    ("at: 1 s, arm: true, for: 1 s", [("scenario-event", 6, 40)]),
    ("at: 1 s, reboot: false", [("scenario-event", 6, 32)]),
    ("at: 11 s, arm: true", [("scenario-time", 6, 19)]),
    ("at: -1 s, arm: true", [("scenario-time", 6, 19)]),
    (
        "at: 1 s, fault: slow, of: battery.voltage, delay: 2 s, for: 0 s",
        [("scenario-event", 6, 65), ("scenario-time", 6, 75)],
    ),
]

EXPECTED = [
    ("state: battery.failsafe", [("scenario-expect", 6, 14)]),
    ("state: battery.failsafe, is: 1, between: [0, 1]", [("scenario-expect", 6, 14)]),
    ("state: battery.failsave, is: 1", [("scenario-course", 6, 22)]),
    ("state: battery.voltage, is: 3 A", [("unit-mismatch", 6, 43)]),
    ("state: battery.voltage, between: [12 V, 11 V]", [("scenario-expect", 6, 48)]),
    ("state: battery.voltage, between: [12 V]", [("scenario-expect", 6, 48)]),
    ("state: battery.cells, is: 1 V", [("scenario-expect", 6, 22)]),
    ("told: battery.protected, is: true", [("scenario-expect", 6, 21)]),
    ("text: low, is: 3", [("scenario-expect", 6, 30)]),
    ("text: low, told: battery.voltage", [("one-of-keys", 6, 26)]),
    ("at: 11 s, text: low", [("scenario-time", 6, 19)]),
]


@pytest.mark.parametrize(("text", "findings"), BROKEN)
def test_what_is_wrong_is_reported_at_its_place(tmp_path: Path, text: str, findings: list[object]) -> None:
    assert found(tmp_path, text)[1] == findings


@pytest.mark.parametrize(("event", "findings"), EVENTS)
def test_what_is_wrong_with_an_event_is_reported_at_its_place(
    tmp_path: Path, event: str, findings: list[object]
) -> None:
    text = HEAD + PACK + f"    events: [{{{event}}}]\n"
    assert found(tmp_path, text)[1] == findings


@pytest.mark.parametrize(("expected", "findings"), EXPECTED)
def test_what_is_wrong_with_an_expectation_is_reported_at_its_place(
    tmp_path: Path, expected: str, findings: list[object]
) -> None:
    assert found(tmp_path, HEAD + PACK + f"    expect: [{{{expected}}}]\n")[1] == findings


def test_all_findings_come_in_one_run(tmp_path: Path) -> None:
    text = HEAD + "    courses: {battery.voltage: {value: 12 A, noise: 1 s}}\n    events: [{at: 1 V, arm: true}]\n"
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
        assert float(scenarios[name].courses[0].value(5_000) or 0) >= 11, name


def test_the_example_of_the_documentation_is_a_scenario_of_the_boat_to_begin_with() -> None:
    folder = ROOT / "templates" / "start" / "boat" / "specs"
    example = re.search(r"```yaml\nscenarios:\n(.*?)```", (ROOT / "docs" / "simulation.md").read_text(), re.DOTALL)
    assert example is not None
    assert example[1] in (folder / "scenarios.yaml").read_text()
    report = Report()
    systems = read_systems(str(folder / "codegen.yaml"), report)
    scenarios = read_scenarios(str(folder / "scenarios.yaml"), systems, report)
    assert list(report) == []
    assert scenarios is not None
    assert [len(scenarios["around_the_buoy"].courses), scenarios["around_the_buoy"].has_code] == [8, False]
