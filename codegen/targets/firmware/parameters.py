"""View of parameters.py: each parameter in whole steps."""

from dataclasses import dataclass

from codegen.model.system import Parameter, System
from codegen.model.unit import decimal
from codegen.targets.naming import parameter_attribute, prose


@dataclass(frozen=True, slots=True)
class ParameterView:
    """One parameter; the value is ``steps * numerator / denominator`` in ``unit``."""

    name: str
    attribute: str
    default: int
    minimum: int
    maximum: int
    numerator: int
    denominator: int
    comment: str
    doc: str


def parameter_views(system: System) -> tuple[ParameterView, ...]:
    """The parameters in the order of their names."""
    return tuple(_parameter(system.parameters[name]) for name in sorted(system.parameters))


def _parameter(parameter: Parameter) -> ParameterView:
    unit = f" {parameter.unit.name}" if parameter.unit.name else ""
    step = "" if parameter.step == 1 else f", in steps of {decimal(parameter.step)}{unit}"
    return ParameterView(
        name=parameter.name,
        attribute=parameter_attribute(parameter.name),
        default=parameter.default,
        minimum=parameter.minimum,
        maximum=parameter.maximum,
        numerator=parameter.step.numerator,
        denominator=parameter.step.denominator,
        comment=f"{decimal(parameter.default * parameter.step)}{unit}{step}",
        doc=prose(parameter.spec.doc),
    )
