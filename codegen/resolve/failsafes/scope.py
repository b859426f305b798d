"""The names that failsafes can use, quantities and actions, and the findings about them."""

from collections.abc import Mapping

from codegen.derivations.surroundings import UNKNOWN_QUANTITY
from codegen.diagnostics import Report, did_you_mean, shortened_list
from codegen.frozen import dataclass
from codegen.model.spec.failsafe import ConditionSpec, FailsafeLevelSpec, FailsafeSpec
from codegen.model.spec.program import ActionSpec
from codegen.model.spec.spec import Requirement
from codegen.model.spec.state import StateSpec
from codegen.model.vehicle import Component, Parameter, Quantity, QuantityKind
from codegen.resolve.failsafes.finding import BAD_FAILSAFE
from codegen.resolve.failsafes.setting import SettingReader
from codegen.resolve.quantities.component import find_component


@dataclass(frozen=True, slots=True)
class FailsafeScope:
    """The names that a failsafe may use, and the report for its findings."""

    settings: SettingReader
    components: Mapping[str, Component]
    state: StateSpec
    actions: tuple[ActionSpec, ...]
    index: Mapping[str, Requirement]
    report: Report

    def bad(
        self,
        spec: FailsafeSpec | FailsafeLevelSpec | ConditionSpec,
        key: str | None,
        message: str,
        hint: str | None,
    ) -> None:
        """Report something at a key of a record, or at the record itself."""
        self.report.add(BAD_FAILSAFE, spec.at(key) if key else spec.place, message, hint)

    def quantity(
        self, spec: FailsafeSpec | ConditionSpec, key: str, path: str, component: str | None
    ) -> Quantity | None:
        """A number of the state, of ``component`` where one is given; None after a finding."""
        owner, _, name = path.partition(".")
        place, form = spec.at(key), "write component.quantity"
        whole = find_component(owner, self.components, self.state, BAD_FAILSAFE, place, self.report, form)
        if whole is None:
            return None
        quantity = whole.quantities.get(name)
        if quantity is None:
            if not whole.spec.is_written(name):
                hint = did_you_mean(name, whole.quantities)
                self.report.add(UNKNOWN_QUANTITY, spec.at(key), f"{owner} has no quantity {name}", hint)
            return None
        if component is not None and owner != component:
            self.bad(spec, key, f"{path} belongs to another component than {component}", "a failsafe of its own")
            return None
        if quantity.kind is not QuantityKind.NUMBER or quantity.elements is not None or quantity.derivation.counts_time:
            self.bad(
                spec,
                key,
                f"{path} is not a number that can be compared",
                hint="name a single number, such as what an ADC measures or code sets",
            )
            return None
        return quantity

    def kept(self, spec: FailsafeSpec, key: str, name: str | None, component: Component | None) -> Quantity | None:
        """A quantity that the failsafe sets: of the component that it watches, or of one alone, with its path."""
        if name is None:
            return None
        path = name if "." in name or component is None else f"{component.name}.{name}"
        quantity = self.quantity(spec, key, path, component.name if component else None)
        if quantity is None:
            return None
        if quantity.initial is None or not quantity.derivation.is_set_by_code:
            self.bad(
                spec,
                key,
                f"{quantity.path} is not a number with an initial value",
                hint="write initial: 0 at it, and leave it to the failsafe alone",
            )
        if component is None and self.components[quantity.component].instances > 1:
            self.bad(
                spec,
                key,
                f"there are several {quantity.component}, and the failsafe is one",
                hint="name a quantity of a component of which there is one",
            )
        return quantity

    def action(self, level: FailsafeLevelSpec, component: Component | None) -> Parameter | ActionSpec | None:
        """The parameter that chooses what a level does, or what it does, or None; findings are reported."""
        if level.action is None:
            return None
        for action in self.actions:
            if action.call == level.action:
                return action
        if level.action.islower():
            hint = did_you_mean(level.action, [action.call for action in self.actions])
            self.bad(level, "action", f"there is no action {level.action}", hint)
            return None
        parameter = self.settings.parameter(level.action, level.at("action"), component)
        if parameter is None:
            return None
        known = {0, *(entry.value for entry in self.actions)}
        possible = set(parameter.choices) or set(range(parameter.minimum, parameter.maximum + 1))
        lacking = sorted(possible - known)
        if lacking and len(known) > len(self.actions):  # else one of them has the value of another
            are = "is" if len(lacking) == 1 else "are"
            message = f"{shortened_list(map(str, lacking))} of {parameter.name} {are} none of the actions"
            self.bad(level, "action", message, hint="give an action each of them, or narrow the parameter's values")
        return parameter
