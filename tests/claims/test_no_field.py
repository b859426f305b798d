"""A unit that no field of a message has is found without a name of a field; what only looks like that is not."""

from collections.abc import Callable

import pytest

from codegen.diagnostics import Diagnostic

Check = Callable[[str], list[Diagnostic]]

WRONG = {
    "what is only described": (
        "* `SCALED_IMU2`: rates are in mrad/s. The magnetometer is in microtesla.\n",
        "no field of SCALED_IMU2 is in microtesla: xmag is in mgauss, ymag is in mgauss, zmag is in mgauss",
    ),
    "a cell of a row": (
        "| Message | Field strength |\n| --- | --- |\n| SCALED_IMU2 | int16, tesla |\n",
        "no field of SCALED_IMU2 is in tesla: xmag is in mgauss, ymag is in mgauss, zmag is in mgauss",
    ),
    "degrees per second where a temperature is in degrees": (
        "| Message | Rates |\n| --- | --- |\n| HIGHRES_IMU | float, deg/s |\n",
        "no field of HIGHRES_IMU is in deg/s: xgyro is in rad/s, ygyro is in rad/s, zgyro is in rad/s",
    ),
}
RIGHT = {
    "a unit that a field has": "* `SCALED_IMU2`: rates are in mrad/s. The magnetometer is in mgauss.\n",
    "nothing measures the same": "- HEARTBEAT: the cable is in metres.\n",
    "a sensor's own": "- SCALED_IMU2: the sensor is in microtesla.\n",
    "what is made of it": "- SCALED_IMU2: our plots are in microtesla.\n",
    "another thing that has a name": "- SCALED_IMU2 and the register COMPASS_RAW, in microtesla.\n",
    "the other one": "GPS_RAW_INT has a stamp in microseconds, the other one is in milliseconds.\n",
    "a row about something else": "| Compass | SCALED_IMU2 |\n| --- | --- |\n| microtesla | mgauss |\n",
    "a code of another message": "- `SCALED_IMU2` and `HIGHRES_IMU`: the magnetometer is in gauss.\n",
}


@pytest.mark.parametrize("name", WRONG)
def test_a_unit_that_no_field_has_is_found(name: str, check: Check) -> None:
    text, message = WRONG[name]
    assert [each.message for each in check(f"MAVLink.\n\n{text}")] == [f"{message} (likely, not certain)"]


@pytest.mark.parametrize("name", RIGHT)
def test_a_unit_that_may_be_right_is_no_finding(name: str, check: Check) -> None:
    assert [each.message for each in check(f"MAVLink.\n\n{RIGHT[name]}")] == []


def test_a_list_of_everyday_words_names_fields(check: Check) -> None:
    """One of them, "roll", would be no name of a field there."""
    text = "## VISION_POSITION_ESTIMATE\n\n- x, y, z are float metres; roll, pitch, yaw are degrees.\n"
    assert [each.message for each in check(text)] == ["VISION_POSITION_ESTIMATE.roll is in rad, not degrees"]


READ = {
    "AIS_VESSEL: `COG` is in decidegrees.": "AIS_VESSEL.COG is in cdeg, not decidegrees",
    "HIGH_LATENCY2: `target_distance` is in hectometres.": "HIGH_LATENCY2.target_distance is in dam, not hectometres",
    "STORAGE_INFORMATION: `total_capacity` is in gibibytes.": "STORAGE_INFORMATION.total_capacity is in MiB, not gibibytes",
    "GLOBAL_POSITION_INT: `lat` is in degrees times 1 000 000.": (
        "GLOBAL_POSITION_INT.lat is in degE7, not degrees times 1 000 000"
    ),
    "SCALED_PRESSURE: `temperature` is in degrees Celsius.": "SCALED_PRESSURE.temperature is in cdegC, not degrees Celsius",
    "CRC_EXTRA values: 50 for HEARTBEAT, 40 for ATTITUDE.": "ATTITUDE has the CRC_EXTRA 39, not 40",
    "| Message | Field |\n| --- | --- |\n| HIGHRES_IMU | `xacc` in m/s/s |\n| | `xgyro` in deg/s |": (
        "HIGHRES_IMU.xgyro is in rad/s, not deg/s"
    ),
}
LEFT = (
    "RAW_IMU has id 27 and 29 bytes, ATTITUDE has id 30 and 28 bytes.",
    "- `tslc` of AIS_VESSEL is uint16, ok (in ADSB_VEHICLE it is uint8).",
    "GPS_RAW_INT: for `fix_type` 5 is float and 6 is fixed.",
    "SIM_STATE: the bridge fills `lat_int` (degE7) next to the floats in degrees.",
    "Frames on CAN are 8 bytes; the payload of GENERATOR_STATUS is 42 bytes.",
    "- `UTM_GLOBAL_POSITION.uas_id` \u2192 `id`: 18 bytes as hex. COLLISION has an `id` as well.",
)


@pytest.mark.parametrize("text", READ, ids=lambda text: text[:40])
def test_words_for_units_and_numbers_are_read(text: str, check: Check) -> None:
    assert [each.message.partition(" (likely")[0] for each in check(f"MAVLink.\n\n{text}\n")] == [READ[text]]


@pytest.mark.parametrize("text", LEFT, ids=lambda text: text[:40])
def test_what_is_right_is_no_finding(text: str, check: Check) -> None:
    assert [each.message for each in check(f"MAVLink.\n\n{text}\n")] == []
