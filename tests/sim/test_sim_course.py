"""A course of a scenario in the mocks: the same under both interpreters, and exact; and what an ADC makes of it."""

import json
import os
import random
import subprocess
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from packs import FULL, ROOT, pack

from codegen.derivations.set_by_code import set_by_code
from codegen.diagnostics import Report
from codegen.model.quantities.simulated import SimulatedInput
from codegen.model.scenario import Course, Fault, Point, course_data, event_data
from codegen.project.systems import read_system
from codegen.resolve.scenarios.values import ScenarioValues
from codegen.sim.process import Runtime, find_interpreter

MOCKS = Path(__file__).resolve().parents[2] / "templates" / "mocks"

SCRIPT = """
import json, sys
import sim_adc
from sim_course import Course
with open(sys.argv[1]) as file:
    data, faults, times = json.loads(file.read())
course = Course(data, faults)
full = data["settings"]["full"]
found = []
for at in times:
    seen = course.seen(at)
    found.append([course.value(at), seen, None if not isinstance(seen, (int, float)) else sim_adc.count(seen / full)])
print(json.dumps(found))
"""


def readings(
    tmp_path: Path,
    runtime: str,
    course: Course,
    times: list[int],
    *faults: Fault,
    seed: int = 1,
    script: str = SCRIPT,
) -> list[Any]:
    """Return the truth, the result of one look and the count of an ADC, at each time."""
    interpreter = find_interpreter(Runtime(runtime))
    assert interpreter is not None
    file, data = tmp_path / "script.py", tmp_path / "data.json"
    file.write_text(script)
    data.write_text(json.dumps([course_data(course, seed), [event_data(fault) for fault in faults], times]))
    environment = {**os.environ, "MICROPYPATH": str(MOCKS), "PYTHONPATH": str(MOCKS), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [interpreter, str(file), str(data)]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60, check=True)
    found: list[Any] = json.loads(done.stdout)
    return found


@pytest.mark.parametrize("runtime", Runtime)
def test_values_and_counts_are_exact(tmp_path: Path, runtime: str) -> None:
    """Against exact arithmetic, forwards and backwards in time; the host has the same values."""
    rolls = random.Random(5)
    points = [(0, 12.6), (1_000, 12.345), (1_000, 9.0), (77_777, 13.033), (90_000, 0.0), (99_000, 20.0)]
    course = pack(*points)
    times = [0, 1, 999, 1_000, 1_001, 89_999, 98_999, 99_000, 200_000, *(rolls.randrange(100_000) for _ in range(200))]
    for at_ms, (true, _, count) in zip(times, readings(tmp_path, runtime, course, times), strict=True):
        before = [point for point in points if point[0] <= at_ms][-1]
        after = next((point for point in points if point[0] > at_ms), before)
        share = Fraction(at_ms - before[0], after[0] - before[0] or 1)
        exact = Fraction(before[1]) + share * (Fraction(after[1]) - Fraction(before[1]))
        assert true == pytest.approx(float(exact), rel=1e-12)
        assert course.value(at_ms) == pytest.approx(true, rel=1e-12)
        counts = exact / Fraction("3.3") / Fraction("3.95") * 4095
        assert abs(count - min(counts, 4095)) <= Fraction(1, 2) + Fraction(1, 10**9)


@pytest.mark.parametrize("runtime", Runtime)
def test_what_is_no_number_changes_in_steps(tmp_path: Path, runtime: str) -> None:
    """Booleans, texts, entries; unknown holds until a value is known again, and nothing leads there in a line."""
    course = pack((0, 1.0), (10, None), (20, 3.0), (30, 5.0))
    times = [0, 5, 9, 10, 15, 20, 25, 30]
    assert [true for true, _, _ in readings(tmp_path, runtime, course, times)] == [1, 1, 1, None, None, 3, 4, 5]
    assert [course.value(at_ms) for at_ms in times] == [1, 1, 1, None, None, 3, 4, 5]
    for first, second in ((True, False), ("one", "two")):
        course = pack((0, first), (10, second))  # type: ignore[arg-type]
        assert [true for true, _, _ in readings(tmp_path, runtime, course, [0, 9, 10])] == [first, first, second]


def test_noise_is_the_same_everywhere_and_within_its_limit(tmp_path: Path) -> None:
    times = list(range(0, 4_000, 2))
    noisy = pack((0, 12.0), noise=0.1)
    first, again, other = (
        readings(tmp_path, runtime, noisy, times) for runtime in ("cpython", "cpython", "micropython")
    )
    assert first == again
    assert [count for _, _, count in first] == [count for _, _, count in other]
    assert readings(tmp_path, "cpython", noisy, times, seed=2) != first
    deviations = {seen - 12 for _, seen, _ in first}
    assert max(deviations) <= 0.1 + 1e-9
    assert min(deviations) >= -0.1 - 1e-9
    assert len(deviations) > 40
    assert abs(sum(seen - 12 for _, seen, _ in first) / len(first)) < 2 / 4095 * FULL
    assert {true for true, _, _ in first} == {12.0}, "what is true has no noise"


