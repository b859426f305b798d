"""Numbers beside names that say nothing of them: sizes of fields, lines of files, arguments, lists, own arguments.

Each group has a twin that does say something, and is found.
"""

from collections.abc import Callable

import pytest

from codegen.diagnostics import Diagnostic

Check = Callable[[str], list[Diagnostic]]


def table(heads: str, *rows: str) -> str:
    """Return a table of Markdown from its lines without the outer bars."""
    return "\n".join(f"| {line} |" for line in (heads, "|".join("---" for _ in heads.split("|")), *rows))


RIGHT = {
    "size": table("Message | Field | Size", "HEARTBEAT | custom_mode | 4", "HEARTBEAT | base_mode | 1"),
    "bytes": table("Message | Field | Bytes", "HEARTBEAT | `custom_mode` | 4", "ATTITUDE | `roll` | 4"),
    "length": table("Message | Field | Length", "HEARTBEAT | custom_mode | 4", "PARAM_SET | param_id | 16"),
    "width": table("Message | Field | Width", "HEARTBEAT | custom_mode | 32", "ATTITUDE | roll | 32"),
    "amount": table("Message | Field | Size", "HEARTBEAT | custom_mode | 4 bytes", "ATTITUDE | roll | 4 bytes"),
    "before": table("Message | Length | Field", "HEARTBEAT | 4 | custom_mode", "HEARTBEAT | 1 | base_mode"),
    "count": table("Message | Field | #", "HEARTBEAT | custom_mode | 1", "ATTITUDE | roll | 3"),
    "extra": table("Message | Field | Extra", "HEARTBEAT | custom_mode | 1", "ATTITUDE | roll | 3"),
    "place": "**main.c:14** MAV_TYPE_GROUND_ROVER is what we send.",
    "place with column": "src/main.rs:102:5: MAV_TYPE_GROUND_ROVER",
    "place alone": ":102: MAV_TYPE_GROUND_ROVER is sent.",
    "line": "Line 14: MAV_TYPE_GROUND_ROVER",
    "lines": "lines 12, 14: MAV_TYPE_GROUND_ROVER",
    "step": "Step 7: MAV_TYPE_GROUND_ROVER",
    "winch in a file": "WINCH_STATUS.status, see winch.cpp:102** HEALTHY is 1 and MOVING is 4.",
    "argument": "```python\nreturn struct.pack(F, 0, MAV_TYPE_GROUND_ROVER,\n    MAV_AUTOPILOT_INVALID, 0, 3)\n```",
    "argument of two": "```c\nsend(MAV_TYPE_GROUND_ROVER, 3);\n```",
    "argument in text": "We call `send(3, MAV_TYPE_GROUND_ROVER)` for it.",
    "element": "```python\nargs = [0, MAV_TYPE_GROUND_ROVER, 3, MAV_STATE_ACTIVE]\n```",
    "list": "The parameters are 3, MAV_TYPE_GROUND_ROVER, 0.",
    "values called bits": "WINCH_STATUS: bit 1 is healthy, 2 fully retracted, 4 moving, 8 clutch engaged.",
    "places of bits": "WINCH_STATUS: bits 0 healthy, 1 fully retracted, 2 moving, 3 clutch engaged.",
    "states": "`battery_remaining` of SYS_STATUS is in percent: -1 invalid, 0 empty, 100 full.",
    "next state": "DISTANCE_SENSOR has `signal_quality` in percent. 0 is unknown, 1 invalid, 100 perfect.",
    "several things": "GENERATOR_STATUS: `generator_speed` is a number of revolutions per minute. The two temperatures are "
    "whole degrees Celsius with 32767 for a missing probe.",
    "range of fields": "The three bytes `custom0` to `custom2` of HIGH_LATENCY2 are free.",
    "zero byte": "PARAM_SET: `param_id` is taken up to the zero byte.",
    "number word": "ATTITUDE has a payload: six arrays follow the time.",
    "direction": "```python\nGPS_RTK = dict(\n    baseline_a_mm=-15230,  # 15.23 m to the south\n)\n```",
    "cast": "BATTERY_STATUS.\n\n```c\nbars = (r->battery_remaining < 0) ? 0 : (uint8_t)(r->battery_remaining / 20);\n```",
    "other one": "GPS_RAW_INT: `lat` is a degE7 integer where the other one has float metres.",
    "widened": "Ana asked to widen `current_battery` of BATTERY_STATUS to 32 bits.",
    "corrected": "We read `satellite_visible` of GPS_RAW_INT, should have been `satellites_visible`.",
    "share": "ATTITUDE at 10 Hz is 400 bytes/s, 7 % of the 5760 bytes/s there are.",
    "denied enum": "COMMAND_ACK is read.\n\n0 accepted, 1 failed. These are not MAV_RESULT values.",
    "own argument": "# `push(lat, lon)`\n\nSends GLOBAL_POSITION_INT. `lat` and `lon` are plain degrees as float.",
}
NUMBERED = {
    "position": table("Message | Field | Position", "HEARTBEAT | custom_mode | 4", "HEARTBEAT | type | 1"),
    "bytes on the wire": table(
        "Message | Field | Bytes on the wire", "HEARTBEAT | custom_mode | 4", "ATTITUDE | roll | 4"
    ),
    "rows": table("No. | Message | Step", "1 | HEARTBEAT | wait", "2 | ATTITUDE | compare"),
    "short": "HEARTBEAT (2 bytes short) is dropped.",
}
DOUBTFUL = {
    "number": table("Message | Number", "HEARTBEAT | 12", "ATTITUDE | 120"),
    "size": table("Message | Topic | Size", "HEARTBEAT | state | 120", "ATTITUDE | pose | 60"),
    "entries": table("# | Type", "1 | MAV_TYPE_GROUND_ROVER", "3 | MAV_TYPE_GCS"),
    "mapping": "```python\nPRIORITY = {\n    MAV_TYPE_GROUND_ROVER: 3,\n    MAV_TYPE_QUADROTOR: 1,\n}\n```",
    "counted": "MAV_TYPE_GROUND_ROVER: 3 vehicles.",
    "amount": "There are 3 MAV_TYPE_GROUND_ROVER in it.",
    "own list": "MAV_TYPE_GROUND_ROVER is 3 in our list.",
    "source": "HEARTBEAT [3] is described elsewhere.",
}
"""Numbers that may be of anything, and that nothing beside them bears out."""
BORNE_OUT = {
    "number": table("Message | Number", "HEARTBEAT | 0", "ATTITUDE | 120"),
    "message id": table("Message | Message ID", "HEARTBEAT | 12", "ATTITUDE | 120"),
    "size": table("Message | Topic | Size", "HEARTBEAT | state | 9", "ATTITUDE | pose | 60"),
    "payload": table("Message | Topic | Payload", "HEARTBEAT | state | 120", "ATTITUDE | pose | 60"),
    "entries": table("# | Type", "10 | MAV_TYPE_GROUND_ROVER", "3 | MAV_TYPE_GCS"),
    "values": table("Value | Type", "1 | MAV_TYPE_GROUND_ROVER", "3 | MAV_TYPE_GCS"),
    "mapping": "```python\nTYPES = {\n    MAV_TYPE_GROUND_ROVER: 10,\n    MAV_TYPE_QUADROTOR: 1,\n}\n```",
    "position": table("Message | Field | Position", "HEARTBEAT | custom_mode | 0", "HEARTBEAT | type | 1"),
    "list": "- 10 MAV_TYPE_GROUND_ROVER\n- 3 MAV_TYPE_GCS",
    "alone": "MAV_TYPE_GROUND_ROVER is 3 in the dialect.",
}
"""The same where others of their kind, or a heading, say that they are what they seem."""
WRONG = {
    "size": table("Message | Field | Size", "HEARTBEAT | custom_mode | 2", "HEARTBEAT | base_mode | 1"),
    "width": table("Message | Field | Width", "HEARTBEAT | custom_mode | 24", "ATTITUDE | roll | 32"),
    "payload": table("Message | Field | Payload", "HEARTBEAT | custom_mode | 9", "ATTITUDE | roll | 27"),
    "size before": table("Message | Size | Field", "HEARTBEAT | 9 | custom_mode", "ATTITUDE | 27 | roll"),
    "size without fields": table("Message | Size", "HEARTBEAT | 9", "ATTITUDE | 27"),
    "id": table("Message | Field | ID", "HEARTBEAT | type | 0", "ATTITUDE | roll | 30", "SYS_STATUS | load | 2"),
    "pair": "```python\nNAMES = [\n    (3, MAV_TYPE_GROUND_ROVER),\n]\n```",
    "value": "MAV_TYPE_GROUND_ROVER, 3.",
    "beside": "main.c: MAV_TYPE_GROUND_ROVER is 14.",
    "comment": "```c\nsend(3); // MAV_TYPE_GROUND_ROVER\n```",
    "values": "WINCH_STATUS.status: 1 healthy, 2 moving, 4 retracted, 8 clutch engaged.",
    "states": "`battery_remaining` of SYS_STATUS is in percent, 255 unknown, 0 empty, 100 full.",
    "number word": "ATTITUDE has a payload of six bytes.",
    "enum": "COMMAND_ACK is read.\n\n0 accepted, 1 failed. These are MAV_RESULT values.",
    "field": "The three bytes `custom0` of HIGH_LATENCY2 are free.",
    "direction": "```python\nGPS_RTK = dict(\n    baseline_a_mm=-1523,  # 15.23 m to the south\n)\n```",
    "sign": "`vx` of GLOBAL_POSITION_INT: 1.5 m/s is -150.",
    "type": "`current_battery` of BATTERY_STATUS has 32 bits.",
    "name": "We read `satellite_visible` of GPS_RAW_INT.",
    "share": "ATTITUDE at 10 Hz is 700 bytes/s, 12 % of the 5760 bytes/s there are.",
    "argument": "# `push()`\n\nSends GLOBAL_POSITION_INT. `lat` and `lon` are plain degrees as float.",
}


