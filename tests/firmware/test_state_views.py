"""Attributes of the state that are made when they are first used, on both interpreters."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from whole_program import module_folders

PATHS = module_folders(Path(__file__).resolve().parents[2] / "generated", "firmware", "mocks")
SCRIPT = """
import json
import sys
if sys.implementation.name == "cpython":
    import mock_time
    mock_time.install()
from state import BatteryState, SystemState
told = []
state = SystemState(log=lambda *parts: told.append(" ".join(map(str, parts))))
battery = state.battery
made = [name in BatteryState.__dict__ for name in ("voltage", "voltage_mv", "absent")]
battery.voltage = 12.5
battery.mine = 7
seen = [battery.voltage_mv, battery.absent, battery.mine, state.battery[1].voltage, battery.words[0]]
made += [name in BatteryState.__dict__ for name in ("voltage", "voltage_mv", "absent", "mine", "cold")]
battery.voltage_mv = 70000
try:
    battery.voltag
    failed = None
except AttributeError as error:
    failed = str(error)
print(json.dumps([made, seen, failed, hasattr(battery, "hot"), hasattr(battery, "hott"), battery.limited, told]))
"""


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_attributes_are_made_when_they_are_used(interpreter: str) -> None:
    """By the first who reads or sets one, for all instances; nothing else is one, and other names stay plain."""
    command = [str(Path(sys.executable).parent / interpreter), "-c", SCRIPT]
    path = os.pathsep.join(map(str, PATHS))
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": path, "PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    made, seen, failed, is_known, is_guessed, limited, told = json.loads(done.stdout)
    assert made == [False, False, False, True, True, True, False, False]
    assert seen == [12500, False, 7, None, 12500]
    assert failed == "battery has no voltag"
    assert (is_known, is_guessed) == (True, False)
    assert limited == {"voltage": 1}
    assert told == ["warning: battery[0].voltage beyond 65.534: limited"]
