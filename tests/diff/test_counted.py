"""How much changed and how bad it is, in words; and what the telemetry takes of the links."""

from dataclasses import replace
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.diagnostics import Severity
from codegen.diff.change import Change, Notice, Reach, Victim, changed
from codegen.diff.dialect import wire_rules as wire
from codegen.diff.report.grouping import Group, counted, grouped, numbers_of
from codegen.diff.report.review import elsewhere_text, fails, following_text, review, severity, what_changed
from codegen.diff.report.review import tests_text as shown_tests
from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.bandwidth import Bandwidth, BandwidthRow, LinkRow, bandwidth_changes
from codegen.diff.system.system import Comparison
from codegen.diff.system.trace_rules import UNTESTED
from codegen.model.price import Range
from codegen.source import Place

STATION = (Victim.OLD_STATION,)


def change(number: int, rule: Any = wire.ENTRY_ADDED, **more: Any) -> Change:
    """A harmless change of a file of its own, unless ``more`` says otherwise."""
    place = Place(f"{number}.xml", number, 1)
    return replace(changed(rule, f"E{number}.a", "x", "y", (place, place), breaks=()), **more)


def group(number: int, rule: Any = wire.ENTRY_ADDED, **more: Any) -> Group:
    return Group((change(number, rule, **more),))


def several(count: int, rule: Any = wire.ENTRY_ADDED, **more: Any) -> list[Group]:
    return [group(number, rule, **more) for number in range(count)]


def silent(count: int) -> list[Group]:
    return several(count, breaks=STATION, notice=Notice.SILENT)


def noticed(count: int) -> list[Group]:
    return several(count, breaks=STATION, notice=Notice.NOTICED)


def raised(count: int) -> list[Group]:
    return [replace(each, severity=Severity.ERROR) for each in several(count)]


def waived(count: int) -> list[Group]:
    return [replace(each, waived="by us") for each in silent(count)]


@pytest.mark.parametrize(
    ("groups", "said"),
    [
        ([], "0 changes: none of them breaks anybody"),
        (several(1), "1 change: none of them breaks anybody"),
        (several(2), "2 changes: none of them breaks anybody"),
        (silent(1), "1 change: 1 breaks somebody silently"),
        (silent(2), "2 changes: 2 break somebody silently"),
        (noticed(1), "1 change: 1 breaks somebody who notices"),
        (noticed(2), "2 changes: 2 break somebody who notices"),
        (several(1, doubt="whether"), "1 change: 1 needs a person"),
        (several(2, doubt="whether"), "2 changes: 2 need a person"),
        (several(1, UNTESTED), "1 change: 1 loses what a requirement asks for"),
        (several(2, UNTESTED), "2 changes: 2 lose what a requirement asks for"),
        (raised(1), "1 change: 1 set to be an error"),
        (raised(2), "2 changes: 2 set to be errors"),
        ([*waived(2), *several(1)], "1 change: none of them breaks anybody, 2 waived"),
        (waived(1), "0 changes: none of them breaks anybody, 1 waived"),
        ([*silent(1), *noticed(2), *several(3, doubt="whether")],
         "6 changes: 1 breaks somebody silently, 2 break somebody who notices, 3 need a person"),
        ([replace(each, severity=Severity.WARNING) for each in silent(2)], "2 changes: none of them breaks anybody"),
        (several(1, min(rules.TOLD, key=str)), "1 change: 1 alters what is told"),
        (several(2, min(rules.TOLD, key=str)), "2 changes: 2 alter what is told"),
    ],
)  # fmt: skip
def test_the_head_line_counts_what_is_grave(groups: list[Group], said: str) -> None:
    assert counted(groups) == said


def test_what_is_set_to_be_an_error_is_raised_only_where_it_was_none() -> None:
    for grave in (*silent(1), *several(1, UNTESTED), *several(1, doubt="whether")):
        assert not replace(grave, severity=Severity.ERROR).is_raised
        assert severity(grave) is Severity.ERROR
        assert severity(replace(grave, severity=Severity.WARNING)) is Severity.WARNING
    assert severity(group(1)) is Severity.WARNING


def test_parameters_of_a_family_stand_at_one_place_and_are_one_change() -> None:
    family = Group((change(1), change(1, subject="E1.b"), change(2)))
    assert (family.count, family.subject) == (2, "E1: a, b, E2.a")
    assert numbers_of([family, group(3)]).changes == 3
    assert Group((change(1, subject="A"), change(1, subject="B"))).subject == "A, B"


def test_what_follows_reaches_as_well() -> None:
    below = group(1, reach=Reach(tests=("b",)))
    head = replace(group(2, reach=Reach(tests=("a",))), following=(below,))
    assert head.reach.tests == ("a", "b")