@pytest.mark.parametrize("name", NUMBERED)
def test_a_number_that_counts_or_orders_is_no_claim(name: str, check: Check) -> None:
    assert [each.message for each in check(f"MAVLink.\n\n{NUMBERED[name]}\n")] == []


@pytest.mark.parametrize("name", RIGHT)
def test_a_number_that_is_of_something_else_is_no_claim(name: str, check: Check) -> None:
    assert [each.message for each in check(f"MAVLink.\n\n{RIGHT[name]}\n")] == []


@pytest.mark.parametrize("name", WRONG)
def test_the_twin_that_is_a_claim_is_found(name: str, check: Check) -> None:
    assert check(f"MAVLink.\n\n{WRONG[name]}\n")


def test_the_size_of_a_field_is_never_certainly_that_of_its_message(check: Check) -> None:
    assert not any(finding.is_error for finding in check(WRONG["size"]))
    assert all("custom_mode has 4 bytes, not 2" in finding.message for finding in check(WRONG["size"]))


@pytest.mark.parametrize("name", DOUBTFUL)
def test_what_nothing_bears_out_is_not_certain(name: str, check: Check) -> None:
    assert not any(finding.is_error for finding in check(f"MAVLink.\n\n{DOUBTFUL[name]}\n"))


@pytest.mark.parametrize("name", BORNE_OUT)
def test_what_others_of_its_kind_bear_out_is_certain(name: str, check: Check) -> None:
    assert any(finding.is_error for finding in check(f"MAVLink.\n\n{BORNE_OUT[name]}\n"))
