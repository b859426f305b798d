"""Values that a text tells in passing: beside an amount, in a clause with an entry's word, with a meaning of their own."""

from collections.abc import Callable

import pytest

from codegen.diagnostics import Diagnostic

Check = Callable[[str], list[Diagnostic]]

WRONG = {
    "a row with the amount first": (
        "| # | physical | field | raw |\n| --- | --- | --- | --- |\n| 1 | 3.4 A | SYS_STATUS.current_battery | 3400 |\n",
        "3.4 A is 340 in SYS_STATUS.current_battery (cA), not 3400 (likely, not certain)",
    ),
    "a dilution of precision, which has no unit": (
        "| physical | field | raw |\n| --- | --- | --- |\n| HDOP 0.85 | GPS_RAW_INT.eph | 850 |\n",
        "0.85 is 85 in GPS_RAW_INT.eph (steps of 1E-2), not 850 (likely, not certain)",
    ),
    "the first digits of many": (
        "For 47.3977418 deg the sender of GLOBAL_POSITION_INT has `lat` 47397742 there.\n",
        "47.3977418 deg is 473977418 in GLOBAL_POSITION_INT.lat (degE7), not 47397742 (likely, not certain)",
    ),
    "a word that one other entry has": (
        "When armed, `base_mode` of HEARTBEAT shall have bit 64 set.\n",
        "HEARTBEAT.base_mode: MAV_MODE_FLAG_SAFETY_ARMED is 128, not 64 (likely, not certain)",
    ),
    "a value that means something": (
        "`cal_status` of MAG_CAL_REPORT becomes 3, which means success.\n",
        "MAG_CAL_REPORT.cal_status: MAG_CAL_SUCCESS is 4, not 3 (likely, not certain)",
    ),
    "a special value": (
        "`interval_us` of MESSAGE_INTERVAL: 10 means that the stream is disabled.\n",
        'MESSAGE_INTERVAL.interval_us: for "this stream is disabled" it is -1, not 10 (likely, not certain)',
    ),
}
RIGHT = {
    "the right number": "| physical | field | raw |\n| --- | --- | --- |\n| 3.4 A | SYS_STATUS.current_battery | 340 |\n",
    "other digits": "At 3.4 A the `current_battery` of SYS_STATUS was 512 once.\n",
    "one digit": "After 1000 ms `time_boot_ms` of ATTITUDE is past 1000000.\n",
    "an alarm": "The alarm for SYS_STATUS.current_battery at 3.4 A is number 3400.\n",
    "the field of the next sentence": "The radio needs 3.5 deg, port 35; ADSB_VEHICLE.heading does not matter.\n",
    "the word of the right entry": "When armed, `base_mode` of HEARTBEAT shall have bit 128 set.\n",
    "a flag with others": "`flags` of SERIAL_CONTROL: 5 reply\n",
    "the special value": "`interval_us` of MESSAGE_INTERVAL: -1 means that the stream is disabled.\n",
    "no special value": "`count` of LOG_DATA: 90 is for a full log.\n",
}


@pytest.mark.parametrize("name", WRONG)
def test_a_value_told_in_passing_is_compared(name: str, check: Check) -> None:
    text, message = WRONG[name]
    assert [each.message for each in check(f"MAVLink.\n\n{text}")] == [message]


@pytest.mark.parametrize("name", RIGHT)
def test_what_may_be_right_is_no_finding(name: str, check: Check) -> None:
    assert [each.message for each in check(f"MAVLink.\n\n{RIGHT[name]}")] == []
