"""The review document's part about commands and modes."""

from codegen.frozen import dataclass
from codegen.model.command import Command, CommandParam, Mode
from codegen.model.program import Program
from codegen.model.spec.command import Sender
from codegen.model.units.unit import decimal
from codegen.summaries.fields import in_table
from codegen.targets.firmware.program.commands import left_words


@dataclass(frozen=True, slots=True)
class CommandLine:
    """A command: what it does, its parameters, when it is done, for whom, and by which method of the vehicle."""

    name: str
    doc: str
    params: str
    when: str
    method: str
    criterion: str


@dataclass(frozen=True, slots=True)
class ModeLine:
    """A mode of the vehicle."""

    number: int
    name: str
    doc: str
    base: str
    criterion: str


def command_lines(program: Program) -> tuple[CommandLine, ...]:
    """The commands of the project, then those that every program answers."""
    services = str(program.cited.get("services", ""))
    own = tuple(_line(command) for command in program.commands)
    return own + tuple(CommandLine(each.name, each.doc, "", "", "", services) for each in program.built_in)


def _line(command: Command) -> CommandLine:
    return CommandLine(
        name=command.name,
        doc=in_table(command.spec.doc),
        params=in_table("; ".join(param_words(param) for param in command.params)),
        when=when_words(command),
        method=f"{command.spec.method}({', '.join(param.name for param in command.params)})",
        criterion=str(command.citation or ""),
    )


def param_words(param: CommandParam) -> str:
    """``1 duration: 0 to 60 s``."""
    unknown = "" if param.default is None else f", NaN is {decimal(param.default)}"
    left = f", {left_words(param)}: as it is" if left_words(param) else ""
    return f"{param.number} {param.name}: {param.limits}{unknown}{left}"


def when_words(command: Command) -> str:
    """Return when a command is done, for whom, and whether it takes long."""
    words = [command.spec.allowed.value]
    if command.spec.sender is Sender.GROUND_STATION:
        words.append("for ground stations")
    if command.spec.long:
        words.append("takes long")
    return ", ".join(words)


def mode_lines(modes: tuple[Mode, ...]) -> tuple[ModeLine, ...]:
    """The modes in the order of vehicle.yaml."""
    return tuple(
        ModeLine(
            number=mode.number,
            name=in_table(mode.name),
            doc=in_table(mode.spec.doc),
            base=", ".join(quantity.path for quantity in mode.base),
            criterion=str(mode.citation or ""),
        )
        for mode in modes
    )
