"""Each class of statement that a reader understands, right and wrong: amounts, ranges, lengths, order, commands and others."""

from typing import Any

import pytest

TWINS = [
    # rule, what is right, what is wrong, what the finding says
    ("claim-scaling", "14.8 V is sent as 14800 in POWER_STATUS.Vcc.", "14.8 V is sent as 1480 in POWER_STATUS.Vcc.", "14.8 V is 14800"),
    ("claim-scaling", "SCALED_PRESSURE.temperature = 2150 means 21.5 degC.", "SCALED_PRESSURE.temperature = 215 means 21.5 degC.", "is 2150"),
    ("claim-scaling", "At 5 Hz `interval_us` of MESSAGE_INTERVAL will read 200000.", "At 5 Hz `interval_us` of MESSAGE_INTERVAL will read 200.", "5 Hz is 200000"),
    ("claim-scaling", "To get m, DISTANCE_SENSOR.current_distance is divided by 100.", "To get m, DISTANCE_SENSOR.current_distance is divided by 1000.", "is in cm"),
    ("claim-scaling", "GPS_RAW_INT.lat is scaled by 10000000.", "GPS_RAW_INT.lat is scaled by 100000.", "is in degE7"),
    ("claim-range", "`rssi` of RC_CHANNELS ends at 255.", "`rssi` of RC_CHANNELS ends at 65535.", "its maximum is 255"),
    ("claim-range", "`temperature` of SCALED_PRESSURE2 cannot be more than 327.67 degC.", "`temperature` of SCALED_PRESSURE2 cannot be more than 655.35 degC.", "not 655.35 degC"),
    ("claim-range", "GPS2_RAW.cog goes from 0 to 35999.", "GPS2_RAW.cog goes from 0 to 3599.", "a full turn is 36000"),
    ("claim-range", "`rssi` of RC_CHANNELS_RAW has values 0..255.", "`rssi` of RC_CHANNELS_RAW has values 0..256.", "not 256"),
    ("claim-struct", "ACTUATOR_OUTPUT_STATUS has room for 32 values in `actuator`.", "ACTUATOR_OUTPUT_STATUS has room for 16 values in `actuator`.", "has 32 elements"),
    ("claim-struct", "```python\nvalues = [0] * 32  # size of ACTUATOR_OUTPUT_STATUS.actuator\n```", "```python\nvalues = [0] * 16  # size of ACTUATOR_OUTPUT_STATUS.actuator\n```", "has 32 elements"),
    ("claim-struct", "## ACTUATOR_OUTPUT_STATUS\n\n| Field | Length |\n| --- | --- |\n| actuator | 32 |", "## ACTUATOR_OUTPUT_STATUS\n\n| Field | Length |\n| --- | --- |\n| actuator | 8 |", "has 32 elements"),
    ("claim-struct", "## ACTUATOR_OUTPUT_STATUS\n\n- `actuator[31]`", "## ACTUATOR_OUTPUT_STATUS\n\n- `actuator[40]`", "there is no 40"),
    ("claim-struct", "`load` of SYS_STATUS goes out as uint16.", "`load` of SYS_STATUS goes out as int16.", "is uint16_t"),
    ("claim-struct", "## MISSION_COUNT\n\n```ts\ninterface Count {\n  missionType: number; // uint8_t\n}\n```", "## MISSION_COUNT\n\n```ts\ninterface Count {\n  missionType: number; // uint16_t\n}\n```", "mission_type is uint8_t"),
    ("claim-message-size", "SYS_STATUS grows from 31 to 43 bytes with its extensions.", "SYS_STATUS grows from 31 to 45 bytes with its extensions.", "not 45"),
    ("claim-message-size", "SCALED_IMU would be 22 bytes, 34 in the v2 frame.", "SYSTEM_TIME would be 12 bytes, 26 in the v2 frame.", "not 26"),
    ("claim-message-size", "base payload of EFI_STATUS: 65 bytes", "base payload of EFI_STATUS: 73 bytes", "not 73"),
    ("claim-message-size", "```c\nstatic_assert(sizeof(mavlink_system_time_t) == 12);\n```", "```c\nstatic_assert(sizeof(mavlink_system_time_t) == 14);\n```", "not 14"),
    ("claim-bytes-per-second", "Sending SYSTEM_TIME every 100 ms takes 240 bytes/s.", "Sending SYSTEM_TIME every 100 ms takes 260 bytes/s.", "240 bytes/s"),
    ("claim-bytes-per-second", "| Message | Frame | Rate | B/s |\n| --- | --- | --- | --- |\n| VFR_HUD | 32 | 4 Hz | 128 |", "| Message | Frame | Rate | B/s |\n| --- | --- | --- | --- |\n| VFR_HUD | 32 | 4 Hz | 138 |", "are 128 bytes/s"),
    ("claim-message-id", "RADIO_STATUS is 109, see the XML.", "RADIO_STATUS is 166, see the XML.", "has the id 109"),
    ("claim-message-id", "We request it: param1 = 33 for GLOBAL_POSITION_INT.", "We request it: param1 = 32 for GLOBAL_POSITION_INT.", "has the id 33"),
    ("claim-message-id", "```python\nHEARTBEAT = 0\nVFR_HUD = 74\n```", "```python\nHEARTBEAT = 0\nVFR_HUD = 75\n```", "has the id 74"),
    ("claim-sentinel", "If nothing is known, `rssi` of RC_CHANNELS is 255.", "If nothing is known, `rssi` of RC_CHANNELS is 100.", "is 255, not 100"),
    ("claim-sentinel", "```c\nmsg.load = 0; // SYS_STATUS\nmsg.rssi = 255; // RC_CHANNELS: unknown\n```", "```c\nmsg.rssi = 254; // RC_CHANNELS: unknown\n```", "is 255, not 254"),
    ("claim-sentinel", "`rssi`, `remrssi` of RADIO_STATUS\n: signal. 255 is the value for unknown.", "RADIO_STATUS\n\n`rssi`, `remrssi`\n: signal. 0 is the value for unknown.", "not 0"),
    ("claim-extension", "## LANDING_TARGET\n\n- `position_valid` (ext)", "## LANDING_TARGET\n\n- `position_valid` (base)", "is an extension"),
    ("claim-extension", "In LANDING_TARGET we give `x`, `y`, `z` and `q`. These four are extensions.", "In LANDING_TARGET we give `x`, `y`, `z` and `q`. These four are base fields.", "is an extension"),
    ("claim-extension", "## LANDING_TARGET\n\n| Field | Extension |\n| --- | --- |\n| position_valid | yes |", "## LANDING_TARGET\n\n| Field | Extension |\n| --- | --- |\n| position_valid | no |", "is an extension"),
    ("claim-wire-order", "Wire order of ODOMETRY: `time_usec` comes first, `x` and `y` come second and third.", "Wire order of ODOMETRY: `time_usec` comes first, `frame_id` and `x` come second and third.", "x comes second"),
    ("claim-wire-order", "RADIO_STATUS starts with `rxerrors` on the wire.", "RADIO_STATUS starts with `rssi` on the wire.", "rxerrors comes first"),
    ("claim-enum-value", "MAV_CMD_DO_SET_SERVO, command 183, is used.", "MAV_CMD_DO_SET_SERVO, command 184, is used.", "is 183, not 184"),
    ("claim-enum-value", "```yaml\nMAV_LANDED_STATE_IN_AIR: 2\n```", "```yaml\nMAV_LANDED_STATE_IN_AIR: 3\n```", "is 2, not 3"),
    ("claim-no-entry", "`landed_state` of EXTENDED_SYS_STATE is MAV_LANDED_STATE_TAKEOFF.", "`landed_state` of EXTENDED_SYS_STATE is LANDED_MAV_STATE_TAKEOFF.", "no entry LANDED_MAV_STATE_TAKEOFF"),
    ("claim-no-message", "RAW_RPM (339) is sent.", "RPM_RAW_VALUE is ours; RAW_RPMS (339) is sent.", "no message RAW_RPMS"),
    ("claim-no-message", "## RAW_RPM\n\nId 339 in common.xml.", "## RAW_RPM_STATUS\n\nId 339 in common.xml.", "no message RAW_RPM_STATUS"),
    ("claim-command-parameter", "Param 2 of MAV_CMD_SET_MESSAGE_INTERVAL is the interval in us.", "Param 2 of MAV_CMD_SET_MESSAGE_INTERVAL is the interval in ms.", "is in us, not ms"),
    ("claim-command-parameter", "MAV_CMD_SET_MESSAGE_INTERVAL: p2 = 2000, the interval in us.", "MAV_CMD_SET_MESSAGE_INTERVAL: p2 = 2000, the interval in ms.", "us"),
    ("claim-sentinel", "`rssi` of RC_CHANNELS: 255 means that the sensor does not know.", "`rssi` of RC_CHANNELS: 100 means that the sensor does not know.", "not 100"),
    ("claim-command-parameter", "MAV_CMD_DO_SET_SERVO takes the pwm in param2.", "MAV_CMD_DO_SET_SERVO takes the pwm in param1.", "PWM is param 2, not 1"),
    ("claim-unit", "```python\nvalue = msg.current_distance  # DISTANCE_SENSOR, cm\n```", "```python\nvalue = msg.current_distance  # DISTANCE_SENSOR, mm\n```", "is in cm, not mm"),
    ("claim-unit", "The unit of `battery_voltage` in ACTUATOR_OUTPUT_STATUS is open; that of `vel` in GPS2_RAW is cm/s.", "The unit of `Vcc` in POWER_STATUS is V.", "is in mV, not V"),
]  # fmt: skip

