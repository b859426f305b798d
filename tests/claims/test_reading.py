"""What a document is about: messages that a name is near, the message of a list of fields, and words that lead a text."""

from collections.abc import Callable

import pytest

from codegen.claims.known_names import names_of, near_message
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic

Check = Callable[[str], list[Diagnostic]]


@pytest.fixture
def reading(read: Callable[[str], Reading]) -> Reading:
    return read("# HEARTBEAT\n\nSYS_STATUS follows.\n")


@pytest.mark.parametrize(("name", "near"), [("HEARTBEET", "HEARTBEAT"), ("ATITUDE", "ATTITUDE"), ("SONARS", None)])
def test_a_name_of_one_word_is_near_messages_of_one_word(reading: Reading, name: str, near: str | None) -> None:
    """Those of several words are looked at for names of several words."""
    assert near_message(name, names_of(reading)) == near


def test_the_message_of_a_list_has_more_than_half_of_its_fields(reading: Reading) -> None:
    """Half of them may be any other message's."""
    found = reading.message_with(["load", "drop_rate_comm", "other"], 3)
    assert found is not None
    assert found.name == "SYS_STATUS"
    assert reading.message_with(["load", "other"], 3) is None


def test_a_field_in_a_heading_leads_no_text_of_marks_alone(check: Check) -> None:
    assert check('## GPS_RAW_INT\n\n### `alt`\n\n"\n\n`alt` is in mm.\n') == []


def test_a_list_of_values_is_borne_out_though_it_has_more_than_the_enum(check: Check) -> None:
    """Most of those that are an entry's are right: so the one that is another's is wrong for certain."""
    values = ("0: uninit", "1: boot", "2: calibrating", "4: standby", "15: of a simulator", "16: of a crash test")
    found = check("## HEARTBEAT\n\nValues of `system_status`:\n\n" + "".join(f"- {each}\n" for each in values))
    assert [(each.is_error, each.message) for each in found] == [
        (True, "HEARTBEAT.system_status: MAV_STATE_STANDBY is 3, not 4")
    ]


@pytest.mark.parametrize(("heading", "named"), [("Geo status", "CAMERA_TRACKING_GEO_STATUS"), ("Remarks", None)])
def test_a_heading_may_have_the_end_of_a_name(check: Check, heading: str, named: str | None) -> None:
    """Where the document names another message of the family; what stands below is about that one."""
    text = f"# CAMERA_TRACKING_IMAGE_STATUS\n\nIt is sent.\n\n## {heading}\n\n| Field | Units |\n| --- | --- |\n"
    found = [each.message for each in check(text + "| `lat` | degrees |\n")]
    assert found == ([f"{named}.lat is in degE7, not degrees"] if named else [])
