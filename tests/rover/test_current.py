"""The rover's current sensor: what was worked out by hand, and by fractions, is what three interpreters keep and send.

1234 counts of the sensor are 16.905450 A, 3770 of the divider 12.000494 V; readings are a tenth of a second apart.
"""

import json
import math
import os
import struct
import subprocess
import sys
from fractions import Fraction
from math import floor
from pathlib import Path
from typing import Any

import pytest
from pymavlink.dialects.v20 import common
from whole_program import module_folders

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent
GENERATED = HERE.parents[1] / "generated"

MILLIVOLTS, MILLIAMPERES = 12000, 16905
CAPACITY = 3300
HALF = Fraction(1, 2)


@pytest.fixture(scope="module", params=["python", "micropython", "micropython32"])
def told(request: pytest.FixtureRequest) -> Any:
    """Return the output of the story on an interpreter."""
    folders = [*map(str, module_folders(GENERATED, "firmware", "mocks", "tests"))]
    paths = {"PYTHONPATH": os.pathsep.join(folders), "MICROPYPATH": os.pathsep.join([".frozen", *folders])}
    command = [str(BIN / request.param), str(HERE / "current_story.py")]
    done = subprocess.run(command, env={**os.environ, **paths}, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def counted(readings: int, milliamperes: int = MILLIAMPERES) -> list[int]:
    """Charge in mAh, energy in hJ, and what is left in mAh and in percent, after a first reading and so many more."""
    hours = Fraction(readings, 36000)
    charge = floor(milliamperes * hours + HALF)
    energy = floor(Fraction(milliamperes * MILLIVOLTS, 1000000) * hours * 36 + HALF)
    left = max(0, min(CAPACITY, CAPACITY - charge))
    return [charge, energy, left, floor(Fraction(left * 100, CAPACITY) + HALF)]


def decoded(frame: str) -> tuple[int, ...]:
    """Return pymavlink's reading of a BATTERY_STATUS: current, charge, energy, the share that is left, and the time."""
    (message,) = common.MAVLink(None).parse_buffer(bytes.fromhex(frame))
    names = ("current_battery", "current_consumed", "energy_consumed", "battery_remaining", "time_remaining")
    return tuple(getattr(message, name) for name in names)


@pytest.mark.requirement("FR-00077.1", "FR-00077.3")
def test_counts_are_amperes(told: Any) -> None:
    """The rows of FR-00077, and a factor of 0."""
    assert told["conversion"] == [0, 28043, 56100, 326700, -5610, 0]


@pytest.mark.requirement("FR-00077.2", "FR-00068.6")
def test_nothing_is_known_by_default(told: Any) -> None:
    """Without BATT_MONITOR 4 there is no reading, and every field about charge is the dialect's sentinel."""
    values, frame = told["without_a_sensor"]
    assert values == [None] * 6
    assert decoded(frame) == (-1, -1, -1, -1, 0)


@pytest.mark.requirement("FR-00077.5", "FR-00077.6", "FR-00077.7")
def test_what_is_drawn_is_counted(told: Any) -> None:
    """Charge, energy and what is left are the nearest to their exact values after each reading, and so on the wire."""
    *readings, frame = told["drawn"]
    assert [each[:5] for each in readings] == [[MILLIAMPERES, *counted(number)] for number in range(40)]
    assert [each[5] for each in readings] == [each[3] * 3600 // MILLIAMPERES for each in readings]
    charge, energy, left, share = counted(39)
    assert decoded(frame) == (1691, charge, energy, share, left * 3600 // MILLIAMPERES)


@pytest.mark.requirement("FR-00077.5", "FR-00077.6", "FR-00077.7")
def test_what_is_put_in_is_counted_back(told: Any) -> None:
    """A current below the offset charges the pack: it is not more than full, and lasts for ever."""
    # (0.805861 V - 1.65 V) * 17 = -14.350365 A.
    assert told["charged"] == [[-14350, *counted(number, -14350), None] for number in range(30)]


@pytest.mark.requirement("FR-00077.5", "FR-00073.8")
def test_another_pack_is_counted_from_its_own_beginning(told: Any) -> None:
    """Nothing of the old one is left over: not its charge, its energy, nor what was less than a step of either."""
    without, after = told["swapped"][:5], told["swapped"][5:]
    assert [each[:5] for each in without] == [[0, *counted(36)]] * 5
    # The current before was none of this pack's, so its first reading stands for no time.
    assert [each[:5] for each in after] == [[MILLIAMPERES, *counted(number)] for number in range(30)]
    assert [each[4] for each in after[:2]] == [100, 100]


@pytest.mark.requirement("FR-00077.4", "FR-00077.5", "FR-00077.6")
def test_a_sensor_that_fails_leaves_a_gap(told: Any) -> None:
    """The fifth failure makes the current unknown, and what is left; the voltage goes on, and nothing is counted."""
    readings = [reading for reading, _ in told["failing"]]
    assert all(has_voltage for _, has_voltage in told["failing"])
    kept = [MILLIAMPERES, *counted(1)]
    assert [each[:5] for each in readings[1:6]] == [kept] * 5
    assert readings[6][:6] == [None, *counted(1)[:2], None, None, None]
    assert [each[:5] for each in readings[7:]] == [kept, [MILLIAMPERES, *counted(2)]]


def test_an_interrupt_ends_no_reading_for_good(told: Any) -> None:
    """Ctrl-C reaches who called; voltage and current are read again by the next call."""
    # 1000 counts are 13.699634 A, 3000 are 9.549451 V.
    assert told["interrupted"] == ["interrupted", [13700, 9549]]


@pytest.mark.requirement("FR-00072.4")
def test_infinity_is_unknown(told: Any) -> None:
    """It went out as 1073741.875 V; NaN is what the new message has for unknown, and nothing was limited."""
    *kept, payload = told["endless"]
    assert kept == [[None, None, None, {}]] * 3
    assert struct.unpack_from("<ff", bytes.fromhex(payload)) == pytest.approx((math.nan, math.nan), nan_ok=True)


@pytest.mark.requirement("FR-00077.6", "FR-00077.7")
def test_an_empty_pack_has_nothing_left(told: Any) -> None:
    """5 mAh are used up after 11 readings; without a capacity nothing says what is left."""
    empty, unstated = told["emptied"]
    assert empty == [MILLIAMPERES, 5, counted(11)[1], 0, 0, 0]
    assert unstated[3:] == [None] * 3


@pytest.mark.requirement("FR-00077.8", "FR-00020.1", "FR-00020.2", "FR-00021.3")
def test_too_little_charge_is_a_failsafe_at_once(told: Any) -> None:
    """Each level with the first reading that leaves less than its threshold, although BATT_LOW_TIMER is 0."""
    armed, *halves, texts, refused = told["empty_failsafe"]
    assert armed is None
    assert len(halves) == 11
    for left, level, health in halves:
        assert level == health == (left < 3290) + (left < 3280)
    assert texts == ["Battery 1 is low 12.00V used 11 mAh", "Battery 1 is critical 12.00V used 21 mAh"]
    assert refused == "PreArm: Battery 1 low capacity failsafe"


@pytest.mark.requirement("FR-00077.8", "FR-00077.9")
def test_it_is_off_by_default_and_without_a_sensor(told: Any) -> None:
    """Nothing is refused and nothing reached: thresholds of 0, or thresholds of what nobody measures."""
    assert told["never_empty"] == [[None, 0], [None, 0]]


@pytest.mark.requirement("FR-00077.9")
def test_arming_says_what_is_too_little(told: Any) -> None:
    """In ArduPilot's words."""
    assert told["arming"] == [
        "PreArm: Battery 1 below minimum arming capacity",
        None,
        "PreArm: Battery 1 low capacity failsafe",
        "PreArm: Battery 1 critical capacity failsafe",
        "PreArm: Battery 1 capacity failsafe critical >= low",
        None,
    ]
