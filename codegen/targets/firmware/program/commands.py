"""Views of the commands: the table of those of the project, the methods of the vehicle that do them, and its modes."""

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction
from textwrap import wrap

from codegen.frozen import dataclass
from codegen.model.command import WHOLE_IN_INT, Command, CommandParam, Mode
from codegen.model.program import Program
from codegen.model.spec.command import Allowed, Sender
from codegen.model.units.affine import AffineMap
from codegen.targets.naming import prose, quoted

FINITE = "3.4e38"
"""The limit of what has none: infinities are beyond it."""
_ARMED = {Allowed.ALWAYS: None, Allowed.ARMED: True, Allowed.DISARMED: False}


@dataclass(frozen=True, slots=True)
class CommandRow:
    """A command as a row of the table; ``params`` and ``int_params`` are the text of each parameter."""

    number: int
    about: str
    method: str
    title: str
    armed: bool | None
    is_for_stations: bool
    is_long: bool
    params: tuple[str, ...]
    int_params: tuple[str, ...]
    frames: tuple[int, ...]
    frame_words: str


@dataclass(frozen=True, slots=True)
class MethodView:
    """A method of the vehicle that code overrides: its head, and the lines below it."""

    head: str
    lines: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class ModeView:
    """A mode, by its number."""

    number: int
    name: str


@dataclass(frozen=True, slots=True)
class CommandTableView:
    """The commands of the project."""

    commands: tuple[CommandRow, ...]


def command_table_view(program: Program) -> CommandTableView:
    """The view of command_table.py."""
    return CommandTableView(tuple(_row(command) for command in program.commands))


def title_of(command: Command) -> str:
    """``Pump``: how texts begin that are about a command."""
    return command.spec.method.replace("_", " ").capitalize()


_ROOM = 100
"""Columns of a line of the table behind its indentation, with a comma."""


def _row(command: Command) -> CommandRow:
    is_other_int = any(param.steps is not None or _is_exact_int(param) for param in command.params)
    return CommandRow(
        number=command.number,
        about=f"{command.name}: {prose(command.spec.doc)}{_cited(command)}",
        method=command.spec.method,
        title=title_of(command),
        armed=_ARMED[command.spec.allowed],
        is_for_stations=command.spec.sender is Sender.GROUND_STATION,
        is_long=command.spec.long,
        params=tuple(_param(param, is_int=False) for param in command.params),
        int_params=tuple(_param(param, is_int=True) for param in command.params) if is_other_int else (),
        frames=tuple(entry.value for entry in command.frames),
        frame_words=_frame_words(command),
    )


def _frame_words(command: Command) -> str:
    """Return the text about another frame, as Python writes it."""
    if not command.spec.frames:
        return '"positions have to be global"' if command.frames else "None"
    return quoted(f"the frame must be {' or '.join(dict.fromkeys(command.spec.frames))}")


def _param(param: CommandParam, *, is_int: bool) -> str:
    """Number, least, most, multiplier, divisor, form, values, default, words: as own_commands.py reads them."""
    steps = param.steps if is_int and param.steps is not None else Fraction(1)
    scale = AffineMap(param.scale.factor / steps, param.scale.pi)
    low, high = (None if end is None else end * steps for end in (param.minimum, param.maximum))
    if is_int and (param.steps is not None or _is_exact_int(param)):
        low, high = param.int_ends
    multiplier, divisor = _factor(scale)
    parts = (
        str(param.number),
        f"-{FINITE}" if low is None else number_text(low),
        FINITE if high is None else number_text(high),
        multiplier,
        divisor,
        _form(param),
        _among(param),
        "None" if param.default is None else argument_text(param, param.default),
        quoted(f"{param.name} must be {param.limits}"),
        *_further(param, param.int_left if is_int else param.left),
    )
    line = f"({', '.join(parts)})"
    if len(line) <= _ROOM:
        return line
    own = [each for part in parts for each in ([f"{part},"] if '"' in part else wrap(f"{part},", _ROOM))]
    return "\n                ".join(("(", *own)) + "\n            )"


def _is_exact_int(param: CommandParam) -> bool:
    """Return whether COMMAND_INT carries whole numbers of which the limits of COMMAND_LONG, floats, are others."""
    if param.number not in WHOLE_IN_INT or param.steps is not None:
        return False
    meant, floats = param.int_ends, (param.minimum, param.maximum)
    return any(
        end is not None and limit is not None and end != inward(limit)
        for end, limit, inward in zip(meant, floats, (math.ceil, math.floor), strict=True)
    )


def _further(param: CommandParam, numbers: Iterable[Fraction]) -> Iterator[str]:
    """The numbers that leave things as they are, and the ends of the argument, as far as there are any."""
    ends = param.whole_ends
    left = [*(["None"] if param.is_none_for_nan else []), *map(number_text, numbers)]
    if left or ends:
        yield f"({', '.join(left)}{',' if len(left) == 1 else ''})"
    if ends:
        yield f"({ends[0]}, {ends[1]})"


