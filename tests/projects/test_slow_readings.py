"""A sensor that is read every ten seconds holds nothing else of its component up: failsafes look, and load is told."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from in_process import build, codegen

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent

SCRIPT = """
import json
from program_bench import SECOND_US, mock_time, new_craft, run

craft = new_craft()
failsafe = craft.over_failsafes[0]
found = []
for tenth in range(450):
    if tenth % 10 == 0:
        craft.state.known.humidity = 50
    craft.state.motor.speed = 8000 if 110 <= tenth < 190 or tenth >= 320 else 3000
    before = failsafe.level
    run(craft, SECOND_US // 10)
    if failsafe.level != before:
        found.append([tenth, failsafe.level])
craft.state.vehicle.load = 100
run(craft, SECOND_US // 2)
print(json.dumps([found, craft.state.vehicle.load < 100]))
"""


@pytest.fixture(scope="module")
def boat(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The project, built."""
    folder = tmp_path_factory.mktemp("slow")
    shutil.copytree(HERE / "slow_readings" / "specs", folder / "specs")
    build(folder)
    return folder / "generated"


def test_what_code_sets_is_not_held_to_the_rate_of_readings(boat: Path) -> None:
    """The speed may be sent more often than the oil of the same motor is read: `rate-above-update` says nothing."""
    done = codegen(boat.parent, "check")
    assert (done.returncode, done.stdout) == (0, ""), done.stdout


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_a_failsafe_looks_between_two_readings(boat: Path, tmp_path: Path, interpreter: str) -> None:
    """Half a second of too high a speed is noticed each time, though the oil of the same motor is read at 0.1 Hz."""
    script = tmp_path / "story.py"
    script.write_text(SCRIPT)
    path = os.pathsep.join(str(boat / part) for part in ("firmware", "mocks", "tests"))
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": f"{path}{os.pathsep}.frozen"}
    heap = [] if interpreter == "python" else ["-X", "heapsize=4m"]
    command = [str(BIN / interpreter), *heap, str(script)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    found, is_load_told = json.loads(done.stdout)
    assert [level for _, level in found] == [1, 0, 1]
    assert [abs(tenth - due) <= 1 for (tenth, _), due in zip(found, (115, 190, 325), strict=True)] == [True] * 3
    assert is_load_told
