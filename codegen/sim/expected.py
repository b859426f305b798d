"""Compares the expectations of a scenario with the recording of a run."""

import math
from fractions import Fraction
from typing import Any, TypeGuard

from codegen.model.quantities.precision import Precision
from codegen.model.scenario import Expectation
from codegen.model.units.unit import shortly
from codegen.sim.amount import amount
from codegen.sim.record import Recording
from codegen.sim.sample import Kind


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
    found, precision = _found(expectation, recording, at_ms)
    if _holds(expectation, found, precision):
        return None
    unit = next((line.unit for line in recording.program.lines if line.label == expectation.label), "")
    return f"it is {_shown(found, precision)} {unit if _is_number(found) else ''}".rstrip() + "."


def _found(expectation: Expectation, recording: Recording, at_ms: int) -> tuple[Any, Precision]:
    """Return what there is, a number as exactly as that is known, and how precise it is."""
    if not expectation.told:
        return recording.state(expectation.label, at_ms), expectation.precision
    reading = recording.reading(expectation.label, at_ms)
    return (None, expectation.precision) if reading is None else (reading.exact, reading.precision)


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


def _holds(expectation: Expectation, found: Any, precision: Precision) -> bool:
    if expectation.low is not None and expectation.high is not None:
        return _is_number(found) and precision.is_between(found, expectation.low, expectation.high)
    wanted = expectation.value
    if _is_number(found) and _is_number(wanted):
        return precision.is_same(found, Fraction(wanted))
    return bool(found == wanted)


def _is_number(value: Any) -> TypeGuard[int | float | Fraction]:
    is_number = isinstance(value, int | float | Fraction) and not isinstance(value, bool)
    return is_number and math.isfinite(value)


def _shown(found: Any, precision: Precision) -> str:
    if not _is_number(found):
        return "unknown" if found is None else str(found).lower() if isinstance(found, bool) else str(found)
    exact = precision.exact(found)
    return shortly(exact) if precision.step or exact.denominator == 1 else amount(float(found), "")
