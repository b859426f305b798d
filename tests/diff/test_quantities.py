"""Another unit, another range, another default: by how much a number is read otherwise, or what a person is asked."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.diff.change import Change, changed
from codegen.diff.dialect import wire_rules as wire
from codegen.diff.dialect.meaning import other_default
from codegen.diff.judging.judging import Judgement
from codegen.diff.judging.quantities import Range, other_range, other_unit, share_for_unit
from codegen.diff.judging.softening import softened
from codegen.diff.judging.units_in_words import unit_in_words
from codegen.diff.system.requirements import renamed_ids
from codegen.model.dialect.dialect import Lifecycle
from codegen.source import Place

PLACE = Place("m.xml", 1, 1)
CORRECTED = "whether the old unit was a mistake and the numbers are as before"


def said(judgement: Judgement) -> tuple[bool, str]:
    return judgement.breaks, judgement.doubt or judgement.effect


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("m", "paces", (True, "the number is read in another unit")),
        ("paces", "m", (True, "the number is read in another unit")),
        ("m", "m", (False, "the same value is the same number as before")),
        ("m / s", "m/s", (False, "the same value is the same number as before")),
        ("m", "cm", (True, "the same value is a number 100 times as large")),
        ("cm", "m", (True, "the same value is a number 100 times as small")),
        ("mm", "mm/s", (False, CORRECTED)),
        ("mm/s", "mm", (False, CORRECTED)),
        ("mm", "m/s", (True, "the number is read in another unit")),
        ("s", "m", (True, "the number is read in another unit")),
        ("degC", "K", (True, "the number is read in another unit: degC + 273.15 = K")),
    ],
)
def test_another_unit(old: str, new: str, expected: tuple[bool, str]) -> None:
    assert said(other_unit(old, new)) == expected


SMALLER = "whether values beyond the smallest, now 5 and not 0, were sent"
LARGER = "whether values beyond the largest, now 50 and not 100, were sent"


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (("0", "100"), ("0", "100"), (False, "")),
        (("0", "100"), ("0", "1000"), (True, "the range is 10 times as large")),
        (("0", "100"), ("0", "1"), (True, "the range is 100 times as small")),
        (("-5", "10"), ("-50", "100"), (True, "the range is 10 times as large")),
        (("-5", "10"), ("-5", "100"), (False, "")),
        ((None, "10"), (None, "100"), (True, "the range is 10 times as large")),
        ((None, "10"), ("0", "100"), (True, "the range is 10 times as large")),
        (("1", "10"), (None, "100"), (False, "")),
        (("0", "100"), ("0", "200"), (False, "")),
        (("0", "100"), ("0", "50"), (False, LARGER)),
        (("0", "100"), ("5", "100"), (False, SMALLER)),
        (("0", "100"), ("-5", "101"), (False, "")),
        (("0", "0"), ("0", "10"), (False, "")),
        (("0", "10"), ("0", "0"), (False, "whether values beyond the largest, now 0 and not 10, were sent")),
        ((None, None), ("5", "50"), (False, "")),
        (("0", "100"), (None, None), (False, "")),
    ],
)
def test_another_range(old: Range, new: Range, expected: tuple[bool, str]) -> None:
    assert said(other_range(old, new)) == expected


def test_a_range_whose_unit_is_known_has_no_other_scale() -> None:
    assert said(other_range(("0", "100"), ("0", "1000"), is_scaled=False)) == (False, "")


@pytest.mark.parametrize(
    ("old", "new", "unit", "step", "expected"),
    [
        (("0", "1"), ("0", "5"), "m", None, (True, "it was a share of 1 and is a number of m")),
        ((None, "1"), ("0", "5"), "m", None, (True, "it was a share of 1 and is a number of m")),
        (("-1", "1"), ("0", "5"), "m", None, (True, "it was a share of 1 and is a number of m")),
        (("-2", "1"), ("0", "5"), "m", None, (False, "")),
        (("0", "100"), (None, "5"), "m", None,
         (False, "whether what was up to 100 was a share of it or a number of m")),
        (("-100", "100"), (None, "5"), "m", None,
         (False, "whether what was up to 100 was a share of it or a number of m")),
        (("1", "100"), (None, "5"), "m", None, (False, "")),
        (("0", "99"), (None, "5"), "m", None, (False, "")),
        (("0", "1"), ("0", "1"), "m", None, (False, "")),
        (("0", "1"), ("0", "5"), "%", None, (False, "")),
        (("0", "1"), ("0", "5"), "m", "0.1", (False, "")),
        (("0", None), ("0", "5"), "m", None, (False, "")),
        (("0", "1"), ("0", "5"), "paces", None, (True, "it was a share of 1 and is a number of paces")),
    ],
)  # fmt: skip
def test_a_unit_for_what_may_have_been_a_share(
    old: Range, new: Range, unit: str, step: str | None, expected: tuple[bool, str]
) -> None:
    assert said(share_for_unit(old, new, unit, step)) == expected


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (None, "0", (False, "who does not set it sends 0 already")),
        ("", None, (False, "who does not set it sends 0 already")),
        ("0.01", "1E-2", (False, "who does not set it sends 0 already")),
        ("NaN", "NaN", (False, "who does not set it sends 0 already")),
        ("1", "2", (True, "what nobody sets was 1 and is 2")),
        ("0", "2", (True, "what nobody sets was 0 and is 2")),
        (None, "2", (False, "who fills in 2, since what nobody sets is sent as 0")),
        ("2", None, (False, "who fills in 2, since what nobody sets is sent as 0")),
    ],
)
def test_another_default(old: str | None, new: str | None, expected: tuple[bool, str]) -> None:
    assert said(other_default(old, new)) == expected


def test_units_in_words() -> None:
    """One unit is stated, whatever its prefix; of two nobody knows which is meant, and an amount is none."""
    words = {
        "in millimeters": "mm",
        "Meters per second": "m/s",
        "(cm/s)": "cm/s",
        "distance in meters*100": "m*100",
        "distance in meters * 1e7": "m*10000000",
        "5 seconds, (3) volts": None,
        "volts or amperes": None,
        "hours": "h",
        "(d)": None,
        "in furlongs": None,
    }
    assert {text: unit_in_words(text) for text in words} == words


WIP, OLDER = Lifecycle(wip=True), Lifecycle(deprecated_since="2020-01", replaced_by="N")
SUPERSEDED = Lifecycle(superseded_since="2021-02")


def dialect(message: Lifecycle | None, entry: Lifecycle, enum: Lifecycle) -> Any:
    messages = {"M": SimpleNamespace(definition=SimpleNamespace(lifecycle=message))} if message is not None else {}
    entries = (SimpleNamespace(name="A", lifecycle=entry), SimpleNamespace(name="B", lifecycle=WIP))
    return SimpleNamespace(messages=messages, enums={"E": SimpleNamespace(entries=entries, lifecycle=enum)})


NONE = Lifecycle()
GONE = changed(wire.MESSAGE_REMOVED, "M", "x", None, (PLACE, None), messages=("M",))
NO_ENTRY = changed(wire.ENTRY_REMOVED, "E.A", "A", None, (PLACE, None))


def of_entry(change: Change, name: str | None, enum: str = "E") -> Change:
    return replace(change, enum=enum, entry=name)


@pytest.mark.parametrize(
    ("change", "old", "reason"),
    [
        (GONE, dialect(WIP, NONE, NONE), "it was work in progress"),
        (GONE, dialect(OLDER, NONE, NONE), "it was deprecated since 2020-01, N taking its place"),
        (GONE, dialect(SUPERSEDED, NONE, NONE), "it was superseded since 2021-02"),
        (GONE, dialect(Lifecycle(deprecated_since=""), NONE, NONE), "it was deprecated"),
        (GONE, dialect(NONE, NONE, NONE), ""),
        (GONE, dialect(None, NONE, NONE), ""),
        (changed(wire.FIELD_TYPE, "M.a", "x", "y", (PLACE, PLACE), messages=("M",)), dialect(OLDER, NONE, NONE), ""),
        (of_entry(NO_ENTRY, "A"), dialect(None, OLDER, NONE), "it was deprecated since 2020-01, N taking its place"),
        (of_entry(NO_ENTRY, "A"), dialect(None, NONE, WIP), "it was work in progress"),
        (of_entry(NO_ENTRY, "A"), dialect(None, SUPERSEDED, WIP), "it was superseded since 2021-02"),
        (of_entry(NO_ENTRY, "C"), dialect(None, OLDER, NONE), "it was deprecated since 2020-01, N taking its place"),
        (of_entry(NO_ENTRY, "A", "F"), dialect(None, WIP, WIP), ""),
    ],
)
def test_who_was_told_does_not_break(change: Change, old: Any, reason: str) -> None:
    (found,) = softened([change], old)
    assert found.softened == reason
    assert found.is_breaking is not bool(reason)


def documents(**aliases: str) -> Any:
    """A system with documents and the alias of each."""
    found = {name: SimpleNamespace(id=name, aliases=(alias,)) for name, alias in aliases.items()}
    return SimpleNamespace(requirements=found)


def test_a_document_with_a_new_id_lists_the_old_one() -> None:
    """Whoever was there before has its own id, and an alias that is still in use is no old one."""
    old = documents(A1="", B1="Z")
    assert renamed_ids(old, documents(A2="A1", B1="Z")) == {"A1": "A2"}
    assert renamed_ids(old, documents(A1="", A2="A1", B1="Z")) == {}
    assert renamed_ids(old, documents(A2="Q", B1="A1")) == {}