def test_what_is_stuck_stays_as_it_was(tmp_path: Path) -> None:
    """With its noise, until the fault is over; another quantity's fault does not matter."""
    course = pack((0, 10.0), (100, 20.0), noise=0.01)
    faults = (Fault(20, "stuck", course.label, 60, "stays"), Fault(0, "stuck", "gps.lat", None, "stays"))
    found = readings(tmp_path, "micropython", course, [10, 20, 40, 59, 60, 80], *faults)
    seen = [round(value, 1) for _, value, _ in found]
    assert seen == [11.0, 12.0, 12.0, 12.0, 16.0, 18.0]
    assert found[1][1] == found[3][1]


INPUT = """
import json, sys
import machine
import sim_adc
from sim_course import Course
with open(sys.argv[1]) as file:
    data, faults, times = json.loads(file.read())
now = [0]
sim_adc.connect([Course(data, faults)], lambda: now[0], 0)
found = []
for now[0] in times:
    try:
        found.append(machine.analog(27).read_count())
    except OSError:
        found.append(None)
print(json.dumps(found))
"""


@pytest.mark.parametrize("runtime", Runtime)
def test_an_adc_counts_from_what_zero_volts_stand_for(tmp_path: Path, runtime: str) -> None:
    """A sensor of -50 to 50 A: 0 A are half of full scale; beyond it the end; no count in a fault."""
    through = SimulatedInput("adc", {"gpio": 27, "zero": -50.0, "full": 50.0})
    points = (Point(0, 0.0), Point(1_000, 50.0), Point(2_000, -25.0), Point(3_000, 80.0), Point(4_000, None))
    course = Course("power.current", points, through)
    fault = Fault(500, "fail", course.label, 600, "fails")
    found = readings(tmp_path, runtime, course, [0, 500, 600, 1_000, 2_000, 2_999, 4_000], fault, script=INPUT)
    assert found == [2048, None, 3276, 4095, 1024, 4095, None]


WHOLE = """
import json, sys
import sim_state
from sim_course import Course
with open(sys.argv[1]) as file:
    data = json.loads(file.read())

class State:
    pass

state = State()
state.lens = [State()]
sim_state.Setter(Course(data, [])).set(0, state)
print(json.dumps(str(state.lens[0].shots)))
"""


@pytest.mark.parametrize("runtime", Runtime)
@pytest.mark.parametrize("text", ["18446744073709551613", "9007199254740993", "-9223372036854775806", "7", "2.5"])
def test_a_whole_number_of_64_bits_is_set_as_it_is(tmp_path: Path, runtime: Runtime, text: str) -> None:
    """A float in between would be another one; what is no whole number is rounded."""
    system = read_system(str(ROOT / "tests" / "projects" / "wide_values" / "specs" / "codegen.yaml"), Report())
    assert system is not None
    quantity = system.components["meter"].quantities["big"]
    values = ScenarioValues(Report(), {})
    found = values.truth(text, quantity, quantity.spec.place)
    assert found is not None
    through = set_by_code(quantity, 0)
    through = replace(through, settings={**through.settings, "component": "lens", "attribute": "shots"})
    data = tmp_path / "data.json"
    data.write_text(json.dumps(course_data(Course("lens.shots", (Point(0, *found),), through), 1)))
    (tmp_path / "set.py").write_text(WHOLE)
    path = {"MICROPYPATH": str(MOCKS), "PYTHONPATH": str(MOCKS)}
    command = [find_interpreter(runtime), str(tmp_path / "set.py"), str(data)]
    done = subprocess.run(command, env={**os.environ, **path}, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == ("3" if text == "2.5" else text)


LEFT_OUT = """
import json
import sys
import sim


class Module:
    Vehicle = "the plain one"


sim.leave_out("thermometer", None)
sim.leave_out("json", None)
sim.leave_out("boat", "Boat")
sys.modules["vehicle"] = Module
import boat
assert boat.Boat == "the plain one"
try:
    __import__("thermometer", None, None, ["Thermometer"]).Thermometer()
except ImportError as error:
    print(json.dumps(str(error)))
"""


@pytest.mark.parametrize("runtime", Runtime)
def test_code_that_is_left_out_says_so(tmp_path: Path, runtime: Runtime) -> None:
    """Its module lies in the folder of the project: that there is none would be untrue. What is there is imported.

    The vehicle runs without the code of the user that stands in the same module.
    """
    (tmp_path / "left.py").write_text(LEFT_OUT)
    path = {"MICROPYPATH": f".frozen:{MOCKS}", "PYTHONPATH": str(MOCKS)}
    command = [find_interpreter(runtime), str(tmp_path / "left.py")]
    done = subprocess.run(command, env={**os.environ, **path}, capture_output=True, text=True, check=True)
    assert done.stdout == '"it has no course, and code is left out"\n'
