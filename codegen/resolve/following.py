"""What depends on the facts of each instance: how many values a quantity has, and the limit that a boolean follows."""

from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.state_spec import QuantitySpec
from codegen.model.unit import NUMBER, UNITS
from codegen.model.vehicle import SMALL_INT_MAX, Following
from codegen.source import Place

BAD_ELEMENTS = Rule(
    "bad-elements",
    "A quantity with elements has one number for each of what a fact of its component counts: board.yaml states the "
    "fact for every instance, a whole number from 1 to 255. Nothing measures or estimates it, and it starts unknown.",
)
BAD_FOLLOWING = Rule(
    "bad-following",
    "A boolean that follows names a number of the same component and one limit for it, at_least or below, in its unit. "
    "With per_cell the limit, or warn_above, is multiplied with the fact cells, which board.yaml states for every "
    "instance.",
)
MOST_ELEMENTS = 255

Facts = Mapping[str, str | Fraction]
"""The facts of one instance by name."""


def resolve_elements(
    spec: QuantitySpec, component: str, facts: tuple[Facts, ...], report: Report
) -> tuple[int, ...] | None:
    """How many values the quantity has, by instance; None for a single value, or after a finding."""
    if spec.elements is None:
        return None
    for key in ("boolean", "enum", "initial", "adc", "trend_of", "estimate_from"):
        if getattr(spec, key) not in (None, False):
            message = f"a quantity with elements has numbers that other code sets, and no {key}"
            report.add(BAD_ELEMENTS, spec.at(key), message)
            return None
    return _counts(spec.elements, component, facts, spec.at("elements"), BAD_ELEMENTS, report)


def _counts(
    fact: str, component: str, facts: tuple[Facts, ...], place: Place, rule: Rule, report: Report
) -> tuple[int, ...] | None:
    """A fact that counts something, by instance."""
    counts = []
    for number, known in enumerate(facts, 1):
        count = known.get(fact)
        owner = component if len(facts) == 1 else f"{component} {number}"
        if count is None:
            hint = did_you_mean(fact, known) or f"facts: {{{component}: {{{fact}: 3}}}}"
            report.add(rule, place, f"board.yaml does not state the fact {fact} of {owner}", hint)
            return None
        if not isinstance(count, Fraction) or count.denominator != 1 or not 1 <= count <= MOST_ELEMENTS:
            report.add(rule, place, f"{fact} of {owner} is {count}, not a whole number from 1 to {MOST_ELEMENTS}")
            return None
        counts.append(int(count))
    return tuple(counts)


def count_cells(component: str, facts: tuple[Facts, ...], place: Place, report: Report) -> tuple[int, ...] | None:
    """The cells of each instance, which a limit per cell is multiplied with; None after a finding."""
    return _counts("cells", component, facts, place, BAD_FOLLOWING, report)


def resolve_following(
    spec: QuantitySpec,
    component: str,
    quantities: Mapping[str, QuantitySpec],
    facts: tuple[Facts, ...],
    report: Report,
) -> Following | None:
    """The limit that a boolean follows, by instance; None where it follows none, or after a finding."""
    limits = [key for key in ("at_least", "below") if getattr(spec, key) is not None]
    if spec.follows is None:
        for key in [*limits, *(["per_cell"] if spec.per_cell and spec.warn_above is None else [])]:
            report.add(BAD_FOLLOWING, spec.at(key), f"{key} says nothing without follows")
        return None
    place = spec.at("follows")
    followed = quantities.get(spec.follows)
    if followed is None:
        hint = did_you_mean(spec.follows, quantities)
        report.add(BAD_FOLLOWING, place, f"there is no quantity {spec.follows}", hint)
        return None
    if followed.boolean or followed.enum is not None or followed.elements is not None:
        report.add(BAD_FOLLOWING, place, f"{spec.follows} is not a single number")
        return None
    if len(limits) != 1:
        which = "both limits" if limits else "no limit"
        report.add(BAD_FOLLOWING, place, f"{which} given for {spec.follows}", "write at_least: 2, or below: 2")
        return None
    names = (followed.unit, followed.stored or followed.unit)
    unit, stored = (NUMBER if name is None else UNITS.get(name) for name in names)
    steps = unit.to(stored) if unit is not None and stored is not None else None
    if steps is None:
        return None  # the units of the followed quantity have been reported
    counts: tuple[int, ...] | None = (1,) * len(facts)
    if spec.per_cell:
        counts = count_cells(component, facts, spec.at("per_cell"), report)
    if counts is None:
        return None
    written: Fraction = getattr(spec, limits[0])
    scaled = [written * steps * count for count in counts]
    if any(limit.denominator != 1 or abs(limit) > SMALL_INT_MAX for limit in scaled):
        message = f"{limits[0]} is not a whole number of the units that {spec.follows} is kept in, or too large"
        report.add(BAD_FOLLOWING, spec.at(limits[0]), message)
        return None
    return Following(spec.follows, tuple(int(limit) for limit in scaled), is_below=limits[0] == "below")
