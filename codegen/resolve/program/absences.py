"""Resolves the answers about features that the vehicle lacks, as far as its dialect has words for them."""

from codegen.model.absence import (
    ABSENCE_FIELDS,
    LOGS,
    MISSION_RESULTS,
    MISSIONS,
    MODES,
    MORE_MISSIONS,
    Absence,
)
from codegen.model.dialect.dialect import Dialect

AUTOPILOT = 1
"""The component id that such questions are for: others, such as a battery, are not asked for missions."""


def resolve_absences(dialect: Dialect, component_id: int, taken: frozenset[str]) -> tuple[Absence, ...]:
    """The questions that are answered: of a kind of which the vehicle has ``taken`` one otherwise, none."""
    found: list[Absence] = []
    if component_id != AUTOPILOT:
        return ()
    for rows, more in ((MISSIONS, MORE_MISSIONS), (LOGS, ()), (MODES, ())):
        has_words = _has_all(dialect, rows) and (rows is not MISSIONS or _has_results(dialect))
        if has_words and not taken & {question for question, _, _ in (*rows, *more)}:
            messages = dialect.messages
            known = (*rows, *(row for row in more if _has_all(dialect, (row,))))
            found += [Absence(messages[question], messages[answer], method) for question, answer, method in known]
    return tuple(found)


def _has_all(dialect: Dialect, rows: tuple[tuple[str, str, str], ...]) -> bool:
    """Return whether a dialect has the questions and the answers of some rows."""
    return all(_has(dialect, name) for question, answer, _ in rows for name in (question, answer))


def mission_results(dialect: Dialect) -> dict[str, int]:
    """The entries of MAV_MISSION_RESULT that answers have, by name."""
    enum = dialect.enums.get("MAV_MISSION_RESULT")
    entries = [enum.entry(name) for name in MISSION_RESULTS] if enum else []
    return {entry.name: entry.value for entry in entries if entry}


def _has_results(dialect: Dialect) -> bool:
    return len(mission_results(dialect)) == len(MISSION_RESULTS)


def _has(dialect: Dialect, name: str) -> bool:
    """Return whether a dialect has a message, with the fields that are written or read."""
    wire = dialect.messages.get(name)
    return wire is not None and all(wire.field(field) for field in ABSENCE_FIELDS.get(name, "").split())
