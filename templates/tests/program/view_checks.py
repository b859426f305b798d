"""Attributes as views of words: what each kind keeps of a number, shows of it, limits, counts and tells.

The component of these checks is made up, so that it has each kind that this program can have.
"""

import struct

from conversion import to_steps
from program_bench import main, needs
from words import UNKNOWN, Component, known, number, result, together, truth, whole

try:
    import wide
except ImportError:  # nothing has so many bits
    wide = None

try:
    import lists
except ImportError:  # nothing is a list
    lists = None

try:
    import thresholds
except ImportError:  # nothing has a threshold
    thresholds = None

NAN, INFINITY = float("nan"), float("inf")
LARGEST = 1073741823


class Invented(Component):
    """A component with a number of each kind; two more are made of what VIEWS says of them."""

    NAME = "invented"
    SIZE = 24
    START = (0, (3, 4, 2), 6, 1, 9, 5)
    VIEWS = (
        # A comment is no view.
        " late: whole 7 -2 2 late\n late_mm: late_m: number 8 -9000 9000 late_m 1000\n is_late: known 7\n"
    )
    plain = whole(0, -5, 7, "plain")
    steps, shown = number(1, -100, 100, "shown", 10, 1, 2)
    third = number(3, -50, 50, "third", 1, 3)[1]
    half = number(10, -50, 50, "half", 1, 2)[1]
    count, same = number(4, 0, 9, "same", 1)
    only = result(5, 4, 1)
    flag = truth(6)
    is_known = known(1)


def new(instances=1):
    """Return a component of so many instances, with the texts that they log."""
    texts = []
    words = [UNKNOWN] * (Invented.SIZE * instances + 2)
    made = together(Invented, array_of(words), 1, Invented.SIZE, instances, lambda *told: texts.append(told[0]))
    return made, texts


def array_of(words):
    """Return words in an array."""
    from array import array  # noqa: PLC0415

    return array("i", words)


def instances_share_the_words():
    """Each has its part, and starts with what it knows; alone it has words of its own."""
    first, _ = new(3)
    assert [len(first), first[0] is first, len(first[2])] == [3, True, 3]
    assert [first[at].plain for at in range(3)] == [3, 4, 2]
    for at in range(2):
        first[at].steps = at
        assert first.words[1] == 0
        assert [first[0].steps, first[1].steps, first[2].steps] == [0, 1 if at else None, None]
    alone = Invented(None, 1)
    assert list(alone.words) == [4] + [UNKNOWN] * 5 + [1] + [UNKNOWN] * 2 + [5] + [UNKNOWN] * 14
    assert (alone[0] is alone, len(alone)) == (True, 1)


