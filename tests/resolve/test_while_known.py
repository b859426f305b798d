"""``send: while_known``: a message is withheld while something is unknown that one of its fields cannot say."""

from pathlib import Path

import pytest
from edited_project import edited

from codegen.diagnostics import Report
from codegen.diff.system.system import compare_systems
from codegen.explain.story import explain
from codegen.model.answers.known import Known
from codegen.model.price import message_price
from codegen.model.system import PopulatedMessage, System
from codegen.targets.pages.example_state import example_states
from codegen.targets.suite.cases.messages import message_cases
from codegen.targets.suite.expected import expected_fields

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "named_tables" / "specs"
TABLE = "messages/global_position_int.yaml"


def table(system: System) -> PopulatedMessage:
    return next(message for message in system.messages if message.name == "GLOBAL_POSITION_INT")


KNOWN: Known = {"gps.altitude": 7, "gps.climbed": 8, "vehicle.uptime": 9}


@pytest.mark.parametrize("path", ["gps.altitude", "gps.climbed"])
def test_nothing_is_expected_while_one_of_them_is_unknown(path: str, folder: Path) -> None:
    """The sentinel of no field stands for it, nor does a 0; what has an initial value withholds nothing."""
    message = table(edited(folder)[0])
    assert expected_fields(message, KNOWN)["alt"] == 7
    assert expected_fields(message, {**KNOWN, path: None}) == {}
    assert expected_fields(message, {**KNOWN, "vehicle.uptime": None})["time_boot_ms"] == 0


def test_each_field_that_causes_it_has_a_case(folder: Path) -> None:
    """In which no frame is expected, beside the one in which all is known."""
    system, _ = edited(folder)
    cases = {case.name: case.expect for case in message_cases(system) if case.message == "GLOBAL_POSITION_INT"}
    for name in ("alt-unknown", "relative_alt-unknown", "everything-unknown"):
        assert cases[f"GLOBAL_POSITION_INT.{name}"] == {}
    assert cases["GLOBAL_POSITION_INT.nominal"]


def test_without_it_the_hint_names_all_ways(folder: Path) -> None:
    """At the field that cannot say unknown, and with the line of the dialect."""
    _, findings = edited(folder, (TABLE, "send: while_known\n", ""))
    assert [(found.rule.id, found.place.line) for found in findings] == [("no-sentinel", 8), ("no-sentinel", 9)]
    for found in findings:
        assert found.hint is not None
        assert all(way in found.hint for way in ("'initial'", "'send: while_known'", "corrections"))
        assert found.related[0][0].file.endswith(".xml")


def test_where_it_says_nothing_it_is_reported(folder: Path) -> None:
    """A table of which each field can say unknown, or is always known."""
    _, findings = edited(folder, ("messages/heartbeat.yaml", "stream:", "send: while_known\nstream:"))
    assert [(found.rule.id, found.place.line) for found in findings] == [("pointless-key", 3)]


def test_always_is_the_default(folder: Path) -> None:
    """The choice may be written or not; another word is an error."""
    system, findings = edited(folder, ("messages/heartbeat.yaml", "stream:", "send: always\nstream:"))
    assert not findings
    assert not system.messages[0].withheld_for
    _, findings = edited(folder, ("messages/heartbeat.yaml", "send: always", "send: when_known"))
    assert {found.rule.id for found in findings} == {"unknown-choice"}


def test_it_is_told_which_quantities_withhold_it(folder: Path) -> None:
    """By explain, in reports of changes, by what it costs, and on the page, which shows no frame that is not sent."""
    system, _ = edited(folder)
    message = table(system)
    story = explain("GLOBAL_POSITION_INT", system, Report())
    assert story is not None
    assert "withheld while one of these is unknown: gps.altitude (alt), gps.climbed (relative_alt)\n" in story
    assert message_price(message, system).whole.low == 0 < message_price(message, system).whole.high
    assert [state.label for state in example_states(message, system)] == ["a value in every quantity"]
    other, findings = edited(
        folder,
        (
            "state.yaml",
            "{doc: Above the start., unit: m, stored: mm}",
            "{doc: Above the start., unit: m, stored: mm, initial: 0}",
        ),
    )
    assert not findings
    found = {change.rule.id: change for change in compare_systems((system,), (other,)).changes}
    assert found["message-schedule-changed"].old == "withheld while unknown gps.altitude, gps.climbed"
    assert found["message-schedule-changed"].new == "withheld while unknown gps.altitude"
