"""Fields that are coarser than what is kept: up to its declared limits each value goes out as the nearest step.

A limit may lie between two steps of the field. Only what lies beyond it is counted and told, by the limit itself; and
a receiver takes the step that the limit is rounded to for a value.
"""

import json
import math
import runpy
import shutil
import struct
import subprocess
import sys
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

import pytest
from generated_suite import COMMON, suite_is_green
from in_process import build, codegen

from codegen.diagnostics import Report
from codegen.project.systems import read_system
from codegen.rules.source_beyond import check

MINIMAL = Path(__file__).resolve().parent / "minimal" / "specs"
READINGS = Path(__file__).resolve().parents[2] / "templates" / "receiver" / "readings.py"
DIALECT = """\
<?xml version="1.0"?>
<mavlink>
  <include>minimal.xml</include>
  <messages>
    <message id="52000" name="COARSE">
      <description>d</description>
      <field type="int32_t" name="trend" units="Pa/s" multiplier="1E-3" invalid="INT32_MAX">d</field>
      <field type="int16_t" name="heading" units="deg" invalid="INT16_MAX">d</field>
      <field type="int8_t" name="cold" units="degC" invalid="INT8_MIN">d</field>
      <field type="uint8_t" name="dir" units="deg" multiplier="360/255">d</field>
      <field type="int8_t" name="floor" units="degC" invalid="INT8_MIN">d</field>
      <field type="uint16_t[4]" name="cells" units="cV" invalid="[UINT16_MAX]">d</field>
    </message>
  </messages>
</mavlink>
"""
TABLE = """\
message: COARSE
requirement: FR-1
stream: only
fields:
  trend: {state: it.trend}
  heading: {state: it.heading}
  cold: {state: it.cold}
  dir: {state: it.dir}
  floor: {state: it.floor, rounding: down}
  cells: {state: it.sum, split: true}
"""
QUANTITIES = """\
  it:
    doc: d
    quantities:
      trend: {doc: d, unit: hPa/h, stored: Pa/h, min: -10000, max: 10000}
      heading: {doc: d, unit: rad, stored: mrad, min: 0, max: 6.283}
      cold: {doc: d, unit: degC, stored: ddegC, min: -50.6, max: 50.4}
      dir: {doc: d, unit: deg, stored: ddeg, min: 0, max: 359.9, initial: 0}
      floor: {doc: d, unit: degC, stored: ddegC, min: -20.4, max: 50.4}
      sum: {doc: d, unit: V, stored: mV, min: 0, max: 5.007}
"""
SCRIPT = """
import json, sys, time
sys.path[:0] = ["generated/firmware", "generated/mocks", "generated/tests"]
if not hasattr(time, "ticks_ms"):
    time.ticks_ms = lambda: 0
import telemetry
from mavlink import Link
from state import SystemState
for name, attribute, steps in json.loads(open("given.json").read()):
    told = []
    state, link = SystemState(log=told.append), Link(None)
    setattr(state.it, attribute, steps)
    frame = bytes(telemetry.encode_coarse(link, state))
    print(json.dumps([frame.hex(), told, state.it.limited.get(attribute.split("_")[0], 0)]))
"""
HEAP = {"python": [], "micropython": ["-X", "heapsize=8m"]}
FACTORS = {
    "trend": Fraction(1000, 3600),
    "heading": Fraction(180 / math.pi) / 1000,
    "cold": Fraction(1, 10),
    "dir": Fraction(255, 3600),
    "floor": Fraction(1, 10),
    "cells": Fraction(1, 10),
}
KEPT = {"trend": "pa_h", "heading": "mrad", "cold": "ddegc", "dir": "ddeg", "floor": "ddegc", "cells": "mv"}
LIMITS = {
    "trend": (-1000000, 1000000, "10000"),
    "heading": (0, 6283, "6.283"),
    "cold": (-506, 504, "50.4"),
    "dir": (0, 3599, "359.9"),
    "floor": (-204, 504, "50.4"),
    "cells": (0, 5007, "5.007"),
}


def nearest(name: str, steps: int) -> int:
    """Return what a value within the limits goes out as: the nearest step, or the one below."""
    exact = steps * FACTORS[name]
    if name == "floor":
        return math.floor(exact)
    return math.floor(exact + Fraction(1, 2)) if exact >= 0 else math.ceil(exact - Fraction(1, 2))


