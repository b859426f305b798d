"""What comes of a number, a name or a text that is another one: a break, a question for a person, or nothing."""

from types import SimpleNamespace
from typing import Any

import pytest

from codegen.diff.judging.conflicts import stated_conflict
from codegen.diff.judging.judging import (
    Judgement,
    by_words,
    enum_for_words,
    gone_entry,
    gravest,
    other_entry,
    other_enum,
)
from codegen.diff.judging.texts import same_entry
from codegen.diff.judging.wording import Likeness

BREAK, DOUBT, NOTHING = "break", "doubt", "nothing"
SAME, NEAR, VAGUE, UNSAID, OTHER, DISPUTED, OPPOSITE = Likeness
ALL = frozenset(Likeness)


def weight(judgement: Judgement) -> str:
    return BREAK if judgement.breaks else DOUBT if judgement.doubt else NOTHING


# By the likeness of names, and of texts, what an entry with another name is.
BY_WORDS = {
    SAME: {OPPOSITE: BREAK, OTHER: DOUBT, DISPUTED: DOUBT},
    NEAR: {OPPOSITE: BREAK, OTHER: BREAK, DISPUTED: BREAK, SAME: NOTHING, NEAR: NOTHING, VAGUE: DOUBT, UNSAID: DOUBT},
    VAGUE: {SAME: NOTHING, NEAR: DOUBT, VAGUE: DOUBT, UNSAID: DOUBT},
    OTHER: {SAME: NOTHING, NEAR: DOUBT},
    OPPOSITE: {SAME: NOTHING},
}
OTHERWISE = {SAME: NOTHING, VAGUE: BREAK, OTHER: BREAK, OPPOSITE: BREAK}


@pytest.mark.parametrize("names", BY_WORDS)
@pytest.mark.parametrize("texts", sorted(ALL))
def test_another_name_is_judged_by_both_likenesses(names: Likeness, texts: Likeness) -> None:
    expected = BY_WORDS[names].get(texts) or OTHERWISE[names]
    assert weight(by_words(names, texts, "GO", "DRIVE")) == expected


def test_a_shorter_name_may_say_less() -> None:
    """Only one that says as much or more is a fuller name of the same."""
    found = [by_words(NEAR, NEAR, *names) for names in (("GO", "AT"), ("GO", "GO_ON"), ("GO_ON", "GO"))]
    assert [weight(each) for each in found] == [NOTHING, NOTHING, DOUBT]


def entry(name: str, description: str = "", value: int = 1) -> Any:
    return SimpleNamespace(name=name, description=description, value=value)


def enum(*entries: Any, name: str = "PACE") -> Any:
    return SimpleNamespace(name=name, entries=entries)


def numbered(*names: str, name: str = "PACE") -> Any:
    """An enum whose entries count from 0; an empty name is a number that it leaves out."""
    return enum(*(entry(each, value=value) for value, each in enumerate(names) if each), name=name)


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (entry("PACE_RESERVED"), entry("PACE_TROT"), NOTHING),
        (entry("PACE_A", "Reserved."), entry("PACE_TROT", "Trots."), NOTHING),
        (entry("PACE_WALK"), entry("PACE_TROT"), BREAK),
        (entry("PACE_WALK", "Walks slowly."), entry("PACE_RESERVED", "Was PACE_WALK"), NOTHING),
        (entry("PACE_WALK", "Walks slowly."), entry("PACE_RESERVED", "Walks slowly."), NOTHING),
        (entry("PACE_WALK", "Walks slowly."), entry("PACE_RESERVED", ""), BREAK),
        (entry("PACE_USER_1"), entry("PACE_TROT"), DOUBT),
        (entry("PACE_USER_1"), entry("PACE_PRIVATE_1"), BREAK),
        (entry("PACE_USER_1"), entry("PACE_USER1"), NOTHING),
        (entry("PACE_WALK", "Walks slowly."), entry("PACE_STROLL", "Walks slowly."), NOTHING),
    ],
)
def test_a_number_with_another_name(old: Any, new: Any, expected: str) -> None:
    assert weight(other_entry(old, new, enum(old))) == expected


