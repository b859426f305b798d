"""Sensors of every kind at mocks of their hardware: what becomes of it was worked out by hand."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from in_process import build, codegen

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent

LAT, LON = 481173000, 115166667  # 48 deg 7.038', 11 deg 31'
NOWHERE = [None, None, None]
HEARD = [3, LAT, LON, 545400, 8]

# What hardware.py tells by name.
EXPECTED: dict[str, Any] = {
    "nothing yet": [0, *NOWHERE, None, None, None, None, None],
    "uart": {"baudrate": 9600, "timeout": 0, "rxbuf": 512},
    "gga": [*HEARD, None, None, 90, None],
    # 35 deg 21.79726' south, 139 deg 41.4' west; 22.4 knots of 1852 m/h; 360 degrees are 0; 2026-09-19 12:35:20.5,
    # and two turns later.
    "rmc": [3, -353632877, -1396900000, 545400, 8, 1152, 0, 90, None, "1789821320600000"],
    "vtg": [283, 5475, 90, None],
    "gsa": [283, 5475, 109, 147],
    "flat": [2, LAT, LON, None, 8],
    "quality 0": [1, *NOWHERE, 8],
    "quality 2": [4, LAT, LON, 545400, 8],
    "quality 4": [6, LAT, LON, 545400, 8],
    "quality 5": [5, LAT, LON, 545400, 8],
    "quality 6": [1, *NOWHERE, 8],
    "quality 8": [1, *NOWHERE, 8],
    "quality 3": HEARD,
    "void": [1, *NOWHERE, 8, None, None, 90, 147],
    "no motion": [None, None, 90, 147],
    "ends": {
        "north pole": [3, 900000000, -1800000000, -999999, 12, None],
        "beyond north": [3, None, None, 0, 12, 100],
        "beyond west": [3, None, None, 0, 12, 100],
        "just south": [3, 0, 0, 0, 12, 100],
        "date line": [3, 0, 1800000000, 0, 12, 100],
        "half a word": [3, 450000000, -65536, 0, 12, 100],
        "60 minutes": [3, None, None, 0, 12, 100],
        "no side": [3, None, None, 0, 12, 100],
        "letters": [3, None, None, 0, None, 100],
        "too long": [3, 450000000, LON, None, 12, 100],
        "short": [1, *NOWHERE, None, None],
        "empty": [1, *NOWHERE, None, None],
    },
    "talkers": [12, 8],  # six of the eight count
    "wrong": [0, *NOWHERE, None, 0, 1, 0],
    "joined": [1, 2, 1],
    "bad lines": [1, 3, 4],
    "in pieces": [2, 3, 5, LAT],
    "small letters": 3,
    "flood": [3, 700 - 256, 70],
    "after noise": HEARD,
    "dates": {
        "000000.00 010100": "946684800000000",
        "235959.999 311299": "946684799999000",
        "120000.00 290224": "1709208000000000",
        "120000.00 290223": None,
        "120000.00 310426": None,
        "120000 010380": "320760000000000",
        "235960.00 311216": "1483228800000000",  # a leap second
        "240000.00 010126": None,
        "126000.00 010126": None,
        "120000.00 320126": None,
        "120000.00 011326": None,
        "120000.00 ": None,
        "120000.00 190138": "2147515200000000",  # twelve hours beyond 32 bits
    },
    "clock": [0, 50, 100, 9000, 3000],
    "silent": [LAT, [0, *NOWHERE, None], ["error: receiver: nothing arrives"]],
    "heard again": [HEARD, "notice: receiver works again"],
    "no uart": ["error: receiver: UART 1 does not work"],
    "uart fails": ["error: receiver: UART 1 does not work", 2, False],
    "nmea allocates": [0, 0],
    # 9600 steps of 1.25 mV; 4000 of 2.5 uV across 2 mOhm; 4321 of 4 mV, 1234 of 10 uV across 100 mOhm.
    "monitors": [12000, 500, 60000, 4321],
    "panel": [17.284, 0.1234],
    "settings": [0x4527, 0x3DDF, 400000],
    "readings": {
        "drawn": [1, 0, 0],
        "charged": [36000, 0, -45],
        "most": [36000, 4096, 1474470],
        "least": [36000, -4096, -1474470],
        "too much": [35999, None, None],
        "too little": [0, None, None],
        "beyond": [None, 1, 180],
        "broken": [None, 0, None],
    },
    "not converted": [12000, 500, 60000],
    "converts still": [],
    "converts no more": "error: power: it does not convert",
    "converts again": [10000, 500, 50000, "notice: power works again"],
    "one failure": [10000, 500, 50000, "notice: power works again", 2],
    "gone": [None, None, None, "error: power: no answer at 0x40 on I2C 0 (2 times)", 6],
    "back": [10000, 500, 50000, "notice: power works again", 0],
    "problems": {
        "wrong id": [*NOWHERE, "error: power: no INA226: its id is 1234 2260"],
        "wrong die": [*NOWHERE, "error: power: no INA226: its id is 5449 2190"],
        "stuck": [*NOWHERE, "error: power: it does not keep its settings"],
        "nobody": [*NOWHERE, "error: power: no answer at 0x40 on I2C 0"],
        "no ina219": ["error: solar: no INA219: its settings are 1234"],
    },
    "three transfers": [900, 0],
    "slow bus": [3000, 1, "warning: power took too long, in us: 3000"],
    "ina226 allocates": 0,
    # 359 degrees, mounted the other way round and by 2.5 degrees.
    "compass": [181.5, 48],
    "strong field": [18150, None],
    "raised": [
        "error: sonar: OSError: no file",
        "error: sonar: ValueError: no echo",
        "error: needle: no answer at 0x1e on I2C 0",
        "error: needle: has 3 values, and 2 are declared",
    ],
    # Every 20 ms are 50 Hz; 600 pulses every 333 us after a pause; 9000 every 100 us; faster than can be told.
    "pulses": [
        [0, 0, None],
        [1, 0, None],
        [11, 50000, 1500],
        [611, 2733896, 100],
        [9611, 9997411, 20],
        [9612, 10000000, 1],
        [9613, None, 1000000],
    ],
    "no pulses": [9613, 0, None],
    "pulses again": [[9614, 0, None], [9618, 1000000, 500]],
    "pin": [1, 0],
    # In four seconds: the receiver is due first after 40 ms, and so at 3990 ms, after the last pass, for the 80th time;
    # the compass after 100 ms. 85 turns a second in 50 passes, with a third to spare: three at a time at most.
    "turns": {"sonar": 40, "imu": 80, "receiver": 79, "power": 40, "solar": 40, "needle": 39, "log": 20},
    "at once": 3,
    "after half a turn of the ticks": 7,
    "asked while nothing waits": [1, 1, 2, 2],
}


@pytest.fixture(scope="module")
def sensors(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which the project is built."""
    folder = tmp_path_factory.mktemp("sensors")
    parts = [str(HERE / "sensors" / name) for name in ("specs", "hardware.py")]
    subprocess.run(["cp", "-r", *parts, str(folder)], check=True)
    build(folder)
    return folder


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_what_sensors_say_is_kept(sensors: Path, interpreter: str) -> None:
    """In machine code, in plain Python with words of 32 bits, and under CPython."""
    command = [str(BIN / interpreter), "hardware.py"]
    done = subprocess.run(command, cwd=sensors, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert found.keys() == EXPECTED.keys()
    for name, expected in EXPECTED.items():
        assert found[name] == expected, name


def test_it_has_no_findings(sensors: Path) -> None:
    """Nor has its trace: each criterion has rows and tests."""
    done = codegen(sensors, "check")
    assert (done.returncode, done.stdout) == (0, "")
    done = codegen(sensors, "trace", "--fail-on", "uncovered,orphaned,unspecified")
    assert done.returncode == 0, done.stdout
