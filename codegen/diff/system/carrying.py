"""The way of a number to the wire: from parameters, ADC channels and quantities to the fields that send it."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from codegen.diff.system.state import fact_name
from codegen.model.spec.population import FieldAnswer
from codegen.model.system import System
from codegen.model.vehicle import Parameter


def fields_by_source(system: System) -> Mapping[str, tuple[str, ...]]:
    """The fields (``MESSAGE.field``) that take numbers from each parameter, ADC channel and quantity, by its name."""
    fields = {f"{message.name}.{answer.covers.field.name}" for message in system.messages for answer in message.answers}
    found = {name: tuple(one for one in reached if one in fields) for name, reached in carried_on(system).items()}
    return {name: reached for name, reached in found.items() if reached}


def carried_on(system: System) -> Mapping[str, tuple[str, ...]]:
    """Everything that takes numbers from each parameter, ADC channel and quantity, by its name: quantities, fields.

    A channel is called ``adc.NAME``. What a quantity is computed from leads on to what that one is sent in; a parameter
    of a family leads to where the first one does, one that is the rate of a stream to its messages.
    """
    onward: dict[str, dict[str, None]] = {}
    for source, target in (*_in_state(system), *_in_messages(system)):
        onward.setdefault(source, {})[target] = None
    found = {name: tuple(_reached(name, onward)) for name in onward}
    for parameter in system.parameters.values():
        first = parameter.siblings[0] if parameter.siblings else parameter.name
        if first in found:
            found[parameter.name] = found[first]
    return found


def scaling_parameters(system: System) -> Mapping[str, tuple[str, ...]]:
    """The parameters, by name, whose value a measured number is multiplied with, with the quantities that they make."""
    found: dict[str, list[str]] = {}
    for component in system.components.values():
        for quantity in component.quantities.values():
            if quantity.derivation.conversion is not None:
                for factor in quantity.derivation.conversion.factors:
                    if isinstance(factor, Parameter):
                        found.setdefault(factor.name, []).append(quantity.path)
    for parameter in system.parameters.values():
        if parameter.siblings and parameter.siblings[0] in found:
            found[parameter.name] = found[parameter.siblings[0]]
    return {name: tuple(paths) for name, paths in found.items()}


def fed_by_facts(system: System) -> Mapping[str, tuple[str, ...]]:
    """Return what may be otherwise where a fact of the board is, by what ``fact_name`` calls the fact.

    These are the fields that the fact goes into, and the quantities and parameters of its component.
    """
    found: dict[str, tuple[str, ...]] = {}
    for component in system.components.values():
        names = [quantity.path for quantity in component.quantities.values()]
        names += [name for name, parameter in system.parameters.items() if parameter.component == component.name]
        for fact in dict.fromkeys(name for part in component.parts for name in part.facts):
            found[fact_name(component.name, fact)] = (*names, *told_of_fact(system, component.name, fact))
    return found


def written_otherwise(old: System, new: System) -> Iterator[str]:
    """The fields, quantities and parameters that two versions write otherwise: they follow from no other change."""
    for before, after in (
        (_fields_written(old), _fields_written(new)),
        (_quantities_written(old), _quantities_written(new)),
        (_parameters_written(old), _parameters_written(new)),
    ):
        yield from (name for name, written in after.items() if name in before and before[name] != written)


def told_of_fact(system: System, component: str, fact: str) -> tuple[str, ...]:
    """The fields that a fact of the board goes into, by itself or as the number that another one is multiplied with."""
    return tuple(
        field
        for field, answer in _fields_written(system).items()
        if answer.board == f"{component}.{fact}" or (answer.board is not None and answer.per == fact)
    )


def _fields_written(system: System) -> dict[str, FieldAnswer]:
    return {
        f"{message.name}.{answer.covers.field.name}": answer.covers.written
        for message in system.messages
        for answer in message.answers
    }


def _quantities_written(system: System) -> dict[str, object]:
    return {
        quantity.path: quantity.spec
        for component in system.components.values()
        for quantity in component.quantities.values()
    }


def _parameters_written(system: System) -> dict[str, object]:
    """A default for each cell or the like was multiplied before, and is left out."""
    return {
        name: parameter.spec if parameter.spec.per is None else replace(parameter.spec, default=Fraction(0))
        for name, parameter in system.parameters.items()
    }


def _in_state(system: System) -> Iterator[tuple[str, str]]:
    for component in system.components.values():
        for quantity in component.quantities.values():
            derivation = quantity.derivation
            for name, _, _ in derivation.gives:
                yield f"sensor {name.partition('.')[0]}", quantity.path
            for name in derivation.sources:
                if name in component.quantities:
                    yield component.quantities[name].path, quantity.path
            for parameter, _ in derivation.uses(quantity):
                yield parameter.name, quantity.path
            if derivation.conversion is not None:
                channel = derivation.conversion.channel
                yield f"adc.{channel.name}", quantity.path
                if channel.pin is not None:
                    yield channel.pin.name, f"adc.{channel.name}"


def _in_messages(system: System) -> Iterator[tuple[str, str]]:
    for message in system.messages:
        if message.stream is not None and message.stream.parameter is not None:
            yield message.stream.parameter.name, message.name
        for answer in message.answers:
            field = f"{message.name}.{answer.covers.field.name}"
            for quantity in answer.quantities:
                yield quantity.path, field
            for parameter in answer.parameters:
                yield parameter.name, field


def _reached(name: str, onward: Mapping[str, Mapping[str, None]]) -> Iterator[str]:
    seen, ahead = {name}, list(onward[name])
    while ahead:
        target = ahead.pop(0)
        if target in seen:
            continue
        seen.add(target)
        yield target
        ahead += onward.get(target, ())
