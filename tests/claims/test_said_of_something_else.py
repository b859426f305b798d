"""What a sentence says of something else beside a field is no claim about the field."""

from collections.abc import Callable

import pytest

from codegen.diagnostics import Diagnostic

Check = Callable[[str], list[Diagnostic]]

RIGHT = {
    "fields that are told apart from those of a message":
        "`relative_alt` and `hdg` are floats here, unlike the fields of the same name in GLOBAL_POSITION_INT.\n",
    "a message that is told apart, first":
        "Other than in GLOBAL_POSITION_INT, `hdg` is a float.\n",
    "texts that somebody tried":
        "# STATUSTEXT\n\nTexts of 1, 50, 51, 100 and 120 characters were sent.\n",
    "two lengths":
        "# STATUSTEXT\n\nTexts of 50 or 51 characters were sent.\n",
    "what a version did":
        "Fixed:\n\n* 3.3 read `lat` of GPS_RAW_INT as float degrees.\n* v2.1 sent `eph` of GPS_RAW_INT in metres.\n",
    "what a version did, at the end":
        "GPS_RAW_INT is right now. Version 1.5 took `vel` in m/s.\n",
    "what somebody did":
        "We filled 36 floats in `covariance` of VISION_POSITION_ESTIMATE, which has 21, and wrote over the counter.\n",
    "another quantity behind a semicolon":
        "| Where | Unit | Remark |\n|---|---|---|\n| SET_POSITION_TARGET_LOCAL_NED | rad | `yaw`; the rate is rad/s |\n",
    "a value of the field behind it":
        "BATTERY_STATUS: `current_battery` in cA. INT16_MAX as temperature: not available.\n",
    "a value of a parameter of the command":
        "MAV_CMD_DO_CHANGE_SPEED has -1 for no change and -2 for the vehicle's own speed.\n",
    "the number of a parameter":
        "A correction holds: `{enum: MAV_CMD, entry: MAV_CMD_DO_SET_PARAMETER, param: 4}`, `{entry: ..., param: 4, set: 0}`.\n",
    "a value for the field behind it":
        "BATTERY_STATUS: `current_battery` in cA. INT16_MAX for `temperature`: not available.\n",
    "the ends of a range":
        "`signal_quality` of DISTANCE_SENSOR is the quality of the echo, 2 to 100 %.\n",
    "two ranges":
        "`humidity` of HYGROMETER_SENSOR: 0 to 10000 means 0 to 100 %.\n",
}  # fmt: skip
WRONG = {
    "an amount behind its number":
        ("`temperature` of SCALED_PRESSURE is 215 for 21.5 degC.\n", "claim-scaling"),
    "a comparison with another message":
        ("GLOBAL_POSITION_INT is easy: `relative_alt` is a float, unlike the one in VFR_HUD.\n", "claim-struct"),
    "one length":
        ("# STATUSTEXT\n\nTexts of up to 120 characters are sent.\n", "claim-struct"),
    "what a version does":
        ("Since 3.3 `lat` of GPS_RAW_INT is a float.\n", "claim-struct"),
    "what somebody does":
        ("We send 36 floats in `covariance` of VISION_POSITION_ESTIMATE.\n", "claim-struct"),
    "the unit behind a semicolon":
        ("- `yaw` of SET_POSITION_TARGET_LOCAL_NED; it is in deg.\n", "claim-unit"),
    "a wrong value of the field behind it":
        ("BATTERY_STATUS: `current_battery` in cA. UINT16_MAX as temperature: not available.\n", "claim-sentinel"),
}  # fmt: skip


@pytest.mark.parametrize("name", RIGHT)
def test_what_is_said_of_something_else_is_no_claim(name: str, check: Check) -> None:
    """The value stands beside the field, and the words between say that it is another's, or another time's."""
    assert [str(each) for each in check(RIGHT[name])] == []


@pytest.mark.parametrize("name", WRONG)
def test_what_is_said_of_the_field_is_found(name: str, check: Check) -> None:
    """Words that only look alike rule out nothing."""
    text, rule = WRONG[name]
    assert [each.rule.id for each in check(text)] == [rule]
