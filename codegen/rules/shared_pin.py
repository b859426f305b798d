"""Pins that more than one instance is read from."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.system import System
from codegen.model.vehicle import Component, Parameter

RULE = Rule(
    "shared-pin",
    "Two instances of a component are read from the same pin, so that both show one voltage. Give each a pin of its "
    "own, by a parameter for_each instance and the defaults in board.yaml, or switch one off by default.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every measured quantity, with the pins of the instances that are switched on by default."""
    for name, quantity, conversion in system.measured():
        component = system.components[name]
        channel = conversion.channel
        owners: dict[int, int] = {}
        for number, gpio in enumerate(system.gpios(component, channel)):
            if _is_off(system, component, number):
                continue
            owner = owners.setdefault(gpio, number)
            if owner != number:
                message = f"{name} {owner + 1} and {number + 1} are both read from GPIO {gpio}"
                written = system.spec.board.instances.get(name, ())
                place = written[number].place if number < len(written) else component.spec.place
                related = ((quantity.spec.at("adc"), "the ADC channel is named here"),)
                yield Diagnostic(place, RULE, message, _hint(component, channel.pin, number), related)


def _is_off(system: System, component: Component, number: int) -> bool:
    """Whether an instance is switched off by default."""
    switch = component.switch
    if switch is None:
        return False
    own = switch.siblings[number] if switch.siblings else switch.name
    return system.parameters.get(own, switch).default == 0


def _hint(component: Component, pin: Parameter | None, number: int) -> str:
    if pin is None or not pin.siblings:
        return f"let a parameter with for_each: {component.name} have the pin"
    return f"defaults: {{{pin.siblings[number]}: 27}}"
