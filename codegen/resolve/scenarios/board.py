"""The parameters that were stored on a board before a scenario begins."""

from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Rule, did_you_mean
from codegen.model.spec.scenario import BesideSpec, ScenarioSpec
from codegen.model.system import System
from codegen.model.vehicle import Parameter
from codegen.resolve.scenarios.values import ScenarioValues

SCENARIO_PARAMETER = Rule(
    "scenario-parameter",
    "A scenario sets a parameter that the program does not have, or to a value that it does not take: outside its "
    "limits, between two steps, or none of its single values.",
    remedy="name a parameter of parameters.yaml, with a value that it takes",
)


def stored_parameters(
    source: ScenarioSpec | BesideSpec, system: System | None, values: ScenarioValues
) -> dict[str, float]:
    """The parameters by name, those with errors left out; without a system none is checked."""
    found = {}
    for name, value in source.parameters.items():
        problem = None if system is None else _problem(system.parameters, name, value)
        if problem:
            values.say(SCENARIO_PARAMETER, source.at(f"parameters.{name}"), *problem)
        else:
            found[name] = float(value)
    return found


def _problem(parameters: Mapping[str, Parameter], name: str, value: Fraction) -> tuple[str, str | None] | None:
    """Return why a parameter does not take a value, with a hint."""
    parameter = parameters.get(name)
    if parameter is None:
        return f"there is no parameter {name}", did_you_mean(name, parameters)
    steps = value / parameter.step
    unit = f" {parameter.unit.name}" if parameter.unit.name else ""
    if parameter.choices and steps not in parameter.choices:
        choices = ", ".join(f"{_number(step * parameter.step)} {word}" for step, word in parameter.choices.items())
        return f"{name} does not take {_number(value)}", f"it takes {choices}"
    if not parameter.minimum <= steps <= parameter.maximum:
        low, high = (_number(limit * parameter.step) for limit in (parameter.minimum, parameter.maximum))
        return (
            f"{name}: {_number(value)}{unit} is not from {low} to {high}",
            f"the nearest is {low if steps < parameter.minimum else high}",
        )
    if steps.denominator != 1:
        return (
            f"{name}: {_number(value)}{unit} lies between two steps of {_number(parameter.step)}{unit}",
            f"the nearest is {_number(round(steps) * parameter.step)}",
        )
    return None


def _number(value: Fraction) -> str:
    return f"{float(value):.9g}"
