"""Rates of what the main loop does that are faster than its passes, so that they cannot be kept."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Report, Rule
from codegen.measure import read_rate
from codegen.model.program import Program
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.source import Place

RULE = Rule(
    "faster-than-control",
    "A sensor, an input of the converter, the failsafes or the code of the vehicle have a rate that the main loop "
    "cannot keep: each has its turn once in a pass at most, and passes come at the rate of control. Whoever filters or "
    "counts by the stated rate would be wrong. Lower it, or let control run as fast.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every rate in the main loop of a program."""
    program = system.program
    if program is None:
        return
    control = program.spec.control
    for what, key, written, place in _rates(system, program):
        rate = read_rate(written, place, Report())
        if rate is not None and round(1000000 / rate) < program.control_us:
            message = f"{what} at {written}, and passes of the main loop come at {control.rate} only"
            hint = f"{key}: {control.rate}, or a higher rate of control in vehicle.yaml"
            yield Diagnostic(place, RULE, message, hint, ((control.at("rate"), "the rate of control is stated here"),))


def _rates(system: System, program: Program) -> Iterator[tuple[str, str, str, Place]]:
    """Yield what has a turn, the key that says how often, this rate as it is written, and its place."""
    for source in system.polled:
        polling = source.polling
        usual = f"{decimal(Fraction(1000000, polling.period_us))} Hz"
        yield f"{source.name} is asked", "rate", polling.spec.rate or usual, polling.spec.at("rate")
    for component in system.components.values():
        spec = component.spec
        if component.readings:
            place = spec.at("update_rate")
            key = "rate" if place.file.endswith("board.yaml") else "update_rate"
            yield f"{component.name} is measured", key, spec.update_rate or "10 Hz", place
    if "checks" in program.spec.control.places:
        yield "failsafes look", "checks", program.spec.control.checks, program.spec.control.at("checks")
    code = program.spec.code
    if code is not None and code.measure is not None:
        yield "measure() is called", "measure", code.measure, code.at("measure")
