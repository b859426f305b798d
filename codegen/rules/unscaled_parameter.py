"""COMMAND_INT multiplies a parameter by what only the dialect's words say, and the specification does not say it."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.command import WHOLE_IN_INT, Command, CommandParam
from codegen.model.dialect.dialect import CommandParameter
from codegen.model.stated_parameters import stated_parameters
from codegen.model.system import System
from codegen.pattern import pattern

RULE = Rule(
    "unscaled-parameter",
    "COMMAND_INT carries parameters 5 and 6 as whole numbers, of positions 1e7 to a degree and, in local frames, 1e4 "
    "to a metre. What the dialect calls a latitude or a longitude is known to be one; of other positions, and of what "
    "its words say is scaled, commands.yaml says by what, with 'scaled', and in which 'frames' a position may be. "
    "Without it the method would be given thousands of metres for each.",
    Severity.ERROR,
)
_SCALED = pattern(r"(?i)\b(?:scaled|multiplied) by (1e\d|10\^\d)\b|\* ?(1e\d|10\^\d)\b")
_PLACE = pattern(r"(?i)\b(?:position|location|coordinates?|latitude|longitude|MAV_FRAME)\b|\b[XY]\b")
_LOCAL, _GLOBAL = "1e4", "1e7"


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each parameter 5 or 6 of which nothing says by what it is multiplied, or in which frames."""
    for command, param, parameter in stated_parameters(system):
        if param.number in WHOLE_IN_INT and param.axis is None:
            yield from _of(command, param, parameter)


def _of(command: Command, param: CommandParam, parameter: CommandParameter) -> Iterator[Diagnostic]:
    words = f"{dict(parameter.attributes).get('label', '')} {parameter.description}"
    scaled, is_place = _SCALED.search(words), _PLACE.search(words) is not None
    related = ((parameter.place, "the dialect says so here"),)
    label = f"{command.name} {param.number}"
    if param.spec.scaled is None and (scaled or is_place):
        said = f"{scaled[0]!r}" if scaled else f"a position ({parameter.description.strip().rstrip('.')!r})"
        factor = (scaled[1] or scaled[2]).replace("10^", "1e") if scaled else _factor(command)
        message = f"{label} is {said} to the dialect, and {param.name} would get what COMMAND_INT carries as it is"
        hint = f"write scaled: {factor}; scaled: 1 where COMMAND_INT has whole numbers of the value itself"
        yield Diagnostic(param.spec.place, RULE, message, hint, related)
    elif param.steps is not None and is_place and not scaled and len(_kinds(command)) != 1:
        kinds = "global and local" if command.spec.frames else "any"
        message = f"{label} is a position in {kinds} frames, and COMMAND_INT multiplies those of each kind differently"
        hint = "name frames of one kind: frames: [MAV_FRAME_LOCAL_NED]"
        yield Diagnostic(param.spec.place, RULE, message, hint, related)


def _factor(command: Command) -> str:
    kinds = _kinds(command)
    return next(iter(kinds)) if len(kinds) == 1 else f"{_GLOBAL} and frames that are global, or {_LOCAL} and local ones"


def _kinds(command: Command) -> set[str]:
    """Return by what COMMAND_INT multiplies a position in the frames that a command may have."""
    return {_GLOBAL if name.startswith("MAV_FRAME_GLOBAL") else _LOCAL for name in command.spec.frames}