def test_the_gravest_comes_first_and_what_says_the_same_is_one_group() -> None:
    """Of changes that weigh the same the lost ones, then by area, then as they were found."""
    changes = [
        change(1), change(2, rules.STREAM_ADDED), change(3, UNTESTED), change(4, doubt="whether"),
        change(5, breaks=STATION, notice=Notice.NOTICED), change(6, breaks=STATION, notice=Notice.SILENT),
        change(7), change(1, subject="E1.b"), change(1, subject="E1.c", doubt="or not"),
    ]  # fmt: skip
    found = [tuple(each.subject for each in one.changes) for one in grouped(changes)]
    assert found == [("E6.a",), ("E5.a",), ("E4.a",), ("E1.c",), ("E3.a",), ("E1.a", "E1.b"), ("E7.a",), ("E2.a",)]


@pytest.mark.parametrize("key", ["old", "new", "effect", "notice", "breaks", "doubt", "softened"])
def test_what_says_something_else_is_a_group_of_its_own(key: str) -> None:
    other = {"notice": Notice.NOTICED, "breaks": STATION}.get(key, "other")
    assert len(grouped([change(1), change(1, subject="E1.b", **{key: other})])) == 2


def test_reports_say_what_was_and_what_is() -> None:
    for texts, told in (("xy", "E1.a: x -> y"), ((None, "y"), "E1.a: now y"), (("x", None), "E1.a: no longer x")):
        found = group(1, old=texts[0], new=texts[1])
        assert what_changed(found) == told
        assert following_text(found) == f"follows: enum-entry-added: {told}"
    assert what_changed(group(1, old=None, new=None)) == "E1.a"
    assert elsewhere_text(1).startswith("1 further change of the dialect concerns nothing")
    assert elsewhere_text(2).startswith("2 further changes of the dialect concern nothing")
    assert shown_tests(["a::x", "a::y", "b::z"]) == "a::x, a::y, b::z"
    assert shown_tests(["a::x", "a::y", "b::z", "b::w"]) == "4 tests in a, b"


@pytest.mark.parametrize(
    ("one", "kinds"),
    [
        (change(1), {"any", "wire", "enum-entry-added"}),
        (change(1, doubt="whether"), {"any", "wire", "enum-entry-added", "person"}),
        (change(1, breaks=STATION, notice=Notice.NOTICED), {"any", "wire", "enum-entry-added", "breaking"}),
        (change(1, breaks=STATION, notice=Notice.SILENT), {"any", "wire", "enum-entry-added", "breaking", "silent"}),
        (change(1, UNTESTED), {"any", "trace", UNTESTED.id, "breaking"}),
    ],
)
def test_a_comparison_fails_on_what_it_is_told_to(one: Change, kinds: set[str]) -> None:
    found = review("old", "new", Comparison((one,), ()))
    asked = {
        "never",
        "any",
        "breaking",
        "silent",
        "person",
        "wire",
        "trace",
        "behaviour",
        "enum-entry-added",
        UNTESTED.id,
    }
    assert {kind for kind in asked if fails(found, [kind])} == kinds
    assert not fails(found, [])


def row(name: str, old: int | None, new: int | None) -> BandwidthRow:
    return BandwidthRow(name, *(None if each is None else Range(Fraction(each), Fraction(each)) for each in (old, new)))


@pytest.mark.parametrize(
    ("share", "before", "is_overloaded"),
    [(101, None, True), (100, None, False), (101, 100, True), (120, 120, False), (120, 130, False), (90, 80, False)],
)
def test_a_link_is_overloaded_by_more_than_before(share: int, before: int | None, is_overloaded: bool) -> None:
    taken = Range(Fraction(960), Fraction(960))
    link = LinkRow("radio", 960, taken, Fraction(share), None if before is None else Fraction(before))
    assert link.is_overloaded is is_overloaded


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        (100, 110, "110 bytes/s (+10.0 %)"),
        (100, 90, "90 bytes/s (-10.0 %)"),
        (100, 109, None),
        (100, 91, None),
        (0, 5, "5 bytes/s"),
    ],
)
def test_bandwidth_is_told_from_a_tenth_on(old: int, new: int, told: str | None) -> None:
    found = Bandwidth((row("M", old, new), row("N", 7, 7)), row("all", old, new), ())
    system: Any = SimpleNamespace(
        links=(), streams={}, messages=(), spec=SimpleNamespace(project=SimpleNamespace(place=Place("codegen.yaml")))
    )
    assert [each.new for each in bandwidth_changes(found, system, system, Fraction(10))] == ([told] if told else [])
    same = replace(found, rows=(row("M", old, old),))
    assert not list(bandwidth_changes(same, system, system, Fraction(0)))
