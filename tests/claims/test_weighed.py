"""Statements that no rule reads are weighed by what stands around them, and are told where that is enough."""

from collections.abc import Callable
from pathlib import Path

import claims_weights
import pytest

from codegen.claims import of_dialect
from codegen.claims.reading import Reading
from codegen.claims.weighed import likely as weighing
from codegen.claims.weighed.candidates import Candidate, candidates
from codegen.claims.weighed.likely import chosen, likely
from codegen.claims.weighed.weights import Weights, likelihood, stored_weights
from codegen.diagnostics import Diagnostic

Read = Callable[[str], Reading]
Check = Callable[[str], list[Diagnostic]]

LIKELY = {
    "a unit behind words that other rules stop at": (
        "## CAMERA_CAPTURE_STATUS (262)\n\n- `image_interval`: time between two pictures, float, in milliseconds\n",
        "CAMERA_CAPTURE_STATUS.image_interval is in s, not milliseconds",
    ),
    "a value for unknown in words of its own": (
        "SMART_BATTERY_INFO (370) is filled from the gauge.\n\n| Source | Field | Note |\n| --- | --- | --- |\n"
        "| configuration | `cells_in_series` | 255 if not configured |\n",
        "SMART_BATTERY_INFO.cells_in_series is unknown when it is 0, not 255",
    ),
    "a length that must not be exceeded": (
        "CAMERA_INFORMATION (259) has the address of the definition.\n\n"
        "- `cam_definition_uri` shall not be longer than 128 characters, which is what the field holds.\n",
        "CAMERA_INFORMATION.cam_definition_uri has 140 elements, not 128",
    ),
    "a type in the next column": (
        "| Trouble | Where |\n| --- | --- |\n| `fields_updated` cut to 8 bit | it is uint32 in HIGHRES_IMU |\n",
        "HIGHRES_IMU.fields_updated is uint16_t, not uint32",
    ),
    "a number beside words for another entry": (
        "# STORAGE_INFORMATION\n\n| Field | Meaning |\n| --- | --- |\n"
        "| `status` | 1 when the card is ready, 0 without card |\n",
        "STORAGE_INFORMATION.status: STORAGE_STATUS_READY is 2, not 1",
    ),
    "an order in a sentence about a mistake": (
        "- `LANDING_TARGET` (149): the position is sent.\n"
        "- `q` was garbled; we now send it as x, y, z, w like ROS does\n",
        'LANDING_TARGET.q: the dialect says "w, x, y, z", not "x, y, z, w"',
    ),
}
"""Statements of which no rule says anything."""
UNLIKELY = {
    "the unit of another thing": "`current_distance` of DISTANCE_SENSOR: the beam reports millimetres, we divide by ten.\n",
    "a value that must not be sent": "Never send `temperature` = 0 for unknown in BATTERY_STATUS.\n",
    "the number of an element": "BATTERY_STATUS: unknown `voltages`, but the one in element 0.\n",
    "a denied type": "`param_value` of PARAM_EXT_SET is no float here.\n",
    "two numbers for two entries": "EXTENDED_SYS_STATE.landed_state has 3 and 4 for taking off and landing.\n",
    "a variable with the unit in its name": "`heading_deg` has two sources, VFR_HUD.heading and a hundredth of GLOBAL_POSITION_INT.hdg.\n",
    "some of the elements": "`voltages` of BATTERY_STATUS: six cells, the other four elements are UINT16_MAX.\n",
}


@pytest.mark.parametrize(("text", "message"), LIKELY.values(), ids=LIKELY)
def test_what_no_rule_reads_is_found_by_its_weight(read: Read, check: Check, text: str, message: str) -> None:
    """Each is a warning: certain is only what the structure of a document ties."""
    reading = read(text)
    assert of_dialect(reading, with_weighed=False) == ()
    (finding,) = check(text)
    assert finding.message == f"{message} (likely, not certain)"
    assert not finding.is_error


