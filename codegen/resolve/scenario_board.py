"""What one program of a scenario finds: its batteries by instance, and the parameters that were stored."""

from collections.abc import Mapping, Sequence
from fractions import Fraction

from codegen.diagnostics import Rule, did_you_mean
from codegen.model.scenario import Battery
from codegen.model.scenario_spec import BatterySpec, BesideSpec, EventSpec, ScenarioSpec
from codegen.model.system import System
from codegen.model.vehicle import Parameter
from codegen.model.wiring import BatteryInput, battery_inputs
from codegen.resolve.scenario_values import ScenarioValues

SCENARIO_INSTANCE = Rule(
    "scenario-instance",
    "A scenario has a battery for a program that measures one, battery or batteries, at most as many as it measures "
    "(instances of board.yaml), and a fault is at one of these: instance counts from 1.",
)
SCENARIO_PARAMETER = Rule(
    "scenario-parameter",
    "A scenario sets a parameter that the program does not have, or to a value that it does not take: outside its "
    "limits, between two steps, or none of its single values.",
)

Source = ScenarioSpec | BesideSpec | EventSpec


class ScenarioBoard:
    """Reads what a scenario states for one program; without ``system`` only what needs no knowledge of it."""

    def __init__(self, system: System | None, values: ScenarioValues) -> None:
        """Report through ``values``."""
        self._system = system
        self._values = values
        self._inputs: tuple[BatteryInput, ...] = () if system is None else battery_inputs(system)

    def batteries(self, source: Source, parameters: Mapping[str, float]) -> tuple[Battery, ...]:
        """The batteries by instance; some are missing after errors."""
        if source.battery is not None:
            found: Sequence[BatterySpec] = [source.battery]
            if "batteries" in source.places:
                message = "battery and batteries are given, and only one of them can hold"
                self._values.say(SCENARIO_INSTANCE, source.at("batteries"), message)
        else:
            found = source.batteries
            self._check_count(source)
        batteries = []
        for instance, spec in enumerate(found):
            known = self._inputs[instance] if instance < len(self._inputs) else None
            divider = Fraction(1) if known is None else known.voltage.multiplier_with(parameters)
            batteries.append(self._values.battery(spec, divider))
        return tuple(battery for battery in batteries if battery is not None)

    def parameters(self, source: ScenarioSpec | BesideSpec) -> dict[str, float]:
        """The parameters by name, those with errors left out."""
        found = {}
        for name, value in source.parameters.items():
            problem = None if self._system is None else _problem(self._system.parameters, name, value)
            if problem:
                self._values.say(SCENARIO_PARAMETER, source.at(f"parameters.{name}"), *problem)
            else:
                found[name] = float(value)
        return found

    def instance(self, event: EventSpec) -> int:
        """The battery of a fault, from 0."""
        number = 1 if event.instance is None else event.instance
        most = len(self._inputs) or 1
        if number < 1 or (self._system is not None and number > most):
            message = f"there is no battery {number}: the program measures {_count(most)}"
            self._values.say(SCENARIO_INSTANCE, event.at("instance"), message)
            return 0
        return number - 1

    def _check_count(self, source: Source) -> None:
        place = source.at("batteries")
        written = len(source.batteries)
        if "batteries" in source.places:
            if not written and "batteries[0]" not in source.places:
                self._values.say(SCENARIO_INSTANCE, place, "batteries has no battery", "write [{voltage: 12.6 V}]")
        elif self._inputs and "battery" not in source.places:
            message = "there is no battery, and the program measures one"
            self._values.say(SCENARIO_INSTANCE, source.place, message, "write battery: {voltage: 12.6 V}")
        most = len(self._inputs) or 1
        if self._system is not None and written > most:
            message = f"{_count(written)} are given, and the program measures {_count(most)}"
            hint = "list one more under instances of board.yaml, or remove one here"
            self._values.say(SCENARIO_INSTANCE, place, message, hint)


def _problem(parameters: Mapping[str, Parameter], name: str, value: Fraction) -> tuple[str, str | None] | None:
    """Why a parameter does not take a value, with a hint."""
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
        return f"{name}: {_number(value)}{unit} is not from {low} to {high}", None
    if steps.denominator != 1:
        return f"{name}: {_number(value)}{unit} lies between two steps of {_number(parameter.step)}{unit}", None
    return None


def _number(value: Fraction) -> str:
    return f"{float(value):.9g}"


def _count(number: int) -> str:
    return "1 battery" if number == 1 else f"{number} batteries"