def test_a_text_that_others_have_as_well_says_nothing_of_a_name() -> None:
    """Then the name alone decides, but a respelling stays one."""
    old, other = entry("PACE_WALK", "A pace."), entry("PACE_TROT", "A pace.", 2)
    assert weight(other_entry(old, entry("PACE_GALLOP", "A pace."), enum(old, other))) == BREAK
    assert weight(other_entry(old, entry("PACE_WALK_ON", "A pace."), enum(old, other))) == NOTHING
    assert (
        weight(other_entry(old, entry("PACE_GALLOP", "A pace."), enum(old, entry("PACE_TROT", "Quick.", 2)))) == NOTHING
    )


def test_one_word_in_place_of_another_in_name_and_text_is_another_thing() -> None:
    old = entry("PACE_HORSE_WALK", "The horse walks along the long fence.")
    new = entry("PACE_MULE_WALK", "The mule walks along the long fence.")
    assert weight(other_entry(old, new, enum(old))) == BREAK
    alike = entry("PACE_MULE_WALK", "The horse walks along the long fence there.")
    assert weight(other_entry(old, alike, enum(old))) == DOUBT


@pytest.mark.parametrize(
    ("old", "new", "expected", "said"),
    [
        ("1: walk, 2: trot", "1: trot, 2: walk", BREAK, "1 was 'walk' and is 'trot'"),
        ("The left wheel turns", "The right wheel turns", BREAK, "the opposite"),
        ("Left: road leads town by river", "Right: counts sheep, wool, goats, cows", DOUBT, "the opposite of"),
        ("The horse walks along there", "The mule walks along there", DOUBT, "'mule' in place of 'horse'"),
        ("Grass on the northern hill slope", "Ships sailing across oceans", DOUBT, "something else"),
        ("Grass on hill", "Ships sailing across oceans", NOTHING, ""),
        ("Ships sailing across oceans", "Grass on hill", NOTHING, ""),
        ("The horse walks", "The horse walks.", NOTHING, ""),
        ("", "The horse walks", NOTHING, ""),
    ],
)  # fmt: skip
def test_another_text_under_the_same_name(old: str, new: str, expected: str, said: str) -> None:
    found = same_entry(old, new)
    assert weight(found) == expected
    assert said in (found.effect or found.doubt)


@pytest.mark.parametrize(
    ("gone", "is_bitmask", "expected"),
    [
        (entry("PACE_RESERVED", value=4), True, NOTHING),
        (entry("PACE_WALK", value=4), True, BREAK),
        (entry("PACE_WALK", value=0), False, BREAK),
        (entry("PACE_NONE", value=0), True, NOTHING),
        (entry("PACE_WALK", value=0), True, DOUBT),
    ],
)
def test_an_entry_that_is_gone(gone: Any, is_bitmask: bool, expected: str) -> None:
    assert weight(gone_entry(gone, is_bitmask=is_bitmask)) == expected


WALKS = numbered("PACE_WALK", "PACE_TROT")


