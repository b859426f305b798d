"""Candidates that name no field, or another thing than a field: each is there where the dialect is contradicted only."""

from collections.abc import Callable

import pytest

from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.weighed.candidates import Candidate, candidates
from codegen.claims.weighed.entities.parameter_places import parameter_places
from codegen.diagnostics import Diagnostic

Read = Callable[[str], Reading]
Check = Callable[[str], list[Diagnostic]]

WAYPOINT = "| Command | param1 | param2 |\n|---|---|---|\n| MAV_CMD_NAV_WAYPOINT | {} | {} |\n"
GRIPPER = "## MAV_CMD_DO_GRIPPER (211)\n\n| Param | Meaning |\n|---|---|\n| 1 | gripper id |\n| 2 | {} |\n"
YAW = "| Command | Parameters |\n|---|---|\n| MAV_CMD_CONDITION_YAW | 1: angle, deg. 2: deg/s. 3: {}. 4: {} |\n"
WINCH = "- `MAV_CMD_DO_WINCH` has the action in param2.\n- Buttons:\n  - deliver 4\n  - retract {}\n"
FACING = "DISTANCE_SENSOR (132) is sent. With `orientation` {} the sensor looks down.\n"

TWINS = {
    "columns of parameters": ("parameter label", WAYPOINT, ("hold time, s", "acceptance radius, m"), ("acceptance radius, m", "hold time, s")),
    "the unit in a column of a parameter": ("parameter unit", WAYPOINT, ("hold, s", "radius, m"), ("hold, min", "radius, m")),
    "a row with the number of a parameter": ("parameter value", GRIPPER, ("0 = release, 1 = grab",), ("0 = grab, 1 = release",)),
    "a list of numbers": ("parameter label", YAW, ("direction", "relative offset"), ("absolute", "direction")),
    "a parameter that stands last": (
        "parameter label", "MAV_CMD_DO_JUMP (177) is sent. The repeat count goes to param{}.\n", ("2",), ("1",),
    ),
    "values of a command's enum in a list": ("meaning", WINCH, ("6",), ("7",)),
    "elements of the one text": ("length of none", "STATUSTEXT (253): at most {} characters per chunk.\n", ("50",), ("64",)),
    "numbered fields": ("length of none", "RC_CHANNELS (65) shows up to {} channels.\n", ("18",), ("16",)),
    "a meaning that the description gives another number": (
        "special", "| Step | Expected |\n|---|---|\n| Read beyond the end of the log | `LOG_DATA` with `count` {} |\n", ("0",), ("255",),
    ),
    "the end of a described range": ("range", "OPTICAL_FLOW (100): `quality` goes up to {}, which is the best.\n", ("255",), ("100",)),
    "words that a description has for an entry": ("meaning", FACING, ("25",), ("24",)),
    "versions that carry a field": (
        "extension", "OPTICAL_FLOW (100): `{}` is available with MAVLink 1 and 2 alike.\n", ("flow_x",), ("flow_rate_x",),
    ),
    "a version that loses a field": (
        "extension", "OPTICAL_FLOW (100): `{}` is lost on MAVLink 1 links.\n", ("flow_rate_x",), ("flow_x",),
    ),
}  # fmt: skip
"""By what is said: the kind of its candidate, a document, and what fills it rightly and wrongly."""


@pytest.mark.parametrize(("kind", "text", "right", "wrong"), TWINS.values(), ids=TWINS)
def test_only_what_contradicts_the_dialect_is_a_candidate(
    read: Read, kind: str, text: str, right: tuple[str, ...], wrong: tuple[str, ...]
) -> None:
    """What is right in the same words is none, or all of it would weigh on what is wrong."""

    def of_kind(filled: str) -> list[Candidate]:
        return [each for each in candidates(read(filled)) if each.kind == kind]

    assert of_kind(text.format(*wrong))
    assert not of_kind(text.format(*right))


