"""What comes of another text for the same number: what is said anew is harmless, what says another thing is not."""

import pytest

from codegen.diff.judging.alignment import aligned
from codegen.diff.judging.conflicts import other_truth, stated_conflict
from codegen.diff.judging.judging import Judgement
from codegen.diff.judging.phrases import in_one_wording, says_unknown
from codegen.diff.judging.quantities import first_minimum, first_unit
from codegen.diff.judging.readings import stated_signs, stated_states, stated_values
from codegen.diff.judging.texts import other_message, other_text, same_entry
from codegen.diff.judging.unset import first_meaning
from codegen.model.dialect.dialect import CommandParameter, EnumDefinition, EnumEntry
from codegen.source import Place

BREAK, DOUBT, NOTHING = "break", "doubt", "nothing"


def weight(judgement: Judgement) -> str:
    return BREAK if judgement.breaks else DOUBT if judgement.doubt else NOTHING


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        # one phrase in a frame of equal words
        (
            "Angle of the mast, with its tip at the level of the rail",
            "Angle of the mast, with its tip on top of a wave",
            DOUBT,
        ),
        ("Depth counted from the surface of the lake", "Depth counted from the keel of the vessel", DOUBT),
        # the same word at several places
        (
            "Valves by layers, at first that layer of the pump on deck",
            "Valves by segments, at first that segment of the pump on deck",
            DOUBT,
        ),
        # a word before what is told, for words behind it
        (
            "Share of the full stroke, -1 to hold the piston",
            "Share of the stroke that is left, -1 to hold the piston",
            DOUBT,
        ),
        # and beside it a slip of the pen, or two words in one
        (
            "Way of the reciever over the mast, as seen from its tip",
            "Way of the receiver over the mast, as seen from deck",
            DOUBT,
        ),
        ("Load of the mainloop on the board at the bow", "Load of the main loop on the board at the stern", DOUBT),
        # the same phrase in other words is none: synonyms, slips of the pen, limits of types, compounds
        ("Length of cable that the winch let out so far", "Length of line that the winch released so far", NOTHING),
        (
            "Load in percent of the mainloop on this board, should be low",
            "Load of the main loop on this board, should be low",
            NOTHING,
        ),
        ("Position of the reciever, taht is on the mast", "Position of the receiver, that is on the mast", NOTHING),
        (
            "Number of drops in the last minute, 255 if not known",
            "Number of drops in the last minute, UINT8_MAX: unknown",
            NOTHING,
        ),
        (
            "Kind of the valve behind the pump, as on its label",
            "Kind of the valve behind the pump, see the description",
            NOTHING,
        ),
        ("Thrust of the pump, reverse trust below 0", "Thrust of the pump, reverse thrust below 0", NOTHING),
        ("Height above the deck of the vessel", "Altitude above the deck of the vessel", NOTHING),
        ("Depth, cannot be measured while docked at the pier", "Depth, unknown while docked at the pier", NOTHING),
        ("Current of the pump on deck, in 10*milliamperes", "Current of the pump on deck, in centiamperes", NOTHING),
        (
            "Axes of the stick, of which buttons are also transmit as booleans",
            "Axes of the stick, of which buttons are transmitted as bits of a mask",
            NOTHING,
        ),
        ("Depth, not available while at the pier", "Depth, unknown while at the pier", NOTHING),
        # much else is another
        ("Length of the hose", "How far the hose reaches from the pump when it is pulled out of its drum", NOTHING),
        # nothing but numbers has rules of its own
        (
            "Pressure of the left tank, 65535 if it is unknown",
            "Pressure of the left tank, NaN if it is unknown",
            NOTHING,
        ),
        ("Flow in 10*milliliter through the pump", "Flow through the pump in the hose", NOTHING),
        # a sentence that is added, and one that is gone
        ("Depth below the keel.", "Depth below the keel. It is filtered by the sonar over several pings.", NOTHING),
        # an alternative, an exception, a restriction that is gone
        ("Sail home.", "Sail home, or drop the anchor if the wind is too strong.", DOUBT),
        ("Sail home.", "Sail home unless the anchor is down.", DOUBT),
        ("Time to wait. (ignored by sailing vessels)", "Time to wait.", DOUBT),
        ("Time to wait.", "Time to wait. (ignored by sailing vessels)", NOTHING),
        ("Red or green.", "Red or green or blue.", NOTHING),
    ],
)
def test_phrases_that_are_exchanged_added_or_gone(old: str, new: str, expected: str) -> None:
    assert weight(other_text(old, new)) == expected


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            "Positive if the hose is filled, negative if it is drained",
            "Positive if the hose is drained, negative if it is filled",
            BREAK,
        ),
        ("Counted from the bow to the stern of the vessel", "Counted from the stern to the bow of the vessel", DOUBT),
        ("Pumps of the bow and the stern", "Pumps of the stern and the bow", NOTHING),
        ("0: stop, 1: start", "1: start, 0: stop", NOTHING),
        ("Elements: left, right, radius", "Elements: radius, left, right", DOUBT),
        ("First it is filled. Then it is drained.", "Then it is drained. First it is filled.", NOTHING),
    ],
)
def test_phrases_that_change_places(old: str, new: str, expected: str) -> None:
    """What a sign or a number stands between breaks; a list may have any order."""
    assert weight(other_text(old, new)) == expected


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("Direction (0=Forward, 1=Reverse)", "Direction (MAV_BOOL_FALSE: Reverse)", BREAK),
        ("Direction (0=Forward, 1=Reverse)", "Direction (MAV_BOOL_FALSE: Forward)", NOTHING),
        (
            "False: brake is released. True: brake is applied.",
            "False: brake is applied. True: brake is released.",
            BREAK,
        ),
        (
            "Cleared while the hatch is dry, set while it is wet",
            "Set while the hatch is dry, cleared while it is wet",
            BREAK,
        ),
        (
            "Time left, -1 if there is no estimate",
            "Time left, -1 while it is charged, -2 if there is no estimate",
            BREAK,
        ),
        ("Angle, NaN to keep the present one", "Angle, NaN: stop the axis", BREAK),
        ("Angle, NaN to keep the present one", "Angle, NaN: no change", NOTHING),
        ("Quality, 255: maximum quality", "Quality, 255 for the best", NOTHING),
        ("Quality, 255: maximum quality", "Quality, 255 for the lowest", DOUBT),
        ("Yaw, NaN if the vehicle shall choose", "Yaw, NaN: the vehicle decides", NOTHING),
        ("Index, or -1 to look it up by tank_id", "Index. -1: the tank is told by tank_id", NOTHING),
        ("Index, or -1 to look it up by tank_id", "Index. -1: the tank is not told by tank_id", DOUBT),
        ("Charge, -1: pump does not provide an estimate", "Charge, -1: field not provided", NOTHING),
        ("Depth, -1 if it cannot be measured", "Depth, -1: there is no sonar data", NOTHING),
        ("Positive: loiter clockwise", "A positive number makes the vehicle turn right", NOTHING),
        ("Positive: loiter clockwise", "A positive number makes the vehicle turn left", BREAK),
        ("Flow. Positive for out", "Flow. Positive while it is drained (it flows out of the tank)", NOTHING),
        ("Third value: positive altitude over the sea", "Third value: altitude over the sea, positive up", NOTHING),
        ("Sense, positive is clockwise", "Sense, positive is anticlockwise", BREAK),
        ("It is ignored unless KIND is set", "Only used if KIND is set", NOTHING),
        ("Zero: stop", "0: stop", NOTHING),
        ("Limit, 0 for none", "Limit. 0: there is no limit.", NOTHING),
        ("Rejected since it is invalid", "Rejected, as it is not valid", NOTHING),
    ],
)
def test_what_is_said_of_numbers_signs_and_bits(old: str, new: str, expected: str) -> None:
    found = weight(other_text(old, new))
    assert (BREAK if found == BREAK else DOUBT if found == DOUBT else NOTHING) == expected


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            "Counters. All of them count from the boot of the node.",
            "Counters. All of them count from the last message of the node.",
            BREAK,
        ),
        ("Counters of the valves of each pump on board", "Counters of the seals of each pump on board", DOUBT),
        (
            "Counters of the valves of each pump on board.",
            "Counters of the valves of each pump on board. They are sent twice.",
            NOTHING,
        ),
        ("Idle channels should be set to UINT16_MAX here", "Idle channels should be set to INT16_MAX here", DOUBT),
        ("", "Counters of the valves", NOTHING),
        ("Counters of the valves of each pump", "Counters for valves and for each pump of them, added up", NOTHING),
    ],
)
def test_texts_of_messages(old: str, new: str, expected: str) -> None:
    """They are about all fields: only what is exchanged while all else stays tells."""
    assert weight(other_message(old, new)) == expected


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("Angle measured from north", "Angle measured from the present heading", BREAK),
        ("Speed of the vessel", "Speed of the vessel through the water", DOUBT),
        ("Speed of the vessel through the water", "Speed of the vessel over ground", BREAK),
        ("Standard deviation of the depth", "Variance of the depth", BREAK),
        ("Current of all motors together", "Current of each motor", BREAK),
        ("Temperature of the pack", "Temperature of the hottest cell of the pack", DOUBT),
        ("Zero based index of the tank", "Index of the tank", DOUBT),
        ("", "Course over ground", NOTHING),
        ("Heading, 0 to 360, 0 is north", "Heading, 0..360, 0 is north", NOTHING),
    ],
)
def test_what_is_measured_from_what(old: str, new: str, expected: str) -> None:
    assert weight(other_text(old, new)) == expected


