"""A course says what is true in the unit of its quantity, whatever unit the firmware keeps that in."""

import json
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from in_process import build

from codegen.derivations.set_by_code import set_by_code
from codegen.diagnostics import Report
from codegen.model.scenario import Expectation
from codegen.project.systems import read_system
from codegen.sim.expected import unmet

MINIMAL = Path(__file__).resolve().parents[1] / "projects" / "minimal" / "specs"
DIALECT = """\
<?xml version="1.0"?>
<mavlink>
  <include>minimal.xml</include>
  <messages>
    <message id="52000" name="WEATHER">
      <description>d</description>
      <field type="float" name="pressure" units="hPa" invalid="NaN">d</field>
      <field type="float" name="rain" units="mm" invalid="NaN">d</field>
      <field type="double" name="depth" units="mm" invalid="NaN">d</field>
      <field type="float" name="wind" units="m/s" invalid="NaN">d</field>
      <field type="int16_t" name="water" units="cdegC" invalid="INT16_MIN">d</field>
      <field type="int32_t" name="lat" units="degE7" invalid="INT32_MAX">d</field>
    </message>
  </messages>
</mavlink>
"""
QUANTITIES = """\
  air:
    doc: d
    quantities:
      pressure: {doc: d, unit: Pa, min: 30000, max: 110000}
      rain: {doc: d, unit: m}
      depth: {doc: d, unit: m}
      wind: {doc: d, unit: m/s}
      water: {doc: d, unit: degC, stored: cdegC}
      lat: {doc: d, unit: deg, stored: degE7, min: -90, max: 90}
"""
TRUE = {"pressure": 101325.0, "rain": 0.0015, "depth": 12.5, "wind": 3.25, "water": 12.34, "lat": 54.25}
SCRIPT = """
import json, sys
sys.path[:0] = ["generated/firmware", "generated/mocks"]
from sim_state import connect
from state import SystemState

class Course:
    every_ms = 100
    def __init__(self, value, settings):
        self.value, self.settings = value, settings
    def fault(self, kind, at_ms):
        return None
    def seen(self, at_ms):
        return self.value

class Vehicle:
    told = []
    state = SystemState(log=told.append)

given = json.loads(open("given.json").read())
connect([Course(*each) for each in given.values()], None, 0)(0, Vehicle)
print(json.dumps([Vehicle.told, {name: getattr(Vehicle.state.air, name) for name in given}]))
"""


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_a_course_sets_the_unit_of_its_quantity(interpreter: str, tmp_path: Path) -> None:
    """Floats that are kept in the unit of their field, of 32 and 64 bits, and whole steps."""
    specs = Path(shutil.copytree(MINIMAL, tmp_path / "specs"))
    (specs / "dialects").mkdir()
    (specs / "dialects" / "weather.xml").write_text(DIALECT)
    (specs / "codegen.yaml").write_text("project: weather\ndialect: dialects/weather.xml\nmachine_code: false\n")
    fields = "".join(f"  {name}: {{state: air.{name}}}\n" for name in TRUE)
    table = f"message: WEATHER\nrequirement: FR-1\nstream: only\nfields:\n{fields}"
    (specs / "messages" / "weather.yaml").write_text(table)
    (specs / "state.yaml").write_text((MINIMAL / "state.yaml").read_text() + QUANTITIES)
    build(tmp_path)
    system = read_system(str(specs / "codegen.yaml"), Report())
    assert system is not None
    quantities = system.components["air"].quantities
    assert quantities["pressure"].stored.name == "hPa"
    given = {name: [value, dict(set_by_code(quantities[name], 0).settings)] for name, value in TRUE.items()}
    (tmp_path / "given.json").write_text(json.dumps(given))
    mocks = Path(__file__).resolve().parents[2] / "templates" / "mocks"
    shutil.copy(mocks / "sim_state.py", tmp_path / "generated" / "mocks" / "sim_state.py")
    command = [str(Path(sys.executable).parent / interpreter), "-c", SCRIPT]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert not done.returncode, done.stderr
    told, found = json.loads(done.stdout)
    assert told == []
    assert found == pytest.approx(TRUE, rel=1e-6)


@pytest.mark.parametrize(
    ("found", "unit", "said"),
    [(117600, "mJ", "it is 117600 mJ."), (1.5, "V", "it is 1.5 V."), (4, "", "it is 4."), (True, "", "it is true.")],
)
def test_what_was_found_has_its_unit(found: Any, unit: str, said: str) -> None:
    """Whole numbers, too, which are amounts where their quantity has a unit."""
    expectation = Expectation(label="a.b", written="state a.b is 7", at_ms=None, value=7)
    program = SimpleNamespace(lines=[SimpleNamespace(label="a.b", unit=unit)])
    scenario = SimpleNamespace(expected=[expectation])
    recording: Any = SimpleNamespace(at_ms=1000, program=program, scenario=scenario, state=lambda *_: found)
    assert unmet(recording) == [f"Expected state a.b is 7: {said}"]
