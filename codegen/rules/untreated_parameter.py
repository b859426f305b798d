"""The dialect's words give a number of a parameter a meaning of its own, and the command makes nothing of it."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.command import WHOLE_IN_INT, Command, CommandParam
from codegen.model.dialect.dialect import CommandParameter
from codegen.model.dialect.literals import LIMITS
from codegen.model.dialect.stated_values import StatedValue, stated_nan, stated_values
from codegen.model.stated_parameters import stated_parameters
from codegen.model.system import System

RULE = Rule(
    "untreated-parameter",
    "The dialect says in words that a number of a command's parameter means something of its own, such as -1 that "
    "nothing is to change, and the method would get it as a value, converted like any other. List it under "
    "'unchanged': the method gets None. Or keep it out with min and max: it is denied. An empty list, 'unchanged: []', "
    "says that it is a value here. Without a conversion any list says that the others are known. NaN with such a "
    "meaning would be denied: write what the method is given for it under 'default', null for None; 'unchanged: []' "
    "says that it is to be denied.",
    Severity.WARNING,
)

_UNKNOWN_WHOLE = LIMITS["INT32_MAX"]
"""The number that stands for NaN in x and y of COMMAND_INT: words about it are words about NaN."""


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each such number of a parameter that the method is given, and for NaN where it is denied."""
    for command, param, parameter in stated_parameters(system):
        unknown = _stated_unknown(param, parameter)
        if unknown is not None and not _is_unknown_treated(param):
            yield _denied(command, param, parameter, unknown)
        for stated in stated_values(parameter.description) if param.enum is None else ():
            if not _is_treated(stated, param):
                yield _finding(command, param, parameter, stated)


def _stated_unknown(param: CommandParam, parameter: CommandParameter) -> StatedValue | None:
    """Return what the words say of NaN, or of what stands for it in COMMAND_INT."""
    found = stated_nan(parameter.description)
    if found is None and param.number in WHOLE_IN_INT:
        return next((each for each in stated_values(parameter.description) if each.number == _UNKNOWN_WHOLE), None)
    return found


def _is_unknown_treated(param: CommandParam) -> bool:
    """Return whether NaN is not denied, or the project says that it is to be."""
    return param.default is not None or param.is_none_for_nan or param.spec.unchanged == ()


def _is_treated(stated: StatedValue, param: CommandParam) -> bool:
    value, unchanged = stated.number, param.spec.unchanged
    if value == _UNKNOWN_WHOLE and param.number in WHOLE_IN_INT:
        return True
    is_below = param.minimum is not None and value < param.minimum
    is_above = param.maximum is not None and value > param.maximum
    if is_below or is_above or value in param.left or unchanged == ():
        return True
    return unchanged is not None and param.scale.ratio == 1


def _finding(command: Command, param: CommandParam, parameter: CommandParameter, stated: StatedValue) -> Diagnostic:
    wire, unit = param.wire_unit.name, param.unit.name
    converted = f", converted from {wire} to {unit}" if param.scale.ratio != 1 else ""
    more = " (the method is then given None)" if stated.is_left else ", or keep it out with min and max"
    return Diagnostic(
        param.spec.place,
        RULE,
        f"{command.name} {param.number} has a number with a meaning of its own, {stated.words!r}, and {param.name} "
        f"would get it as a value{converted}",
        f"write unchanged: [{stated.text}]{more}, or unchanged: [] where it is a value",
        ((parameter.place, "the dialect says so here"),),
    )


def _denied(command: Command, param: CommandParam, parameter: CommandParameter, stated: StatedValue) -> Diagnostic:
    return Diagnostic(
        param.spec.place,
        RULE,
        f"{command.name} {param.number} has a meaning for {stated.text}, {stated.words!r}, and without a default "
        "the command is denied then",
        "write default: null (the method is then given None), or a number, or unchanged: [] where NaN is to be denied",
        ((parameter.place, "the dialect says so here"),),
    )
