"""What documents say of ways and levels is compared with descriptions: up for down, above home for above sea level."""

from collections.abc import Callable

import pytest

from codegen.diagnostics import Diagnostic

Check = Callable[[str], list[Diagnostic]]

WRONG = {
    "up for down": (
        "In GLOBAL_POSITION_INT `vz` is positive when climbing.\n",
        'GLOBAL_POSITION_INT.vz: the dialect says "positive down", not "positive when climbing"',
    ),
    "down for up, the sign behind the way": (
        "`speed_vertical` of OPEN_DRONE_ID_LOCATION: down is positive.\n",
        'OPEN_DRONE_ID_LOCATION.speed_vertical: the dialect says "up is positive", not "down is positive"',
    ),
    "the way that something counts": (
        "| Field | Remark |\n| --- | --- |\n| GLOBAL_POSITION_INT.vz | counts upwards |\n",
        'GLOBAL_POSITION_INT.vz: the dialect says "positive down", not "counts upwards"',
    ),
    "a number with a sign": (
        "MANUAL_CONTROL has four axes. On `r` turning clockwise is +1000.\n",
        'MANUAL_CONTROL.r: the dialect says "counter-clockwise being 1000", not "clockwise is +1000"',
    ),
    "z in a message in NED": (
        "`vz` of LOCAL_POSITION_NED is positive upwards.\n",
        'LOCAL_POSITION_NED.vz: the dialect says "positive down (NED)", not "positive upwards"',
    ),
    "without the field's name": (
        "With MANUAL_CONTROL, turning clockwise is +1000.\n",
        'MANUAL_CONTROL.r: the dialect says "counter-clockwise being 1000", not "clockwise is +1000"',
    ),
    "another level": (
        "`relative_alt` of GLOBAL_POSITION_INT is in mm above sea level.\n",
        'GLOBAL_POSITION_INT.relative_alt: the dialect says "above home", not "sea level"',
    ),
    "another first number": (
        "`image_index` of CAMERA_IMAGE_CAPTURED starts at one.\n",
        'CAMERA_IMAGE_CAPTURED.image_index: the dialect says "zero based", not "starts at one"',
    ),
    "another order": (
        "The quaternion in SET_ATTITUDE_TARGET has the order x, y, z, w.\n",
        'SET_ATTITUDE_TARGET.q: the dialect says "w, x, y, z", not "x, y, z, w"',
    ),
    "what is left for what is used": (
        "`txbuf` of RADIO_STATUS is the percentage of the buffer that is in use.\n",
        'RADIO_STATUS.txbuf: the dialect says "remaining", not "in use"',
    ),
    "all for one": (
        "`discharge_minimum_voltage` of SMART_BATTERY_INFO is in mV for the whole pack.\n",
        'SMART_BATTERY_INFO.discharge_minimum_voltage: the dialect says "per-cell", not "whole"',
    ),
}
RIGHT = {
    "what the description says": "In GLOBAL_POSITION_INT `vz` is positive down, `vx` positive to the north.\n",
    "the other sign of the other way": "`vz` of GLOBAL_POSITION_INT is negative when climbing.\n",
    "nothing is described": "`climb` of VFR_HUD is positive when climbing.\n",
    "what somebody makes of it": "We flip `vz` of GLOBAL_POSITION_INT, so that up is positive.\n",
    "what it is not": "`vz` of GLOBAL_POSITION_INT is not positive upwards.\n",
    "both ways": "| Field | Wire | Shown |\n| --- | --- | --- |\n| GLOBAL_POSITION_INT.vz | down | up positive |\n",
    "a value of it": "With `relative_alt` of GLOBAL_POSITION_INT you are at 488 m above sea level.\n",
    "a register with a factor": (
        "| Register | Field | Conversion |\n| --- | --- | --- |\n"
        "| 40003 | GENERATOR_STATUS.battery_current | x -0.1 (the maker counts charging as positive) |\n"
    ),
    "the level of the description": "`alt` of GLOBAL_POSITION_INT is above MSL, `relative_alt` above home.\n",
    "used for something": "`txbuf` of RADIO_STATUS is used for flow control.\n",
    "another library": "nav_msgs has the quaternion as x, y, z, w; ODOMETRY has `q` as w, x, y, z.\n",
    "each of several, of which the description tells the sum as well": "`voltages` of BATTERY_STATUS: mV per cell.\n",
}


@pytest.mark.parametrize("name", WRONG)
def test_another_way_than_the_description_tells_is_found(name: str, check: Check) -> None:
    text, message = WRONG[name]
    found = [each.message for each in check(f"MAVLink.\n\n{text}") if each.rule.id == "claim-sense"]
    assert found == [f"{message} (likely, not certain)"]


@pytest.mark.parametrize("name", RIGHT)
def test_what_may_be_right_is_no_finding(name: str, check: Check) -> None:
    assert [each.message for each in check(f"MAVLink.\n\n{RIGHT[name]}") if each.rule.id == "claim-sense"] == []