def numbers_have_units():
    """Whole steps and the unit of people show the same; a half is rounded away from zero; NaN and None are unknown."""
    one, texts = new()
    assert (one.steps, one.shown, one.is_known, one.words[2]) == (None, None, False, UNKNOWN)
    for value, steps, shown in ((1.25, 13, 1.3), (-1.25, -13, -1.3), (1.24, 12, 1.2), (0, 0, 0.0), (10, 100, 10.0)):
        one.words[2] = 5
        one.shown = value
        assert (one.steps, one.shown, one.is_known, one.words[2]) == (steps, shown, True, 0), (value, one.steps)
    for nothing in (None, NAN, INFINITY, -INFINITY):
        one.shown, one.words[2] = 1, 5
        one.shown = nothing
        assert (one.steps, one.shown, one.words[1], one.words[2]) == (None, None, UNKNOWN, 0)
    one.steps, one.words[2] = 7, 9
    one.steps = None
    assert (one.shown, one.words[2]) == (None, 0)
    for value, kept in ((9, 9.0), (7, 6.0), (8, 9.0), (-8, -9.0)):
        one.third = value
        assert (one.third, one.words[3]) == (kept, kept // 3), value
    for value, kept in ((8, 8.0), (7, 8.0), (-7, -8.0), (0.9, 0.0)):
        one.half = value
        assert (one.half, one.words[10]) == (kept, kept // 2), value
    assert to_steps((1 << 60) + 1, 1, 1, 1 << 64) == (1 << 60) + 1, "a whole number has all of its digits"
    one.same = 5
    assert (repr(one.same), one.count) == ("5", 5), "a whole number stays one"
    one.words[5] = 10
    assert one.only == 2.5
    one.words[5] = UNKNOWN
    assert one.only is None
    for value, kept in ((True, 1), (5, 1), (0, 0), (None, 0)):
        one.flag = value
        assert (one.words[6], one.flag) == (kept, kept == 1)
    one.words[6] = -1
    assert one.flag is True
    assert texts == []


def what_is_beyond_is_counted_and_told():
    """A number beyond its limits is counted each time, and told once, until one within them is set."""
    one, texts = new()
    for value, kept, count, told in (
        (7, 7, 0, None),
        (8, 8, 1, "7"),
        (9, 9, 2, None),
        (1 << 40, LARGEST, 3, None),
        (-5, -5, 3, None),
        (-6, -6, 4, "-5"),
        (-(1 << 40), -LARGEST, 5, None),
        (None, None, 5, None),
        (-7, -7, 6, None),
        (0, 0, 6, None),
        (8, 8, 7, "7"),
    ):
        del texts[:]
        one.plain = value
        assert (one.plain, one.limited.get("plain", 0)) == (kept, count), (value, one.plain, one.limited)
        assert texts == ([f"warning: invented.plain beyond {told}: limited"] if told else []), (value, texts)
    several, texts = new(2)
    several[1].shown = 10.1
    assert (texts, several[1].limited, several[0].limited) == (
        ["warning: invented[1].shown beyond 10: limited"],
        {"shown": 1},
        {},
    )
    assert several[1].steps == 101
    one.limited["plain"] = LARGEST
    one.plain = 9
    assert one.limited["plain"] == LARGEST, "a count ends where the heap would begin"
    for wrong in ("1", [1]):
        try:
            one.plain = wrong
        except TypeError:
            continue
        raise AssertionError(wrong)


def views_are_made_when_they_are_used():
    """Of a line of VIEWS, by any of its names, for reading as for writing; other names are none."""
    for order in (0, 1, 2):

        class Late(Invented):
            """One whose views are not made yet."""

        one = Late()
        if order == 0:
            one.late_m = 1.5
        if order == 1:
            one.late_mm = 1500
        if order == 2:
            assert one.late_mm is None
            one.words[8] = 1500
        assert (one.late_mm, one.late_m, one.is_late, one.late) == (1500, 1.5, False, None)
        one.late = 2
        assert (one.words[7], one.is_late) == (2, True)
        one.other = 5
        assert one.other == 5
        for wrong in ("lat", "ate", "late_", "whole", "7", "late:"):
            try:
                getattr(one, wrong)
            except AttributeError as error:
                assert error.args[0] == "invented has no " + wrong, error  # noqa: PT017
                continue
            raise AssertionError(wrong)


def lists_have_places():
    """Each element by its place, from either end, and all of them in the unit of people; others are no places."""
    needs(lists, "a list")

    class Listed(Invented):
        """One with lists: of as many as there can be, and of as many as an instance says."""

        parts = lists.elements(10, 4, 0, 100, "parts", None, 2)
        parts_v = lists.shown_elements("parts", 10)
        few = lists.elements(14, 4, -9, 9, "few", 20)

    texts = []
    one = together(Listed, array_of([UNKNOWN] * 24), 0, 24, 1, lambda *told: texts.append(told[0]))
    assert (len(one.parts), len(one.parts_v), list(one.parts_v)) == (4, 4, [None] * 4)
    one.parts = [1, None, 3, 4]
    assert list(one.words[10:14]) == [1, UNKNOWN, 3, 4]
    assert one.words[2] == 0
    assert [one.parts[at] for at in (0, 1, 3, -1, -4)] == [1, None, 4, 4, 1]
    one.words[2] = 5
    one.parts[-2] = 7
    assert (one.words[12], one.words[2]) == (7, 0)
    one.parts_v = (0.25, 1, None, NAN)
    assert (list(one.words[10:14]), list(one.parts_v)) == ([3, 10, UNKNOWN, UNKNOWN], [0.3, 1.0, None, None])
    one.words[2] = 5
    one.parts_v[-1] = 0.76
    assert (one.words[13], one.parts_v[3], one.words[2]) == (8, 0.8, 0)
    one.parts_v = None
    assert list(one.parts_v) == [None] * 4
    one.words[20] = 2
    assert len(one.few) == 2
    one.few = [1, 2]
    assert list(one.words[14:18]) == [1, 2, UNKNOWN, UNKNOWN]
    for name, values in (("parts", [1, 2, 3]), ("parts_v", [1] * 5), ("few", [1, 2, 3])):
        try:
            setattr(one, name, values)
        except ValueError as error:
            expected = f"there are {2 if name == 'few' else 4} values, not {len(values)}"
            assert error.args[0] == expected, error  # noqa: PT017
            continue
        raise AssertionError(name)
    for wrong in (4, -5):
        try:
            one.parts[wrong] = 1
        except IndexError:
            continue
        raise AssertionError(wrong)
    assert texts == []
    one.parts[2] = 101
    assert texts == ["warning: invented.parts[2] beyond 100: limited"], texts
    assert one.limited == {"parts": 1}


def numbers_of_many_bits():
    """Halves of 16 bits, the low ones first; to the ends of what they carry, and what is beyond becomes the end."""
    needs(wide, "a number of more than 30 bits")

    class Wide(Invented):
        """One with whole numbers of 32 and 64 bits."""

        signed = wide.integer(8, 2, -(1 << 31), (1 << 31) - 1, "signed")
        unsigned = wide.integer(10, 4, 0, (1 << 64) - 1, "unsigned")
        deep = wide.integer(14, 4, -(1 << 63), (1 << 63) - 1, "deep", (-5, 5))
        shown = wide.shown_integer(18, 2, -(1 << 31), (1 << 31) - 1, "shown", 10)
        same = wide.shown_integer(20, 4, 0, (1 << 64) - 1, "same", 1)

    texts = []
    one = together(Wide, array_of([UNKNOWN] * 24), 0, 24, 1, lambda *told: texts.append(told[0]))
    for name, place, halves, low, high in (
        ("signed", 8, 2, -(1 << 31), (1 << 31) - 1),
        ("unsigned", 10, 4, 0, (1 << 64) - 1),
        ("deep", 14, 4, -(1 << 63), (1 << 63) - 1),
        ("same", 20, 4, 0, (1 << 64) - 1),
    ):
        assert getattr(one, name) is None
        for value in (low, high, 0, 1, low + 1, high - 1, 0x12345678, high // 3, 0x8000, 0xFFFF, 0x10000):
            setattr(one, name, value)
            assert getattr(one, name) == value, (name, value)
            bits = value & (1 << 16 * halves) - 1
            expected = [bits >> 16 * half & 0xFFFF for half in range(halves)]
            assert list(one.words[place : place + halves]) == expected, (name, value)
        setattr(one, name, None)
        assert (getattr(one, name), one.words[place]) == (None, UNKNOWN)
    assert one.limited.pop("deep") == 9
    assert texts == ["warning: invented.deep beyond -5: limited"] * 2, texts
    del texts[:]
    one.deep = 5
    one.deep = -5
    for name, beyond, kept in (("signed", 1 << 31, (1 << 31) - 1), ("signed", -(1 << 40), -(1 << 31))):
        setattr(one, name, beyond)
        assert getattr(one, name) == kept
        setattr(one, name, 0)
    assert one.limited == {"signed": 2}
    assert len(texts) == 2, texts
    for value, steps in ((1.25, 13), (-1.25, -13), (10, 100), (None, None), (NAN, None), (0.04, 0)):
        one.shown = value
        assert one.shown == (None if steps is None else steps / 10)
        assert one.words[18] == (UNKNOWN if steps is None else steps & 0xFFFF)
    one.same = 2.0
    assert repr(one.same) == "2"


def floats_of_both_sizes():
    """As struct packs them, in halves; what is infinite or no number is unknown, and what is too large the largest."""
    needs(wide, "a number of more than 30 bits")
    largest = struct.unpack("<f", b"\xff\xff\x7f\x7f")[0]

    class Floating(Invented):
        """One with floats of 32 and 64 bits, with and without limits and units."""

        single = wide.floating(8, 2, "single")
        double = wide.floating(10, 4, "double")
        bounded = wide.floating(14, 4, "bounded", -2.0, 3.0)
        told = wide.floating(18, 2, "told", None, None, (-1.0, 1.0), 4, 2)

    texts = []
    one = together(Floating, array_of([UNKNOWN] * 24), 0, 24, 1, lambda *said: texts.append(said[0]))
    for name, code, place, halves in (("single", "<f", 8, 2), ("double", "<d", 10, 4)):
        assert getattr(one, name) is None
        for value in (0.0, 1.5, -0.375, 1e30, -1e-30, 3):
            setattr(one, name, value)
            packed = struct.pack(code, value)
            assert getattr(one, name) == struct.unpack(code, packed)[0], (name, value)
            words = [packed[2 * at] | packed[2 * at + 1] << 8 for at in range(halves)]
            assert list(one.words[place : place + halves]) == words, (name, value)
        for nothing in (None, NAN, INFINITY, -INFINITY):
            setattr(one, name, 1.0)
            setattr(one, name, nothing)
            assert (getattr(one, name), one.words[place]) == (None, UNKNOWN)
    one.double = 1.7e308
    assert (one.double, texts, one.limited) == (1.7e308, [], {})
    for value, kept in ((1e39, largest), (-1e39, -largest)):
        one.single = value
        assert one.single == kept
    assert one.limited == {"single": 2}
    assert [text[:31] for text in texts] == ["warning: invented.single beyond"], texts
    for value, kept in ((3.0, 3.0), (3.5, 3.0), (-2.0, -2.0), (-2.5, -2.0)):
        one.bounded = value
        assert one.bounded == kept
    assert one.limited == {"single": 2, "bounded": 2}
    for value, count in ((0.5, 0), (-0.5, 0), (0.75, 1), (-0.75, 2)):  # two of what is kept make one
        one.told = value
        assert (one.told, one.limited.get("told", 0)) == (value, count), (value, one.limited)
        packed = struct.pack("<f", 2 * value)
        assert list(one.words[18:20]) == [packed[0] | packed[1] << 8, packed[2] | packed[3] << 8]


def thresholds_have_sides():
    """A number at a threshold is not below it; one that is unknown, or below the floor, is on no side."""
    needs(thresholds, "a threshold")

    class Threshold(Invented):
        """One with a threshold of all, and with those of an instance."""

        high = thresholds.at_least(1, 50)
        own_high = thresholds.at_least(1, 50, 2)
        low = thresholds.below(1, 20)
        own_low = thresholds.below(1, 20, 3)
        floored = thresholds.below(1, 20, None, 5)
        own_floored = thresholds.below(1, 20, 3, 5, 4)

    one = Threshold()
    one.words[2], one.words[3], one.words[4] = 60, 30, 7
    for value in (UNKNOWN, -LARGEST, 4, 5, 6, 7, 19, 20, 29, 30, 49, 50, 59, 60, LARGEST):
        one.words[1] = value
        assert (one.high, one.own_high) == (value >= 50, value >= 60), value
        assert (one.low, one.own_low) == (UNKNOWN < value < 20, UNKNOWN < value < 30), value
        assert (one.floored, one.own_floored) == (5 <= value < 20, 7 <= value < 30), value


CHECKS = (
    (instances_share_the_words,),
    (numbers_have_units,),
    (what_is_beyond_is_counted_and_told,),
    (views_are_made_when_they_are_used,),
    (lists_have_places,),
    (numbers_of_many_bits,),
    (floats_of_both_sizes,),
    (thresholds_have_sides,),
)

if __name__ == "__main__":
    main(CHECKS)
