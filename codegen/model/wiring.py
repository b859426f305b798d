"""How the batteries of a program are connected to its board: the ADC inputs of each instance, and its parameters."""

from collections.abc import Mapping
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.conversion import Conversion, Factor, factors_by_instance
from codegen.model.system import System
from codegen.model.vehicle import Component, Parameter, by_instance

FIRST_PREFIX = "BATT_"
"""What the names of the first battery's parameters begin with, where no instances are listed."""


@dataclass(frozen=True, slots=True)
class AdcInput:
    """One ADC input: ``pin`` is the parameter that has the GPIO number, or None; ``gpio`` is the number without it.

    ``multiplier`` gives what is measured by the volts at the pin, ``reference`` is the voltage of full scale.
    """

    gpio: int
    pin: Parameter | None
    multiplier: Factor
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
    voltages = _inputs(voltage, component, system)
    currents = (None,) * component.instances if current is None else _inputs(current, component, system)
    return tuple(
        BatteryInput(part.prefix or FIRST_PREFIX, voltages[part.number], currents[part.number])
        for part in component.parts
    )


def first_number(system: System) -> str | None:
    """The name of the parameter with the id of the first battery; None where the ids begin with 0."""
    component = _battery(system)
    return component.first_number.name if component and component.first_number else None


def _battery(system: System) -> Component | None:
    """The component whose voltage is measured."""
    components = (system.components[name] for name, _, _ in system.measured())
    return next((component for component in components if _conversion(component, "voltage")), None)


def _conversion(component: Component, kind: str) -> Conversion | None:
    quantities = [quantity for quantity in component.quantities.values() if quantity.unit.kind == kind]
    return next((quantity.derivation.conversion for quantity in quantities if quantity.derivation.conversion), None)


def _inputs(conversion: Conversion, component: Component, system: System) -> tuple[AdcInput, ...]:
    """The input of each instance."""
    channel, count = conversion.channel, component.instances
    multipliers = factors_by_instance(conversion.multiplier, system.parameters, count)
    if channel.pin is None:
        return tuple(AdcInput(channel.gpio, None, multiplier, channel.reference) for multiplier in multipliers)
    pins = by_instance(channel.pin, system.parameters, count)
    return tuple(
        AdcInput(int(pin.default * pin.step), pin, multiplier, channel.reference)
        for pin, multiplier in zip(pins, multipliers, strict=True)
    )
