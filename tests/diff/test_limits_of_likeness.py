"""Limits of what compares names and texts of two versions: exactly at a limit, and one letter or word beside it."""

import pytest

from codegen.diff.judging.alignment import Word, _shared_ends, _together, _without_common, aligned
from codegen.diff.judging.severities import version_of
from codegen.diff.judging.wording import Likeness, is_reworded, text_likeness
from codegen.diff.judging.words import excluding, is_negated, is_shortened, is_slip


@pytest.mark.parametrize(
    ("one", "other", "slip"),
    [
        ("ab", "abc", False),  # too short
        ("abc", "abcd", True),
        ("abcd", "abc", True),
        ("abc", "abcde", False),  # two letters
        ("abc", "acb", True),  # two that stand side by side change places
        ("abc", "cba", False),
        ("abcdef", "abdcfe", False),
        ("abcd", "abxy", False),
        ("abcd", "abcx", False),  # one letter of four makes another word
        ("abcde", "abcdx", True),
        ("abcde", "xbcde", True),
        ("abcde", "xbcdy", False),
        ("abcde", "bcde", True),
        ("abcde", "abcd", True),
        ("abcde", "axce", False),
        ("abcde", "abcde", False),
    ],
)
def test_a_slip_of_the_pen_is_one_letter(one: str, other: str, slip: bool) -> None:
    assert is_slip(one, other) is slip


@pytest.mark.parametrize(
    ("one", "other", "shortened"),
    [
        ("permant", "permanent", True),
        ("permanent", "permant", True),
        ("perman", "permanen", True),  # six letters, and two more
        ("perma", "perman", False),  # five are too few
        ("perman", "permanent", False),  # three are too many
        ("ermant", "permanet", False),  # another first letter
        ("pamner", "permaner", False),  # another order
    ],
)
def test_a_long_word_lacks_at_most_two_letters(one: str, other: str, shortened: bool) -> None:
    assert is_shortened(one, other) is shortened


def test_words_that_exclude_each_other() -> None:
    assert excluding("up") == {"down"}
    assert "up" not in excluding("up")
    assert {"backward", "revers"} <= excluding("forward")
    assert excluding("winch") == frozenset()
    assert is_negated("healthy", "unhealthy")
    assert not is_negated("unhealthy", "healthy")


@pytest.mark.parametrize(
    ("before", "after", "ends"),
    [
        ("", "", (0, 0)),
        ("a", "", (0, 0)),
        ("a", "a", (1, 0)),
        ("a", "b", (0, 0)),
        ("a b", "a b", (2, 0)),
        ("a b c", "a c", (1, 1)),
        ("a b c", "a x c", (1, 1)),
        ("a a", "a", (1, 0)),  # no word counts at both ends
        ("x b c", "y b c", (0, 2)),
        ("b c", "x b c", (0, 2)),
        ("a b x c d", "a b c d", (2, 2)),
    ],
)
def test_words_at_both_ends(before: str, after: str, ends: tuple[int, int]) -> None:
    sides = [[Word(word, 0) for word in text.split()] for text in (before, after)]
    assert _shared_ends(*sides) == ends


def test_differences_that_are_a_word_apart() -> None:
    """One that is gone and one that comes behind the next word are one; not two that come, nor two words apart."""
    gone, come = (range(1), range(0)), (range(2, 2), range(1, 2))
    assert list(_together([gone, come])) == [(range(2), range(2))]
    assert list(_together([gone, (range(3, 3), range(2, 3))])) == [gone, (range(3, 3), range(2, 3))]
    assert list(_together([come, (range(3, 3), range(3, 4))])) == [come, (range(3, 3), range(3, 4))]
    assert list(_together([gone])) == [gone]
    assert list(_together([])) == []


def test_what_texts_share() -> None:
    found = aligned("mast pump hose sail", "mast pump keel sail")
    assert (found.kept, found.longest, found.share) == (3, 4, 0.75)
    (piece,) = found.pieces
    assert (piece.gone, piece.come, piece.was, piece.now) == (("hose",), ("keel",), " hose", " keel")
    assert piece.is_exchange
    (more,) = aligned("mast pump", "mast pump keel").pieces
    assert not more.is_exchange
    assert aligned("", "").share == 0
    assert aligned("mast pump", "mast pump") == ((), 2, 2)


def test_texts_with_little_in_common_are_not_laid_side_by_side() -> None:
    """With a fifth of the words they are, with less they are not."""
    assert aligned("mast pump hose sail deck", "mast buoy chain rope cleat").pieces
    assert not aligned("mast pump hose sail deck", "mast buoy chain rope cleat fender").pieces


@pytest.mark.parametrize(
    ("old", "new", "reworded"),
    [
        (None, None, False),
        ("", None, False),
        ("mast pump", "mast pump", False),
        (None, "mast", True),
        ("mast", None, True),
        ("mast pump", "mast keel", True),
    ],
)
def test_a_text_that_was_not_there_is_reworded(old: str | None, new: str | None, reworded: bool) -> None:
    assert is_reworded(old, new) is reworded


@pytest.mark.parametrize(
    ("new", "likeness"),
    [
        ("mast pump hose buoy chain", Likeness.NEAR),  # three of five
        ("mast pump rope buoy chain", Likeness.VAGUE),
        ("mast cleat rope buoy chain", Likeness.OTHER),
    ],
)
def test_shares_of_words(new: str, likeness: Likeness) -> None:
    assert text_likeness("mast pump hose sail deck", new) is likeness


def test_three_of_ten_words_are_vague() -> None:
    old = "mast pump hose sail deck bilge rudder anchor winch keel"
    assert text_likeness(old, "mast pump hose buoy chain rope cleat fender lamp oar") is Likeness.VAGUE
    assert text_likeness(old, "mast pump lock buoy chain rope cleat fender lamp oar") is Likeness.OTHER


@pytest.mark.parametrize(
    ("label", "version"),
    [
        ("pymavlink-2.4.43-py3-none-any.whl:common", (2, 4, 43)),
        ("v1.2", (1, 2)),
        ("folder-9.9/v1.2.tar.gz", (1, 2)),
        ("v1", None),
        ("", None),
    ],
)
def test_versions_in_names(label: str, version: tuple[int, ...] | None) -> None:
    assert version_of(label) == version


def test_words_on_both_sides_of_a_difference_count_as_often_as_they_are_there() -> None:
    assert _without_common(("mast", "pump", "mast"), ("pump", "mast", "keel")) == (("mast",), ("keel",))
    assert _without_common(("mast",), ("keel", "keel")) == (("mast",), ("keel", "keel"))