@pytest.mark.parametrize("text", UNLIKELY.values(), ids=UNLIKELY)
def test_what_weighs_too_little_is_no_finding(check: Check, text: str) -> None:
    assert check(text) == []


def test_weights_decide(read: Read, monkeypatch: pytest.MonkeyPatch) -> None:
    """The same candidates are all told, or none, with other weights."""
    reading = read("".join(text for text, _ in LIKELY.values()))
    monkeypatch.setattr(weighing, "stored_weights", lambda: Weights({}, 0.51))
    assert list(likely(reading, ())) == []
    monkeypatch.setattr(weighing, "stored_weights", lambda: Weights({"unit": 3.0}, 0.51))
    assert {each.rule.id for each in likely(reading, ())} == {"claim-unit"}


def test_a_place_that_is_told_is_not_told_again(read: Read) -> None:
    """Nor is a field whose finding of a rule is in the same line, whatever the rule says of it."""
    reading = read(LIKELY["a unit behind words that other rules stop at"][0])
    first, *_ = likely(reading, ())
    assert list(likely(reading, [first])) == []
    (each,) = [each for each in candidates(reading) if each.kind == "unit"]
    elsewhere = reading.found(first.rule, first.place._replace(column=1), "other", "`image_interval` is something else")
    assert list(chosen([(1.0, each)], [elsewhere])) == []
    other_line = reading.found(first.rule, first.place._replace(line=1), "other", "`image_interval` is something else")
    assert list(chosen([(1.0, each)], [other_line])) == [each]


def test_of_one_place_the_likeliest_is_told(read: Read) -> None:
    reading = read("# ATTITUDE\n\n- `roll`, `pitch`: both are written by the logger, as it is, in deg\n")
    both = [each for each in candidates(reading) if each.kind == "unit"]
    assert [each.field for each in both] == ["roll", "pitch"]
    assert [each.field for each in chosen(zip((0.8, 0.9), both, strict=True), ())] == ["pitch"]


def test_lists_whose_other_entries_are_right_speak_for_a_fault(read: Read) -> None:
    """The same entry, alone and among others that agree: only the traits of the list differ."""
    alone = "# GPS_RAW_INT\n\n- `alt`: in cm\n"
    others = "- `vel`: in cm/s\n- `cog`: in cdeg\n- `lat`: in degE7\n"
    (one,) = candidates(read(alone))
    (among,) = candidates(read(alone + others))
    assert {"others agree", "several agree", "most agree"} <= among.traits - one.traits
    weights = stored_weights().of
    assert likelihood(weights, among.kind, among.traits) > likelihood(weights, one.kind, one.traits)


def test_what_is_stored_are_weights_of_traits(read: Read) -> None:
    """A trait that got another name would count for nothing."""
    reading = read("".join(text for text, _ in LIKELY.values()))
    known = {trait for each in candidates(reading) for trait in each.traits}
    stored = stored_weights()
    assert 0.5 < stored.threshold < 1
    assert len(known & set(stored.of)) > len(known) * 0.9


def _example(read: Read, *traits: str, is_right: bool) -> claims_weights.Example:
    (one,) = candidates(read("# GPS_RAW_INT\n\n- `alt`: in cm\n"))
    candidate = Candidate("unit", one.message, one.field, one.written, one.finding, frozenset(traits))
    return claims_weights.Example("seen-1", Path("notes.md"), candidate, is_right, is_told=False)


def test_traits_of_what_is_right_get_weights_above_zero(read: Read) -> None:
    """The regression behind the stored weights: what stands with both says nothing."""
    those = [_example(read, "good", "both", is_right=True), _example(read, "bad", "both", is_right=False)] * 20
    weights = claims_weights.weighed(those)
    assert weights["good"] > 0.5
    assert weights["bad"] < -0.5
    assert abs(weights["both"]) < 0.1
    assert likelihood(weights, "unit", ["good", "both"]) > 0.9