def specs_in(folder: Path) -> Path:
    """Write the project into a folder; return its specifications."""
    specs = Path(shutil.copytree(MINIMAL, folder / "specs"))
    (specs / "dialects").mkdir()
    (specs / "dialects" / "coarse.xml").write_text(DIALECT)
    (specs / "codegen.yaml").write_text("project: coarse\ndialect: dialects/coarse.xml\nmachine_code: false\n")
    (specs / "messages" / "coarse.yaml").write_text(TABLE)
    (specs / "state.yaml").write_text((MINIMAL / "state.yaml").read_text() + QUANTITIES)
    return specs


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which the project is built."""
    folder = tmp_path_factory.mktemp("coarse")
    specs_in(folder)
    build(folder)
    return folder


def sent(project: Path, interpreter: str, given: Sequence[tuple[str, int]]) -> list[tuple[int, list[str], int]]:
    """Return of each what goes out, what is told, and how often it was counted."""
    names = {"cells": "sum"}
    rows = [(name, f"{names.get(name, name)}_{KEPT[name]}", steps) for name, steps in given]
    (project / "given.json").write_text(json.dumps(rows))
    command = [str(Path(sys.executable).parent / interpreter), *HEAP[interpreter], "-c", SCRIPT]
    done = subprocess.run(command, cwd=project, capture_output=True, text=True, check=False)
    assert not done.returncode, done.stderr
    found = []
    for (name, _), (frame, told, count) in zip(given, map(json.loads, done.stdout.splitlines()), strict=True):
        payload = bytes.fromhex(frame)[10:-2].ljust(17, b"\0")
        trend, heading, cells, _, _, _, cold, side, floor = struct.unpack("<ihHHHHbBb", payload)
        fields = {"trend": trend, "heading": heading, "cold": cold, "dir": side, "floor": floor, "cells": cells}
        found.append((fields[name], told, count))
    return found


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_every_value_within_the_limits_is_the_nearest_step(project: Path, interpreter: str) -> None:
    """And nothing is told of it."""
    given = [
        (name, steps)
        for name, (low, high, _) in LIMITS.items()
        for steps in (*range(low, low + 40), *range(low, high, max(1, (high - low) // 97)), *range(high - 40, high + 1))
    ]
    found = sent(project, interpreter, given)
    expected = [(nearest(name, steps), [], 0) for name, steps in given]
    assert [pair for pair in zip(given, found, expected, strict=True) if pair[1] != pair[2]] == []


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_what_is_beyond_is_told(project: Path, interpreter: str) -> None:
    """The limit goes out in place of it, and is what the text says."""
    given = [(name, high + more) for name, (_, high, _) in LIMITS.items() for more in (1, 5, 10**6)]
    names = {"cells": "sum"}
    expected = [
        (nearest(name, LIMITS[name][1]), [f"warning: it.{names.get(name, name)} beyond {LIMITS[name][2]}: limited"], 1)
        for name, _ in given
    ]
    assert sent(project, interpreter, given) == expected


def test_the_suite_of_the_project_passes(project: Path) -> None:
    """Its cases have the same limits. What every project has alike is run by test_projects.py."""
    suite_is_green(project, "generated/tests", only=f"not (test_program and (cpython or {COMMON}))")


def test_a_receiver_takes_the_step_of_the_limit(project: Path) -> None:
    """360 degrees are a little more than 6.283 rad, and what that is sent as; 361 is nothing that it can be."""
    system = read_system(str(project / "specs" / "codegen.yaml"), Report())
    assert system is not None
    message = next(each for each in system.messages if each.name == "COARSE")
    functions = runpy.run_path(str(READINGS))
    for name, (low, high, _) in LIMITS.items():
        if name == "cells":
            continue
        answer = next(each for each in message.answers if each.covers.field.name == name)
        (reading,) = answer.readings(system.components["it"], system.dialect)
        for steps, is_taken in ((low, True), (high, True), (high + 400 / FACTORS[name], False)):
            wire = nearest(name, int(steps))
            got = eval(reading.expression, {**functions, "get": lambda _, wire=wire: wire})  # noqa: S307
            assert (got is not None) == is_taken, (name, steps, reading.expression)


def test_what_is_rounded_to_a_number_that_the_field_does_not_have_is_an_error(tmp_path: Path) -> None:
    """127.4 is 127, and 127.5 would be 128."""
    specs = specs_in(tmp_path)
    text = (specs / "state.yaml").read_text()
    for most, code in (("127.4", 0), ("127.5", 1)):
        (specs / "state.yaml").write_text(text.replace("min: -50.6, max: 50.4", f"min: -50.6, max: {most}"))
        done = codegen(tmp_path, "check")
        assert done.returncode == code, done.stdout
        assert ("error beyond-field: it.cold goes up to 127.5 degC, and cold (int8_t)" in done.stdout) == bool(code)


def test_limits_of_a_sensor_may_lie_between_two_steps_as_well(tmp_path: Path) -> None:
    """Whatever the field rounds to: only what it cannot carry is beyond it."""
    specs = specs_in(tmp_path)
    state = (specs / "state.yaml").read_text()
    for name, unit, stored, low, high in (
        ("cold", "degC", "ddegC", -50.6, 50.4),
        ("floor", "degC", "ddegC", -20.4, 50.4),
    ):
        written = f"{name}: {{doc: d, unit: {unit}, stored: {stored}, min: {low}, max: {high}}}"
        assert written in state
        state = state.replace(written, f"{name}: {{doc: d, unit: {unit}, source: probe.{name}, invalid_after: 2}}")
    (specs / "state.yaml").write_text(state)
    kept = "unit: degC, stored: ddegC"
    outputs = f"cold: {{{kept}, min: -50.6, max: 50.4}}, floor: {{{kept}, min: LOW, max: 50.4}}"
    board = f"board: odd\nsources:\n  probe: {{driver: user, class: probe.Probe, outputs: {{{outputs}}}}}\n"
    for low, expected in (("-20.4", []), ("-128.5", ["source-beyond-limits"])):
        (specs / "board.yaml").write_text(board.replace("LOW", low))
        report = Report()
        system = read_system(str(specs / "codegen.yaml"), report)
        assert system is not None
        assert [found.rule.id for found in check(system)] == expected
