"""A third battery, or one more cell, is one edit of board.yaml: everything else follows."""

import json
import os
import subprocess
import sys
from pathlib import Path

import generated_suite
import pytest
from rover_alone import without_programs
from test_change_goes_everywhere import ROOT, apply, run
from whole_program import module_folders

ANYWHERE = "arming or instance or monitor or good_count or broken_board or order_within or partial_writes"
SECOND = "      defaults: {BATT2_MONITOR: 0, BATT2_VOLT_PIN: 27}\n"
PROGRAM = "cpython-failsafe or cpython-arming or cpython-health or cpython-instance or cpython-parameter"


@pytest.fixture
def whole_project(tmp_path):
    """The shipped specification, to be changed."""
    subprocess.run(["cp", "-r", str(ROOT / "specs"), str(tmp_path)], check=True)
    return tmp_path


@pytest.fixture
def project(whole_project):
    """The same of the rover alone."""
    without_programs(whole_project / "specs")
    return whole_project


def suite_is_green(project: Path, selection: str) -> None:
    """Build the project, check that nothing is wrong with it, and run a part of its own suite."""
    run(project, "build")
    suites = ("generated/tests/test_program.py", "generated/tests/test_behaviour.py")
    generated_suite.suite_is_green(project, *suites, only=selection)


def parameters_of(project: Path) -> dict[str, float]:
    """Name and default of every parameter, as the firmware itself tells them."""
    script = "import json; from parameters import Parameters; p = Parameters(); "
    script += "print(json.dumps({name: p.get(name) for name in p.names()}))"
    path = os.pathsep.join(map(str, module_folders(project / "generated", "firmware")))
    command, environment = [sys.executable, "-c", script], {**os.environ, "PYTHONPATH": path}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    told: dict[str, float] = json.loads(done.stdout)
    return told


@pytest.mark.requirement("FR-00073.1", "FR-00073.2", "FR-00073.7", "FR-00073.9")
def test_a_third_battery_is_one_entry(project):
    """It has parameters, a pin, a failsafe and messages of its own; the generated suite tests all three."""
    third = "    - {prefix: BATT3_, doc: A third pack., facts: {cells: 2}, "
    third += "defaults: {BATT3_MONITOR: 0, BATT3_VOLT_PIN: 28}}\n"
    apply(project, "board.yaml", SECOND, SECOND + third)
    suite_is_green(project, PROGRAM)
    values = parameters_of(project)
    firsts = {name.removeprefix("BATT_") for name in values if name.startswith("BATT_VOLT")}
    assert firsts
    assert firsts <= {name.removeprefix("BATT3_") for name in values}
    assert values["BATT3_MONITOR"] == 0
    assert values["BATT3_VOLT_PIN"] == 28
    assert values["BATT3_LOW_VOLT"] == pytest.approx(7.0)
    assert values["BATT_LOW_VOLT"] == pytest.approx(10.5)


@pytest.mark.requirement("FR-00073.9")
def test_one_more_cell_is_one_number(project):
    """The thresholds of both batteries rise by what one cell has (a divider for them is another matter)."""
    apply(project, "board.yaml", "    cells: 3\n", "    cells: 4\n")
    run(project, "build")
    values = parameters_of(project)
    for prefix in ("BATT_", "BATT2_"):
        assert values[f"{prefix}LOW_VOLT"] == pytest.approx(14.0)
        assert values[f"{prefix}CRT_VOLT"] == pytest.approx(13.2)
    firmware = project / "generated" / "firmware"
    assert "> 17333 and" in (firmware / "state_plain.py").read_text(), "13 V of three cells is what a full pack has"
    assert "# nominal_voltage: 14.8 V" in (firmware / "telemetry_plain.py").read_text()


def test_batteries_that_are_on_with_more_cells(project):
    """Three packs of 4, 2 and 4 cells, all on by default: the generated suite holds.

    The ADC shows 13 V at most, less than four cells are low at: the checks bring thresholds that they can pass.
    """
    third = "    - {prefix: BATT3_, doc: A third pack., defaults: {BATT3_VOLT_PIN: 28}}\n"
    on = "      defaults: {BATT2_VOLT_PIN: 27}\n      facts: {cells: 2}\n"
    apply(project, "board.yaml", SECOND, on + third)
    apply(project, "board.yaml", "    cells: 3\n", "    cells: 4\n")
    suite_is_green(project, f"micropython and (behaviour or {ANYWHERE})")
    state = (project / "generated" / "firmware" / "state.py").read_text()
    assert "        _BATTERY_WARN_ABOVE,\n        (17333, 8667, 17333),\n" in state


def test_fewer_cells_are_one_number(whole_project):
    """One cell, and the smart battery with four: what the suite starts from is not worth a warning."""
    apply(whole_project, "board.yaml", "    cells: 3\n", "    cells: 1\n")
    apply(whole_project, "smart_battery/board.yaml", "    cells: 3\n", "    cells: 4\n")
    suite_is_green(whole_project, "cpython and (behaviour or good_count)")
    state = (whole_project / "generated" / "smart_battery" / "firmware" / "state_plain.py").read_text()
    assert "> 17333 and" in state


def test_both_generations_by_default(project):
    """The suite knows that a battery which comes back is told of by the info of both then."""
    apply(project, "streams.yaml", "parameter: BATT_REPORT", "send: both")
    suite_is_green(project, "micropython and (return or announcement or generation)")


@pytest.mark.long
@pytest.mark.requirement("FR-00073.1", "FR-00073.4", "FR-00073.10")
def test_sixteen_packs(project):
    """The converter has no pins for them: code sets what other systems measure, in the suite and in a simulation."""
    entry = "    - {{prefix: {0}, doc: A pack on a bus., defaults: {{{0}MONITOR: 29}}}}\n"
    packs = "".join(entry.format(f"BATT{mark}_") for mark in "3456789ABCDEFG")
    apply(project, "board.yaml", SECOND, SECOND + packs)
    suite_is_green(project, "micropython-arming or micropython-instance")
    courses = {place: f"points: [[0 s, 12 V], [20 s, {11 + place / 10:.1f} V]]" for place in range(2, 16)}
    lines = ["scenarios:", "  bus:", "    doc: Sixteen packs.", "    duration: 30 s", "    courses:"]
    lines += ["      battery.voltage: {value: 12 V}"]
    lines += [f"      battery[{place}].voltage: {{{points}}}" for place, points in courses.items()]
    lines += ["    events:", "      - {at: 22 s, fault: fail, of: 'battery[15].voltage', for: 8 s}", "    expect:"]
    for place in courses:
        value = 11 + place / 10
        between = f"[{value - 0.1:.1f} V, {value + 0.1:.1f} V]"
        lines.append(f"      - {{at: 21 s, told: 'battery[{place}].voltage', between: {between}}}")
    lines.append("      - {text: Battery 16 health}")
    scenario = project / "packs.yaml"
    scenario.write_text("\n".join(lines) + "\n", encoding="utf-8")
    done = run(project, "sim", str(scenario), "--speed", "max", "--out", "udp:127.0.0.1:9")
    assert "The failsafe did not fire." in done
    assert "warning   Battery 16 health: unhealthy" in done
