"""What a reader supplies: names for pronouns, from headings, other cells and aligned lines; and whose words they are not."""

from typing import Any

import pytest

TWINS = [
    # rule, what is right, what is wrong, what the finding says
    ("claim-unit", "`Vcc` of POWER_STATUS tells the supply. It is given in millivolts.", "`Vcc` of POWER_STATUS tells the supply. It is given in volts.", "is in mV"),
    ("claim-struct", "See `tc1` and `ts1` of TIMESYNC. Both are int64.", "See `tc1` and `ts1` of TIMESYNC. Both are uint64.", "is int64_t"),
    ("claim-sentinel", "POWER_STATUS is sent.\n\nMind `eph` of GPS_RAW_INT. If it is not known, set it to 65535.", "Mind `eph` of GPS_RAW_INT. If it is not known, set it to 9999.", "not 9999"),
    ("claim-unit", "## DISTANCE_SENSOR\n\n### `max_distance`\n\n`uint16_t`, cm from the lens.", "## DISTANCE_SENSOR\n\n### `max_distance`\n\n`uint16_t`, mm from the lens.", "is in cm"),
    ("claim-struct", "What DISTANCE_SENSOR sends:\n\n    min_distance   uint16  cm\n    max_distance   uint16  cm\n    time_boot_ms   uint32  ms\n", "What DISTANCE_SENSOR sends:\n\n    min_distance   uint16  cm\n    max_distance   int16   cm\n    time_boot_ms   uint32  ms\n", "is uint16_t"),
    ("claim-sentinel", "```\nmessage,field,type,unknown\nGPS_RAW_INT,eph,uint16_t,65535\nGPS_RAW_INT,epv,uint16_t,65535\nGPS_RAW_INT,vel,uint16_t,65535\n```", "```\nmessage,field,type,unknown\nGPS_RAW_INT,eph,uint16_t,65535\nGPS_RAW_INT,epv,uint16_t,9999\nGPS_RAW_INT,vel,uint16_t,65535\n```", "not 9999"),
    ("claim-sentinel", "## GPS_RAW_INT\n\n| Requirement | Field |\n| --- | --- |\n| while the dilution is unknown it holds 65535 | `eph` |", "## GPS_RAW_INT\n\n| Requirement | Field |\n| --- | --- |\n| while the dilution is unknown it holds 9999 | `eph` |", "not 9999"),
    ("claim-sentinel", "No receiver on board? Then `eph` of GPS_RAW_INT is filled with 65535.", "No receiver on board? Then `eph` of GPS_RAW_INT is filled with -1.", "not -1"),
    ("claim-enum-value", "`flags` = 258, which is CAMERA_CAP_FLAGS_CAPTURE_IMAGE and CAMERA_CAP_FLAGS_HAS_VIDEO_STREAM.", "`flags` = 514, which is CAMERA_CAP_FLAGS_CAPTURE_IMAGE and CAMERA_CAP_FLAGS_HAS_VIDEO_STREAM.", "is 258"),
    ("claim-enum-value", "The card says STORAGE_STATUS_READY, which is 2.", "The card says STORAGE_STATUS_READY, which is 1.", "is 2, not 1"),
    ("claim-offset", "POWER_STATUS on the wire:\n\n- 0 `Vcc`\n- 2 `Vservo`\n- 4 `flags`\n\nDISTANCE_SENSOR is another one.", "DISTANCE_SENSOR in bytes:\n\n- 0 `time_boot_ms`\n- 4 `min_distance`\n- 6 `max_distance`\n- 9 `current_distance`\n- 10 `type`", "begins at byte 8"),
    ("claim-no-field", "The `press_abs` of SCALED_PRESSURE is a float.", "The `press_absolute` of SCALED_PRESSURE is a float.", "has no field press_absolute"),
    ("claim-no-field", "GPS_RAW_INT gives `lat` and `lon`.", "GPS_RAW_INT gives `lat` and `lng`.", "has no field lng"),
    ("claim-no-message", "The angle is `yaw` of GIMBAL_DEVICE_ATTITUDE_STATUS? No, `flags` of it is. ATTITUDE has it.", "We read `failure_flags` of GIMBAL_DEVICE_STATUS. ATTITUDE is next.", "there is no message GIMBAL_DEVICE_STATUS"),
    ("claim-extension", "## POWER_STATUS\n\n- `flags`: two bytes, base field.", "## POWER_STATUS\n\n- `flags`: two bytes, extension field.", "is a base field"),
    ("claim-scaling", "```c\nmavlink_global_position_int_t g;\np->alt = g.alt / 1000.0f;  // MSL, metres\n```", "```c\nmavlink_global_position_int_t g;\np->alt = g.alt / 100.0f;  // MSL, metres\n```", "is in mm"),
    ("claim-scaling", "The sensor of SCALED_PRESSURE is warm: a day of 21.5 degC comes as 2150.", "The sensor of SCALED_PRESSURE is warm: a day of 21.5 degC comes as 215.", "is 2150"),
    ("claim-unit", "HIL_SENSOR comes at 250 Hz. Accelerations are sent in m/s/s.", "HIL_SENSOR comes at 250 Hz. Accelerations are sent in milli-g.", "is in m/s/s"),
    ("claim-unit", "## SCALED_PRESSURE\n\n| Field | Type | LSB |\n| --- | --- | --- |\n| temperature | int16_t | 0.01 °C |", "## SCALED_PRESSURE\n\n| Field | Type | LSB |\n| --- | --- | --- |\n| temperature | int16_t | 0.1 °C |", "is in cdegC"),
    ("claim-range", "`quality` of OPTICAL_FLOW_RAD runs from 0 to 255.", "`rssi` of RC_CHANNELS runs from 0 to 100.", "not to 100"),
    ("claim-command-parameter", "## MAV_CMD_DO_CHANGE_SPEED\n\n1. param2 = 12 (m/s).", "## MAV_CMD_DO_CHANGE_SPEED\n\n1. param2 = 1200 (cm/s).", "is in m/s"),
    ("claim-message-id", "RPM comes as ODOMETRY (331) does.", "RPM comes as ODOMETRY (330) does.", "has the id 331"),
]  # fmt: skip

