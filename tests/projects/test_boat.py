"""The boat sends what was set: what was worked out by hand from FR-101 arrives at pymavlink, from three interpreters.

Each was wrong once: longitudes beyond 107.37 degrees, an hdop of 1.2, an angle of 0.1 rad, 0 for what nobody knows.
"""

import json
import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from in_process import build, codegen
from pymavlink.dialects.v20 import ardupilotmega

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent
UNUSED = dict.fromkeys((f"chan{number}_raw" for number in (3, 4, *range(6, 19))), 65535)
NAN = math.nan

# What voyage.py tells by name, and what its message has to say; None is no message.
EXPECTED: dict[str, dict[str, Any] | None] = {
    "nothing known": None,
    # 139.69 degrees are 1396900000 steps of 1e-7, 1.75 m are 1750 mm; what has no sentinel is 0.
    "position": {
        "time_usec": 1000000, "fix_type": 0, "lat": -353632621, "lon": 1396900000, "alt": 12500,
        "eph": 65535, "epv": 65535, "vel": 65535, "cog": 65535, "satellites_visible": 255,
        "alt_ellipsoid": -33250, "h_acc": 1750, "v_acc": 0, "vel_acc": 0, "hdg_acc": 0, "yaw": 0,
    },
    # An hdop of 1.2 are 120 steps of the dialect's multiplier, 1E-2.
    "under way": {"fix_type": 3, "eph": 120, "vel": 257, "cog": 35999, "satellites_visible": 17, "epv": 65535},
    # 7 m/s more than fit into 65534 cm/s, and never 65535, which is unknown.
    "at the limits": {
        "time_usec": 1790000000123456, "lat": 899999999, "lon": -1799999999, "alt": -2000000000,
        "alt_ellipsoid": 2147483647, "h_acc": 4294967295, "eph": 65534, "vel": 65534, "cog": 35999,
        "satellites_visible": 254,
    },
    "beyond the earth": {"lat": -900000000, "lon": 1800000000},
    "no receiver": {"eph": 65535, "vel": 65535, "cog": 65535, "satellites_visible": 255, "lat": -353632621},
    **dict.fromkeys(f"without {name}" for name in ("lat", "lon", "alt", "ellipsoid", "accuracy")),
    "after 2 s": {"time_usec": 1790000002123456, "lon": 1396900000, "satellites_visible": 9},
    "after more than 2 s": None,
    "again": {"time_usec": 1790000002124456, "lon": 1396900000, "satellites_visible": 255},
    # A millisecond after 2 ** 64 - 1 us.
    "when the clock begins again": {"time_usec": 999, "lat": -353632621},
    "without a rate": None,
    # 0.1 is 0x3DCCCCCD as a float of 32 bits, -0.6 is 0xBF19999A; 2 ** 24 + 1 lies between two floats.
    "attitude": {
        "time_boot_ms": 4294967295, "roll": 0xCCCCCD / 2**27, "pitch": -0x99999A / 2**24, "yaw": 3.5,
        "rollspeed": 0xA24260 / 2**123, "pitchspeed": -0xC9F2CA * 2.0**76, "yawspeed": 16777216.0,
    },
    # 4294967295999 us and one ms are 2 ** 32 ms; pi as a float of 32 bits is 0x40490FDB.
    "capsized, a millisecond later": {"time_boot_ms": 0, "roll": -0xC90FDB / 2**22, "yaw": 3.5},
    "no attitude for a second": None,
    "no depth": None,
    # 8 degrees are 0.139626340... rad, 0x3E0EFA35.
    "depth": {
        "min_distance": 50, "max_distance": 5000, "current_distance": 1235, "type": 1, "id": 1, "orientation": 25,
        "covariance": 255, "horizontal_fov": 0x8EFA35 / 2**26, "vertical_fov": 0x8EFA35 / 2**26,
        "quaternion": [0.0] * 4, "signal_quality": 0,
    },
    "too deep": {"max_distance": 2050, "current_distance": 10000, "covariance": 25, "signal_quality": 1},
    "aground": {"current_distance": 50, "covariance": 36, "signal_quality": 100},
    "no echo for three seconds": None,
    "no time": None,
    "wind": {
        "time_usec": 1790000002500000, "wind_x": 3.5, "wind_y": 0xCCCCCD / 2**27, "wind_z": NAN, "wind_alt": NAN,
        "var_horiz": NAN, "var_vert": NAN, "horiz_accuracy": 0.0, "vert_accuracy": 0.0,
    },
    "half of the wind": {"time_usec": 1790000003001000, "wind_x": NAN, "wind_y": 0xCCCCCD / 2**27},
    "no remote control": {
        "chancount": 0, "chan1_raw": 65535, "chan2_raw": 65535, "chan5_raw": 65535, "rssi": 255, **UNUSED,
    },
    "remote control": {"chancount": 8, "chan1_raw": 1500, "chan2_raw": 2200, "chan5_raw": 800, "rssi": 254, **UNUSED},
    "one stick": {"chancount": 8, "chan1_raw": 65535, "chan2_raw": 1100, "chan5_raw": 65535, "rssi": 255, **UNUSED},
    "rudder": {"name": "RUDDER", "value": -12.5},
    "no bilge": None,
    "bilge": {"name": "BILGE", "value": 0xCCCCCD / 2**27},
    "hard over": {"name": "RUDDER", "value": 45.0},
    "no rudder for a second": None,
}  # fmt: skip

