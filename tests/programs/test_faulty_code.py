"""Faulty code of the user on the board: HEARTBEATs, a text that says what is wrong, and no arming; no silence."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from whole_program import module_folders

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(sys.executable).parent

SCRIPT = """
import json
import program_bench as bench
import board, dialect, main, messages

port = bench.Port()
board.Board.open_ports = lambda _board: [port]
bench.Flash()
for measured in bench.MEASURED:
    bench.analog(measured).source = bench.good_count(measured)
main.sys = None  # a traceback would stand between what is printed
vehicle = main.new_vehicle()
bench.run(vehicle, 3 * bench.SECOND_US)
station = bench.GroundStation(port)
beats = station.received(messages.Heartbeat)
vehicle.texts.say(dialect.MAV_SEVERITY_INFO, "end")
texts = [vehicle.texts.get(number)[1] for number in range(1, vehicle.texts.last + 1) if vehicle.texts.get(number)]
said = [text for text in texts if text.startswith("rover")]
print(json.dumps([len(beats), said, vehicle.arm(), type(vehicle).__name__]))
"""


def outcome(folder: Path, code: str | None, interpreter: str) -> list[object]:
    """Return how many HEARTBEATs came in three seconds, what was said of the module, why not armed, and the class."""
    if code is not None:
        (folder / "rover.py").write_text(code)
    (folder / "script.py").write_text(SCRIPT)
    paths = map(str, module_folders(ROOT / "generated", "firmware", "mocks", "tests"))
    path = os.pathsep.join([str(folder), *paths, *([".frozen"] if interpreter == "micropython" else [])])
    done = subprocess.run(
        [str(BIN / interpreter), str(folder / "script.py")],
        cwd=folder,
        env={**os.environ, "MICROPYPATH": path, "PYTHONPATH": path, "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    found: list[object] = json.loads(done.stdout.splitlines()[-1])
    return found


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
@pytest.mark.parametrize(
    ("code", "says"),
    [
        ("class Rover(\n", "SyntaxError"),
        ("import wheels\n", "ImportError"),
        ("import rover_wheels\n", "ImportError"),
        ("raise OSError(5)\n", "OSError"),
        ("x = 1\n", "AttributeError"),
        ("class Rover:\n    pass\n", "not derived from"),
        (
            "from vehicle import Vehicle\nclass Rover(Vehicle):\n    def __init__(self):\n"
            "        Vehicle.__init__(self)\n        raise ValueError('no motors')\n",
            "no motors",
        ),
    ],
)
def test_faulty_code_is_told_and_not_armed(code: str, says: str, interpreter: str, tmp_path: Path) -> None:
    """Whatever is wrong with it, the vehicle is there for its operator."""
    beats, said, problem, kind = outcome(tmp_path, code, interpreter)
    assert isinstance(beats, int)
    assert beats >= 2
    assert isinstance(said, list)
    assert len(said) == 1
    assert says in said[0] or (says == "ImportError" and "ModuleNotFoundError" in said[0])
    assert problem == f"PreArm: {said[0]}"
    assert kind == "Vehicle"


@pytest.mark.parametrize("code", [None, "from vehicle import Vehicle\nclass Rover(Vehicle):\n    pass\n"])
def test_what_works_is_what_runs(code: str | None, tmp_path: Path) -> None:
    """With right code of the user, or none, nothing is said and nothing kept from arming."""
    beats, said, problem, kind = outcome(tmp_path, code, "micropython")
    assert (said, kind) == ([], "Vehicle" if code is None else "Rover")
    assert isinstance(beats, int)
    assert beats >= 2
    assert problem != ""
    assert "rover" not in str(problem)