def _factor(scale: AffineMap) -> tuple[str, str]:
    if scale.ratio is None:
        return repr(scale.settled(Fraction(1), float)), "1"
    return str(scale.ratio.numerator), str(scale.ratio.denominator)


def _form(param: CommandParam) -> str:
    if not param.is_whole:
        return "_REAL"
    return "_ROUNDED" if param.is_rounded else "_WHOLE"


def _among(param: CommandParam) -> str:
    if param.enum is None:
        return "None"
    values = [entry.value for entry in param.enum.entries]
    if not param.enum.is_bitmask:
        return f"({', '.join(map(str, values))},)"
    mask = 0
    for value in values:
        mask |= value
    return str(mask)


def argument_text(param: CommandParam, value: Fraction) -> str:
    """An argument of the method as Python writes it."""
    return str(int(value)) if param.is_whole else repr(float(value))


def left_words(param: CommandParam) -> str:
    """``NaN and -1``: the numbers on the wire that leave things as they are, for people; empty for none."""
    words = [*(["NaN"] if param.is_none_for_nan else []), *map(number_text, param.left)]
    return " and ".join(words) if len(words) < 3 else f"{', '.join(words[:-1])} and {words[-1]}"


def number_text(value: Fraction) -> str:
    """A limit as Python writes it, whole where it is."""
    return str(value.numerator) if value.denominator == 1 else repr(float(value))


def method_views(program: Program) -> tuple[MethodView, ...]:
    """The methods that do the commands, each once; one that a failsafe calls, too, is written there."""
    by_method: dict[str, list[Command]] = {}
    for command in program.commands:
        by_method.setdefault(command.spec.method, []).append(command)
    calls = {action.call for action in program.actions}
    return tuple(view for name, each in by_method.items() if name not in calls for view in _methods(name, each))


def _methods(name: str, commands: list[Command]) -> Iterator[MethodView]:
    arguments = dict.fromkeys(", ".join(param.name for param in command.params) for command in commands)
    listed = next(iter(arguments)) if len(arguments) == 1 else "*arguments"
    noqa = "  # noqa: ARG002  code overrides it" if listed else ""
    head = f"{name}({', '.join(filter(None, ('self', listed)))}):{noqa}"
    yield MethodView(head, _indented([*_doc(commands), "return NotImplemented"]))
    if commands[0].spec.long:
        doc = (
            f'"""Return how far {name}() is, 0 to 100; at its end None or True, or False or a text where it failed."""'
        )
        yield MethodView(f"{name}_progress(self):", _indented([doc]))
        doc = f'"""End {name}() at once. Return None or True, or False or a text where it goes on."""'
        yield MethodView(f"{name}_cancel(self):", _indented([doc, "return NotImplemented"]))


def _indented(lines: Iterable[str]) -> tuple[str, ...]:
    return tuple(f"        {line}".rstrip() for line in lines)


def _doc(commands: list[Command]) -> Iterator[str]:
    """The lines of a docstring: the commands with their parameters, then what the method may return."""
    first, *others = (f"{prose(each.spec.doc)} {each.name}{_cited(each)}." for each in commands)
    yield f'"""{first}'
    yield ""
    for head, command in zip(("", *others), commands, strict=True):
        if head:
            yield head
        for param in command.params:
            unknown = "" if param.default is None else f", and {argument_text(param, param.default)} for NaN"
            unknown += f", and None for {left_words(param)}" if left_words(param) else ""
            doc = f": {prose(param.spec.doc)}" if param.spec.doc else ""
            yield f"`{param.name}` is {param.limits}{unknown}{doc}"
    is_long = commands[0].spec.long
    yield f"Return None or True {'once it is begun' if is_long else 'to accept it'}, False or a text to refuse it."
    yield "Until code overrides it, the command is unsupported."
    yield '"""'


def _cited(command: Command) -> str:
    return f" ({command.citation})" if command.citation else ""


def mode_views(modes: tuple[Mode, ...]) -> tuple[ModeView, ...]:
    """The modes by their numbers."""
    return tuple(ModeView(mode.number, prose(mode.name)) for mode in modes)


def mode_statements(modes: tuple[Mode, ...]) -> tuple[str, ...]:
    """The statements that set what is true of the vehicle in a mode."""
    quantities = {quantity.name: quantity for mode in modes for quantity in mode.base}
    found = []
    for name, quantity in quantities.items():
        numbers = [str(mode.number) for mode in modes if any(each.name == name for each in mode.base)]
        found.append(f"vehicle.{quantity.attribute} = mode in ({', '.join(numbers)},)")
    return tuple(found)