NONE = {
    "parameters that are several": "MAV_CMD_NAV_DELAY: the time of day is in params 2 to 4.\n",
    "elements of a field with a name": "TUNNEL (385): `payload` of 100 elements.\n",
    "less than three": "STATUSTEXT (253) has 2 characters.\n",
    "a special value that stands there rightly as well": "GPS_RAW_INT: `yaw` 0 is none, north is 36000.\n",
    "words for entries without the field's name": "DISTANCE_SENSOR (132) looks down in 24 of our tests.\n",
}
KINDS = frozenset(("parameter label", "length of none", "special", "meaning"))


@pytest.mark.parametrize("text", NONE.values(), ids=NONE)
def test_what_is_said_of_something_else_is_no_candidate(read: Read, text: str) -> None:
    assert [each for each in candidates(read(text)) if each.kind in KINDS] == []


def test_a_parameter_is_one_of_the_command_above(read: Read) -> None:
    """A heading without a command ends what the last one was about, unless the document names no other."""
    jump = "## MAV_CMD_DO_JUMP\n\nparam1 is a number.\n\n## Other things\n\nparam2 is a number.\n"
    other = "\n## Yaw\n\nMAV_CMD_CONDITION_YAW turns.\n"
    for text, numbers in ((jump, ["1", "2"]), (jump + other, ["1"])):
        reading = read(text)
        places = [place for span in spans(reading) for place in parameter_places(reading, span)]
        assert {place.command.name for place in places} == {"MAV_CMD_DO_JUMP"}
        assert [place.parameter.number for place in places] == numbers


EFFECTS = {
    "unchanged, with the range behind it": (
        "RC_CHANNELS_OVERRIDE (70): a value of {} leaves a channel unchanged for channels 1 to 8.\n", "65535", "0",
    ),
    "in a list, with the range before it": (
        "For `chan1_raw` to `chan8_raw` of RC_CHANNELS_OVERRIDE:\n\n- {} means no change\n", "65535", "0",
    ),
    "taken back": (
        "For `chan9_raw` to `chan18_raw` of RC_CHANNELS_OVERRIDE:\n\n- {} hands it back to the radio\n", "65534", "0",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("text", "right", "wrong"), EFFECTS.values(), ids=EFFECTS)
def test_effects_of_values_are_those_of_the_channels_that_are_meant(
    check: Check, text: str, right: str, wrong: str
) -> None:
    assert check(text.format(right)) == []
    (finding,) = check(text.format(wrong))
    assert finding.rule.id == "claim-sentinel"


ORDERS = {
    "z above the origin": ("LOCAL_POSITION_NED (32): `z` is {} above the origin.\n", "negative", "positive"),
    "the first byte": ("HEARTBEAT (0): `{}` is the first byte of the payload.\n", "custom_mode", "type"),
    "goes out as": (
        "VFR_HUD (74) goes out as `airspeed`, `groundspeed`, {}, `throttle`.\n", "`alt`, `climb`, `heading`", "`heading`, `alt`, `climb`",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("text", "right", "wrong"), ORDERS.values(), ids=ORDERS)
def test_ways_and_orders_in_further_words(check: Check, text: str, right: str, wrong: str) -> None:
    assert check(text.format(right)) == []
    assert check(text.format(wrong)) != []


NO_CLAIMS = {
    "a member of one's own with the unit in its name": (
        "# ADSB_VEHICLE (246)\n\n```c\ntypedef struct {\n    int32_t  lat;            /* degE7 */\n"
        "    int32_t  altitude_mm;    /* above sea level */\n    uint16_t heading_cdeg;   /* over ground */\n} t;\n```\n"
    ),
    "the number of a requirement before what releases": (
        "RC_CHANNELS_OVERRIDE (70)\n\n**REQ-07-10** Releasing the trigger shall cause one last message.\n"
    ),
    "a number before what it is sorted by": "WINCH_STATUS (9005): actions are 0 relax, 1 by length, 2 by rate.\n",
}


@pytest.mark.parametrize("text", NO_CLAIMS.values(), ids=NO_CLAIMS)
def test_nothing_is_found_in_what_is_no_claim(check: Check, text: str) -> None:
    assert check(text) == []
