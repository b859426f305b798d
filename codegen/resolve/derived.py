"""Quantities that are computed from a measured one: its trend, and the charge that a voltage stands for."""

from collections.abc import Mapping
from fractions import Fraction
from itertools import pairwise

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.measure import UNIT_MISMATCH, read_time
from codegen.model.dialect import Dialect
from codegen.model.spec import Spec
from codegen.model.state_spec import ComponentSpec, QuantitySpec
from codegen.model.unit import NUMBER, UNITS, Unit, read_measure
from codegen.model.vehicle import Estimate, Instance, Quantity, Trend
from codegen.source import Place

BAD_TREND = Rule(
    "bad-trend",
    "A trend is the change per second of a measured quantity of the same component, kept in the same unit per second. "
    "Its window is an even number of readings, 4 to 200.",
)
BAD_ESTIMATE = Rule(
    "bad-estimate",
    "The remaining charge is estimated from a measured voltage of the same component: it is in %, and board.yaml has "
    "the component's chemistry and cells and a discharge curve of that chemistry, from 100 down to 0, that falls with "
    "the voltage.",
)


def resolve_trend(
    spec: QuantitySpec, stored: Unit, period_ms: int | None, component: ComponentSpec, report: Report
) -> Trend | None:
    """The trend that a quantity is; None, perhaps with a finding, if it is none."""
    if spec.trend_of is None and spec.window is None:
        return None
    if spec.trend_of is None or spec.window is None:
        report.add(BAD_TREND, spec.at("window" if spec.window else "trend_of"), "a trend has both trend_of and window")
        return None
    window = read_time(spec.window, UNITS["ms"], spec.at("window"), report)
    if window is None:
        return None
    readings = Fraction(window, period_ms) if period_ms else Fraction(0)
    if readings.denominator != 1 or readings % 2 or not 4 <= readings <= 200:
        message = f"{spec.window} is not an even number of readings, 4 to 200"
        hint = None if period_ms else "the component needs an update_rate"
        report.add(BAD_TREND, spec.at("window"), message, hint)
        return None
    followed = component.quantities.get(spec.trend_of)
    if followed is not None and followed.adc is not None and f"{followed.stored or followed.unit}/s" != stored.name:
        message = f"the change of {spec.trend_of} is kept in {followed.stored or followed.unit}/s, not {stored.name}"
        report.add(BAD_TREND, spec.at("stored"), message)
    return Trend(spec.trend_of, int(readings))


def check_derived(spec: ComponentSpec, quantities: Mapping[str, Quantity], report: Report) -> None:
    """Whether trends and estimates follow a quantity of the component that is measured."""
    for quantity in quantities.values():
        for rule, key, derived in (
            (BAD_TREND, "trend_of", quantity.trend),
            (BAD_ESTIMATE, "estimate_from", quantity.estimate),
        ):
            if derived is None:
                continue
            followed = quantities.get(derived.quantity)
            if derived.quantity not in spec.quantities:
                hint = did_you_mean(derived.quantity, spec.quantities)
                report.add(rule, quantity.spec.at(key), f"there is no quantity {derived.quantity}", hint)
            elif followed is not None and followed.conversion is None:
                report.add(rule, quantity.spec.at(key), f"{derived.quantity} is not measured by an ADC")


def resolve_estimate(
    spec: QuantitySpec, component: str, parts: tuple[Instance, ...], whole: Spec, dialect: Dialect, report: Report
) -> Estimate | None:
    """The curve of each pack by its voltage; None, perhaps with a finding, if the charge is not estimated."""
    if spec.estimate_from is None:
        return None
    place = spec.at("estimate_from")
    quantities = whole.state.components[component].quantities
    followed = quantities.get(spec.estimate_from)
    if followed is None:
        hint = did_you_mean(spec.estimate_from, quantities)
        report.add(BAD_ESTIMATE, place, f"there is no quantity {spec.estimate_from}", hint)
        return None
    name = followed.stored or followed.unit
    unit = NUMBER if name is None else UNITS.get(name)
    if unit is None:
        return None  # the unit has been reported
    volts = UNITS["V"].to(unit)
    if spec.unit != "%" or (spec.stored or "%") != "%" or volts is None:
        report.add(UNIT_MISMATCH, place, "an estimate is a share in %, from a voltage")
        return None
    curves = []
    for part in parts:
        curve = _curve(component, part, place, whole, dialect, report)
        if curve is None:
            return None
        cells = part.cells or 1
        curves.append(tuple((round(cell * cells * volts), percent) for cell, percent in curve))
    return Estimate(spec.estimate_from, tuple(curves))


def _curve(
    component: str, part: Instance, place: Place, whole: Spec, dialect: Dialect, report: Report
) -> list[tuple[Fraction, int]] | None:
    """Volts of one cell and percent for the chemistry of an instance; None after a finding."""
    chemistry = part.facts.get("chemistry")
    if not isinstance(chemistry, str) or part.cells is None:
        message = f"board.yaml does not state the chemistry and the cells of {component}"
        report.add(BAD_ESTIMATE, place, message, f"facts: {{{component}: {{chemistry: ..., cells: 3}}}}")
        return None
    enum = dialect.enums.get("MAV_BATTERY_TYPE")
    if enum is not None and enum.entry(chemistry) is None:
        _report_chemistry(chemistry, component, part, [entry.name for entry in enum.entries], whole, report)
        return None
    if chemistry not in whole.board.discharge_curves:
        hint = did_you_mean(chemistry, whole.board.discharge_curves) or "write it under discharge_curves in board.yaml"
        report.add(BAD_ESTIMATE, place, f"there is no discharge curve of {chemistry}", hint)
        return None
    return _points(chemistry, whole, report)


def _report_chemistry(
    chemistry: str, component: str, part: Instance, names: list[str], whole: Spec, report: Report
) -> None:
    """An unknown chemistry; a message that sends it reports it, too, and better."""
    answers = (answer for population in whole.populations for answer in population.fields.values())
    if not any(answer.board == f"{component}.chemistry" for answer in answers):
        message = f"MAV_BATTERY_TYPE has no entry {chemistry}"
        place = whole.board.fact_place(component, part.number, "chemistry")
        report.add(BAD_ESTIMATE, place, message, did_you_mean(chemistry, names))


def _points(chemistry: str, whole: Spec, report: Report) -> list[tuple[Fraction, int]] | None:
    """Volts of one cell and percent, rising."""
    board = whole.board
    curve = board.discharge_curves[chemistry]
    points = []
    for written, percent in curve.items():
        measure = read_measure(written)
        cell = measure.in_unit(UNITS["V"]) if measure else None
        place = board.at(f"discharge_curves.{chemistry}.{written}")
        if cell is None or cell <= 0:
            report.add(BAD_ESTIMATE, place, f"{written!r} is not a voltage of a cell")
            return None
        if percent.denominator != 1:
            report.add(BAD_ESTIMATE, place, f"{percent} is not a whole number of %")
            return None
        points.append((cell, int(percent)))
    points.sort()
    falls = all(first[1] < second[1] for first, second in pairwise(points))
    if len(points) < 2 or points[0][1] != 0 or points[-1][1] != 100 or not falls:
        message = f"the curve of {chemistry} does not go from 100 down to 0 % with the voltage"
        report.add(BAD_ESTIMATE, board.at(f"discharge_curves.{chemistry}"), message)
        return None
    return points
