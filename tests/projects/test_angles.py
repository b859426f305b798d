"""Angles cross pi in both directions: what the firmware sends and keeps is what ``math.pi`` makes of it.

A quantity in hundredths of a degree goes out and comes in as radians, one in thousandths of a radian the other way.
Half a turn is a little more in a float than in degrees, and is taken.
"""

import json
import math
import shutil
import struct
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from in_process import build
from pymavlink.dialects.v20 import common

SPECS = Path(__file__).resolve().parent / "angles" / "specs"
BIN = Path(sys.executable).parent
CDEG = (*range(-18000, 18001, 173), -17999, -1, 0, 1, 57, 5730, 17999, 18000)
MRAD = (*range(0, 6283, 31), 1, 1571, 2938, 3142, 6282)
"""2938 is nearly a half in hundredths of a degree: 16833.5000000005."""
BEYOND = 3.1417
"""More than half a turn, in rad."""
SCRIPT = """
import json, sys
sys.path[:0] = ["generated/firmware", "generated/mocks", "generated/tests"]
from program_bench import Port, Craft, run_passes
import telemetry
from mavlink import Link

given = json.loads(open("given.json").read())
vehicle, link = Craft(ports=[Port()]), Link(None)
course, heard = vehicle.state.course, vehicle.state.heard
sent, kept = {"roll": [], "hdg": []}, {"roll": [], "hdg": []}
for value in given["cdeg"]:
    course.roll_cdeg = value
    sent["roll"].append(bytes(telemetry.encode_attitude(link, vehicle.state)).hex())
for value in given["mrad"]:
    course.heading_mrad = value
    sent["hdg"].append(bytes(telemetry.encode_global_position_int(link, vehicle.state)).hex())
for name, attribute in (("roll", "roll_cdeg"), ("hdg", "heading_mrad")):
    for frame in given[name]:
        vehicle.connections[0].port.arrives(bytes.fromhex(frame))
        run_passes(vehicle, 4)
        kept[name].append(getattr(heard, attribute))
json.dump([sent, kept], sys.stdout)
"""


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which the project is built, with the frames that arrive."""
    folder = tmp_path_factory.mktemp("angles")
    shutil.copytree(SPECS, folder / "specs")
    build(folder)
    other = common.MAVLink(None, srcSystem=7, srcComponent=1)
    rolls = [*(math.radians(cdeg / 100) for cdeg in CDEG), BEYOND]
    attitudes = [common.MAVLink_attitude_message(0, roll, 0, 0, 0, 0, 0) for roll in rolls]
    positions = [common.MAVLink_global_position_int_message(*[0] * 8, cdeg) for cdeg in headings()]
    given = {
        "cdeg": CDEG,
        "mrad": MRAD,
        "roll": [each.pack(other).hex() for each in attitudes],
        "hdg": [each.pack(other).hex() for each in positions],
    }
    (folder / "given.json").write_text(json.dumps(given))
    (folder / "angles.py").write_text(SCRIPT)
    return folder


def headings() -> list[int]:
    return [*range(0, 36000, 179), 1, 2938, 35999]


def run(interpreter: str, project: Path) -> Any:
    command = [str(BIN / interpreter), "angles.py"]
    done = subprocess.run(command, cwd=project, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads(done.stdout)


def nearest(value: float) -> int:
    """The whole number that comes nearest, a half away from zero: none of these is one."""
    return math.floor(value + 0.5) if value >= 0 else -math.floor(0.5 - value)


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_angles_are_those_of_pi(interpreter: str, project: Path) -> None:
    """A float to its last digit, a whole number exactly; in machine code and in plain Python."""
    sent, kept = run(interpreter, project)
    parser = common.MAVLink(None)
    for cdeg, frame in zip(CDEG, sent["roll"], strict=True):
        (message,) = parser.parse_buffer(bytearray(bytes.fromhex(frame)))
        (expected,) = struct.unpack("<f", struct.pack("<f", math.radians(cdeg / 100)))
        assert message.roll == expected, cdeg
    for mrad, frame in zip(MRAD, sent["hdg"], strict=True):
        (message,) = parser.parse_buffer(bytearray(bytes.fromhex(frame)))
        assert message.hdg == min(nearest(math.degrees(mrad / 1000) * 100), 35999), mrad
    assert kept["roll"] == [*CDEG, CDEG[-1]], "what is beyond the limits leaves what was there"
    assert kept["hdg"] == [nearest(1000 * math.radians(cdeg / 100)) for cdeg in headings()]
