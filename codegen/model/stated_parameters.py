"""The parameters of the project's commands, each beside what the dialect says of it."""

from collections.abc import Iterator

from codegen.model.command import Command, CommandParam
from codegen.model.dialect.dialect import CommandParameter
from codegen.model.system import System


def stated_parameters(system: System) -> Iterator[tuple[Command, CommandParam, CommandParameter]]:
    """Yield the parameters that methods are given, in the order of commands.yaml; not those without a word of it."""
    enum = system.dialect.enums.get("MAV_CMD")
    for command in system.program.commands if system.program and enum else ():
        entry = enum.entry(command.name) if enum else None
        written = {parameter.number: parameter for parameter in entry.parameters} if entry else {}
        for param in command.params:
            parameter = written.get(str(param.number))
            if parameter is not None:
                yield command, param, parameter
