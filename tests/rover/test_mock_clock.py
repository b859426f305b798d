"""The mocks' clock is the firmware's clock, whatever was imported first."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from whole_program import module_folders

GENERATED = Path(__file__).resolve().parents[2] / "generated"

SCRIPT = """
import telemetry
from state import SystemState
from mock_board import MockBoard
import mock_time
board = MockBoard()
board.set_adc_value(3000)
state = SystemState(log=lambda *words: None)
mock_time.set_ticks_us(5_000_000_000)
state.update_battery(board)
print(telemetry.build_battery_status(state).raw("voltages")[0])
mock_time.advance_us(1_001_000)
print(telemetry.build_battery_status(state).raw("voltages")[0])
"""


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_firmware_imported_before_the_mocks(interpreter, tmp_path):
    """A fresh reading goes out, and an old one does not: state and telemetry look at the same clock."""
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    path = os.pathsep.join(map(str, module_folders(GENERATED, "firmware", "mocks")))
    program = sys.executable if interpreter == "cpython" else str(Path(sys.executable).with_name("micropython"))
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": path}
    command = [program, str(script)]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    assert done.stdout.split() == ["9549", "65535"], done.stderr