def test_a_denial_of_something_else_is_no_doubt() -> None:
    """Of the same words in another order a denial in one of them is about another thing."""
    old = (
        "Radius around the buoy for sailing vessels (not for boats). Positive: clockwise. Negative: counter-clockwise."
    )
    new = "A negative number turns sailing vessels around the buoy counter-clockwise, a positive one clockwise."
    assert weight(other_text(old, new)) == NOTHING
    assert weight(other_text("True if the pump runs", "True unless the pump runs")) == DOUBT


def test_an_entry_that_says_the_same_in_other_words() -> None:
    assert weight(same_entry("Pump is off", "The pump is switched off.")) == NOTHING
    assert weight(same_entry("Set while the hull is dry inside", "Set while the hull is wet inside")) == DOUBT


def test_texts_side_by_side() -> None:
    """The pieces in which they differ, each as it is written, and how much of the longer one both have."""
    found = aligned("Depth of the keel below the surface", "Depth of the sonar below the calm surface")
    assert [(piece.gone, piece.come) for piece in found.pieces] == [(("keel",), ("sonar",)), ((), ("calm",))]
    assert [(piece.was, piece.now) for piece in found.pieces] == [(" of the keel", " of the sonar"), ("", " the calm")]
    assert (found.kept, found.longest) == (3, 5)
    endless = aligned("depth of it " * 1000, "depth of the keel " * 1000 + "below")
    assert (endless.pieces, endless.kept) == ((), 0), "nobody waits for it"
    nothing = aligned("Depth of the keel below the surface", "Colour for a lamp that somebody may see at night")
    assert (nothing.pieces, nothing.kept) == ((), 0)


