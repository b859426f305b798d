"""Curves, or points of them, by which nothing is estimated."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import pairwise

from codegen.diagnostics import Diagnostic, Rule, Severity, did_you_mean
from codegen.findings.fingerprint import fingerprint
from codegen.model.spec.board import CurveSpec
from codegen.model.spec.derivation import EstimateSpec
from codegen.model.system import System
from codegen.model.units.unit import read_measure

UNUSED = Rule(
    "unused-curve",
    "No quantity is estimated by a curve of board.yaml, so it has no effect. Name it where it is meant, beside "
    "estimate_from, say that it is kept for later (spare: true), or leave it out.",
    Severity.WARNING,
    remedy="write curve: and its name at the quantity that it is for, or spare: true, or leave the curve out",
)
BAD_CURVE = Rule(
    "bad-curve",
    "The points of a curve by which nothing is estimated are looked at as well: two or more at different amounts of "
    "one kind, whose values rise or fall throughout. Its choice, and what it counts (per), are facts of a component.",
    remedy="correct the curve, or leave it out",
)

_POINTS = "4.2 V: 100"


def check(system: System) -> Iterator[Diagnostic]:
    """Every curve of the board; what is estimated by one has been looked at with the quantity."""
    state = system.spec.state
    written = {key.split(".")[1] for key in state.places if key.startswith("components.")}
    if written - state.components.keys() or any(each.unread for each in state.components.values()):
        return  # what may be estimated there has been reported
    used = {spec.curve: component for component, spec in _estimates(system)}
    for name, curve in system.spec.board.curves.items():
        component = used.get(name)
        chosen = _chosen(curve, component, system) if component else set()
        if component is None:
            yield from _unnamed(name, curve, system)
        for key, points in _points(curve):
            if component is not None and (curve.choice is None or curve.points):
                continue  # looked at with the quantity
            if key not in chosen:
                yield from _beside(name, curve, key, points)


def _estimates(system: System) -> Iterator[tuple[str, EstimateSpec]]:
    for component, spec in system.spec.state.components.items():
        for quantity in spec.quantities.values():
            estimate = quantity.written(EstimateSpec)
            if estimate is not None:
                yield component, estimate


def _chosen(curve: CurveSpec, component: str, system: System) -> set[str]:
    """The keys of the points that instances of a component use."""
    if curve.choice is None:
        return {"points"}
    parts = system.components[component].parts if component in system.components else ()
    return {f"by.{part.facts.get(curve.choice)}" for part in parts}


def _points(curve: CurveSpec) -> Iterator[tuple[str, Mapping[str, Fraction]]]:
    if curve.points:
        yield "points", curve.points
    yield from ((f"by.{chosen}", points) for chosen, points in curve.by.items())


def _unnamed(name: str, curve: CurveSpec, system: System) -> Iterator[Diagnostic]:
    """Yield that nothing names a curve, and what of it no component could have."""
    if system.spec.is_own(curve.place.file) and not curve.spare:  # others may use what a program does not
        hint = f"curve: {name} at a quantity with estimate_from; spare: true, if it is kept for later; or leave it out"
        message = f"nothing is estimated by the curve {name}"
        file, about = curve.place.file, f"{system.spec.program} {name}"
        yield Diagnostic(curve.place, UNUSED, message, hint, fingerprint=fingerprint(UNUSED.id, file, about))
    if (curve.choice is None) == bool(curve.by) or bool(curve.by) == bool(curve.points):
        message = f"the curve {name} has neither points alone, nor a choice and points by what is chosen"
        hint = f"points: {{{_POINTS}, ...}}, or choice: a fact, and by: {{its value: {{{_POINTS}, ...}}}}"
        yield Diagnostic(curve.place, BAD_CURVE, message, hint)
    parts = [part for component in system.components.values() for part in component.parts]
    facts = {fact for part in parts for fact in part.facts}
    for key, fact in (("choice", curve.choice), ("per", curve.per)):
        if fact is not None and fact not in facts:
            hint = did_you_mean(fact, facts) or f"state it in facts of the component, or leave {key} out"
            yield Diagnostic(curve.at(key), BAD_CURVE, f"board.yaml states no {fact} of any component", hint)


def _beside(name: str, curve: CurveSpec, key: str, points: Mapping[str, Fraction]) -> Iterator[Diagnostic]:
    """Yield what is wrong with points that nothing follows."""
    read: list[tuple[Fraction, Fraction]] = []
    kinds = set()
    for written, value in points.items():
        measure = read_measure(written)
        if measure is None:
            hint = f"write it like {_POINTS}"
            yield Diagnostic(curve.at(f"{key}.{written}"), BAD_CURVE, f"{written!r} is no amount with a unit", hint)
            return
        kinds.add(measure.unit.dimension)
        read.append((measure.value * measure.unit.scale, value))
    if len(kinds) > 1:
        hint = "write all of them in the unit of what is measured"
        yield Diagnostic(curve.at(key), BAD_CURVE, f"amounts of the curve {name} are of several kinds", hint)
        return
    steps = [(second[0] - first[0], second[1] - first[1]) for first, second in pairwise(sorted(read))]
    is_steady = all(step > 0 for _, step in steps) or all(step < 0 for _, step in steps)
    if not steps or not is_steady or any(amount == 0 for amount, _ in steps):
        message = "a curve has two points or more, at different amounts, whose values rise or fall throughout"
        yield Diagnostic(curve.at(key), BAD_CURVE, message, "leave out the points that turn back, or add some")