# Whole payloads, in the order of the wire and without the zeros at the end.
PAYLOADS = {
    "under way": "40420f0000000000 93feebea a0004353 d4300000 7800 ffff 0101 9f8c 03 11 1e7effff d606",
    "attitude": "ffffffff cdcccc3d 9a9919bf 00006040 6042a20d caf249f1 0000804b",
    "aground": "00000000 3200 0208 3200 01 01 19 24 35fa0e3e 35fa0e3e 00000000 00000000 00000000 00000000 64",
    "one stick": "f5010000 ffff 4c04" + "ffff" * 16 + "08 ff",
    "rudder": "00000000 000048c1 525544444552",
}


@pytest.fixture(scope="module")
def boat(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which the boat is built."""
    folder = tmp_path_factory.mktemp("boat")
    subprocess.run(
        ["cp", "-r", str(HERE / "boat" / "specs"), str(HERE / "boat" / "voyage.py"), str(folder)], check=True
    )
    build(folder)
    return folder


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_what_was_set_arrives(boat: Path, interpreter: str) -> None:
    """In machine code, and in plain Python with words of 32 bits and under CPython."""
    done = subprocess.run([str(BIN / interpreter), "voyage.py"], cwd=boat, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    frames = json.loads(done.stdout)
    assert frames.keys() == EXPECTED.keys()
    parser = ardupilotmega.MAVLink(None)
    for name, expected in EXPECTED.items():
        frame = frames[name]
        assert (frame is None) is (expected is None), name
        if expected is not None:
            (message,) = parser.parse_buffer(bytearray(bytes.fromhex(frame)))
            found = message.to_dict()
            for field, value in expected.items():
                assert found[field] == value or (value is NAN and math.isnan(found[field])), (name, field, found[field])
    for name, payload in PAYLOADS.items():
        assert bytes.fromhex(frames[name])[10:-2] == bytes.fromhex(payload), name


def test_its_documents_hold(boat: Path) -> None:
    """Tables and claims of its requirement document have no finding, and each criterion has rows and tests."""
    for command in (["check"], ["trace", "--fail-on", "uncovered,orphaned,suspect,unspecified,uncited"]):
        done = codegen(boat, *command)
        assert done.returncode == 0, done.stdout
        assert ": warning " not in done.stdout
    assert "14 criteria" in done.stdout
    for topic, words in (
        ("ATTITUDE.pitch", " -3.4028234663852886e+38..3.4028234663852886e+38\n"),
        ("gps.lon", " -1800000000..1800000000 degE7"),
    ):
        assert words in codegen(boat, "explain", topic).stdout


def exact(interpreter: str, boat: Path, script: str) -> Any:
    """Return the output of a script that has the state of the boat."""
    head = (boat / "voyage.py").read_text().partition("frames = {}")[0]
    (boat / "exact.py").write_text(f"{head}state = SystemState(log=lambda *_: None)\n{script}")
    done = subprocess.run([str(BIN / interpreter), "exact.py"], cwd=boat, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_a_whole_number_of_64_bits_is_set_exactly(boat: Path, interpreter: str) -> None:
    """In the unit that it is kept in it never becomes a float, which has 53 bits at most; a fraction is rounded."""
    script = """
clock, found = state.clock, []
for value in (2**53 + 1, 2**64 - 1, 2**64, -1, 2.5, 1e30):
    clock.unix = value
    found.append(str(clock.unix_us))
    found.append(str(clock.unix))
clock.unix = float("nan")
print(json.dumps(found + [clock.unix]))
"""
    kept = [2**53 + 1, 2**64 - 1, 2**64 - 1, 0, 3, 2**64 - 1]
    assert exact(interpreter, boat, script) == [*(str(value) for one in kept for value in (one, one)), None]


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_what_is_limited_is_counted_and_told_once(boat: Path, interpreter: str) -> None:
    """A longitude of 200 degrees, twice, and again once one was right; an angle and an entry that there is not.

    Infinity is no value that could be limited: it is unknown.
    """
    script = """
told = []
state = SystemState(log=told.append)
gps, attitude = state.gps, state.attitude
for lon in (200, 201, None, -200, 180, 1e30, float("inf"), float("-inf")):
    gps.lon = lon
attitude.roll = 7
gps.fix = 300
state.clock.unix = 2**70
print(json.dumps([told, gps.limited, attitude.limited, gps.lon_dege7]))
"""
    told, gps, attitude, lon = exact(interpreter, boat, script)
    assert told == [
        "warning: gps.lon beyond 180: limited",
        "warning: gps.lon beyond 180: limited",
        "warning: attitude.roll beyond 3.141593: limited",
        "warning: gps.fix beyond 8: limited",
        "warning: clock.unix beyond 18446744073709551615: limited",
    ]
    assert (gps, attitude, lon) == ({"lon": 4, "fix": 1}, {"roll": 1}, None)