ASIDES = [
    "`vel_acc` of GPS_RAW_INT was taken for cm/s, like `vel`. It is mm/s, of course.",
    "`eph` of GPS_RAW_INT is not `epv`. Each of them is a reason to wait. It is worth the time in s.",
    "`lat` and `lon` of GPS_RAW_INT are doubles in the struct on purpose.",
    "RPM comes with two floats `rpm1` and `rpm2`.",
    "SYS_STATUS is sent. CAN_XL_FRAME has a `load` of 64 bytes in V.",
    "## AIS_VESSEL\n\n| Item | Resolution | Field |\n| --- | --- | --- |\n| COG | 0.1° | `COG` (cdeg) |\n| A | 1 m, 9 bit | `dimension_bow` (m) |",
    "## ODOMETRY\n\n| Ours | Kind | Field |\n| --- | --- | --- |\n| `T_wb.q` | double[4] | `q` |",
    '```json\n{"source": "VFR_HUD.groundspeed", "scale": 1.944, "suffix": "kt"}\n```',
    "The modem takes 340 bytes, so a HIGH_LATENCY2 message is a lucky fit.",
    "The message has 25 bytes, PARAM_SET 23.",
    "Never send `eph` = 0 of GPS_RAW_INT for unknown.",
    "In the I2C mode `temperature` of HYGROMETER_SENSOR is in kelvin.",
    "If the tracker loses its features we put -1 into `quality` of ODOMETRY. Zero would mean \"not set\", 100 is the best.",
    "`flags` 1 of EKF_STATUS_REPORT is attitude, 2 and 4 are horizontal and vertical velocity.",
    "- `resolution_h`, `resolution_v` of CAMERA_INFORMATION: 9504 and 6336 pixels",
    "7. `fan_speed` of ONBOARD_COMPUTER_STATUS: no fan, all four INT16_MAX.",
    "```python\nmode = m.custom_mode  # HIGH_LATENCY2: only uint16 here, HEARTBEAT has uint32\n```",
    "## HIGH_LATENCY2\n\n| Field | Ours |\n| --- | --- |\n| `latitude` | `lat` rad |\n| `longitude` | `lon` rad |",
    "`speed` of WIND goes from 0 to 100 on our scale.",
]  # fmt: skip


@pytest.mark.parametrize(("rule", "right", "wrong", "says"), TWINS, ids=[case[2][:50] for case in TWINS])
def test_a_statement_is_found_where_its_name_is_meant(check: Any, rule: str, right: str, wrong: str, says: str) -> None:
    assert [one for one in check(f"{right}\n") if one.rule.id == rule] == []
    found = [(one.rule.id, f"{one.message}; {one.hint}") for one in check(f"{wrong}\n")]
    assert [text for own, text in found if own == rule and says in text], found


@pytest.mark.parametrize("text", ASIDES)
def test_what_is_said_of_something_else_is_no_claim(check: Any, text: str) -> None:
    assert check(f"{text}\n") == []
