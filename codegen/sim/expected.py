"""Compares the expectations of a scenario with the recording of a run."""

from typing import Any

from codegen.model.scenario import Expectation
from codegen.sim.amount import amount
from codegen.sim.record import Recording
from codegen.sim.sample import Kind

_TOLERANCE = 1e-6
"""Relative difference below which two numbers are the same: floats of the state have 32 bits."""


def unmet(recording: Recording) -> list[str]:
    """A sentence for each expectation that does not hold; one about a time that was not reached holds not, either."""
    return [
        f"Expected {expectation.written}: {found}"
        for expectation in recording.scenario.expected
        if (found := _problem(expectation, recording)) is not None
    ]


def _problem(expectation: Expectation, recording: Recording) -> str | None:
    """Return what was found in place of it; None where it holds."""
    at_ms = recording.at_ms if expectation.at_ms is None else expectation.at_ms
    if at_ms > recording.at_ms:
        return f"the simulation ended at {recording.at_ms / 1000:g} s."
    if expectation.text:
        return _said(expectation, recording, at_ms)
    found = (recording.told if expectation.told else recording.state)(expectation.label, at_ms)
    if _holds(expectation, found):
        return None
    unit = next((line.unit for line in recording.program.lines if line.label == expectation.label), "")
    if isinstance(found, float) or (unit and isinstance(found, int)):
        return f"it is {amount(float(found), unit)}."
    return f"it is {_shown(found)}."


def _said(expectation: Expectation, recording: Recording, at_ms: int) -> str | None:
    said = [
        happening.text
        for happening in recording.happenings
        if happening.kind is Kind.TEXT and happening.program == recording.name and happening.at_ms <= at_ms
    ]
    fitting = [text for text in said if expectation.text in text]
    if bool(fitting) is not expectation.is_absent:
        return None
    return f"it said {fitting[0]!r}." if fitting else "it was not said."


def _holds(expectation: Expectation, found: Any) -> bool:
    if expectation.low is not None and expectation.high is not None:
        return isinstance(found, int | float) and expectation.low <= found <= expectation.high
    wanted = expectation.value
    if isinstance(found, float) and isinstance(wanted, int | float):
        return abs(found - wanted) <= _TOLERANCE * max(abs(found), abs(wanted))
    return bool(found == wanted)


def _shown(found: Any) -> str:
    return "unknown" if found is None else str(found).lower() if isinstance(found, bool) else str(found)
