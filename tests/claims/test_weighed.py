"""Statements that no rule reads are weighed by what stands around them, and are told where that is enough."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import claims_weights
import pytest

from codegen.claims import of_dialect
from codegen.claims.reading import Reading
from codegen.claims.weighed import likely as weighing
from codegen.claims.weighed import weights as stored
from codegen.claims.weighed.candidates import Candidate, candidates
from codegen.claims.weighed.entities.statement import is_alike
from codegen.claims.weighed.likely import chosen, is_kept, weighed
from codegen.claims.weighed.likely import likely as likely_of
from codegen.claims.weighed.weights import Weights, likelihood, stored_weights
from codegen.claims.weighed.words import MARK
from codegen.diagnostics import Diagnostic, Severity

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
    "an id in a comment of data": (
        "```yaml\n- message: VIBRATION    # id 241\n  field: clipping_0\n- message: WIND_COV       # id 213\n"
        "  field: var_horiz\n```\n",
        "WIND_COV has the id 231, not 213",
    ),
    "a number with the digits of an amount": (
        "GPS_RAW_INT (24) is filled.\n\n| GGA | Example | Field | Value |\n|---|---|---|---|\n"
        "| hdop | 1.4 | `eph` | 14 |\n",
        "1.4 is 140 in GPS_RAW_INT.eph (steps of 1E-2), not 14",
    ),
    "a message that there is not": (
        "```c\n#define ID_LOG_DATA 120\n/* a LOG_REQUEST_DATA is answered with LOG_DATA_REPLY (123) */\n```\n",
        "there is no message LOG_DATA_REPLY",
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
    "the id of a component": "HIL_CONTROLS comes from component id 92.\n",
    "an id of one's own": "Our own id for WHEEL_DISTANCE is 9001.\n",
    "a number that is denied": "The CRC_EXTRA of LOCAL_POSITION_NED_COV is not 198.\n",
    "a number that was": "MISSION_COUNT was message 54 before.\n",
    "a macro": "The macro FOLLOW_TARGT sends HEARTBEAT.\n",
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
    monkeypatch.setattr(weighing, "stored_weights", lambda: Weights({}, 0.51, 0.0))
    assert list(likely_of(weighed(reading), ())) == []
    monkeypatch.setattr(weighing, "stored_weights", lambda: Weights({"unit": 3.0}, 0.51, 0.0))
    assert {each.rule.id for each in likely_of(weighed(reading), ())} == {"claim-unit"}


def test_a_place_that_is_told_is_not_told_again(read: Read) -> None:
    """Nor is a field whose finding of a rule is in the same line, whatever the rule says of it."""
    reading = read(LIKELY["a unit behind words that other rules stop at"][0])
    first, *_ = likely_of(weighed(reading), ())
    assert list(likely_of(weighed(reading), [first])) == []
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


def test_as_many_numbers_as_names_are_one_for_each(read: Read) -> None:
    """A number more, or one name alone, and it is not said that each name has its number."""
    for text, is_so in (
        ("HEARTBEAT and SYS_STATUS have the ids 3 and 4.\n", True),
        ("HEARTBEAT and SYS_STATUS have the ids 3 and 4 in 2 places.\n", False),
        ("HEARTBEAT has the id 3.\n", False),
    ):
        found = [each for each in candidates(read(text)) if each.kind == "id"]
        assert found, text
        assert {"as many numbers" in each.traits for each in found} == {is_so}, text


def test_what_is_stored_are_weights_of_traits(read: Read) -> None:
    """A trait that got another name would count for nothing."""
    reading = read("".join(text for text, _ in LIKELY.values()))
    traits = {trait for each in candidates(reading) for trait in each.traits}
    known = {trait for trait in traits if not trait.startswith(MARK)}
    assert {"word just before in", "word behind if"} & traits & set(stored_weights().of)
    kept = stored_weights()
    assert 0 < kept.least < 0.5 < kept.threshold < 1
    assert len(known & set(kept.of)) > len(known) * 0.85


def test_what_a_rule_reads_as_likely_is_left_out_where_it_weighs_too_little(read: Read) -> None:
    """Only a likely finding, only by a candidate of its own rule, thing and line, and first of all by that at its place."""
    reading = read("# ATTITUDE\n\n- `roll`, `pitch`: both are written by the logger, as it is, in deg\n")
    each = next(one for one in candidates(reading) if one.field == "roll")
    finding = each.finding
    assert not is_kept([(0.04, each)], finding, 0.05)
    assert is_kept([(0.06, each)], finding, 0.05)
    assert is_kept([], finding, 0.05)
    assert is_kept([(0.04, each)], replace(finding, rule=replace(finding.rule, severity=Severity.ERROR)), 0.05)
    assert is_kept([(0.04, each)], replace(finding, rule=replace(finding.rule, id="claim-struct")), 0.05)
    assert is_kept([(0.04, each)], replace(finding, message="ATTITUDE.yaw is in rad, not deg"), 0.05)
    assert is_kept([(0.04, each)], replace(finding, place=finding.place._replace(line=1)), 0.05)
    other = replace(each, finding=replace(finding, place=finding.place._replace(column=1)))
    assert not is_kept([(0.04, each), (0.9, other)], finding, 0.05)
    assert is_kept([(0.9, other)], finding, 0.05)


def test_a_document_is_told_without_what_weighs_too_little(read: Read, monkeypatch: pytest.MonkeyPatch) -> None:
    """The same likely finding of a rule is told or not, as the weights say."""
    reading = read("HIGHRES_IMU (105): the gyros of the message are in deg/s.\n")
    (told,) = of_dialect(reading, with_weighed=False)
    assert not told.is_error
    those = [each for each in candidates(reading) if each.finding.rule.id == told.rule.id]
    assert those
    for least, found in ((0.0, [told]), (0.99, [])):
        monkeypatch.setattr(stored, "stored_weights", lambda least=least: Weights({}, 1.0, least))
        monkeypatch.setattr(weighing, "stored_weights", lambda least=least: Weights({}, 1.0, least))
        assert list(of_dialect(reading)) == found


def test_numbers_that_look_alike() -> None:
    """Digits in another order, one of them changed, or a number beside it: what a slip of the pen makes of a number."""
    assert is_alike(142, 124)
    assert is_alike(11034, 11031)
    assert is_alike(9, 10)
    assert not is_alike(142, 97)
    assert not is_alike(20, 133)


def test_a_denied_type_is_not_said(read: Read) -> None:
    assert [each.kind for each in candidates(read("`param_value` of PARAM_EXT_SET is no float here.\n"))] == []
    assert [each.kind for each in candidates(read("`param_value` of PARAM_EXT_SET is a float here.\n"))] == ["type"]


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
    assert likelihood(weights, "unit", ["good", "both"]) > 0.8


def test_words_of_few_folders_get_no_weight(read: Read) -> None:
    """A word that one writer likes says nothing of the next one; other traits are kept however rare they are."""
    often, rare = f"{MARK}next in", f"{MARK}next aft"
    one = _example(read, often, rare, "code", is_right=True)
    many = [replace(_example(read, often, is_right=True), folder=f"seen-{number}") for number in range(5)]
    (kept,) = claims_weights.without_rare_words([one], [one, *many])
    assert kept.candidate.traits == {often, "code"}


def test_keys_of_data_are_no_fields(read: Read) -> None:
    """A message may have a field `type`; in a list of its fields the word is the key for what each of them is."""
    listed = "```yaml\nmessage: AIS_VESSEL\nfields:\n  lat: {type: int32}\n  lon: {type: int32}\n```\n"
    assert [each.finding.message for each in candidates(read(listed)) if each.field == "type"] == []
    said = "AIS_VESSEL (301) is sent. Its `type` is an int32 there.\n"
    assert [each.field for each in candidates(read(said)) if each.kind == "type"] == ["type"]


def test_words_beside_a_value_are_those_of_its_sentence(read: Read) -> None:
    (each,) = candidates(read("# GPS_RAW_INT\n\nIt is said. Here `alt` is given in cm, as it was. The rest follows.\n"))
    found = {trait.removeprefix(MARK) for trait in each.traits if trait.startswith(MARK)}
    assert {"just before in", "before given", "next ,", "behind as", "between is"} <= found
    assert not any(word.endswith((" said", " rest")) for word in found)