ASIDES = [
    "We show `vel` of GPS2_RAW in m/s.",
    "The draft would make `vel` of GPS2_RAW int32_t.",
    "Older firmware sent `Vcc` of POWER_STATUS as float.",
    "Our variable for POWER_STATUS.Vcc is float.",
    "With CRC_EXTRA 204 POWER_STATUS was rejected.",
    "`rssi` of RC_CHANNELS must not be 0 if unknown.",
    "The link has 150 bytes/s, enough for SYSTEM_TIME at 4 Hz.",
    "`system_tyme` is a function that packs SYSTEM_TIME with `time_unix_usec`.",
    "We reverted the change that treated SYS_STATUS.load as percent. POWER_STATUS is sent, too.",
    "## POWER_STATUS\n\n```rust\nlet sum = m.Vcc.iter().map(|v| f32::from(v)).sum::<f32>();\n```",
    "On MAVLink 1 the length is the base size: 51 for STATUSTEXT, 12 for SYSTEM_TIME, and the overhead is 8 bytes.",
    "SYSTEM_TIME is sent.\n\n## REEFER_STATUS (50100)\n\n| Field | Type |\n| --- | --- |\n| door | uint8_t |\n\n7 bytes. Sent each hour.",
    "Both are kept:\n\n1. The flight log, message `SRV`. Pitch and roll in degrees.\n2. The telemetry, ATTITUDE.",
    '`GET /pose` gives `{"roll": 3, "pitch": 2}`, degrees. It comes from ATTITUDE.',
    "SCALED_PRESSURE.temperature is in centidegrees.",
    "LOGGING_DATA, 249 bytes in one message.",
    "```cpp\n// pose (x y z, full matrix = 36 doubles) -> ATT_POS_MOCAP\n```",
    "```ts\nexport interface Panel {\n  load: number; // percent\n}\n```\n\nIt is filled from SYS_STATUS and POWER_STATUS.",
    "**May I use LOGGING_DATA, or LOGGING_DATA_ACKED?**\n\nBoth.\n\n**And `data`?**\n\nZeros, if there is nothing. 20 bytes.",
    "## POWER_STATUS\n\n| Field | Our column | Column type |\n| --- | --- | --- |\n| Vcc | volts | float |",
]


@pytest.mark.parametrize(("rule", "right", "wrong", "says"), TWINS, ids=[case[2][:50] for case in TWINS])
def test_a_statement_is_found_where_it_is_wrong(check: Any, rule: str, right: str, wrong: str, says: str) -> None:
    assert [one for one in check(f"{right}\n") if one.rule.id == rule] == []
    found = [(one.rule.id, f"{one.message}; {one.hint}") for one in check(f"{wrong}\n")]
    assert [text for own, text in found if own == rule and says in text], found


@pytest.mark.parametrize("text", ASIDES)
def test_a_sentence_about_something_else_is_no_claim(check: Any, text: str) -> None:
    assert check(f"{text}\n") == []
