"""View of failsafe.py: the thresholds that a measured quantity is compared with."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.program import Failsafe, FailsafeLevel, Program
from codegen.model.unit import ratio
from codegen.model.vehicle import Component, Parameter, Quantity
from codegen.targets.families import family_lines
from codegen.targets.naming import failsafe_class, parameter_attribute, parameter_expression, quoted


@dataclass(frozen=True, slots=True)
class ThresholdView:
    """A parameter as a threshold: its attribute, and an expression of it in the steps of the watched quantity."""

    name: str
    attribute: str
    expression: str
    scale: int


@dataclass(frozen=True, slots=True)
class LevelView:
    """One level of a failsafe; its name is ``low`` or ``critical``."""

    name: str
    number: int
    below: ThresholdView
    names: tuple[str, ...]
    action: str
    action_attribute: str
    actions: tuple[str, ...]
    citation: str


@dataclass(frozen=True, slots=True)
class FailsafeView:
    """A failsafe of one component, for each of its ``instances``; ``divisor`` steps are one unit.

    ``called`` is the literal of what texts call it, ``title`` the same without the number of the instance; ``objects``
    is what makes the vehicle's list of them.
    """

    component: str
    instances: int
    several: bool
    uses_instance: bool
    class_name: str
    objects: str
    title: str
    called: str
    quantity: str
    attribute: str
    unit: str
    divisor: int
    low: LevelView
    critical: LevelView
    after: str
    after_attribute: str
    after_name: str
    afters: tuple[str, ...]
    minimum: ThresholdView | None
    minimums: tuple[str, ...]
    health: str | None
    level: str | None
    health_every_ms: int
    used: str | None
    enabled: str | None
    citation: str

    @property
    def levels(self) -> tuple[LevelView, LevelView]:
        """Both levels, the lower one first."""
        return self.low, self.critical


_INSTANCE = "self._instance"


def parameters_of(failsafe: Failsafe) -> tuple[Parameter, ...]:
    """The parameters of a failsafe, of families those of the first instance."""
    levels = (failsafe.low.below, failsafe.low.action, failsafe.critical.below, failsafe.critical.action)
    return (*levels, failsafe.after, *([failsafe.minimum_to_arm] if failsafe.minimum_to_arm else []))


def failsafe_families(program: Program) -> tuple[str, ...]:
    """The families of parameters that the failsafes read, once each, as lines with an empty one before them."""
    used = {parameter.name: parameter for failsafe in program.failsafes for parameter in parameters_of(failsafe)}
    lines = family_lines(parameter for parameter in used.values() if parameter.siblings)
    return ("", *lines) if lines else ()


def failsafe_views(program: Program) -> tuple[FailsafeView, ...]:
    """The failsafes in the order of vehicle.yaml."""
    return tuple(_failsafe(failsafe) for failsafe in program.failsafes)


def _failsafe(failsafe: Failsafe) -> FailsafeView:
    component, quantity = failsafe.component, failsafe.quantity
    title, several = component.name.replace("_", " ").capitalize(), component.instances > 1
    return FailsafeView(
        component=component.name,
        instances=component.instances,
        several=several,
        uses_instance=any(parameter.siblings for parameter in parameters_of(failsafe)),
        class_name=failsafe_class(component.name),
        objects=_objects(component),
        title=title,
        called=f'f"{title} {{instance + 1}}"' if several else quoted(f"{title} 1"),
        quantity=quantity.name,
        attribute=quantity.attribute,
        unit=quantity.unit.name,
        divisor=int(quantity.steps),
        low=_level("low", 1, failsafe.low, failsafe),
        critical=_level("critical", 2, failsafe.critical, failsafe),
        after=parameter_expression(failsafe.after, "self._parameters", _INSTANCE),
        after_attribute=parameter_attribute(failsafe.after.name),
        after_name=failsafe.after.name,
        afters=tuple(map(parameter_attribute, failsafe.after.siblings)),
        minimum=None if failsafe.minimum_to_arm is None else _threshold(failsafe.minimum_to_arm, quantity),
        minimums=tuple(map(parameter_attribute, failsafe.minimum_to_arm.siblings)) if failsafe.minimum_to_arm else (),
        health=failsafe.health.attribute if failsafe.health else None,
        level=failsafe.level.attribute if failsafe.level else None,
        health_every_ms=failsafe.health_every_ms,
        used=failsafe.used.attribute if failsafe.used else None,
        enabled=component.enabled.name if component.enabled else None,
        citation=str(failsafe.citation),
    )


def _objects(component: Component) -> str:
    name = failsafe_class(component.name)
    if component.instances == 1:
        return f"{name}(self.state, self.texts)"
    return f"{name}(self.state, self.texts, instance) for instance in range({component.instances})"


def _level(name: str, number: int, level: FailsafeLevel, failsafe: Failsafe) -> LevelView:
    return LevelView(
        name=name,
        number=number,
        below=_threshold(level.below, failsafe.quantity),
        names=tuple(map(parameter_attribute, level.below.siblings)),
        action=parameter_expression(level.action, "self._parameters", _INSTANCE),
        action_attribute=parameter_attribute(level.action.name),
        actions=tuple(map(parameter_attribute, level.action.siblings)),
        citation=str(level.citation or failsafe.citation),
    )


def _threshold(parameter: Parameter, quantity: Quantity) -> ThresholdView:
    attribute = parameter_attribute(parameter.name)
    scale = (ratio(parameter.unit, quantity.stored) or Fraction(1)) * parameter.step
    assert scale.denominator == 1, "the failsafe was resolved so"
    times = f" * {scale.numerator}" if scale != 1 else ""
    expression = parameter_expression(parameter, "self._parameters", _INSTANCE)
    return ThresholdView(parameter.name, attribute, f"{expression}{times}", scale.numerator)
