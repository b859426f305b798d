"""The view with which a program, whose component id is a parameter, notices others that use its ids."""

from collections.abc import Iterator

from codegen.model.program import Program
from codegen.model.system import PopulatedMessage, System
from codegen.targets.firmware.messages.sending import number_at
from codegen.targets.imports import one_by_one, tuple_text
from codegen.targets.naming import parameter_attribute


def watched(system: System) -> tuple[PopulatedMessage, ...]:
    """The messages that tell the chip of their sender, each of the dialect once; none where nobody can change an id."""
    if system.program is None or system.component_parameter is None:
        return ()
    found = {message.wire.name: message for message in system.messages if _chip_at(message)}
    return tuple(found.values())


def watching(system: System, program: Program) -> Iterator[str]:
    """The statements that let a connection look: the messages, where they have the chip and the number."""
    parameter = system.component_parameter
    if parameter is None:
        return
    kinds = tuple((message.wire.id, *_chip_at(message), number_at(message)) for message in watched(system))
    arguments = ["connection", "self.texts", f'"{parameter.name}"', tuple_text(kinds), *_numbers(system)]
    cited = program.aspects.get("services", {}).get("twins")
    if cited is not None:
        yield f"# Who uses the same ids is told ({cited})."
    indent = " " * 8
    yield from (line.removeprefix(indent) for line in one_by_one(f"{indent}watch_twins", arguments))


def _chip_at(message: PopulatedMessage) -> tuple[int, ...]:
    """Return where the payload has the number of the chip, and in how many bytes; nothing where it has none."""
    places = ((each.covers.offset, each.covers.count) for each in message.answers if each.is_chip_number)
    return next(places, ())


def _numbers(system: System) -> Iterator[str]:
    """The parameter that gives the first instance its number, and the numbers of all; nothing where they are fixed."""
    components = {message.component.name: message.component for message in watched(system) if message.component}
    for component in components.values():
        if component.first_number is not None:
            first = f"self.parameters.{parameter_attribute(component.first_number.name)}"
            yield f'"{component.first_number.name}"'
            yield f"range({first}, {first} + {component.instances})"
            return