def test_what_texts_say_is_read() -> None:
    assert stated_values("-1 if unknown, 0 while it fills, 2 means full") == {-1: "unknown", 0: "it fills", 2: "full"}
    assert stated_states("Set while wet, not set: dry") == {1: "wet", 0: "dry"}
    assert stated_states("Set to 0") == {}
    assert stated_signs("Positive values if being filled") == {"positive": frozenset({"fill"})}
    assert stated_signs("negative numbers turn left") == {"negative": frozenset({"counterclockwis"})}
    assert in_one_wording("INT8_MAX, UINT16_MAX") == "127, 65535"
    assert [says_unknown(words) for words in ("it is not available", "there is no estimate", "full")] == [
        True,
        True,
        False,
    ]
    assert weight(stated_conflict({0: "False"}, {0: "leave it when it is full"})) == NOTHING


def test_a_truth_value_says_what_1_was() -> None:
    """Where the words for 0 are gone, the text says what 1 is."""
    assert weight(other_truth("0: fill, 1: drain", "Drain the tank")) == NOTHING
    assert weight(other_truth("0: fill, 1: drain", "Fill the tank (values other than 0 or 1 are invalid)")) == BREAK
    assert weight(other_truth("0: fill, 1: drain", "Fill the tank or drain it, 1: drain")) == NOTHING


