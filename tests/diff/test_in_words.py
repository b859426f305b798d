"""Descriptions that say the same in other words are harmless; those of a class that mean another thing are not."""

import importlib.util
from pathlib import Path
from typing import Any

import pytest

from codegen.diff.judging.complements import other_complement
from codegen.diff.judging.defaults import is_default, other_default_in_text
from codegen.diff.judging.mentions import negations, numbers, quantities_of
from codegen.diff.judging.phrases import in_one_wording, with_named_axes, without_examples
from codegen.diff.judging.readings import is_one_sense, stated_values
from codegen.diff.judging.references import references
from codegen.diff.judging.texts import other_text
from codegen.diff.judging.turned import is_turned_twice
from codegen.diff.judging.units_in_words import is_same_unit, unit_in_words, without_same_unit
from codegen.diff.judging.words import is_slip

CORPUS = Path(__file__).parent / "corpus"
CLASSES = sorted(file for file in (CORPUS / "in_words").glob("*.yaml") if not file.stem.startswith("mixed"))
MIXED = {
    "mixed_1": (0, 1),
    "mixed_2": (5, 1),
    "mixed_3": (2, 1),
    "mixed_4": (4, 0),
    "mixed_5": (3, 1),
    "mixed_6": (0, 1),
    "mixed_7": (3, 3),
}
"""Of each file of mixed pairs the silent breaks that are called harmless, and the false alarms."""
NOT_UNDERSTOOD = {"left_out-16", "off_and_stopped-7"}
"""Harmless pairs that alarm: ``do not send`` and ``are suppressed``, ``on`` and ``beeps``."""


def scoring() -> Any:
    """The script beside the corpus."""
    spec = importlib.util.spec_from_file_location("corpus_score_in_words", CORPUS / "score.py")
    assert spec is not None
    assert spec.loader is not None
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


@pytest.mark.parametrize("file", CLASSES, ids=lambda file: file.stem)
def test_a_class_is_understood(file: Path) -> None:
    """No silent break of a class is called harmless, and no more of its harmless changes alarm than are known."""
    score = scoring()
    found = list(score.judged(score.pairs_in_words(file)))
    assert len(found) >= 8
    assert not [each.pair for each in found if each.is_missed]
    assert not [each.pair for each in found if each.is_false_alarm and each.pair.name not in NOT_UNDERSTOOD]


@pytest.mark.parametrize("name", MIXED)
def test_mixed_descriptions_are_not_judged_worse_than_they_were(name: str) -> None:
    score = scoring()
    found = list(score.judged(score.pairs_in_words(CORPUS / "in_words" / f"{name}.yaml")))
    missed, alarms = MIXED[name]
    assert [each.pair.name for each in found if each.is_missed][missed:] == []
    assert [each.pair.name for each in found if each.is_false_alarm][alarms:] == []


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("Temperature (0.01 degrees Celsius)", "cdegC"),
        ("Temperature in centidegrees Celsius", "cdegC"),
        ("Temperature (deg C)", "degC"),
        ("Angle in hundredths of a degree", "cdeg"),
        ("Voltage, in thousandths of a volt", "mV"),
        ("Voltage in units of 0.1 mV", "mV*10"),
        ("Current in 10*milliamperes", "cA"),
        ("Distance, steps of 10 cm", "dm"),
        ("Acceleration in metres per second squared", "m/s/s"),
        ("Speed in revolutions per minute", "rpm"),
        ("Field in milligauss", "mgauss"),
        ("Latitude in 1e-7 degrees", "degE7"),
        ("It is within 0.1 degrees", None),
        ("Waits for 10 seconds", None),
        ("Sent every 0.1 seconds", None),
        ("Sent once per second", None),
    ],
)
def test_the_unit_of_a_text_has_its_factor(text: str, unit: str | None) -> None:
    """What is counted with a unit, such as a duration, states none."""
    found = unit_in_words(text)
    assert found == unit or (found is not None and unit is not None and is_same_unit(found, unit))


def test_a_unit_that_both_texts_state_is_not_compared_as_words() -> None:
    assert without_same_unit("Gap in centimetres.", "Gap (cm).") == ("Gap  .", "Gap  .")
    assert without_same_unit("Gap in metres.", "Gap (cm).") == ("Gap in metres.", "Gap (cm).")
    assert without_same_unit("Gap in m, speed in m/s.", "Gap (m).")[1] == "Gap (m)."


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Hold (default).", True), ("Hold. This is the default.", True), ("Default behaviour: hold.", True),
        ("Hold, the default", True), ("Reset to the default.", False), ("Takes the default rate.", False),
        ("Default rate", False), ("Hold", False),
    ],
)  # fmt: skip
def test_which_texts_mark_a_default(text: str, expected: bool) -> None:
    assert is_default(text) == expected


def test_a_default_that_moves_within_a_text_breaks() -> None:
    before = "0: air (default), 1: ground"
    assert other_default_in_text(before, "0: air, 1: ground (default)").breaks
    assert not other_default_in_text(before, "1: ground, 0: air, the default").gravity
    assert not other_default_in_text(before, "0: air, 1: ground").gravity


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("positive up", "negative down", True), ("positive up", "negative up", False),
        ("positive up", "positive up", False),
        ("true if open, false if shut", "false if closed, true if shut", False),
        ("set while open", "cleared while closed", True),
        ("positive left and up", "negative right and down", False),
        ("rows of the upper right triangle", "columns of the lower left triangle", True),
        ("rows of the upper right triangle", "columns of the upper right triangle", False),
        ("rows of the upper right triangle", "rows of the lower left triangle", False),
    ],
)  # fmt: skip
def test_what_is_turned_twice_is_as_it_was(old: str, new: str, expected: bool) -> None:
    """Of what is shown, one thing has to be turned with what shows it: of two it is not to be seen which."""
    assert is_turned_twice(old, new) == expected


