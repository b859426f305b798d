"""What sentences, lists, tables and code say of fields: found where it is wrong, left alone where it is not."""

from typing import Any

import pytest

WRONG = [
    ("GPS_RAW_INT: divide `lat` by 1000000 to get degrees.", "claim-scaling", "degE7"),
    ("In VFR_HUD, `alt` is an extension.", "claim-extension", "VFR_HUD.alt is a base field"),
    ("In GPS_RAW_INT, `alt_ellipsoid` is a base field.", "claim-extension", "is an extension"),
    ("ATTITUDE\n\n| Field | Offset |\n| --- | --- |\n| time_boot_ms | 0 |\n| roll | 5 |\n", "claim-offset", "roll"),
    ("HEARTBEAT comes from a MAV_TYPE_ROVER.", "claim-no-entry", "did you mean MAV_TYPE_GROUND_ROVER"),
    ("```c\n{ 0, 50, 9 },   // HEARTBEAT\n{ 1, 124, 31 }, // SYS_STATUS\n{ 25, 24, 30 }, // GPS_RAW_INT\n```", "claim-message-id", "24, not 25"),
    ("```python\nm = link.recv_match(type='GPS_RAW_INT')\nalt_m = m.alt / 100\n```", "claim-scaling", "/ 100 does not make m"),
    ("```rust\n/// GPS_RAW_INT\npub struct Gps {\n    /// altitude, m\n    pub alt: i32,\n    /// degE7\n    pub lat: i32,\n}\n```", "claim-unit", "alt is in mm, not m"),
    ("COMMAND_ACK answers 0 accepted, 1 denied, 3 unsupported, 4 failed.", "claim-enum-value", "MAV_RESULT_DENIED is 2, not 1"),
    ("With MAVLink 1 GPS_RAW_INT has 52 bytes of payload.", "claim-message-size", "not 52"),
    ("`rssi` of RC_CHANNELS is a 16-bit unsigned integer.", "claim-struct", "rssi is uint8_t"),
    ("SYS_STATUS.voltage_battery holds volts.", "claim-unit", "in mV, not volts"),
    (
        "GPS_RAW_INT\n\n| Field | Enum |\n| --- | --- |\n| fix_type | MAV_TYPE |\n| eph | |\n",
        "claim-enum-of-field",
        "GPS_FIX_TYPE",
    ),
    ("HEARTBEAT on the wire: `type`, `custom_mode`, `autopilot`.", "claim-wire-order", "custom_mode comes before type"),
    ("GPS_RAW_INT has a field `satelites_visible`.", "claim-no-field", "did you mean satellites_visible"),
    ("Send GLOBAL_POSITION_INT and GLOBAL_POSITON_INT.", "claim-no-message", "did you mean GLOBAL_POSITION_INT"),
    ("GPS_RAW_INT: `fix_type` is 0 = no GPS, 4 = 3D fix.", "claim-enum-value", "GPS_FIX_TYPE_3D_FIX is 3, not 4"),
    ("The field `eph` of GPS_RAW_INT is 9999 if unknown.", "claim-sentinel", "UINT16_MAX, not 9999"),
    ("GPS_RAW_INT.vel is in m/s.", "claim-unit", "GPS_RAW_INT.vel is in cm/s, not m/s"),
    ("## VFR_HUD\n\nMeasured old groundspeed is in km/h.", "claim-unit", "VFR_HUD.groundspeed is in m/s, not km/h"),
    ("- `vel` (int32): speed over ground of GPS_RAW_INT\n", "claim-struct", "vel is uint16_t, not int32_t"),
    ("A BATTERY_STATUS stream takes 41 bytes/message.", "claim-message-size", "not 41"),
    ("```python\nMAVLINK_MSG_ID_GPS_RAW_INT = 25\n```\nGPS_RAW_INT", "claim-message-id", "has the id 24, not 25"),
]  # fmt: skip

RIGHT = [
    "GPS_RAW_INT: divide `lat` by 10000000 to get degrees.",
    "In VFR_HUD, `alt` is a base field.",
    "HEARTBEAT on the wire: `custom_mode`, `type`, `autopilot`.",
    "HEARTBEAT as declared in the XML: `type`, `autopilot`, `base_mode`, `custom_mode`.",
    "GPS_RAW_INT: `fix_type` is 0 = no GPS, 3 = 3D fix.",
    "GPS_RAW_INT.vel is in cm/s; we show it in m/s after division by 100.",
    "The fifth cell in BATTERY_STATUS: `uint16_t voltages[4]`.",
    "## VFR_HUD\n\nStrange green boxes are in km.",
    "GPS_RAW_INT_V2 has a field `satelites_visible`; GPS_RAW_INT has not.",
    "Our own topic `satelites_visible` is filled from GPS_RAW_INT and SATELLITES_X.",
    "The link sends 41 bytes per second of BATTERY_STATUS at most.",
    "### LOG_DATA (120)\n\nReply to [LOG_REQUEST_DATA](https://mavlink.io/en/messages/common.html#LOG_REQUEST_DATA).",
]


def has(check: Any, text: str, rule: str, says: str) -> bool:
    """Whether a finding of a rule says something, in its message or its hint."""
    return any(one.rule.id == rule and says in f"{one.message} {one.hint or ''}" for one in check(text))


@pytest.mark.parametrize(("text", "rule", "says"), WRONG, ids=[case[0][:40] for case in WRONG])
def test_what_is_said_of_a_field_is_compared(check: Any, text: str, rule: str, says: str) -> None:
    assert has(check, text, rule, says), check(text)


@pytest.mark.parametrize("text", RIGHT, ids=[text[:40] for text in RIGHT])
def test_what_is_right_is_left_alone(check: Any, text: str) -> None:
    assert check(text) == []