def parameter(text: str, **attributes: str) -> CommandParameter:
    return CommandParameter("1", tuple(attributes.items()), text, Place("d.xml"))


def enum(zero: str) -> EnumDefinition:
    place = Place("d.xml")
    entries = EnumEntry(zero, 0, "", place), EnumEntry("WAY_B", 1, "", place)
    return EnumDefinition("WAY", entries, False, "", place)


@pytest.mark.parametrize(
    ("old", "new", "zero", "expected"),
    [
        (parameter("Empty"), parameter("0: Delete the log as well, 1: keep it"), "", BREAK),
        (parameter("Empty"), parameter("0: Delete no log"), "", NOTHING),
        (parameter("Empty"), parameter("Camera that is meant. 0 means all cameras."), "", NOTHING),
        (parameter("Empty"), parameter("Pump that is meant.", label="Pump ID"), "", DOUBT),
        (parameter("Empty"), parameter("Pump that is meant, or 0 (see above).", label="Pump ID"), "", NOTHING),
        (parameter("Empty"), parameter("How fast it is.", units="m/s"), "", DOUBT),
        (parameter("Empty"), parameter("How it is done."), "", NOTHING),
        (None, parameter("0: Delete the log as well"), "", BREAK),
        (parameter("", reserved="true", default="NaN"), parameter("Pump that is meant.", label="Pump ID"), "", NOTHING),
        (parameter("", reserved="true", default="NaN"), parameter("NaN: drain the tank"), "", BREAK),
        (parameter("", reserved="true", default="NaN"), parameter("NaN: keep what it was"), "", NOTHING),
        (parameter("Empty"), parameter("How it is done.", enum="WAY"), "WAY_DRAIN", DOUBT),
        (parameter("Reserved (set to 0)"), parameter("How it is done.", enum="WAY"), "WAY_DRAIN", NOTHING),
        (parameter("Empty"), parameter("How it is done.", enum="WAY"), "WAY_NONE", NOTHING),
    ],
)
def test_the_first_meaning_of_a_parameter(
    old: CommandParameter | None, new: CommandParameter, zero: str, expected: str
) -> None:
    """Old senders leave 0 there, or the default: what that asks for was never asked for."""
    assert weight(first_meaning(old, new, enum(zero) if zero else None)) == expected


def test_units_and_limits_that_are_stated_for_the_first_time() -> None:
    assert weight(first_unit("kPa", False, "Pressure (raw)")) == DOUBT
    assert weight(first_unit("kPa", False, "Pressure")) == NOTHING
    assert weight(first_unit("cm/s", True, "Speed")) == DOUBT
    assert weight(first_unit("m/s", True, "Speed")) == NOTHING
    assert weight(first_unit("deg", True, "Angle")) == NOTHING
    assert weight(first_minimum((None, None), ("5", None), "Radius")) == DOUBT
    assert weight(first_minimum((None, None), ("5", None), "Radius, at least 5")) == NOTHING
    assert weight(first_minimum((None, None), ("1", None), "Number of the pump")) == NOTHING
    assert weight(first_minimum(("2", None), ("5", None), "Radius")) == NOTHING, "other_range tells of it"


@pytest.mark.parametrize(("behind", "is_aligned"), [("", True), (" foxtrot", False)])
def test_texts_with_a_fifth_in_common_are_laid_side_by_side(behind: str, is_aligned: bool) -> None:
    """With less there is nothing to be said of what stands where something else stood."""
    found = aligned(f"alpha bravo rudder charlie delta{behind}", "whiskey xray rudder yankee zulu")
    assert bool(found.pieces) is is_aligned
