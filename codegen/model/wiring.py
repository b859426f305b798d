"""How the batteries of a program are connected to its board: the ADC inputs of each instance, and its parameters."""

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from codegen.model.system import System
from codegen.model.vehicle import Component, Conversion, Parameter

FIRST_PREFIX = "BATT_"
"""What the names of the first battery's parameters begin with, where no instances are listed."""


@dataclass(frozen=True, slots=True)
class AdcInput:
    """One ADC input: ``pin`` is the parameter that has the GPIO number, or None; ``gpio`` is the number without it.

    ``multiplier`` gives what is measured by the volts at the pin, ``reference`` is the voltage of full scale.
    """

    gpio: int
    pin: Parameter | None
    multiplier: Parameter
    reference: Fraction

    def gpio_with(self, parameters: Mapping[str, float]) -> int:
        """The GPIO number, by the parameters that were stored on the board."""
        return self.gpio if self.pin is None else round(parameters.get(self.pin.name, self.gpio))

    def multiplier_with(self, parameters: Mapping[str, float]) -> Fraction:
        """What one volt at the pin stands for, by the parameters that were stored on the board."""
        multiplier = self.multiplier
        stored = parameters.get(multiplier.name)
        return multiplier.default * multiplier.step if stored is None else Fraction(stored).limit_denominator(10**6)


@dataclass(frozen=True, slots=True)
class BatteryInput:
    """The ADC inputs of one battery; ``prefix`` begins the names of its parameters."""

    prefix: str
    voltage: AdcInput
    current: AdcInput | None


def battery_inputs(system: System) -> tuple[BatteryInput, ...]:
    """The inputs of the batteries that a program measures, by instance; none if it measures none."""
    component = _battery(system)
    if component is None:
        return ()
    voltage = _conversion(component, "voltage")
    current = _conversion(component, "current")
    assert voltage is not None
    return tuple(
        BatteryInput(
            part.prefix or FIRST_PREFIX,
            _input(voltage, part.number, system),
            None if current is None else _input(current, part.number, system),
        )
        for part in component.parts
    )


def first_number(system: System) -> str | None:
    """The name of the parameter with the id of the first battery; None where the ids begin with 0."""
    component = _battery(system)
    return component.first_number.name if component and component.first_number else None


def _battery(system: System) -> Component | None:
    """The component whose voltage is measured."""
    components = (system.components[name] for name, _ in system.measured())
    return next((component for component in components if _conversion(component, "voltage")), None)


def _conversion(component: Component, dimension: str) -> Conversion | None:
    quantities = [quantity for quantity in component.quantities.values() if quantity.unit.dimension == dimension]
    return next((quantity.conversion for quantity in quantities if quantity.conversion), None)


def _input(conversion: Conversion, instance: int, system: System) -> AdcInput:
    channel = conversion.channel
    pin = None if channel.pin is None else _sibling(channel.pin, instance, system)
    gpio = channel.gpio if pin is None else int(pin.default * pin.step)
    return AdcInput(gpio, pin, _sibling(conversion.multiplier, instance, system), channel.reference)


def _sibling(parameter: Parameter, instance: int, system: System) -> Parameter:
    """The parameter of a family that belongs to an instance, from 0; one that is no family belongs to all."""
    return system.parameters[parameter.siblings[instance]] if parameter.siblings else parameter
