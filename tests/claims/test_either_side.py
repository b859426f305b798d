"""Statements of documents on both sides of where they become wrong: the last number that may be right, and the next."""

from collections.abc import Callable

import pytest

from codegen.claims import LIKELY
from codegen.diagnostics import Diagnostic

Check = Callable[[str], list[Diagnostic]]

WHAT_IS_CERTAIN = [
    (
        "| Message | Frame |\n|---|---|\n| HEARTBEAT | 21 |\n| ATTITUDE | 40 |\n| SYS_STATUS | 56 |",
        "SYS_STATUS has a payload of 31 bytes, 43 with extensions, not 56",
    ),
    (
        "| Message | Payload |\n|---|---|\n| HEARTBEAT | 9 |\n| ATTITUDE | 28 |\n| SYS_STATUS | 44 |",
        "SYS_STATUS has a payload of 31 bytes, 43 with extensions, not 44",
    ),
    (
        "| Message | Payload |\n|---|---|\n| HEARTBEAT | 10 |\n| ATTITUDE | 29 |\n| SYS_STATUS | 31 |",
        "HEARTBEAT has a payload of 9 bytes, not 10",
        "ATTITUDE has a payload of 28 bytes, not 29",
    ),
    ("| Message | ID |\n|---|---|\n| HEARTBEAT | 0 |\n| SYS_STATUS | 2 |", "SYS_STATUS has the id 1, not 2"),
    (
        "| Message | ID |\n|---|---|\n| ATTITUDE | 30 |\n| GPS_RAW_INT | 25 |\n| VFR_HUD | 7 |",
        "GPS_RAW_INT has the id 24, not 25",
        "VFR_HUD has the id 74, not 7",
    ),
    (
        "| Message | CRC_EXTRA |\n|---|---|\n| ATTITUDE | 39 |\n| GPS_RAW_INT | 25 |",
        "GPS_RAW_INT has the CRC_EXTRA 24, not 25",
    ),
    (
        "| Message | Bytes | Rate | B/s |\n|---|---|---|---|\n| ATTITUDE | 40 | 10 Hz | 280 |",
        "ATTITUDE: 40 bytes at 10 Hz are 400 bytes/s, not 280",
    ),
    (
        "| Message | Payload | Rate | B/s |\n|---|---|---|---|\n| ATTITUDE | 28 | 10 Hz | 500 |",
        "ATTITUDE: 40 bytes at 10 Hz are 400 bytes/s, not 500",
    ),
    (
        "`temperature` of BATTERY_STATUS is -1 if unknown.",
        "BATTERY_STATUS.temperature is unknown when it is INT16_MAX, not -1",
    ),
    (
        "`current_battery` of BATTERY_STATUS is -2 if unknown.",
        "BATTERY_STATUS.current_battery is unknown when it is -1, not -2",
    ),
    (
        "`current_battery` of BATTERY_STATUS is 0 if unknown.",
        "BATTERY_STATUS.current_battery is unknown when it is -1, not 0",
    ),
    ("`eph` of GPS_RAW_INT is 0 if unknown.", "GPS_RAW_INT.eph is unknown when it is UINT16_MAX, not 0"),
    (
        "`satellites_visible` of GPS_RAW_INT is 0 if unknown.",
        "GPS_RAW_INT.satellites_visible is unknown when it is UINT8_MAX, not 0",
    ),
    (
        "`distance` of OPTICAL_FLOW_RAD is 0 if unknown.",
        "OPTICAL_FLOW_RAD.distance is unknown when it is negative, not 0",
    ),
    (
        "`ground_distance` of OPTICAL_FLOW is 0 if unknown.",
        "OPTICAL_FLOW.ground_distance is unknown when it is negative, not 0",
    ),
    ("`distances` of OBSTACLE_DISTANCE has 71 elements.", "OBSTACLE_DISTANCE.distances has 72 elements, not 71"),
    ("`distances` of OBSTACLE_DISTANCE has 73 elements.", "OBSTACLE_DISTANCE.distances has 72 elements, not 73"),
    ("`distances[73]` of OBSTACLE_DISTANCE.", "OBSTACLE_DISTANCE.distances has 72 elements, 0 to 71: there is no 73"),
    ("`distances` of OBSTACLE_DISTANCE has 72 bytes.", "OBSTACLE_DISTANCE.distances has 144 bytes, not 72"),
    ("The seed of ATTITUDE is 40.", "ATTITUDE has the CRC_EXTRA 39, not 40"),
    ("The extra byte of ATTITUDE is 40.", "ATTITUDE has the CRC_EXTRA 39, not 40"),
    ("CRC_EXTRA of ATTITUDE is 40.", "ATTITUDE has the CRC_EXTRA 39, not 40"),
    ("The checksum seed for ATTITUDE is 12.", "ATTITUDE has the CRC_EXTRA 39, not 12"),
    (
        "`xacc` of HIGHRES_IMU is in centimetres per second squared.",
        "HIGHRES_IMU.xacc is in m/s/s, not centimetres per second squared",
    ),
    ("`alt` of VFR_HUD is in feet.", "VFR_HUD.alt is in m, not feet"),
    ("`alt` of VFR_HUD is in inches.", "VFR_HUD.alt is in m, not inches"),
    ("`alt` of VFR_HUD is in centi metres.", "VFR_HUD.alt is in m, not centi metres"),
    ("`airspeed` of VFR_HUD is in kilometres per hour.", "VFR_HUD.airspeed is in m/s, not kilometres per hour"),
    ("`voltage_battery` of SYS_STATUS is in centi volts.", "SYS_STATUS.voltage_battery is in mV, not centi volts"),
    ("`load` of SYS_STATUS is in percent.", "SYS_STATUS.load is in d%, not percent"),
    ("`roll` of ATTITUDE is the angle. It is in deg.", "ATTITUDE.roll is in rad, not deg"),
    ("`roll` of ATTITUDE is the angle. The field is in deg.", "ATTITUDE.roll is in rad, not deg"),
    ("`roll` and `pitch` of ATTITUDE are angles. Both are in deg.", "ATTITUDE.roll is in rad, not deg"),
    ("`roll`, `pitch` and `yaw` of ATTITUDE are angles. They are in deg.", "ATTITUDE.yaw is in rad, not deg"),
    ("## GLOBAL_POSITION_INT\n\n- `vx`, `vy`: ground speed, in m/s", "GLOBAL_POSITION_INT.vx is in cm/s, not m/s"),
    ("## GLOBAL_POSITION_INT\n\n- `vx` and `vy`: ground speed, in m/s", "GLOBAL_POSITION_INT.vx is in cm/s, not m/s"),
    ("## ATTITUDE\n\n```c\nCRC_EXTRA = 3\n```", "ATTITUDE has the CRC_EXTRA 39, not 3"),
    ("HEARTBEAT:\n\n```\nid = 3\n```", "HEARTBEAT has the id 0, not 3"),
]
WHAT_IS_LIKELY = [
    ("`cog` of GPS_RAW_INT ends at 3600.", "GPS_RAW_INT.cog is in cdeg: a full turn is 36000, not 3600"),
    ("`cog` of GPS_RAW_INT ends at 3599.", "GPS_RAW_INT.cog is in cdeg: a full turn is 36000, not 3599"),
    ("`cog` of GPS_RAW_INT ends at 360.", "GPS_RAW_INT.cog is in cdeg: a full turn is 36000, not 360"),
    ("`cog` of GPS_RAW_INT goes up to 65536.", "GPS_RAW_INT.cog is uint16_t: its maximum is 65535 cdeg, not 65536"),
    ("`cog` of GPS_RAW_INT goes up to 65537.", "GPS_RAW_INT.cog is uint16_t: its maximum is 65535 cdeg, not 65537"),
    ("`cog` of GPS_RAW_INT goes up to 70000.", "GPS_RAW_INT.cog is uint16_t: its maximum is 65535 cdeg, not 70000"),
    ("`cog` of GPS_RAW_INT wraps at 65538.", "GPS_RAW_INT.cog is uint16_t: its maximum is 65535 cdeg, not 65538"),
    ("`cog` of GPS_RAW_INT ends at 255.", "GPS_RAW_INT.cog is uint16_t: its maximum is 65535 cdeg, not 255"),
    ("`cog` of GPS_RAW_INT ends at 32767.", "GPS_RAW_INT.cog is uint16_t: its maximum is 65535 cdeg, not 32767"),
    ("`cog` of GPS_RAW_INT ends at 127.", "GPS_RAW_INT.cog is uint16_t: its maximum is 65535 cdeg, not 127"),
    (
        "`vx` of GLOBAL_POSITION_INT goes up to 655.35 m/s.",
        "GLOBAL_POSITION_INT.vx is int16_t: its maximum is 32767 cm/s, not 655.35 m/s",
    ),
    (
        "`vx` of GLOBAL_POSITION_INT goes up to 330 m/s.",
        "GLOBAL_POSITION_INT.vx is int16_t: its maximum is 32767 cm/s, not 330 m/s",
    ),
    (
        "`vx` of GLOBAL_POSITION_INT goes from -40000 to 40000.",
        "GLOBAL_POSITION_INT.vx is int16_t: its maximum is 32767 cm/s, not 40000",
    ),
    (
        "`vx` of GLOBAL_POSITION_INT takes values from -2147483648 to 32767.",
        "GLOBAL_POSITION_INT.vx is int16_t: its minimum is -32768 cm/s, not -2147483648",
    ),
    ("`throttle` of VFR_HUD runs from 0 to 255.", "VFR_HUD.throttle is uint16_t: its maximum is 65535 %, not 255"),
    ("`throttle` of VFR_HUD runs from 1 to 255.", "VFR_HUD.throttle is uint16_t: its maximum is 65535 %, not 255"),
    ("`throttle` of VFR_HUD runs from 2 to 255.", "VFR_HUD.throttle is uint16_t: its maximum is 65535 %, not 255"),
    ("`throttle` of VFR_HUD runs from 0 to 5000.", "VFR_HUD.throttle goes from 0 to 100, not to 5000"),
    (
        "`hdg` of GLOBAL_POSITION_INT is at most 3600.",
        "GLOBAL_POSITION_INT.hdg is in cdeg: a full turn is 36000, not 3600",
    ),
    (
        "`hdg` of GLOBAL_POSITION_INT is at most 180.",
        "GLOBAL_POSITION_INT.hdg is in cdeg: a full turn is 36000, not 180",
    ),
    (
        "`hdg` of GLOBAL_POSITION_INT is at most 179.",
        "GLOBAL_POSITION_INT.hdg is in cdeg: a full turn is 36000, not 179",
    ),
    (
        "`hdg` of GLOBAL_POSITION_INT is at most 1800.",
        "GLOBAL_POSITION_INT.hdg is in cdeg: a full turn is 36000, not 1800",
    ),
    (
        "`battery_remaining` of SYS_STATUS ends at 255.",
        "SYS_STATUS.battery_remaining is int8_t: its maximum is 127 %, not 255",
    ),
    (
        "`lat` of GPS_RAW_INT ends at 4294967295.",
        "GPS_RAW_INT.lat is int32_t: its maximum is 2147483647 degE7, not 4294967295",
    ),
    ("`lat` of GPS_RAW_INT ends at 32767.", "GPS_RAW_INT.lat is int32_t: its maximum is 2147483647 degE7, not 32767"),
    (
        "HEARTBEAT.\n\n2 Hz costs 40 bytes/s.",
        "40 bytes/s are 20 bytes at 2 Hz: no message of the document has frames of that size",
    ),
    (
        "HEARTBEAT.\n\n2 Hz costs 44 bytes/s.",
        "44 bytes/s are 22 bytes at 2 Hz: no message of the document has frames of that size",
    ),
    ("HEARTBEAT.\n\n2 Hz costs 43 bytes/s.", "43 bytes/s are 21.5 bytes at 2 Hz: they are no whole bytes"),
    (
        "BATTERY_STATUS.\n\n1 Hz costs 47 bytes/s.",
        "47 bytes/s are 47 bytes at 1 Hz: no message of the document has frames of that size",
    ),
    (
        "BATTERY_STATUS.\n\n1 Hz costs 67 bytes/s.",
        "67 bytes/s are 67 bytes at 1 Hz: no message of the document has frames of that size",
    ),
    ("ATTITUDE at 10 Hz is about 460 bytes/s.", "ATTITUDE: frames of 40 bytes are 400 bytes/s at 10 Hz, not 460"),
    ("ATTITUDE at 10 Hz is about 600 bytes/s.", "ATTITUDE: frames of 40 bytes are 400 bytes/s at 10 Hz, not 600"),
    ("ATTITUDE at 10 Hz is 5000 bits/s.", "ATTITUDE: frames of 40 bytes are 3200 bits/s at 10 Hz, not 5000"),
    ("ATTITUDE at 10 Hz is 401 bytes/s.", "ATTITUDE: frames of 40 bytes are 400 bytes/s at 10 Hz, not 401"),
    ("ATTITUDE every 100 ms is 500 bytes/s.", "ATTITUDE: frames of 40 bytes are 400 bytes/s at 10 Hz, not 500"),
    ("ATTITUDE every 2 s is 30 bytes/s.", "ATTITUDE: frames of 40 bytes are 20 bytes/s at 0.5 Hz, not 30"),
    ("ATTITUDE once per second is 90 bytes/s.", "ATTITUDE: frames of 40 bytes are 40 bytes/s at 1 Hz, not 90"),
    ("ATTITUDE (40 bytes) at 10 Hz is 410 bytes/s.", "40 bytes at 10 Hz are 400 bytes/s, not 410"),
    ("ATTITUDE frames at 10 Hz are 280 bytes/s.", "ATTITUDE: frames of 40 bytes are 400 bytes/s at 10 Hz, not 280"),
    ("ATTITUDE 10 times per second is 500 bytes/s.", "ATTITUDE: frames of 40 bytes are 400 bytes/s at 10 Hz, not 500"),
    (
        "| Message | Rate | B/s |\n|---|---|---|\n| ATTITUDE | 10 Hz | 400 |\n| HEARTBEAT | 1 Hz | 21 |\n| VFR_HUD | 4 Hz | 128 |\n| SYS_STATUS | 1 Hz | 60 |",
        "SYS_STATUS: 55 bytes at 1 Hz are 55 bytes/s, not 60",
    ),
    (
        "Param 2 of MAV_CMD_CONDITION_YAW is the speed in rad/s.",
        "MAV_CMD_CONDITION_YAW: param 2 (Angular Speed) is in deg/s, not rad/s",
    ),
    (
        "Param 2 of MAV_CMD_CONDITION_YAW is the maximal angular speed in rad/s.",
        "MAV_CMD_CONDITION_YAW: param 2 (Angular Speed) is in deg/s, not rad/s",
    ),
    ("Param 2 of MAV_CMD_CONDITION_YAW is the angle in deg.", "MAV_CMD_CONDITION_YAW: Angle is param 1, not 2"),
    ("`text` of STATUSTEXT has 48 characters.", "STATUSTEXT.text has 50 elements, not 48"),
    ("`text` of STATUSTEXT has 51 characters.", "STATUSTEXT.text has 50 elements, not 51"),
    (
        "There is room for 71 values in `distances` of OBSTACLE_DISTANCE.",
        "OBSTACLE_DISTANCE.distances has 72 elements, not 71",
    ),
    (
        "There is room for 143 bytes in `distances` of OBSTACLE_DISTANCE.",
        "OBSTACLE_DISTANCE.distances has 72 elements, not 143",
    ),
    ("8 bytes `roll` of ATTITUDE.", "ATTITUDE.roll has 4 bytes, not 8"),
]
WHAT_MAY_BE_RIGHT = [
    "`cog` of GPS_RAW_INT ends at 65535.",
    "`cog` of GPS_RAW_INT ends at 36000.",
    "`cog` of GPS_RAW_INT ends at 35999.",
    "`cog` of GPS_RAW_INT ends at 18000.",
    "`cog` of GPS_RAW_INT wraps at 65536.",
    "`cog` of GPS_RAW_INT wraps at 65537.",
    "`vx` of GLOBAL_POSITION_INT goes up to 327.67 m/s.",
    "`vx` of GLOBAL_POSITION_INT goes up to 329 m/s.",
    "`vx` of GLOBAL_POSITION_INT goes up to 32.767 m/s.",
    "`vx` of GLOBAL_POSITION_INT goes from -32768 to 32767.",
    "`throttle` of VFR_HUD runs from 0 to 100.",
    "`throttle` of VFR_HUD runs from 0 to 5001.",
    "`throttle` of VFR_HUD runs from 0 to 65535.",
    "`rssi` of RC_CHANNELS runs from 0 to 254.",
    "`rssi` of RC_CHANNELS runs from 0 to 255.",
    "`rssi` of RC_CHANNELS runs from 0 to 100 percent.",
    "`battery_remaining` of SYS_STATUS ends at 127.",
    "`battery_remaining` of SYS_STATUS ends at 100.",
    "`cog` of GPS_RAW_INT can show no more than 360 deg.",
    "`cog` of GPS_RAW_INT is limited to 655.35 deg.",
    "`lat` of GPS_RAW_INT ends at 2147483647.",
    "HEARTBEAT.\n\n2 Hz costs 42 bytes/s.",
    "BATTERY_STATUS.\n\n1 Hz costs 48 bytes/s.",
    "BATTERY_STATUS.\n\n1 Hz costs 66 bytes/s.",
    "ATTITUDE at 10 Hz is about 400 bytes/s.",
    "ATTITUDE at 10 Hz is about 440 bytes/s.",
    "ATTITUDE at 10 Hz is 3200 bits/s.",
    "ATTITUDE at 10 Hz is 4000 bits/s.",
    "ATTITUDE at 10 Hz is 400.5 bytes/s.",
    "ATTITUDE every 2 s is 20 bytes/s.",
    "ATTITUDE once per second is 40 bytes/s.",
    "ATTITUDE takes 28 bytes; at 10 Hz that is 280 bytes/s.",
    "| Message | Bytes |\n|---|---|\n| HEARTBEAT | 17 |\n| ATTITUDE | 36 |\n| SYS_STATUS | 39 |",
    "| Message | ID |\n|---|---|\n| HEARTBEAT | 1 |\n| SYS_STATUS | 2 |",
    "| Message | ID |\n|---|---|\n| ATTITUDE | 1 |\n| GPS_RAW_INT | 2 |",
    "| Message | ID |\n|---|---|\n| ATTITUDE | 0 |\n| GPS_RAW_INT | 1 |\n| VFR_HUD | 2 |",
    "| Message | Rate | B/s |\n|---|---|---|\n| ATTITUDE | 10 Hz | 400 |\n| HEARTBEAT | 1 Hz | 21 |\n| SYS_STATUS | 1 Hz | 60 |",
    "| Message | Payload | Rate | B/s |\n|---|---|---|---|\n| ATTITUDE | 28 | 10 Hz | 400 |",
    "Param 1 of MAV_CMD_CONDITION_YAW is the angle in deg.",
    "Param 1 of MAV_CMD_CONDITION_YAW is the direction.",
    "`temperature` of BATTERY_STATUS is 32767 if unknown.",
    "`temperature` of BATTERY_STATUS is INT16_MAX if unknown.",
    "`eph` of GPS_RAW_INT is 65535 if unknown.",
    "`type` of BATTERY_STATUS is 0 if unknown.",
    "`distance` of OPTICAL_FLOW_RAD is -5 if unknown.",
    "`ground_distance` of OPTICAL_FLOW is -1 if unknown.",
    "Never set `eph` of GPS_RAW_INT to 0 if unknown.",
    "`temperature` of BATTERY_STATUS: INT16_MAX.",
    "`distances` of OBSTACLE_DISTANCE has 72 elements.",
    "`distances[71]` of OBSTACLE_DISTANCE is the last.",
    "`distances[72]` of OBSTACLE_DISTANCE.",
    "`distances` of OBSTACLE_DISTANCE has 144 bytes.",
    "`distances` of OBSTACLE_DISTANCE has 2 bytes.",
    "`text` of STATUSTEXT has 50 characters.",
    "`text` of STATUSTEXT has 49 characters.",
    "There is room for 144 bytes in `distances` of OBSTACLE_DISTANCE.",
    "4 bytes `roll` of ATTITUDE.",
    "The seed of ATTITUDE is 39.",
    "`xacc` of HIGHRES_IMU is in metres per second squared.",
    "`xacc` of HIGHRES_IMU is in metres per second per second.",
    "`airspeed` of VFR_HUD is in metres a second.",
    "`load` of SYS_STATUS is in per mille.",
    "`roll`, `pitch` and `yaw` of ATTITUDE are angles. Both are in deg.",
]


@pytest.mark.parametrize("case", WHAT_IS_CERTAIN, ids=lambda case: case[0][:60])
def test_what_is_certainly_wrong(case: tuple[str, ...], check: Check) -> None:
    text, *said = case
    assert [(each.message, each.is_error) for each in check(f"MAVLink.\n\n{text}\n")] == [(one, True) for one in said]


@pytest.mark.parametrize(("text", "said"), WHAT_IS_LIKELY, ids=lambda text: text[:60])
def test_what_is_likely_wrong(text: str, said: str, check: Check) -> None:
    assert [each.message for each in check(f"MAVLink.\n\n{text}\n")] == [f"{said} ({LIKELY})"]


@pytest.mark.parametrize("text", WHAT_MAY_BE_RIGHT, ids=lambda text: text[:60])
def test_what_may_be_right(text: str, check: Check) -> None:
    assert check(f"MAVLink.\n\n{text}\n") == []
