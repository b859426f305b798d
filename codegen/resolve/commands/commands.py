"""The commands of commands.yaml: entries of MAV_CMD, with the methods that do them."""

from collections.abc import Mapping

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.command import BUILT_IN, Command, CommandParam, Needs
from codegen.model.dialect.dialect import Dialect, EnumEntry
from codegen.model.spec.command import Allowed, CommandSpec, CommandsSpec
from codegen.model.spec.program import VehicleSpec
from codegen.model.spec.spec import Requirement
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.commands.frames import resolve_frames
from codegen.resolve.commands.params import resolve_params
from codegen.resolve.named import is_name
from codegen.resolve.program.vehicle_names import is_vehicle_name
from codegen.resolve.quantities.kept import UNKNOWN_ENTRY

BAD_COMMAND = Rule(
    "bad-command",
    "A command is done by a method with a name of its own that code overrides, with the same arguments for each "
    "command that it does, and is allowed armed or disarmed only where something can be armed.",
)
BUILT_IN_COMMAND = Rule(
    "built-in-command",
    "Every program answers this command, so commands.yaml cannot: other parts of the specification say how.",
    remedy="remove it: the program answers this command by itself",
)
NO_PROGRAM_FOR_COMMANDS = Rule(
    "no-program-for-commands",
    "commands.yaml says what the program does at commands, and without vehicle.yaml there is no program.",
)


def resolve_commands(
    spec: CommandsSpec | None,
    vehicle: VehicleSpec,
    dialect: Dialect,
    index: Mapping[str, Requirement],
    report: Report,
) -> tuple[Command, ...]:
    """The commands in the order of the file; what has a finding is left out."""
    written = spec.commands if spec else {}
    by_method: dict[str, list[CommandSpec]] = {}
    for command in written.values():
        by_method.setdefault(command.method, []).append(command)
    made = {f"{each.method}_{end}" for each in written.values() if each.long for end in ("progress", "cancel")}
    found: list[Command] = []
    for name, command in written.items():
        entry = _entry(name, command, vehicle, dialect, report)
        _check_method(name, command, by_method[command.method], made, vehicle, report)
        if vehicle.arming is None and command.allowed is not Allowed.ALWAYS:
            message = f"{name} is allowed {command.allowed.value}, and nothing can be armed without arming"
            report.add(BAD_COMMAND, command.at("allowed"), message, "vehicle.yaml says with arming that it can")
        citation = cite_optional(command.requirement, command.at("requirement"), index, report)
        aspects = cite_aspects(command, index, report)
        if entry is not None:
            params = resolve_params(name, entry, command, dialect, report)
            frames = resolve_frames(name, command, params, dialect, report)
            _check_arguments(params, [each for each in found if each.spec.method == command.method], command, report)
            found.append(Command(citation, aspects, name, entry.value, params, frames, command))
    return tuple(found)


def _entry(name: str, command: CommandSpec, vehicle: VehicleSpec, dialect: Dialect, report: Report) -> EnumEntry | None:
    enum = dialect.enums.get("MAV_CMD")
    entry = enum.entry(name) if enum else None
    if entry is None:
        known = [each.name for each in enum.entries] if enum else []
        message = f"MAV_CMD has no entry {name}"
        report.add(UNKNOWN_ENTRY, command.place, message, lambda: did_you_mean(name, known))
        return None
    built_in = next((each for each in BUILT_IN if each.name == name), None)
    if built_in is not None and (built_in.needs is not Needs.MODES or vehicle.modes):
        report.add(BUILT_IN_COMMAND, command.place, f"{name} is answered already", built_in.configured)
        return None
    if not 0 < entry.value <= 0xFFFF:
        report.add(
            BAD_COMMAND,
            command.place,
            f"no COMMAND_LONG carries {name}: its number is {entry.value}",
            hint="choose an entry of MAV_CMD from 1 to 65535",
        )
        return None
    return entry


def _check_method(
    name: str, command: CommandSpec, alike: list[CommandSpec], made: set[str], vehicle: VehicleSpec, report: Report
) -> None:
    """Report what is wrong with a command's method; ``alike`` have it, too, and ``made`` are made for long ones."""
    method = command.method
    if not is_name(method) or is_vehicle_name(method) or method in made:
        report.add(
            BAD_COMMAND,
            command.at("method"),
            f"{method} cannot be the name of a method of its own",
            hint="take a lower-case identifier that no other call of the vehicle has",
        )
        return
    if command.long is not alike[0].long:
        message = f"{method} takes long for one command, and not for another"
        report.add(BAD_COMMAND, command.at("method"), message, "write long at both, or give each a method of its own")
    calls = {action.call for action in vehicle.actions}
    if (method in calls and (command.params or command.long)) or made & calls:
        message = f"{method} of {name} is what a failsafe calls: without parameters, and without waiting"
        report.add(BAD_COMMAND, command.at("method"), message, "give the command a method of its own")


def _check_arguments(
    params: tuple[CommandParam, ...], others: list[Command], command: CommandSpec, report: Report
) -> None:
    """Report an argument that the method is given in another place, or in another unit, for one of ``others``.

    The method does not know for which command it is called. It may be given fewer: its last ones can have defaults.
    """
    for other in others:
        for mine, theirs in zip(params, other.params, strict=False):
            if (mine.name, mine.unit) != (theirs.name, theirs.unit):
                message = f"{command.method} is given {_argument(mine)} here, and {_argument(theirs)} for {other.name}"
                hint = "list the same names in one order and in the same units, or give each a method of its own"
                report.add(BAD_COMMAND, mine.spec.place, message, hint, [(theirs.spec.place, "the other is here")])
                return


def _argument(param: CommandParam) -> str:
    return f"{param.name} in {param.unit.name}" if param.unit.name else param.name
