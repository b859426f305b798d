"""The reading of one instance by an ADC in the suite: parameters that switch it on alone, its input, and counts."""

from collections.abc import Iterator

from codegen.model.quantities.conversion import factors_by_instance
from codegen.model.system import System
from codegen.model.vehicle import Component, Parameter, Reading, by_instance
from codegen.targets.firmware.readings.board import adc_input
from codegen.targets.naming import parameter_attribute
from codegen.targets.suite.expected import converted


def input_of(reading: Reading, instance: int, system: System) -> dict[str, object]:
    """The parameters, by their attributes, and the method of the mock with which a count is set."""
    place = [each.name for each in system.readings()].index(reading.name)
    return {
        "parameters": _settings(reading, instance, system),
        "setter": f"set_{adc_input(reading.name, place)}_value",
        "several": reading.component.instances > 1,
    }


def reading_of(name: str, component: Component) -> Reading | None:
    """The reading of a quantity of a component; None where an ADC does not measure it."""
    return next((each for each in component.readings if each.quantity.name == name), None)


def value_at(reading: Reading, instance: int, count: int, system: System) -> int:
    """Return what is kept of a count, by the formula of the requirement and the default factors."""
    conversion, instances = reading.conversion, reading.component.instances
    factors = [factors_by_instance(each, system.parameters, instances)[instance] for each in conversion.factors]
    return converted(reading.quantity, conversion, count, *(each.default for each in factors))


def count_for(reading: Reading, instance: int, value: int, system: System) -> int:
    """The first count whose value comes nearest to one; values rise or fall with the counts."""
    low, high = 0, reading.conversion.channel.full_scale
    rises = value_at(reading, instance, high, system) >= value_at(reading, instance, low, system)
    while low < high:
        middle = (low + high) // 2
        is_before = value_at(reading, instance, middle, system) < value
        if is_before == rises and value_at(reading, instance, middle, system) != value:
            low = middle + 1
        else:
            high = middle
    near = [each for each in (low - 1, low) if each >= 0]
    return min(near, key=lambda count: abs(value_at(reading, instance, count, system) - value))


def is_gone(reading: Reading, instance: int, value: int) -> bool:
    """Return whether a value says that the component is not there, so that nothing of it is known."""
    returns = reading.returns
    return returns is not None and value < max(returns.gone.derivation.own_limits[instance], _back(reading, instance))


def _back(reading: Reading, instance: int) -> int:
    assert reading.returns is not None
    back = reading.returns.count.derivation.back_from
    return back[instance] if back else 0


def _settings(reading: Reading, instance: int, system: System) -> dict[str, int]:
    component = reading.component
    found: dict[str, int] = {}
    switch, when = component.switch, reading.conversion.channel.when
    represented = reading.quantity.derivation.represented
    refused = {0} | ({represented.steps} if represented else set())
    for parameter in _deciding(reading):
        every = by_instance(parameter, system.parameters, component.instances)
        if parameter is switch:
            found |= {parameter_attribute(each.name): 0 for each in every}
        own = every[instance]
        found[parameter_attribute(own.name)] = _on(own, refused)
    if when is not None:
        own = by_instance(when[0], system.parameters, component.instances)[instance]
        found[parameter_attribute(own.name)] = when[1]
    return found


def _deciding(reading: Reading) -> Iterator[Parameter]:
    """The parameters that switch the component on, or say that code sets what is measured."""
    represented = reading.quantity.derivation.represented
    if reading.component.switch is not None:
        yield reading.component.switch
    if represented is not None:
        yield represented.parameter


def _on(parameter: Parameter, refused: set[int]) -> int:
    """Steps of a parameter with which an ADC measures: the default, or others."""
    tried = (
        parameter.default,
        *parameter.choices,
        *range(parameter.minimum, min(parameter.minimum + 8, parameter.maximum) + 1),
    )
    return next((steps for steps in tried if steps not in refused), parameter.default)
