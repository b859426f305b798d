"""Questions about features that a vehicle lacks are answered, and others are left alone."""

from dataclasses import replace
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.model.dialect.dialect import Dialect
from codegen.project.systems import read_system
from codegen.resolve.program.absences import AUTOPILOT, resolve_absences

ROVER = Path(__file__).resolve().parents[2] / "specs" / "codegen.yaml"
PARTS = {"MISSION_REQUEST_PARTIAL_LIST", "MISSION_WRITE_PARTIAL_LIST"}
MISSIONS = {
    "MISSION_REQUEST_LIST",
    "MISSION_COUNT",
    "MISSION_CLEAR_ALL",
    "MISSION_REQUEST",
    "MISSION_REQUEST_INT",
    *PARTS,
}
LOGS = {"LOG_REQUEST_LIST"}


@pytest.fixture(scope="module")
def common() -> Dialect:
    """The rover's dialect."""
    system = read_system(str(ROVER), Report())
    assert system is not None
    return system.dialect


def questions(dialect: Dialect, component_id: int = AUTOPILOT, *taken: str) -> set[str]:
    """Names of the questions that are answered."""
    return {absence.question.name for absence in resolve_absences(dialect, component_id, frozenset(taken))}


def test_an_autopilot_answers_all_of_them(common: Dialect) -> None:
    """Ground stations take it for the vehicle; a battery or a camera beside it is not asked."""
    assert questions(common) == MISSIONS | LOGS | {"SET_MODE"}
    assert questions(common, 180) == set()


@pytest.mark.parametrize(
    ("taken", "left"),
    [
        ("MISSION_COUNT", LOGS | {"SET_MODE"}),
        ("LOG_REQUEST_LIST", MISSIONS | {"SET_MODE"}),
        ("SET_MODE", MISSIONS | LOGS),
        ("MISSION_WRITE_PARTIAL_LIST", LOGS | {"SET_MODE"}),
        ("HEARTBEAT", MISSIONS | LOGS | {"SET_MODE"}),
    ],
)
def test_who_takes_one_answers_all_of_its_kind(common: Dialect, taken: str, left: set[str]) -> None:
    """A vehicle that takes missions is not said to have none."""
    assert questions(common, AUTOPILOT, taken) == left


def test_a_dialect_without_the_words_answers_nothing(common: Dialect) -> None:
    """One that lacks a message, a field or a result has no answer."""
    fewer = {name: wire for name, wire in common.messages.items() if name != "MISSION_ACK"}
    assert questions(replace(common, messages=fewer)) == LOGS | {"SET_MODE"}
    ack = common.messages["COMMAND_ACK"]
    short = replace(ack, fields=tuple(field for field in ack.fields if field.name != "result"))
    assert "SET_MODE" in questions(common)
    assert "SET_MODE" not in questions(replace(common, messages={**common.messages, "COMMAND_ACK": short}))
    results = common.enums["MAV_MISSION_RESULT"]
    some = replace(results, entries=tuple(entry for entry in results.entries if entry.value == 0))
    assert questions(replace(common, enums={**common.enums, results.name: some})) == LOGS | {"SET_MODE"}
    without = {name: enum for name, enum in common.enums.items() if name != results.name}
    assert questions(replace(common, enums=without)) == LOGS | {"SET_MODE"}


def test_a_dialect_may_lack_what_is_rarely_asked(common: Dialect) -> None:
    """Without parts of lists the other questions are answered, and each is left out for itself."""
    for name, left in (
        ("MISSION_WRITE_PARTIAL_LIST", {"MISSION_WRITE_PARTIAL_LIST"}),
        ("MISSION_REQUEST_PARTIAL_LIST", {"MISSION_REQUEST_PARTIAL_LIST"}),
    ):
        fewer = {each: wire for each, wire in common.messages.items() if each != name}
        assert questions(replace(common, messages=fewer)) == (MISSIONS | LOGS | {"SET_MODE"}) - left