@pytest.mark.parametrize(
    ("old", "new", "text", "expected", "said"),
    [
        (None, WALKS, "", NOTHING, "for the first time"),
        (WALKS, None, "", BREAK, "nothing says"),
        (WALKS, None, "One of PACE", NOTHING, "still says so"),
        (WALKS, None, "0: walk, 1: trot", NOTHING, "still says so"),
        (WALKS, None, "0: walk", BREAK, "nothing says"),
        (WALKS, None, "0: walk, 1: gallop", BREAK, "nothing says"),
        (enum(), None, "0: walk", BREAK, "nothing says"),
        (WALKS, numbered("GAIT_WALK", "GAIT_TROT", name="GAIT"), "", NOTHING, "another name of the same enum"),
        (
            WALKS,
            numbered("GAIT_WALK", "GAIT_TROT", "GAIT_RUN", name="GAIT"),
            "",
            NOTHING,
            "GAIT has all values of PACE",
        ),
        (WALKS, numbered("GAIT_TROT", "GAIT_WALK", name="GAIT"), "", BREAK, "0 was PACE_WALK and is GAIT_TROT"),
        (WALKS, numbered("GAIT_WALK", "GAIT_RUN", name="GAIT"), "", BREAK, "1 was PACE_TROT and is GAIT_RUN"),
        (WALKS, numbered("GAIT_LEFT", name="GAIT"), "", BREAK, "0 was PACE_WALK and is GAIT_LEFT"),
        (WALKS, numbered("", "", "GAIT_RUN", name="GAIT"), "", BREAK, "none of its numbers is one of GAIT"),
        (WALKS, numbered("GAIT_WALK", name="GAIT"), "", DOUBT, "whether GAIT has what PACE_TROT was"),
        (WALKS, numbered("GAIT_WALK", "GAIT_TROT_ON", name="GAIT"), "", DOUBT, "whether GAIT has what PACE_TROT was"),
    ],
)
def test_other_names_for_the_numbers_of_a_field(old: Any, new: Any, text: str, expected: str, said: str) -> None:
    found = other_enum(old, new, text)
    assert (weight(found), said in (found.effect or found.doubt)) == (expected, True)


@pytest.mark.parametrize(
    ("text", "new", "expected"),
    [
        ("0: trot, 1: walk", WALKS, "0 was 'trot' in the description, which is 1 in PACE"),
        ("0: walk, 1: trot", WALKS, ""),
        ("0: gallop", WALKS, ""),
        ("5: trot", WALKS, ""),
        ("0: trot", None, ""),
    ],
)
def test_an_enum_in_place_of_words(text: str, new: Any, expected: str) -> None:
    found = enum_for_words(text, new)
    assert (found.effect, found.breaks) == (expected, bool(expected))


@pytest.mark.parametrize(
    ("old", "new", "expected", "said"),
    [
        ({1: "walk", 2: "trot"}, {1: "trot", 2: "walk"}, BREAK, "1 was 'walk' and is 'trot'; 2 is that now"),
        ({1: "walk", 2: "trot"}, {1: "walk", 2: "trot", 3: "run"}, NOTHING, ""),
        ({1: "walk"}, {2: "walk"}, NOTHING, ""),
        ({1: "walk", 2: "run"}, {1: "stand", 2: "sit", 3: "walk slowly"}, BREAK, "1 was 'walk' and is 'stand'; 3 is"),
        ({1: "walk"}, {1: "walk slowly", 2: "walk"}, NOTHING, ""),
        ({1: "walk", 2: "run"}, {1: "walk slowly", 2: "walk"}, BREAK, "is 'walk slowly'; 2 is that now"),
        ({1: "walk", 2: "walk"}, {1: "run", 2: "walk"}, BREAK, "2 is that now"),
        ({1: "turn left"}, {1: "turn right"}, BREAK, "1 was 'turn left' and is 'turn right'"),
        ({1: "walk"}, {1: "sit"}, DOUBT, "whether 1, which was 'walk', is 'sit'"),
        ({1: "walk slowly"}, {1: "walk"}, NOTHING, ""),
    ],
)  # fmt: skip
def test_two_texts_that_say_something_else_of_a_number(
    old: dict[int, str], new: dict[int, str], expected: str, said: str
) -> None:
    found = stated_conflict(old, new)
    assert (weight(found), said in (found.effect or found.doubt)) == (expected, True)


def test_the_gravest_of_several_is_the_first_of_those_that_are_alike() -> None:
    breaks, doubt, other = Judgement(breaks=True), Judgement(doubt="whether"), Judgement(doubt="or not")
    assert gravest(Judgement(), doubt, other) is doubt
    assert gravest(doubt, breaks, Judgement(breaks=True, effect="later")) is breaks
    assert [each.gravity for each in (Judgement(), doubt, breaks)] == sorted(range(3))
