"""Failsafes: what they watch, their thresholds and their actions."""

from collections.abc import Mapping

from codegen.derivations.surroundings import UNKNOWN_QUANTITY
from codegen.diagnostics import Report, Rule, did_you_mean, shortened_list
from codegen.measure import read_time
from codegen.model.program import Failsafe, FailsafeLevel
from codegen.model.program_spec import ActionSpec, FailsafeLevelSpec, FailsafeSpec
from codegen.model.spec import ParametersSpec, Requirement
from codegen.model.unit import ratio, unit_named
from codegen.model.vehicle import Citation, Component, Parameter, Quantity, QuantityKind
from codegen.resolve.citation import cite, cite_aspects, cite_optional
from codegen.resolve.vehicle import find_parameter

BAD_FAILSAFE = Rule(
    "bad-failsafe",
    "A failsafe watches a measured quantity, its thresholds are in the same dimension and never negative, its time is "
    "in whole seconds, and every value of an action's parameter but 0 is one of the actions.",
)


class FailsafeResolver:
    """Resolves failsafes; every problem of one is reported before it is given up."""

    def __init__(
        self,
        written: ParametersSpec,
        parameters: Mapping[str, Parameter],
        components: Mapping[str, Component],
        actions: tuple[ActionSpec, ...],
        index: Mapping[str, Requirement],
        report: Report,
    ) -> None:
        self.written = written
        self.parameters = parameters
        self.components = components
        self.actions = actions
        self.index = index
        self.report = report

    def resolve(self, name: str, spec: FailsafeSpec) -> Failsafe | None:
        """The failsafe of a component, or None after a finding."""
        component = self.components.get(name)
        citation = cite(spec.requirement, spec.at("requirement"), self.index, self.report)
        if component is None:
            hint = did_you_mean(name, self.components)
            self.report.add(BAD_FAILSAFE, spec.place, f"the state has no component {name}", hint)
            return None
        quantity = self._quantity(component, spec, "quantity", spec.quantity)
        if quantity is None:
            return None
        if quantity.derivation.conversion is None:
            self.report.add(BAD_FAILSAFE, spec.at("quantity"), f"{quantity.path} is not measured by an ADC")
            return None
        low = self._level(spec.low, quantity)
        critical = self._level(spec.critical, quantity)
        after = self._parameter(spec, "after", spec.after)
        if after is not None and (after.unit != unit_named("s") or after.step != 1 or after.minimum < 0):
            self.report.add(BAD_FAILSAFE, spec.at("after"), f"{after.name} is not a time in whole seconds")
        minimum = self._threshold(spec, "minimum_to_arm", spec.minimum_to_arm, quantity)
        health = self._kept(component, spec, "health", spec.health)
        level = self._kept(component, spec, "level", spec.level)
        used = self._quantity(component, spec, "used", spec.used)
        if used is not None and used.stored != unit_named("mAh"):
            self.report.add(BAD_FAILSAFE, spec.at("used"), f"{used.path} is not kept in mAh")
        if low is None or critical is None or after is None or citation is None:
            return None
        every = 0
        if spec.health_every is not None:
            every = read_time(spec.health_every, unit_named("ms"), spec.at("health_every"), self.report) or 0
        aspects = cite_aspects(spec, self.index, self.report)
        return Failsafe(
            component, quantity, low, critical, after, minimum, health, level, every, used, spec, citation, aspects
        )

    def _kept(self, component: Component, spec: FailsafeSpec, key: str, name: str | None) -> Quantity | None:
        """A quantity that the failsafe sets."""
        quantity = self._quantity(component, spec, key, name)
        if quantity is not None and (quantity.kind is not QuantityKind.NUMBER or quantity.initial is None):
            self.report.add(BAD_FAILSAFE, spec.at(key), f"{quantity.path} is not a number with an initial value")
        return quantity

    def _level(self, spec: FailsafeLevelSpec, quantity: Quantity) -> FailsafeLevel | None:
        citation: Citation | None = cite_optional(spec.requirement, spec.at("requirement"), self.index, self.report)
        below = self._threshold(spec, "below", spec.below, quantity)
        action = self._parameter(spec, "action", spec.action)
        if action is not None:
            known = {0, *(entry.value for entry in self.actions)}
            possible = set(action.choices) or set(range(action.minimum, action.maximum + 1))
            lacking = sorted(possible - known)
            if lacking and len(known) > len(self.actions):  # else one of them has the value of another
                are = "is" if len(lacking) == 1 else "are"
                message = f"{shortened_list(map(str, lacking))} of {action.name} {are} none of the actions"
                self.report.add(BAD_FAILSAFE, spec.at("action"), message)
        return None if below is None or action is None else FailsafeLevel(below, action, citation)

    def _threshold(
        self, spec: FailsafeSpec | FailsafeLevelSpec, key: str, name: str | None, quantity: Quantity
    ) -> Parameter | None:
        parameter = None if name is None else self._parameter(spec, key, name)
        if parameter is None:
            return None
        steps = ratio(parameter.unit, quantity.stored)
        if steps is None or (steps * parameter.step).denominator != 1 or parameter.minimum != 0:
            message = (
                f"{parameter.name} is no threshold for {quantity.path}: from 0 on, in whole {quantity.stored.name}"
            )
            self.report.add(BAD_FAILSAFE, spec.at(key), message)
            return None
        return parameter

    def _parameter(self, spec: FailsafeSpec | FailsafeLevelSpec, key: str, name: str) -> Parameter | None:
        return find_parameter(name, spec.at(key), self.written, self.parameters, self.report)

    def _quantity(self, component: Component, spec: FailsafeSpec, key: str, name: str | None) -> Quantity | None:
        quantity = component.quantities.get(name) if name else None
        if quantity is None and name and name not in component.spec.quantities:
            hint = did_you_mean(name, component.quantities)
            self.report.add(UNKNOWN_QUANTITY, spec.at(key), f"{component.name} has no quantity {name}", hint)
        return quantity
