"""``driver: adc`` among the sensors is the same as a channel under ``adc``: the same firmware, the same findings."""

import re
import shutil
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.project.systems import read_system

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "power_monitor"
CHANNELS = """adc:
  pack_voltage: {pin: BATT_VOLT_PIN, samples: 2, read_limit: 2 ms}
  pack_current: {pin: BATT_CURR_PIN, samples: 2, read_limit: 2 ms, when: {BATT_MONITOR: 4}}
  level: {gpio: 28, samples: 3}
"""
"""The sensors of the project without ``sources``; multipliers and rates stand in state.yaml then."""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A copy of the project, which has three inputs of the converter among its sensors."""
    return Path(shutil.copytree(PROJECT / "specs", tmp_path / "specs")).parent


def read(project: Path) -> tuple[System | None, list[str]]:
    """The system, and what is found, with its place."""
    report = Report()
    system = read_system(str(project / "specs" / "codegen.yaml"), report)
    return system, [f"{each.place.shown(str(project))} {each.message}" for each in report]


def change(project: Path, file: str, old: str, new: str) -> None:
    path = project / "specs" / file
    text = path.read_text()
    assert text.count(old) >= 1, old
    path.write_text(text.replace(old, new, 1))


def plan(system: System) -> list[object]:
    """Return the plan of the firmware: each reading with its channel and rate."""
    return [
        (name, system.components[name].period_ms, quantity.path, conversion.formula, conversion.channel.samples,
         conversion.channel.gpio, conversion.channel.read_limit_us, conversion.numerator, conversion.denominator)
        for name, quantity, conversion in system.measured()
    ]  # fmt: skip


def test_both_forms_are_the_same(project: Path) -> None:
    system, found = read(project)
    assert found == []
    assert system is not None
    board = project / "specs" / "board.yaml"
    board.write_text(re.sub(r"(?s)sources:\n.*?(?=facts:)", CHANNELS, board.read_text()))
    change(project, "state.yaml", "source: pack_voltage", "adc: pack_voltage, multiplier: BATT_VOLT_MULT")
    current = "adc: pack_current\n        multiplier: BATT_AMP_PERVLT\n        offset: BATT_AMP_OFFSET"
    change(project, "state.yaml", "source: pack_current", current)
    change(project, "state.yaml", "source: level", "adc: level, multiplier: 40 %/V, offset: 0.4 V")
    for name, rate in (("pack", "10 Hz"), ("tank", "5 Hz")):
        state = (project / "specs" / "state.yaml").read_text()
        state = re.sub(rf"(?m)^(  {name}:\n    doc: .*\n)", rf"\1    update_rate: {rate}\n", state)
        (project / "specs" / "state.yaml").write_text(state)
    other, found = read(project)
    assert found == []
    assert other is not None
    assert plan(other) == plan(system)
    assert len(plan(system)) == 3


@pytest.mark.parametrize(
    ("file", "old", "new", "said"),
    [
        ("state.yaml", "source: level", "source: level.first", "specs/state.yaml:29:81 level gives one number"),
        ("state.yaml", "source: level", "source: levle", "did you mean level"),
        ("state.yaml", "source: level", "source: level, multiplier: 2", "the multiplier of level stands at the sensor"),
        ("state.yaml", "  tank:\n", "  tank:\n    update_rate: 4 Hz\n", "read together, at one rate"),
        ("board.yaml", "gpio: 28", "gpio: 29", "gpio of level is 29"),
        ("board.yaml", "multiplier: 40 %/V, ", "", "multiplier"),
        ("board.yaml", "rate: 5 Hz", "rate: 5 Hz, retry: 1 s", "tried again with each text"),
        ("board.yaml", "samples: 3", "samples: 65", "not 1 to 64"),
        ("board.yaml", "sources:\n", "adc: {level: {gpio: 28}}\nsources:\n", "stands under adc, too"),
        ("board.yaml", "samples: 3", "sample: 3", "unknown key 'sample'"),
    ],
)
def test_a_mistake_is_found_where_it_stands(project: Path, file: str, old: str, new: str, said: str) -> None:
    change(project, file, old, new)
    report = Report()
    read_system(str(project / "specs" / "codegen.yaml"), report)
    assert report.has_errors
    shown = [f"{each.place.shown(str(project))} {each.message} {each.hint}" for each in report]
    assert any(said in each for each in shown), shown
    assert len(shown) == 1, shown


def measure_a_thermistor(project: Path, points: str, stored: str) -> None:
    """Have the tank's input measure a thermistor by a curve, and one message tell its degrees."""
    change(project, "board.yaml", "multiplier: 40 %/V, offset: 0.4 V", "multiplier: 1")
    with (project / "specs" / "board.yaml").open("a") as file:
        file.write(f"curves:\n  ntc: {{points: {{{points}}}}}\n")
    state = (project / "specs" / "state.yaml").read_text()
    level = re.compile(r"      level:\n.*?stale_after: 2 s}", re.DOTALL)
    (project / "specs" / "state.yaml").write_text(
        level.sub(
            f"      probe: {{doc: At the divider., unit: V, {stored}source: level, stale_after: 2 s}}\n"
            "      warmth: {doc: Of the fuel., unit: degC, stored: cdegC, min: -20, max: 120, estimate_from: probe, "
            "curve: ntc}",
            state,
        )
    )
    change(
        project,
        "messages/hygrometer_sensor.yaml",
        "temperature: {constant: 20 degC}",
        "temperature: {state: tank.warmth}",
    )
    change(project, "messages/hygrometer_sensor.yaml", "humidity: {state: tank.level}", "humidity: {constant: 0}")


def test_a_thermistor_is_a_curve(project: Path) -> None:
    """Degrees by the volts at its divider: falling, below zero, and as fine as they are kept."""
    measure_a_thermistor(project, "0.3 V: 120, 0.9 V: 60, 2.3 V: 0, 2.9 V: -20", "stored: mV, ")
    system, found = read(project)
    assert found == []
    assert system is not None


@pytest.mark.parametrize(
    ("points", "stored", "said"),
    [
        ("0.3 V: 120, 2.9 V: -20", "", "error bad-estimate: 0.3 V is no whole V, and probe is kept in whole V"),
        ("0.3 V: 120, 2.95 V: -20", "", "hint stored: cV at probe, or round it"),
        ("0.3 V: 120, 2.95 V: -20", "stored: dV, ", "error bad-estimate: 2.95 V is no whole dV"),
        ("0.3 V: 120, 2.9005 V: -20", "stored: mV, ", "hint stored: uV at probe, or round it"),
        (
            "0 V: 120, 3 V: -20",
            "",
            "warning coarse-quantity: tank.probe is kept in whole V, and tank.warmth is estimated",
        ),
        ("0 V: 120, 3 V: -20", "", "hint stored: mV"),
        ("0 V: 120, 3 V: -20", "stored: V, ", ""),
        ("0 V: 120, 3 V: -20", "stored: mV, ", ""),
    ],
)
def test_a_curve_has_its_points_where_they_are_written(project: Path, points: str, stored: str, said: str) -> None:
    """They were rounded to the steps of what is measured: in whole volts a thermistor was 70 degrees off."""
    measure_a_thermistor(project, points, stored)
    report = Report()
    read_system(str(project / "specs" / "codegen.yaml"), report)
    shown = [f"{each.rule.severity.value} {each.rule.id}: {each.message} hint {each.hint}" for each in report]
    assert len(shown) == bool(said), shown
    assert not said or said in shown[0], shown
