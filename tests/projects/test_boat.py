"""The boat sends what was set: positions, times and angles that were worked out by hand, decoded by pymavlink.

Each was wrong once: longitudes beyond 107.37 degrees, an hdop of 1.2, an angle of 0.1 rad.
"""

import json
import math
import subprocess
import sys
from pathlib import Path

import pytest
from pymavlink.dialects.v20 import ardupilotmega

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent
SCRIPT = """
import json, sys
sys.path[:0] = ["generated/firmware", "generated/mocks"]
import mock_time
mock_time.install()
import telemetry
from mavlink import Link
from state import SystemState

state = SystemState(log=lambda *words: None)
link = Link(None)
gps, attitude = state.gps, state.attitude
state.clock.boot_us, gps.lat_dege7, gps.lon_dege7, gps.alt_mm = 1790000000123456, -353632621, 1396900000, -2000000000
gps.hdop, gps.ellipsoid_mm, gps.accuracy_mm = 1.2, 2147483647, 4294967295
first = bytes(telemetry.encode_gps_raw_int(link, state)).hex()
gps.lon, gps.lat, gps.hdop = -179.9999999, 89.9999999, None
second = bytes(telemetry.encode_gps_raw_int(link, state)).hex()
state.clock.boot_us = 4294967295999
attitude.roll, attitude.pitch, attitude.yaw = 0.1, -0.6, 3.5
attitude.roll_speed, attitude.pitch_speed, attitude.yaw_speed = 1e-30, -1e30, 16777217.0
third = bytes(telemetry.encode_attitude(link, state)).hex()
print(json.dumps([first, second, third]))
"""


@pytest.fixture(scope="module")
def boat(tmp_path_factory):
    """The folder in which the boat is built."""
    folder = tmp_path_factory.mktemp("boat")
    subprocess.run(["cp", "-r", str(HERE / "boat" / "specs"), str(folder)], check=True)
    subprocess.run([str(BIN / "codegen"), "build"], cwd=folder, check=True, capture_output=True)
    (folder / "send.py").write_text(SCRIPT)
    return folder


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_what_was_set_arrives(boat, interpreter):
    """In machine code, and in plain Python with words of 32 bits and under CPython."""
    done = subprocess.run([str(BIN / interpreter), "send.py"], cwd=boat, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    parser = ardupilotmega.MAVLink(None)
    first, second, third = (
        parser.parse_buffer(bytearray(bytes.fromhex(frame)))[0] for frame in json.loads(done.stdout)
    )
    assert (first.time_usec, first.lat, first.lon) == (1790000000123456, -353632621, 1396900000)
    assert (first.alt, first.alt_ellipsoid, first.h_acc) == (-2000000000, 2147483647, 4294967295)
    assert first.eph == 120  # 1.2, in steps of 1E-2
    assert (second.lon, second.lat, second.eph) == (-1799999999, 899999999, 65535)
    assert third.time_boot_ms == 4294967295
    # 0.1 is 0x3DCCCCCD as a float of 32 bits, -0.6 is 0xBF19999A; 3.5 rad lie within the range of a yaw.
    assert third.roll == 0xCCCCCD / 2**27
    assert third.pitch == -0x99999A / 2**24
    assert third.yaw == 3.5
    assert math.isclose(third.rollspeed, 1e-30, rel_tol=2**-24)
    assert math.isclose(third.pitchspeed, -1e30, rel_tol=2**-24)
    assert third.yawspeed == 16777216.0  # 2 ** 24 + 1 lies between two floats


def test_what_is_beyond_a_limit_is_the_limit(boat):
    """The roll angle ends at pi, as near as a float comes to what the table says."""
    script = SCRIPT.replace("attitude.roll, ", "attitude.roll, attitude.pitch = -7, 0\nattitude.yaw_speed, ", 1)
    (boat / "beyond.py").write_text(script)
    done = subprocess.run([str(BIN / "micropython"), "beyond.py"], cwd=boat, capture_output=True, text=True, check=True)
    third = json.loads(done.stdout)[2]
    message = ardupilotmega.MAVLink(None).parse_buffer(bytearray(bytes.fromhex(third)))[0]
    assert message.roll == -3.1415927410125732


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_a_whole_number_of_64_bits_is_set_exactly(boat, interpreter):
    """In the unit that it is kept in it never becomes a float, which has 53 bits at most; a fraction is rounded."""
    script = (
        SCRIPT.partition("gps, attitude =")[0]
        + """
clock, found = state.clock, []
for value in (2**53 + 1, 2**64 - 1, 2**64, -1, 2.5, 1e30):
    clock.unix = value
    found.append(str(clock.unix_us))
    found.append(str(clock.unix))
clock.unix = float("nan")
print(json.dumps(found + [clock.unix]))
"""
    )
    (boat / "exact.py").write_text(script)
    done = subprocess.run([str(BIN / interpreter), "exact.py"], cwd=boat, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    kept = [2**53 + 1, 2**64 - 1, 2**64 - 1, 0, 3, 2**64 - 1]
    assert json.loads(done.stdout) == [*(str(value) for one in kept for value in (one, one)), None]


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_what_is_limited_is_counted_and_told_once(boat, interpreter):
    """A longitude of 200 degrees, twice, and again once one was right; an angle and an entry that there is not."""
    script = (
        SCRIPT.partition("gps, attitude =")[0]
        + """
from state import SystemState
told = []
state = SystemState(log=told.append)
gps, attitude = state.gps, state.attitude
for lon in (200, 201, None, -200, 180, float("inf")):
    gps.lon = lon
attitude.roll = 7
gps.fix = 300
print(json.dumps([told, gps.limited, attitude.limited, gps.lon_dege7]))
"""
    )
    (boat / "limited.py").write_text(script)
    done = subprocess.run([str(BIN / interpreter), "limited.py"], cwd=boat, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    told, gps, attitude, lon = json.loads(done.stdout)
    assert told == [
        "warning: gps.lon beyond 180: limited",
        "warning: gps.lon beyond 180: limited",
        "warning: attitude.roll beyond 3.141593: limited",
        "warning: gps.fix beyond 8: limited",
    ]
    assert (gps, attitude, lon) == ({"lon": 4, "fix": 1}, {"roll": 1}, 1800000000)
