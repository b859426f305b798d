"""The charge that a measured voltage stands for, by the discharge curve of the board's chemistry."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING

from codegen.derivations.surroundings import Kept, Surroundings
from codegen.diagnostics import Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.measure import UNIT_MISMATCH
from codegen.model.derivation import Derivation, DerivationFact
from codegen.model.derivation_spec import EstimateSpec, MeasuredSpec
from codegen.model.unit import NUMBER, Unit, ratio, read_measure, unit_named
from codegen.model.vehicle import Instance, Quantity

if TYPE_CHECKING:
    from codegen.model.system import System

BAD_ESTIMATE = Rule(
    "bad-estimate",
    "The remaining charge is estimated from a measured voltage of the same component: it is in %, and board.yaml has "
    "the component's chemistry and cells and a discharge curve of that chemistry, from 100 down to 0, that falls with "
    "the voltage.",
)


@dataclass(frozen=True, slots=True)
class Estimate(Derivation):
    """Percent of charge by pack voltage: for each instance the points (stored steps of ``quantity``, %), rising."""

    quantity: str
    curves: tuple[tuple[tuple[int, int], ...], ...]

    @property
    def curves_by_instance(self) -> tuple[tuple[tuple[int, int], ...], ...]:
        return self.curves

    @property
    def comes_of_readings(self) -> bool:
        return True

    @property
    def sources(self) -> tuple[str, ...]:
        return (self.quantity,)

    def facts(self, quantity: Quantity) -> Iterator[DerivationFact]:
        for number, curve in enumerate(self.curves, 1):
            points = ", ".join(f"{stored}: {percent}" for stored, percent in curve)
            text = f"by {self.quantity}, {points}"
            yield DerivationFact(f"estimate of instance {number}:", text, "estimate_from")

    def words(self, quantity: Quantity) -> str:
        return f"discharge curve by {quantity.component}.{self.quantity}"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        yield "follows", f"{self.quantity}, by the discharge curve of {len(self.curves[0])} points"


def resolve_estimate(written: EstimateSpec, kept: Kept, around: Surroundings) -> Estimate | None:
    """The curve of each pack by its voltage; None after a finding."""
    name = written.estimate_from
    followed = around.others.get(name)
    if followed is None:
        around.no_quantity("estimate_from", name, BAD_ESTIMATE)
        return None
    spelt = followed.stored or followed.unit
    unit = NUMBER if spelt is None else Unit.parse(spelt)
    if unit is None:
        return None  # the unit has been reported
    volts = ratio(unit_named("V"), unit)
    if around.spec.unit != "%" or (around.spec.stored or "%") != "%" or volts is None:
        around.bad("estimate_from", "an estimate is a share in %, from a voltage", UNIT_MISMATCH)
        return None
    curves = []
    for part in around.parts:
        curve = _curve(part, around)
        if curve is None:
            return None
        curves.append(tuple((round(cell * (part.cells or 1) * volts), percent) for cell, percent in curve))
    if followed.written(MeasuredSpec) is None:
        around.bad("estimate_from", f"{name} is not measured by an ADC", BAD_ESTIMATE)
    return Estimate(name, tuple(curves))


def _curve(part: Instance, around: Surroundings) -> list[tuple[Fraction, int]] | None:
    """Volts of one cell and percent for the chemistry of an instance; None after a finding."""
    component, board = around.component, around.whole.board
    chemistry = part.facts.get("chemistry")
    if not isinstance(chemistry, str) or part.cells is None:
        message = f"board.yaml does not state the chemistry and the cells of {component}"
        hint = f"facts: {{{component}: {{chemistry: ..., cells: 3}}}}"
        around.bad("estimate_from", message, BAD_ESTIMATE, hint)
        return None
    enum = around.dialect.enums.get("MAV_BATTERY_TYPE")
    if enum is not None and enum.entry(chemistry) is None:
        _report_chemistry(chemistry, part, [entry.name for entry in enum.entries], around)
        return None
    if chemistry not in board.discharge_curves:
        hint = did_you_mean(chemistry, board.discharge_curves) or "write it under discharge_curves in board.yaml"
        around.bad("estimate_from", f"there is no discharge curve of {chemistry}", BAD_ESTIMATE, hint)
        return None
    return _points(chemistry, around)


def _report_chemistry(chemistry: str, part: Instance, names: list[str], around: Surroundings) -> None:
    """An unknown chemistry; a message that sends it reports it, too, and better."""
    component, whole = around.component, around.whole
    answers = (answer for population in whole.populations for answer in population.fields.values())
    if not any(answer.board == f"{component}.chemistry" for answer in answers):
        message = f"MAV_BATTERY_TYPE has no entry {chemistry}"
        place = whole.board.fact_place(component, part.number, "chemistry")
        around.report.add(BAD_ESTIMATE, place, message, did_you_mean(chemistry, names))


def _points(chemistry: str, around: Surroundings) -> list[tuple[Fraction, int]] | None:
    """Volts of one cell and percent, rising."""
    board, report = around.whole.board, around.report
    points = []
    for written, percent in board.discharge_curves[chemistry].items():
        measure = read_measure(written)
        cell = measure.in_unit(unit_named("V")) if measure else None
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