@pytest.mark.parametrize(
    ("old", "new", "is_other"),
    [
        ("Heat of the pump", "Heat of the hull", True),
        ("Heat of the pump", "Heat of the pumps", False),
        ("Heat of the pump, see below", "Heat of the hull", True),
        ("Kind of the pump", "Kind as described below", False),
        ("Stays where it is", "Stays at the present position", False),
        ("Stays where it is", "Stays at the pier", True),
        ("Rises straight up", "Rises against the current", True),
        ("Wait before the start", "Wait between starts", True),
        ("Pump is switched off", "Pump is stopped", False),
        ("Rise to the level", "Rise by the level", True),
        ("Distance to the pier", "Distance from the pier", False),
        ("Level in metres", "Level in feet or metres", False),
        ("A pump", "The hull", False),
    ],
)
def test_short_texts_that_go_on_about_another_thing(old: str, new: str, is_other: bool) -> None:
    assert bool(other_complement(old, new).doubt) == is_other


@pytest.mark.parametrize(
    ("one", "other", "expected"),
    [
        ("disable it", "turned off", True), ("disable the pump", "disable the winch", False), ("stop", "disable", True),
        ("none", "stop", False), ("none", "no limit", True), ("no error", "healthy", True), ("fine", "ok", True),
        ("any", "it does not matter", True), ("no change", "as it is", True), ("none", "no change", False),
        ("start the pump", "enable the pump", True), ("broken", "healthy", False),
    ],
)  # fmt: skip
def test_senses_of_numbers_with_their_object(one: str, other: str, expected: bool) -> None:
    """Who disables or stops something else does something else, and who stops does not do nothing."""
    assert is_one_sense(one, other) == is_one_sense(other, one) == expected


def test_what_numbers_do_and_what_stands_before_them() -> None:
    assert stated_values("0 disables the pump") == {0: "disables the pump"}
    assert stated_values("Zero leaves it open") == {0: "leaves it open"}
    assert stated_values("Level. If NaN, the pump decides.") == {"NaN": "the pump decides"}
    assert stated_values("Told by success (1) or failure (0)") == {1: "Told by success", 0: "failure"}
    assert stated_values("Pump (1)") == {}


def test_exclusion_denies_as_not_does() -> None:
    assert negations("It is left out") == negations("It is skipped") == negations("It is not used for that") == 1
    assert negations("255 if not used") == negations("Unknown, ignore the value") == 0
    assert other_text("The sonar is used for the depth", "The sonar is ignored for the depth").gravity
    assert not other_text("The sonar is not used for the depth", "The sonar is ignored for the depth").gravity


def test_a_limit_of_a_type_is_a_number_where_a_scale_ends_with_it() -> None:
    assert numbers("From 0 to 255") == {"0", "255"}
    assert numbers("A share of 65535") == {"65535"}
    assert numbers("0 to 100, 255 if unknown") == {"0", "100"}


def test_how_many_are_told_of() -> None:
    assert quantities_of("Of all the pumps, and this hull") == {"pump": {"all"}, "hull": {"this one"}}
    assert other_text("Leaks of all pumps", "Leaks of this pump").doubt


def test_one_wording() -> None:
    assert in_one_wording("Minute of that hour") == "Minute"
    assert in_one_wording("Indicates whether it is open") == "true if it is open"
    assert in_one_wording("Hour in Coordinated Universal Time") == "Hour in UTC"
    assert in_one_wording("lsb first") == "little endian"
    assert without_examples("Hour (e.g. 18 for 6 p.m.).") == "Hour  ."
    assert without_examples("Number (e.g. 0: none)") == "Number (e.g. 0: none)"
    assert with_named_axes("X velocity (NED)", "North velocity (NED)")[0] == "north velocity (NED)"
    assert with_named_axes("X velocity (NED)", "North velocity")[0] == "X velocity (NED)"


def test_axes_are_called_by_letters_and_by_names() -> None:
    assert not other_text("Drift in X (NED) direction", "Drift in north (NED) direction (NaN if unknown)").gravity
    assert other_text("Drift in X (NED) direction", "Drift in east (NED) direction (NaN if unknown)").gravity


def test_a_letter_doubled_in_place_of_another_one_is_a_slip() -> None:
    assert is_slip("sattelites", "satellites")
    assert not is_slip("pumps", "hulls")


@pytest.mark.parametrize(
    ("text", "kind", "name"),
    [
        ("Index, counted from 0", "first number", "0"),
        ("Index, the first one being 1", "first number", "1"),
        ("Time since departure", "course", "what has passed"),
        ("Time until arrival", "course", "what is to come"),
        ("Time at which it was sent", "course", "when it is"),
        ("Flow out of the tank", "way", "out"),
        ("Wind that comes from there", "flow", "where it comes from"),
        ("Little-endian", "byte order", "the least significant first"),
        ("Level per cell", "count", "each"),
        ("Level of all cells in series", "count", "all together"),
        ("The latest level", "statistic", "a moment"),
        ("Level setpoint", "origin", "what was asked for"),
        ("As read by the sensor", "origin", "what was measured"),
    ],
)
def test_what_numbers_are_measured_from(text: str, kind: str, name: str) -> None:
    assert references(text)[kind] == {name}


def test_indicated_by_a_file_is_no_airspeed() -> None:
    assert references("It is indicated by the name") == {}
    assert references("Indicated airspeed")["airspeed"] == {"indicated"}
