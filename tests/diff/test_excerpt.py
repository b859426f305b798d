"""Of two long texts a reviewer sees what changed, whole words, and little else."""

import random

import pytest

from codegen.diff.report.excerpt import difference

LONG = " ".join(f"word{number}" for number in range(80))


def test_one_changed_word_is_shown_with_a_few_around_it() -> None:
    assert difference(LONG, LONG.replace("word40", "other")) == (
        "... word36 word37 word38 word39 word40 word41 word42 word43 word44 ...",
        "... word36 word37 word38 word39 other word41 word42 word43 word44 ...",
    )


def test_two_changes_far_apart_are_two_fragments() -> None:
    """And not all that stands between them."""
    old, new = difference(LONG, LONG.replace("word0 ", "x ").replace("word79", "y"))
    assert old == "word0 word1 word2 word3 word4 ... word75 word76 word77 word78 word79"
    assert new == "x word1 word2 word3 word4 ... word75 word76 word77 word78 y"


def test_short_texts_are_whole_and_long_ones_end_behind_a_word() -> None:
    assert difference("m", "cm") == ("m", "cm")
    assert difference(None, "cm") == (None, "cm")
    _, new = difference(None, LONG)
    assert new is not None
    assert new.endswith("word34 ...")
    assert difference(LONG, LONG.replace(" ", "  ", 1))[0] == new
    assert difference("a" * 300, "b" * 300) == ("a" * 236 + " ...", "b" * 236 + " ...")


def test_what_is_just_short_enough_is_whole() -> None:
    """Texts of 70 characters; changes with eight words between them, which both would show."""
    text = "word " * 13 + "words"
    assert len(text) == 70
    assert difference(text, text.replace("words", "other")) == (text, text.replace("words", "other"))
    assert difference(text + "x", "x" + text)[0] != text + "x"
    one, two = (difference(LONG, LONG.replace("word10 ", "x ").replace(f"word{at} ", "y "))[0] for at in (19, 20))
    assert one == f"... {' '.join(f'word{number}' for number in range(6, 24))} ..."
    assert "word14 ... word16" in str(two)


@pytest.mark.parametrize("seed", range(40))
def test_what_differs_always_differs_in_what_is_shown(seed: int) -> None:
    """Whatever is changed: both excerpts differ, are short, and consist of whole words."""
    draw = random.Random(seed)
    words = [draw.choice(("a", "bb", "GPS_RAW_INT", "is", "unknown")) for _ in range(draw.randrange(1, 120))]
    other = list(words)
    for _ in range(draw.randrange(1, 6)):
        at = draw.randrange(len(other) + 1)
        other[at : at + draw.randrange(2)] = [draw.choice(("new", "words", "x y"))] * draw.randrange(1, 3)
    old, new = difference(" ".join(words), " ".join(other))
    assert old != new
    for shown, whole in ((old, words), (new, other)):
        assert shown is not None
        assert len(shown) <= 250
        assert set(shown.split()) <= {*" ".join(whole).split(), "..."}
