"""What follows from what: each relation, and beside it changes that lack one thing and stand by themselves."""

from dataclasses import replace

import pytest

from codegen.diff.change import Change, ChangeRule, Notice, Victim, changed
from codegen.diff.dialect import wire_rules as wire
from codegen.diff.following import with_following
from codegen.diff.report.grouping import Group
from codegen.diff.system import behaviour_rules as rules
from codegen.source import Place

PLACE = Place("specs/state.yaml", 1, 1)
STATION = (Victim.OLD_STATION,)
CARRIED = {
    "battery.voltage": ("M.a", "M.b"),
    "buoy: battery.voltage": ("buoy: M.a",),
    "board.battery.cells": ("M.c", "battery.voltage", "LOW_VOLT"),
}


def change(rule: ChangeRule, subject: str, texts: tuple[str | None, str | None] = ("1", "2"), **more: object) -> Change:
    """A change of M, which breaks nobody and leaves no doubt unless ``more`` says so."""
    return replace(changed(rule, subject, *texts, (PLACE, PLACE), breaks=(), messages=("M",)), **more)


DROPPED = change(wire.CRC_EXTRA, "M", notice=Notice.NOTICED, breaks=STATION)
WIDER = change(wire.FIELD_TYPE, "M.a", notice=Notice.NOTICED, breaks=STATION)
NEW_FIELD = replace(DROPPED, causes=("a is new",))
ANSWER = change(rules.SOURCE, "M.a", (None, "constant 1"))
UNIT = change(wire.FIELD_UNITS, "M.a", breaks=STATION, notice=Notice.SILENT)
LIMITS = change(rules.LIMITS, "M.a")
ENTRY = change(wire.ENTRY_VALUE, "E.ONE", enum="E", entry="ONE", rows=("M.a", "M.b"), breaks=STATION)
FLAGS = change(rules.FLAGS, "M.b", rows=("M.b",))
KEPT = change(rules.QUANTITY_RANGE, "battery.voltage", doubt="whether it is meant")
FACT = change(rules.FACT, "board.battery.cells", doubt="whether it is meant")
RATE = change(rules.STREAM_RATE, "stream S", ("1 Hz", "2 Hz, the default of RATE"), doubt="whether it is meant")
DEFAULT = change(rules.PARAMETER_DEFAULT, "RATE")


def heads(*changes: Change | tuple[Change, ...]) -> dict[str, list[str]]:
    """By the subject of each finding those that stand below it."""
    groups = [Group(each if isinstance(each, tuple) else (each,)) for each in changes]
    found = with_following(groups, CARRIED)
    return {group.first.subject: [each.first.subject for each in group.following] for group in found}


@pytest.mark.parametrize(
    ("head", "group"),
    [
        (DROPPED, WIDER),
        (DROPPED, replace(WIDER, notice=Notice.UNKNOWN_ID)),
        (replace(DROPPED, rule=wire.MESSAGE_ID, messages=("M", "N")), WIDER),
        (replace(WIDER, rule=wire.MESSAGE_ID), DROPPED),
        (NEW_FIELD, ANSWER),
        (UNIT, LIMITS),
        (UNIT, replace(LIMITS, subject="rover: M.a[1..3]")),
        (ENTRY, FLAGS),
        (KEPT, LIMITS),
        (KEPT, replace(LIMITS, rule=rules.CONVERSION)),
        (replace(KEPT, rule=rules.CHANNEL), LIMITS),
        (replace(KEPT, subject="buoy: battery.voltage"), replace(LIMITS, subject="buoy: M.a[2]")),
        (FACT, replace(LIMITS, subject="M.c")),
        (FACT, replace(DEFAULT, subject="LOW_VOLT")),
        (RATE, DEFAULT),
        (replace(RATE, doubt=""), DEFAULT),
        (RATE, replace(DEFAULT, doubt="whether it is meant")),
    ],
)
def test_one_follows_from_the_other(head: Change, group: Change) -> None:
    """Whichever is found first."""
    below = {head.subject: [group.subject]}
    assert heads(head, group) == heads(group, head) == below


@pytest.mark.parametrize(
    ("head", "group"),
    [
        (DROPPED, replace(WIDER, messages=("M", "N"))),
        (DROPPED, replace(WIDER, messages=())),
        (DROPPED, replace(WIDER, enum="E")),
        (DROPPED, replace(WIDER, rule=wire.DESCRIPTION)),
        (DROPPED, replace(WIDER, notice=Notice.SILENT)),
        (replace(DROPPED, breaks=()), WIDER),
        (NEW_FIELD, replace(ANSWER, old="constant 2")),
        (NEW_FIELD, replace(ANSWER, subject="M.b")),
        (NEW_FIELD, replace(ANSWER, messages=("M", "N"))),
        (NEW_FIELD, replace(ANSWER, rule=rules.FLAGS)),
        (replace(NEW_FIELD, rule=wire.FIELD_ADDED), ANSWER),
        (UNIT, ANSWER),
        (UNIT, replace(LIMITS, subject="M.b")),
        (ENTRY, replace(FLAGS, rows=("M.c",))),
        (ENTRY, replace(FLAGS, rule=rules.LIMITS)),
        (KEPT, replace(LIMITS, subject="M.c")),
        (KEPT, replace(LIMITS, subject="buoy: M.a")),
        (replace(KEPT, subject="buoy: battery.voltage"), LIMITS),
        (KEPT, FLAGS),
        (replace(KEPT, doubt=""), replace(LIMITS, doubt="whether it is meant")),
        (FACT, LIMITS),
        (FACT, replace(DEFAULT, subject="RATE")),
        (RATE, replace(DEFAULT, subject="RATES")),
        (replace(RATE, new=None), DEFAULT),
        (DEFAULT, LIMITS),
    ],
)
def test_neither_follows_from_the_other(head: Change, group: Change) -> None:
    assert heads(head, group) == heads(group, head) == {head.subject: [], group.subject: []}


def test_all_of_a_group_has_to_follow() -> None:
    """One field that the quantity is not sent in is changed by itself."""
    other = replace(LIMITS, subject="M.c")
    assert heads(KEPT, (LIMITS, replace(LIMITS, subject="M.b"))) == {"battery.voltage": ["M.a"]}
    assert heads(KEPT, (LIMITS, other)) == {"battery.voltage": [], "M.a": []}
    assert heads((KEPT, replace(KEPT, subject="board.battery.cells")), (LIMITS, other)) == {"battery.voltage": ["M.a"]}


def test_who_leads_does_not_follow_and_who_follows_does_not_lead() -> None:
    """Findings are two deep; the first that may lead does."""
    source = change(rules.QUANTITY_SOURCE, "battery.voltage", doubt="whether it is meant")
    assert heads(FACT, KEPT, LIMITS) == {"board.battery.cells": [], "battery.voltage": ["M.a"]}
    assert heads(FACT, source, replace(LIMITS, subject="M.c")) == {"board.battery.cells": ["battery.voltage", "M.c"]}
    assert heads(UNIT, KEPT, LIMITS) == {"M.a": ["M.a"], "battery.voltage": []}
    assert heads(KEPT, replace(KEPT, rule=rules.CHANNEL), LIMITS) == {"battery.voltage": []}
