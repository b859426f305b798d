"""The derivation that estimates a quantity by a curve of points: a charge by a voltage, a content by a level."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING

from codegen.derivations.surroundings import Kept, Surroundings, told_origin
from codegen.diagnostics import Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.model.quantities.derivation import Derivation, DerivationFact
from codegen.model.spec.board import CurveSpec
from codegen.model.spec.derivation import EstimateSpec, MeasuredSpec
from codegen.model.units.finer_unit import finer_units
from codegen.model.units.unit import NUMBER, Unit, decimal, ratio, read_measure
from codegen.model.vehicle import Instance, Quantity

if TYPE_CHECKING:
    from codegen.model.system import System

BAD_ESTIMATE = Rule(
    "bad-estimate",
    "A quantity is estimated from a measured one of the same component, by a curve of board.yaml: two points or more, "
    "each an amount of the measured quantity and a number in the unit of the estimate, which rise or fall throughout "
    "and keep to its limits. Both are whole numbers of the steps that are kept: a point between two would be another "
    "one. Where a fact chooses the points, there are points for the fact of every instance.",
    remedy="write estimate_from: and the name of what an ADC measures in this component",
)


@dataclass(frozen=True, slots=True)
class Estimate(Derivation):
    """An estimate: for each instance the points (stored steps of ``quantity``, stored steps of the estimate)."""

    quantity: str
    curve: str
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
            points = ", ".join(f"{stored}: {value}" for stored, value in curve)
            text = f"by {self.quantity}, {points}"
            yield DerivationFact(f"estimate of instance {number}:", text, "estimate_from")

    def words(self, quantity: Quantity) -> str:
        return f"{self.curve} curve by {quantity.component}.{self.quantity}"

    def story(self, quantity: Quantity, system: "System") -> Iterator[tuple[str, str]]:
        yield "follows", f"{self.quantity}, by the {self.curve} curve of {len(self.curves[0])} points"


def resolve_estimate(written: EstimateSpec, kept: Kept, around: Surroundings) -> Estimate | None:
    """The curve of each instance, by what is measured; None after a finding."""
    name = written.estimate_from
    followed = around.others.get(name)
    if followed is None:
        around.no_quantity("estimate_from", name, BAD_ESTIMATE)
        return None
    if followed.written(MeasuredSpec) is None:
        message = f"{name} is {told_origin(followed)}, and an estimate follows what the ADC of the component measures"
        hint = f"write adc and multiplier at {name}, or set {around.name} by code"
        around.bad("estimate_from", message, BAD_ESTIMATE, hint)
        return None
    spelt = followed.stored or followed.unit
    stored = NUMBER if spelt is None else Unit.parse(spelt)
    if stored is None:
        return None  # the unit has been reported
    curve = _curve(written, around)
    if curve is None:
        return None
    curves = []
    for number, part in enumerate(around.parts, 1):
        found = _points_of(curve, number, part, around)
        points = found and _Points(*found, name, stored, kept, around).read(part.count(curve.per) if curve.per else 1)
        if not points:
            return None
        curves.append(points)
    return Estimate(name, written.curve or "", tuple(curves))


def _curve(written: EstimateSpec, around: Surroundings) -> CurveSpec | None:
    """The curve of board.yaml; None after a finding."""
    curves = around.whole.board.curves
    if written.curve is None:
        names = ", ".join(curves) or "write one under curves in board.yaml"
        around.bad("estimate_from", "no curve is named", BAD_ESTIMATE, f"write curve: and its name: {names}")
        return None
    if written.curve not in curves:
        hint = did_you_mean(written.curve, curves) or "write it under curves in board.yaml"
        around.bad("curve", f"board.yaml has no curve {written.curve}", BAD_ESTIMATE, hint)
        return None
    curve = curves[written.curve]
    if curve.per is not None and around.counted(curve.per, "curve", BAD_ESTIMATE) is None:
        return None
    if (curve.choice is None) == bool(curve.by) or bool(curve.by) == bool(curve.points):
        message = f"the curve {written.curve} has neither points, nor a choice and points by what is chosen"
        if curve.by and curve.points:
            message = f"the curve {written.curve} has points and points by what is chosen"
        hint = "points: {4.2 V: 100, ...}, or choice: a fact, and by: {its value: {4.2 V: 100, ...}}"
        around.report.add(BAD_ESTIMATE, curve.place, message, hint)
        return None
    return curve


def _points_of(
    curve: CurveSpec, number: int, part: Instance, around: Surroundings
) -> tuple[CurveSpec, str, Mapping[str, Fraction]] | None:
    """The curve, the key of the points of an instance in it, and these; None after a finding."""
    name = around.spec.written(EstimateSpec).curve  # type: ignore[union-attr]
    if curve.choice is None:
        return curve, "points", curve.points
    chosen = part.facts.get(curve.choice)
    owner = around.component if len(around.parts) == 1 else f"{around.component} {number}"
    if not isinstance(chosen, str):
        message = f"the curve {name} is chosen by {curve.choice}, which board.yaml does not state of {owner}"
        hint = did_you_mean(curve.choice, part.facts) or f"facts: {{{around.component}: {{{curve.choice}: ...}}}}"
        around.report.add(BAD_ESTIMATE, curve.at("choice"), message, hint)
        return None
    if chosen not in curve.by:
        hint = did_you_mean(chosen, curve.by) or f"write it under by of {name}"
        place = around.whole.board.fact_place(around.component, part.number, curve.choice)
        related = [(curve.at("by"), f"the curve {name}")]
        around.report.add(BAD_ESTIMATE, place, f"the curve {name} has no points for {chosen}", hint, related)
        return None
    return curve, f"by.{chosen}", curve.by[chosen]


@dataclass(frozen=True, slots=True)
class _Points:
    """Points as written at ``key`` of a curve; ``stored`` is the unit that the measured quantity is kept in."""

    curve: CurveSpec
    key: str
    written: Mapping[str, Fraction]
    measured: str
    stored: Unit
    kept: Kept
    around: Surroundings

    def read(self, count: int | None) -> tuple[tuple[int, int], ...] | None:
        """The points in stored steps, by those of the measured quantity; None after a finding."""
        points: list[tuple[int, int]] = []
        exact: list[Fraction] = []
        for amount, value in self.written.items():
            measure = read_measure(amount)
            factor = ratio(measure.unit, self.stored) if measure else None
            if measure is None or factor is None:
                self._bad(
                    f".{amount}",
                    f"{amount!r} is no amount of {self.measured}, which is in {self.stored.name}",
                    f"write it like 4.2 {self.stored.name}: 100",
                )
                return None
            steps = value * self.kept.steps
            if steps.denominator != 1:
                self._bad(
                    f".{amount}",
                    f"{decimal(value)} is not a whole number of {self.kept.stored.name or 'steps'}",
                    "round it, or give the estimate a finer unit: stored",
                )
                return None
            if not self.kept.minimum <= steps <= self.kept.maximum:
                low, high = (decimal(Fraction(end) / self.kept.steps) for end in (self.kept.minimum, self.kept.maximum))
                self._bad(
                    f".{amount}",
                    f"{decimal(value)} is not within {low} to {high}",
                    "correct it, or widen min and max of the estimate",
                )
                return None
            exact.append(measure.value * factor * (count or 1))
            if exact[-1].denominator != 1:
                of_count = f" times {count}" if (count or 1) > 1 else ""
                name = self.stored.name or "number"
                message = f"{amount}{of_count} is no whole {name}, and {self.measured} is kept in whole {name}"
                self._bad(f".{amount}", message, self._finer_steps(count or 1))
                return None
            points.append((int(exact[-1]), int(steps)))
        points.sort()
        values = [value for _, value in points]
        is_steady = all(first < second for first, second in pairwise(values)) or all(
            first > second for first, second in pairwise(values)
        )
        if len(points) < 2 or not is_steady or any(first[0] == second[0] for first, second in pairwise(points)):
            self._bad(
                "",
                "a curve has two points or more, at different amounts, whose values rise or fall throughout",
                "leave out the points that turn back, or add some",
            )
            return None
        return tuple(points)

    def _finer_steps(self, count: int) -> str:
        """The hint for a point between two steps: the coarsest unit of which all points are whole numbers."""
        measures = [measure for amount in self.written if (measure := read_measure(amount)) is not None]
        for finer in sorted(finer_units(self.stored), key=lambda each: -each.scale):
            factors = [(measure.value * count, ratio(measure.unit, finer)) for measure in measures]
            if all(factor is not None and (value * factor).denominator == 1 for value, factor in factors):
                return f"stored: {finer.name} at {self.measured}, or round it"
        return f"round it, or keep {self.measured} more finely: stored"

    def _bad(self, below: str, message: str, hint: str) -> None:
        self.around.report.add(BAD_ESTIMATE, self.curve.at(self.key + below), message, hint)
