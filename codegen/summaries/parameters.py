"""The uses of a parameter and how it is carried, in words: for explain and for the review documents."""

from collections.abc import Iterator

from codegen.model.failsafe import Failsafe, Sense
from codegen.model.spec.spec import ParameterType
from codegen.model.system import PopulatedMessage, System
from codegen.model.vehicle import Parameter


def uses(parameter: Parameter, system: System) -> list[str]:
    """Return everything that reads a parameter, in the order of the specification's files.

    The specification names the first one of a family: what reads that one reads each other for its own instance.
    """
    first = system.parameters.get(parameter.siblings[0], parameter) if parameter.siblings else parameter
    found = [use for part in (_board, _state, _messages, _program) for use in part(first, system)]
    if found and parameter.siblings:
        found[0] = f"of {parameter.component} {parameter.instance + 1}: {found[0]}"
    return found


def encoding_words(system: System) -> str:
    """Return how PARAM_VALUE and PARAM_SET carry whole parameters; empty where there are none, or no program."""
    if system.program is None or not system.has_whole_parameters:
        return ""
    return (
        f"{'as the bytes of their types' if system.is_bytewise else 'as floats'} (encoding: {system.program.encoding})"
    )


def type_words(parameter: Parameter, system: System) -> str:
    """Return the type of a parameter, with the encoding that the program has of it: ``uint8; PARAM_VALUE and ...``."""
    kind = parameter.spec.type
    carried = "" if kind is ParameterType.REAL32 else encoding_words(system)
    return f"{kind}; whole parameters are sent and taken {carried}" if carried else f"{kind}"


def _board(parameter: Parameter, system: System) -> Iterator[str]:
    for channel in system.channels.values():
        if channel.pin is parameter:
            yield f"the pin of the ADC channel {channel.name}"


def _state(parameter: Parameter, system: System) -> Iterator[str]:
    for component in system.components.values():
        for quantity in component.quantities.values():
            yield from (use for used, use in quantity.derivation.uses(quantity) if used is parameter)


def _choices(message: PopulatedMessage, parameter: Parameter) -> Iterator[str]:
    for choice in message.represents.values():
        if choice.parameter is parameter:
            yield f"which {choice.component.name} {message.name} is about"


def _messages(parameter: Parameter, system: System) -> Iterator[str]:
    for stream in system.streams.values():
        if stream.parameter is parameter:
            yield f"the rate of stream {stream.name}"
    for generations in system.generations:
        if generations.parameter is parameter:
            yield f"which generation of {generations.component.name} messages is sent"
    for message in system.messages:
        yield from _choices(message, parameter)
        for answer in message.answers:
            if any(read is parameter for read in answer.parameters):
                yield f"{message.name}.{answer.covers.label}"


def _program(parameter: Parameter, system: System) -> Iterator[str]:
    if system.system_parameter is parameter:
        yield "the system id of the vehicle"
    if system.component_parameter is parameter:
        yield "the component id"
    for failsafe in system.program.failsafes if system.program else ():
        yield from _failsafe(parameter, failsafe)


def _failsafe(parameter: Parameter, failsafe: Failsafe) -> Iterator[str]:
    watched = f"the failsafe of {failsafe.watched}"
    for level in failsafe.levels:
        for condition in level.conditions:
            other = (
                f", for {condition.quantity.path}"
                if condition.quantity is not failsafe.quantity and condition.quantity
                else ""
            )
            if condition.limit and condition.limit.parameter is parameter:
                yield f"the {level.name} threshold of {watched}{other}"
        if level.action is parameter:
            yield f"the {level.name} action of {watched}"
    delays = [condition.after.parameter for condition in failsafe.conditions if condition.after]
    if any(delay is parameter for delay in delays):
        yield f"the delay of {watched}"
    for condition in failsafe.to_arm:
        if condition.limit and condition.limit.parameter is parameter and condition.quantity:
            end = "least" if condition.sense is Sense.BELOW else "most"
            yield f"the {end} {condition.quantity.path} to arm with"
    if failsafe.enabled_by is parameter:
        yield f"whether {watched} is on"
