"""Blocks of data with their comments, what nobody fills, and fields that are only described: right and wrong."""

from typing import Any

import pytest

TWINS = [
    # rule, what is right, what is wrong, what the finding says
    ("claim-scaling", "```yaml\n- message: GPS_RAW_INT\n  field: alt\n  factor: 0.001\n  unit: m\n```", "```yaml\n- message: GPS_RAW_INT\n  field: alt\n  factor: 0.01\n  unit: m\n```", "the factor 0.01 does not turn into m"),
    ("claim-scaling", '```json\n{"SYS_STATUS": {"load": {"div": 10, "unit": "%"}}}\n```', '```json\n{"SYS_STATUS": {"load": {"div": 100, "unit": "%"}}}\n```', "the factor 100"),
    ("claim-scaling", "```yaml\n- source: VFR_HUD.groundspeed\n  factor: 1.944\n  unit: kt\n```", "```yaml\n- source: VFR_HUD.groundspeed\n  factor: 19.44\n  unit: kt\n```", "the factor 19.44"),
    ("claim-unit", "```yaml\n- source: SYS_STATUS.voltage_battery\n  # mV on the wire\n  x: 1\n```", "```yaml\n- source: SYS_STATUS.voltage_battery\n  # cV on the wire\n  x: 1\n```", "is in mV, not cV"),
    ("claim-unit", '```json\n{"source": "VFR_HUD.heading",  // raw, deg\n "x": 1}\n```', '```json\n{"source": "VFR_HUD.heading",  // raw, cdeg\n "x": 1}\n```', "is in deg, not cdeg"),
    ("claim-unit", "`current_battery` of SYS_STATUS is in units of 0.01 A.", "`current_battery` of SYS_STATUS is in units of 0.1 A.", "not steps of 0.1 A"),
    ("claim-no-field", "```yaml\n- message: VFR_HUD\n  field: groundspeed\n```", "```yaml\n- message: VFR_HUD\n  field: ground_speed\n```", "no field ground_speed"),
    ("claim-no-field", "## VISION_POSITION_ESTIMATE\n\nThe time is named `usec`.", "ODOMETRY comes first.\n\n## VISION_POSITION_ESTIMATE\n\nThe time is named `time_usec`.", "no field time_usec"),
    ("claim-sentinel", "## OBSTACLE_DISTANCE\n\nSectors without a measurement are set to 65535.", "## OBSTACLE_DISTANCE\n\nSectors without a measurement are set to 0.", "[UINT16_MAX], not 0"),
    ("claim-sentinel", "## BATTERY_STATUS\n\n`voltages`: 65535 marks a cell that is not fitted.", "## BATTERY_STATUS\n\n`voltages`: 0 marks a cell that is not fitted.", "not 0"),
    ("claim-sentinel", "## BATTERY_STATUS\n\nCells past the last end are sent as 65535.", "## BATTERY_STATUS\n\nCells that nobody measures are sent as 1.", "not 1"),
    ("claim-unit", "## OBSTACLE_DISTANCE\n\nThe ring is an array.\n\n- each sector is in cm, from the nose", "## OBSTACLE_DISTANCE\n\nThe ring is an array.\n\n- each sector is in metres, from the nose", "distances is in cm"),
    ("claim-struct", "ODOMETRY.velocity_covariance has 21 elements, of which we use the first 6.", "ODOMETRY.velocity_covariance has 36 elements, of which we use the first 6.", "has 21 elements"),
    ("claim-enum-of-field", "`type` of HEARTBEAT is coded according to MAV_TYPE.", "`type` of HEARTBEAT is coded according to MAV_AUTOPILOT.", "has the enum MAV_TYPE"),
    ("claim-scaling", "In COMMAND_INT `x` and `y` are integers. With a global frame that is degrees times 1e7, else metres times 1e4.", "In COMMAND_INT `x` and `y` are integers. With a global frame that is degrees times 1e7, else metres times 1e3.", "not metres times 1e3"),
    ("claim-sentinel", "## GPS_RAW_INT\n\n- `eph`; 65535 if the receiver got no lock", "## GPS_RAW_INT\n\n- `eph`; 9999 if the receiver got no lock", "UINT16_MAX, not 9999"),
    ("claim-struct", "## GLOBAL_POSITION_INT\n\nThe altitude is an int32_t.", "## VFR_HUD\n\nThe throttle comes as int16_t.", "throttle is uint16_t"),
    ("claim-struct", "## VIBRATION\n\n`clipping_0` grew; that is a 32-bit counter.", "## VIBRATION\n\n`clipping_0` grew; that is a 16-bit counter.", "clipping_0 is uint32_t"),
    ("claim-range", "## RC_CHANNELS\n\nLook at `rssi`. More than 255 cannot be represented.", "## RC_CHANNELS\n\nLook at `rssi`. More than 65535 cannot be represented.", "its maximum is 255"),
    ("claim-offset", "| Message | Fields (offset) |\n| --- | --- |\n| ATTITUDE | roll (4) |", "| Message | Fields (offset) |\n| --- | --- |\n| ATTITUDE | roll (8) |", "begins at byte 4"),
    ("claim-extension", "## LANDING_TARGET\n\n`size_x` and `size_y` are part of the original message.", "## LANDING_TARGET\n\n`size_x` and `size_y` belong to the later additions.", "is a base field"),
    ("claim-message-size", "## SYS_STATUS\n\nSums and a voltage, 31 bytes in base.", "## SYS_STATUS\n\nSums and a voltage, 33 bytes in base.", "not 33"),
]  # fmt: skip

ASIDES = [
    "## BATTERY_STATUS\n\n- `voltages`: six cells, the other four elements are UINT16_MAX",
    "GPS_RTCM_DATA carries pieces of it, the largest RTCM frame has 720 bytes.",
    "## VIBRATION\n\n200 x (12 + 32) = 8800 bytes a second.",
    "Signing takes 13 bytes: HEARTBEAT at 26 Hz, that is 338 bytes/s more.",
    "TIMESYNC: `tc1` is in **nano**seconds.",
    "SCALED_IMU2 sends 0 as `temperature` if there is none; a true 0 degC is sent as 1.",
    "## EFI_STATUS\n\n`fuel_consumed` is filled by us. The controller's bus reports fuel in grams per hour.",
    "```yaml\n- when: SYS_STATUS.voltage_battery < 10500\n# -1 is unknown\n- when: SYS_STATUS.battery_remaining == -1\n```",
    "## OBSTACLE_DISTANCE\n\nIn the lidar's scan each element is in millimetres.",
    "## OBSTACLE_DISTANCE\n\nWe print them: each element is in metres then.",
    "COMMAND_INT has `x` and `y`. Our file has metres times 1e3, which we turn into that.",
    "BATTERY_STATUS: the display moves `voltages` in steps of 10 V.",
    "## ODOMETRY\n\n`quality` is 0 if unknown, and -1 when the odometry has failed.",
]


@pytest.mark.parametrize(("rule", "right", "wrong", "says"), TWINS, ids=[case[2][:50] for case in TWINS])
def test_what_is_wrong_is_found(check: Any, rule: str, right: str, wrong: str, says: str) -> None:
    assert check(f"{right}\n") == []
    found = [(one.rule.id, one.message) for one in check(f"{wrong}\n")]
    assert [text for own, text in found if own == rule and says in text], found


@pytest.mark.parametrize("text", ASIDES)
def test_what_is_no_claim_is_not_found(check: Any, text: str) -> None:
    assert check(f"{text}\n") == []
