"""Projects with a receiver, built where tests can change them, and their code run by either interpreter."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from in_process import build

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BIN = Path(sys.executable).parent

INFO = """\
message: SMART_BATTERY_INFO
requirement: FR-1
for_each: pack
stream: SLOW
fields:
  id: {state: pack.instance}
  battery_function: {enum: MAV_BATTERY_FUNCTION_PROPULSION}
  type: {board: pack.chemistry}
  capacity_full_specification: {parameter: BATT_CAPACITY}
  capacity_full: {parameter: BATT_CAPACITY}
  cycle_count: {state: house.cycles, max: 65534}
  serial_number: {board: pack.serial}
  device_name: {constant: two packs}
  weight: {board: pack.weight}
  discharge_minimum_voltage: {constant: 18.6 V}
  charging_minimum_voltage: {constant: 18600}
  resting_minimum_voltage: unknown
  charging_maximum_voltage: {constant: 25200}
  cells_in_series: {board: pack.cells}
  discharge_maximum_current: {constant: 30 A}
  discharge_maximum_burst_current: {constant: 60 A}
  manufacture_date: {board: pack.maker}
"""
"""The table of the project two_batteries, for each pack: so the receiver has it too."""


def two_packs(folder: Path) -> Path:
    """The project two_batteries in a folder of its own, with information about each pack; its generated files."""
    shutil.copytree(ROOT / "tests" / "projects" / "two_batteries" / "specs", folder / "specs")
    (folder / "specs" / "messages" / "smart_battery_info.yaml").write_text(INFO)
    return built(folder)


def shipped(folder: Path) -> Path:
    """The shipped project in a folder of its own; its generated files."""
    shutil.copytree(ROOT / "specs", folder / "specs")
    return built(folder)


def built(folder: Path) -> Path:
    """The generated files of the project in a folder."""
    build(folder)
    return folder / "generated"


def run(interpreter: str, script: Path, folders: list[Path], *arguments: str) -> str:
    """Return the output of a script, with folders to import from."""
    path = os.pathsep.join(map(str, folders))
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": f"{path}{os.pathsep}.frozen"}
    program = sys.executable if interpreter == "cpython" else str(BIN / "micropython")
    command = [program, str(script), *arguments]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
