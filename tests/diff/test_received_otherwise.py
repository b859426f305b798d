"""Changes in a table of a received message are told, with how bad they are; each edit is one of a real project."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.diff.system.system import compare_systems
from codegen.project.systems import read_systems

SPECS = Path(__file__).resolve().parents[1] / "projects" / "received" / "specs"
RC, STICK, FIX = "receives/rc_channels_override.yaml", "receives/manual_control.yaml", "receives/gps_input.yaml"
NAME = "RC_CHANNELS_OVERRIDE"

# What is replaced by what in which file; the rule, its subject, what is told, and whether somebody breaks by it.
EDITS = [
    (
        RC,
        "  chan9_raw: {state: rc.extra}\n",
        "",
        "field-no-longer-taken",
        f"{NAME}.chan9_raw, received",
        "sets rc.extra",
        True,
    ),
    (
        STICK,
        "  x:",
        "  y: {state: rc.spare}\n  x:",
        "field-taken",
        "MANUAL_CONTROL.y, received",
        "sets rc.spare",
        False,
    ),
    (
        STICK,
        "stick.buttons",
        "rc.spare",
        "field-taken-into-another",
        "MANUAL_CONTROL.buttons, received",
        "sets rc.spare",
        True,
    ),
    (
        FIX,
        "yaw: {state: fix.yaw",
        "yaw: {rounding: down, state: fix.yaw",
        "field-taken-otherwise",
        "fix.yaw, received",
        "1/100, down",
        False,
    ),
    (
        RC,
        "min: 1000 us",
        "min: 1100 us",
        "field-taken-range-changed",
        f"{NAME}.chan2_raw, received",
        "1100..2000 us",
        False,
    ),
    (
        FIX,
        "unchanged: [99.99]",
        "unknown: [99.99]",
        "field-taken-value-changed",
        "fix.hdop, received",
        "-> ",
        True,
    ),
    (
        FIX,
        "unknown: [UINT16_MAX]",
        "unchanged: [UINT16_MAX]",
        "field-taken-value-changed",
        "fix.yaw, received",
        "left as it was by 65535",
        True,
    ),
    (
        RC,
        "chan1_raw: {",
        "chan1_raw: {unchanged: [], ",
        "field-taken-value-changed",
        f"{NAME}.chan1_raw, received",
        "65535",
        True,
    ),
    (RC, "from: ground_station", "from: any", "message-taken-otherwise", f"{NAME}, received", "taken from any", False),
    (FIX, "{gps_id: 0}", "{gps_id: 3}", "message-taken-otherwise", "fix, received", "gps_id 3", True),
    (RC, "call: true\n", "", "message-taken-otherwise", f"{NAME}, received", "calls the vehicle yes", False),
    (
        RC,
        "target: FR-1.5",
        "target: FR-1.3",
        "citation-changed",
        f"{NAME}, received",
        "target answers to FR-1.3",
        False,
    ),
]


def systems(folder):
    """The systems of a project, which has nothing that is reported."""
    report = Report()
    found = read_systems(str(folder / "codegen.yaml"), report)
    assert not report.has_errors, list(report)
    return found


@pytest.fixture(scope="module")
def before(tmp_path_factory):
    """The project with one quantity more, which nothing sets, and its systems."""
    folder = tmp_path_factory.mktemp("before") / "specs"
    shutil.copytree(SPECS, folder)
    state = folder / "state.yaml"
    state.write_text(state.read_text().replace("      rudder: {", "      spare: {doc: d, initial: 0}\n      rudder: {"))
    return folder, systems(folder)


def changes(before, tmp_path, edit=None, gone=None):
    """The changes after an edit, both ways."""
    folder, known = before
    shutil.copytree(folder, tmp_path / "specs")
    if gone:
        (tmp_path / "specs" / gone).unlink()
    else:
        file, old, new = edit
        text = (tmp_path / "specs" / file).read_text()
        assert text.count(old) == 1
        (tmp_path / "specs" / file).write_text(text.replace(old, new))
    after = systems(tmp_path / "specs")
    return compare_systems(known, after).changes, compare_systems(after, known).changes


@pytest.mark.parametrize("edit", EDITS, ids=lambda edit: f"{edit[3]}-{edit[4]}")
def test_an_edit_is_told(edit, before, tmp_path):
    """Under its rule, with what it was and is; back again it is told, too."""
    *what, rule, subject, says, breaks = edit
    there, back = changes(before, tmp_path, what)
    (found,) = [change for change in there if change.rule.id == rule and change.subject == subject]
    assert says in f"{found.old} -> {found.new}"
    assert found.is_breaking is breaks
    assert [change for change in back if change.subject == subject]


def test_a_table_that_goes_is_told(before, tmp_path):
    """With its fields; who steers by it is not heard any more, and nobody breaks where it comes."""
    there, back = changes(before, tmp_path, gone=STICK)
    told = {change.rule.id: change for change in there}
    assert told["message-no-longer-taken"].subject == "MANUAL_CONTROL, received"
    assert told["message-no-longer-taken"].is_breaking
    assert {change.rule.id for change in back} >= {"message-taken", "field-taken"}
    assert not any(change.is_breaking for change in back)


def test_a_condition_that_goes_breaks_nobody_and_one_that_comes_breaks_who_does_not_meet_it(before, tmp_path):
    """More is heard than before, or less; so it is with senders."""
    there, back = changes(before, tmp_path, (FIX, "where: {gps_id: 0}\n", ""))
    for found, breaks in ((there, False), (back, True)):
        (change,) = [each for each in found if each.rule.id == "message-taken-otherwise"]
        assert change.is_breaking is breaks, change
    assert "who sends it with anything but gps_id 0 is not heard any more" in change.effect


def test_fewer_senders_break_the_others(before, tmp_path):
    there, back = changes(before, tmp_path, (RC, "from: ground_station", "from: any"))
    assert [each.is_breaking for each in (*there, *back) if each.rule.id == "message-taken-otherwise"] == [False, True]


@pytest.mark.parametrize(
    ("edit", "doubts"),
    [
        ((RC, "min: 1000 us", "min: 1100 us"), ("whether what is ignored now is sent, which nothing tells", "")),
        ((RC, "call: true\n", ""), ("whether nothing is to be done when it arrives", "")),
        ((FIX, "yaw: {state: fix.yaw", "yaw: {rounding: down, state: fix.yaw"), ("", "")),
    ],
)
def test_who_is_ignored_in_part_may_not_notice(edit, doubts, before, tmp_path):
    """A plausible number less, or a call that is made no more, is a question; more is none, nor is a rounding."""
    for found, doubt in zip(changes(before, tmp_path, edit), doubts, strict=True):
        assert [change.doubt for change in found if change.doubt] == ([doubt] if doubt else [])


def test_a_limit_that_the_dialect_states_ignores_what_was_taken(before):
    """No line of the table is another one then: the dialect's minValue is the limit of what is plausible."""
    (system, *others) = before[1]
    table = next(each for each in system.receptions if each.name == NAME)
    first = table.fields[0]
    narrower = replace(table, fields=(replace(first, low=first.low + 100), *table.fields[1:]))
    after = replace(system, receptions=tuple(narrower if each is table else each for each in system.receptions))
    (change,) = compare_systems(before[1], (after, *others)).changes
    assert (change.rule.id, change.weight) == ("field-taken-range-changed", "person")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("state: stick.ahead", "state: stick.ahead, when: {enabled_extensions: bit 2}"),
        ("state: stick.ahead", "state: stick.ahead, unless: {enabled_extensions: bit 2}"),
    ],
)
def test_what_others_say_to_be_no_value_is_told(old, new, before, tmp_path):
    """Who sends it without that flag, or with it, sets nothing any more, and nothing tells: with its words."""
    for found in changes(before, tmp_path, (STICK, old, new)):
        (change,) = [each for each in found if each.rule.id == "field-taken-value-changed"]
        assert change.is_breaking
        assert "enabled_extensions has bit 2 (4), otherwise unknown" in f"{change.old} {change.new}"


def test_another_outcome_without_a_value_is_told(before, tmp_path):
    """That a quantity stays as it was in place of becoming unknown."""
    keys = "when: {enabled_extensions: bit 2}, otherwise: unchanged"
    (found, _) = changes(before, tmp_path, (STICK, "state: stick.ahead", f"state: stick.ahead, {keys}"))
    assert any("otherwise as it was" in f"{each.new}" for each in found)
