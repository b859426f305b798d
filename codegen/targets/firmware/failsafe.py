"""View of failsafe.py: the thresholds that a measured quantity is compared with."""

from dataclasses import dataclass
from fractions import Fraction

from codegen.model.program import Failsafe, Program
from codegen.model.vehicle import Parameter, Quantity
from codegen.targets.naming import class_name, first_instance, parameter_attribute


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
    action: str
    citation: str


@dataclass(frozen=True, slots=True)
class FailsafeView:
    """A failsafe of one component, which ``path`` reaches below the state; ``divisor`` steps are one unit.

    Of several instances the first is measured, and so watched.
    """

    component: str
    path: str
    class_name: str
    title: str
    quantity: str
    attribute: str
    unit: str
    divisor: int
    levels: tuple[LevelView, ...]
    after: str
    after_name: str
    minimum: ThresholdView | None
    health: str | None
    health_every_ms: int
    used: str | None
    enabled: str | None
    citation: str


def failsafe_views(program: Program) -> tuple[FailsafeView, ...]:
    """The failsafes in the order of vehicle.yaml."""
    return tuple(_failsafe(failsafe) for failsafe in program.failsafes)


def _failsafe(failsafe: Failsafe) -> FailsafeView:
    component, quantity = failsafe.component, failsafe.quantity
    levels = (("low", 1, failsafe.low), ("critical", 2, failsafe.critical))
    return FailsafeView(
        component=component.name,
        path=first_instance(component),
        class_name=f"{class_name(component.name)}Failsafe",
        title=f"{component.name.replace('_', ' ').capitalize()} 1",
        quantity=quantity.name,
        attribute=quantity.attribute,
        unit=quantity.unit.name,
        divisor=int(quantity.steps),
        levels=tuple(
            LevelView(
                name=name,
                number=number,
                below=_threshold(level.below, quantity),
                action=parameter_attribute(level.action.name),
                citation=str(level.citation or failsafe.citation),
            )
            for name, number, level in levels
        ),
        after=parameter_attribute(failsafe.after.name),
        after_name=failsafe.after.name,
        minimum=None if failsafe.minimum_to_arm is None else _threshold(failsafe.minimum_to_arm, quantity),
        health=failsafe.health.attribute if failsafe.health else None,
        health_every_ms=failsafe.health_every_ms,
        used=failsafe.used.attribute if failsafe.used else None,
        enabled=component.enabled.name if component.enabled else None,
        citation=str(failsafe.citation),
    )


def _threshold(parameter: Parameter, quantity: Quantity) -> ThresholdView:
    attribute = parameter_attribute(parameter.name)
    scale = (parameter.unit.to(quantity.stored) or Fraction(1)) * parameter.step
    assert scale.denominator == 1, "the failsafe was resolved so"
    times = f" * {scale.numerator}" if scale != 1 else ""
    return ThresholdView(parameter.name, attribute, f"parameters.{attribute}{times}", scale.numerator)
