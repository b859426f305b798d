"""The floats of the new battery messages are whole numbers until they are on the wire: none is made for them."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from whole_program import whole_program

from codegen.diagnostics import Report
from codegen.project.systems import read_systems

ROOT = Path(__file__).resolve().parents[2]
GENERATED = ROOT / "generated"
PROJECTS = ROOT / "tests" / "projects"

# All that was ever allocated is counted: a locked heap does not show the variables of large functions. And with the
# collector switched off what is in use may not grow. What runs in between makes no object of its own.
SCRIPT = """
import gc
import mock_time
mock_time.install()
from mavlink import Link
from micropython import mem_total
from state import SystemState
import telemetry

class Sink:
    def write(self, frame):
        return len(frame)

VALUES = (None, 0, 1, -1, 99, 100, 101, 12399, -12401, 16777217, 33554435, 999999999, 1073741823, -1073741823)
link = Link(Sink())
state = SystemState(log=lambda *words: None)
battery = state.battery[0]

def set_all(value):
    battery.voltage_mv = battery.current_ma = battery.consumed_mah = battery.left_mah = value
    battery.remaining_pct = battery.temperature_cdegc = value
    state.parameters.batt_capacity = 3300 if value is None else value

def build(instance):
    link.send(telemetry.build_battery_status_v2(state, instance))
    link.send(telemetry.build_battery_info(state, instance))

aside = [0, 0]

def tell(value):  # what is beyond its limits is told, which takes memory: once
    before = mem_total()
    used = gc.mem_alloc()
    set_all(value)
    aside[1] += gc.mem_alloc() - used
    aside[0] += mem_total() - before

def build_and_send():
    for value in VALUES:
        tell(value)
        set_all(value)
        build(0)
        build(1)

def counted():
    build_and_send()
    gc.collect()
    gc.disable()
    aside[0] = aside[1] = 0
    before = mem_total()
    used = gc.mem_alloc()
    build_and_send()
    more = gc.mem_alloc() - aside[1]
    return mem_total() - before - aside[0], more - used

allocated, more = counted()
is_plain = telemetry.build_battery_info is __import__("telemetry_plain").build_battery_info
print(is_plain, allocated, more, link.sequence, link.tx_errors)
"""


@pytest.mark.parametrize("form", ["viper", "plain"])
def test_new_messages_allocate_nothing(form: str, tmp_path: Path) -> None:
    """Unknown, limits and numbers of more than 24 bits, each battery; in machine code and in plain Python."""
    whole_program(GENERATED, tmp_path)
    for path in (tmp_path / "firmware").glob("*_viper.py") if form == "plain" else ():
        path.unlink()
    (tmp_path / "script.py").write_text(SCRIPT)
    path = os.pathsep.join([str(tmp_path / "firmware"), str(tmp_path / "mocks")])
    command = [str(Path(sys.executable).with_name("micropython")), str(tmp_path / "script.py")]
    environment = {**os.environ, "MICROPYPATH": path}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.split() == [str(form != "viper"), "0", "0", str(2 * 14 * 4), "0"]


def findings(specs: Path) -> list[tuple[str, str, str | None]]:
    """Return the findings in a specification: rule, message and hint."""
    report = Report()
    read_systems(str(specs / "codegen.yaml"), report)
    return [(one.rule.id, one.message, one.hint) for one in report]


def test_nothing_is_found_in_the_shipped_specification() -> None:
    """No warning, so that a build of what is unchanged has nothing to repeat, and need not run."""
    assert findings(ROOT / "specs") == []


def test_no_float_has_to_be_made() -> None:
    """Doubles, products that no small integer holds, and divisors: whole numbers of several words make them all."""
    assert findings(PROJECTS / "float_fields" / "specs") == []


def test_what_no_whole_numbers_make_is_an_error(tmp_path: Path) -> None:
    """A tenth of a picosecond is too small a part of a minute: at the field, with the unit in which it would go."""
    shutil.copytree(PROJECTS / "float_fields" / "specs", tmp_path / "specs")
    with (tmp_path / "specs" / "parameters.yaml").open("a") as file:
        file.write("\n  TINY: {doc: A time., unit: ns, default: 1, min: 0, max: 1000, step: 0.0001}\n")
    table = tmp_path / "specs" / "messages" / "with_floats.yaml"
    text = table.read_text()
    assert "{state: meter.running}" in text
    table.write_text(text.replace("{state: meter.running}", "{parameter: TINY}"))
    found = [each for each in findings(tmp_path / "specs") if each[0] == "beyond-float"]
    says = "WITH_FLOATS.running is a float, and one step is 1/600000000000000 of it"
    assert found == [("beyond-float", says, "keep it in min")]
