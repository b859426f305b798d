"""SYS_STATUS, BATTERY_STATUS and BATTERY_STATUS_V2 tell the same of a pack, and nothing of the one before it."""

import importlib.util
import json
import math
import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
GENERATED = ROOT / "generated"
BIN = Path(sys.executable).parent
MESSAGES = ("SYS_STATUS", "BATTERY_STATUS", "BATTERY_STATUS_V2")

Step = list[tuple[str, Any]]


@pytest.fixture(scope="module")
def wire() -> ModuleType:
    """pymavlink's module of the three messages."""
    path = GENERATED / "tests" / "oracle.py"
    specification = importlib.util.spec_from_file_location("picture_oracle", path)
    assert specification is not None
    assert specification.loader is not None
    oracle = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(oracle)
    about = {"shipped": "common", "files": ["specs/dialects/battery_upstream.xml"]}
    module: ModuleType = oracle.dialects(about, MESSAGES, ROOT)[0]
    return module


def told(wire: ModuleType, courses: list[list[Step]], monitor: int, interpreter: str = "python") -> list[list[Any]]:
    """What the rover sends after each step of each course, as pymavlink decodes it: three messages a step."""
    folders = [str(GENERATED / name) for name in ("firmware", "mocks", "tests")]
    paths = {"PYTHONPATH": os.pathsep.join(folders), "MICROPYPATH": os.pathsep.join([".frozen", *folders])}
    command = [str(BIN / interpreter), str(HERE / "picture_story.py")]
    given = "".join(json.dumps({"course": course, "monitor": monitor}) + "\n" for course in courses)
    done = subprocess.run(
        command, input=given, env={**os.environ, **paths}, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    link = wire.MAVLink(None)
    return [
        [[link.parse_buffer(bytes.fromhex(frame))[0] for frame in frames] for frames in json.loads(line)]
        for line in done.stdout.splitlines()
    ]


def millivolts(message: Any) -> int | None:
    """The voltage of a BATTERY_STATUS, as receivers add it up."""
    values = [value for value in message.voltages if value != 65535] + [each for each in message.voltages_ext if each]
    return sum(values) if values else None


SET: Step = [("cells", [4.1, 4.0, 4.1]), ("left", 1200), ("remaining", 36), ("temperature", 25)]
SWAP: list[Step] = [SET, [("voltage", 3200)], [("voltage", 0)], [], [("voltage", 3900)], []]


@pytest.mark.requirement("FR-00073.8", "FR-00068.3", "FR-00072.4")
@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_nothing_of_the_pack_before_is_told_of_another(wire: ModuleType, interpreter: str) -> None:
    """Cells, charge and temperature that code had set are unknown after a swap; the voltage is the new pack's."""
    (steps,) = told(wire, [SWAP], 3, interpreter)
    _, status, latest = steps[0]
    assert status.battery_remaining == 36
    assert latest.capacity_remaining == pytest.approx(1.2)
    basic, status, latest = steps[-1]
    assert basic.voltage_battery == millivolts(status) == round(latest.voltage * 1000) == 12414
    assert status.voltages[1] == 65535
    assert basic.battery_remaining == status.battery_remaining == -1
    assert status.temperature == latest.temperature == 32767
    assert math.isnan(latest.capacity_remaining)
    assert math.isnan(latest.state_of_charge)
