"""The constants with places of words: each has a name of its own, whatever components and quantities are called.

MicroPython refuses a module in which a constant is set twice, and CPython takes the second one for both.
"""

import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest
from in_process import build, codegen

from codegen.targets.firmware.words import OWN_CONSTANTS

ROOT = Path(__file__).resolve().parents[2]
TEMPLATES = ROOT / "templates" / "firmware"
HOLDERS = ("state", "sources", "state_plain", "state_viper", "telemetry_plain", "telemetry_viper", "further_reading")
IN_PROGRAM = ("receiving_plain", "receiving_viper", "vehicle")

LEVEL = "{doc: A level., unit: m, stored: cm, min: 0, max: 100, stale_after: 1 s}"
STATE = f"""\
components:
  vehicle:
    doc: The vehicle.
    quantities:
      status: {{doc: What it does., enum: MAV_STATE, initial: MAV_STATE_ACTIVE}}
      size: {{doc: A name of the firmware., boolean: true, initial: false}}
  tank: {{doc: A tank., quantities: {{aft_level: {LEVEL}, aft: {{doc: A flag., boolean: true, initial: false}}}}}}
  tank_aft: {{doc: Another one., quantities: {{level: {LEVEL}}}}}
  tank_size: {{doc: Another one., quantities: {{level: {LEVEL}}}}}
  size: {{doc: Another one., quantities: {{level: {LEVEL}}}}}
  unknown: {{doc: Another one., quantities: {{level: {LEVEL}}}}}
  aged: {{doc: Another one., quantities: {{level: {LEVEL}}}}}
"""
PATHS = ("tank.aft_level", "tank_aft.level", "tank_size.level", "size.level", "unknown.level", "aged.level")
MESSAGE = """\
message: DISTANCE_SENSOR
as: {name}
requirement: FR-1.2
stream: PRESENCE
send: while_known
others: unknown
fields:
  time_boot_ms: {{clock: boot}}
  min_distance: {{constant: 0 m}}
  max_distance: {{constant: 100 m}}
  current_distance: {{state: {path}}}
  type: {{enum: MAV_DISTANCE_SENSOR_LASER}}
  id: {{constant: {id}}}
  orientation: {{enum: MAV_SENSOR_ROTATION_NONE}}
"""
SCRIPT = """\
import sys
sys.path[:0] = ["mocks", "firmware"]
import mock_time
mock_time.install()
import telemetry
from state import SystemState
state = SystemState()
paths = {paths}
for number, path in enumerate(paths):
    component, name = path.split(".")
    setattr(getattr(state, component), name, number + 1)
print([getattr(telemetry, f"build_from_{number}")(state).current_distance for number in range(len(paths))])
"""


@pytest.fixture(scope="module")
def output(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project whose names run into each other, and into those of the firmware."""
    folder = tmp_path_factory.mktemp("names")
    codegen(folder, "init", "--dialect", "common")
    for path in ("app.py", "specs/messages/level.yaml", "specs/vehicle.yaml", "specs/scenarios.yaml"):
        (folder / path).unlink()
    streams = folder / "specs" / "streams.yaml"
    streams.write_text(streams.read_text().partition("  TANK:")[0])
    (folder / "specs" / "state.yaml").write_text(STATE)
    for number, path in enumerate(PATHS):
        name = f"from_{number}"
        text = MESSAGE.format(name=name, path=path, id=number)
        (folder / "specs" / "messages" / f"{name}.yaml").write_text(text)
    build(folder)
    return folder / "generated"


def test_no_module_sets_a_constant_twice(output: Path) -> None:
    for module in (output / "firmware").glob("*.py"):
        counts = Counter(re.findall(r"^(_[A-Z]\w*) = ", module.read_text(), re.MULTILINE))
        assert [name for name, count in counts.items() if count > 1] == [], module.name


@pytest.mark.parametrize("interpreter", [sys.executable, str(Path(sys.executable).with_name("micropython"))])
def test_each_quantity_goes_out_as_itself(output: Path, interpreter: str) -> None:
    """1 m in the first, 2 m in the second, and so on."""
    script = SCRIPT.replace("{paths}", repr(PATHS))
    done = subprocess.run([interpreter, "-c", script], capture_output=True, text=True, cwd=output, check=False)
    assert done.stdout.strip() == str([100 * (number + 1) for number in range(len(PATHS))]), done.stderr


def test_what_templates_name_is_known() -> None:
    """A constant of such a module's template that is not among those which are kept free can be set twice."""
    names = [*(f"{name}.py.j2" for name in HOLDERS), *(f"program/{name}.py.j2" for name in IN_PROGRAM)]
    paths = [TEMPLATES / name for name in (*names, "reading_places.j2", "streams.py.j2")]
    found = {name for path in paths for name in re.findall(r"(?<![A-Za-z])n?(_[A-Z][A-Z_0-9]*) = ", path.read_text())}
    assert found >= {"_SIZE", "_AGED", "_UNKNOWN"}
    assert found - OWN_CONSTANTS == set()
