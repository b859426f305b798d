"""Facts for checks of commands: values at the ends of parameters and beyond them, by exact arithmetic."""

import math
import struct
from collections.abc import Iterator
from fractions import Fraction
from itertools import islice

from codegen.frozen import dataclass
from codegen.model.command import WHOLE_IN_INT, Command, CommandParam, single
from codegen.model.dialect.dialect import EnumDefinition
from codegen.model.program import Program
from codegen.targets.firmware.program.commands import argument_text, title_of

_NAN, _INFINITE = "NAN", "INFINITE"


@dataclass(frozen=True, slots=True)
class CommandFacts:
    """A command as a dictionary of Python's text; see ``command_facts``."""

    entries: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class _Sample:
    """A value on the wire, and the argument that it is; both as Python writes them."""

    wire: str
    argument: str


def command_facts(program: Program) -> tuple[CommandFacts, ...]:
    """Each command of the project.

    ``good`` are the seven parameters and the arguments that are accepted, ``ends`` more of these, ``unknown`` those
    with NaN; ``beyond`` are parameters that are denied. ``as_int`` are the good parameters of a COMMAND_INT,
    ``frames`` those that it may have; none for any.
    """
    calls = {action.call for action in program.actions}
    armed = {"always": "None", "armed": "True", "disarmed": "False"}
    found = []
    for command in program.commands:
        good = {param.number: _ends(param)[0] for param in command.params}
        found.append(
            CommandFacts(
                (
                    ("name", f'"{command.name}"'),
                    ("number", str(command.number)),
                    ("method", f'"{command.spec.method}"'),
                    ("title", f'"{title_of(command)}"'),
                    ("armed", armed[command.spec.allowed.value]),
                    ("stations", str(command.spec.sender.value == "ground_station")),
                    ("long", str(command.spec.long)),
                    ("unwritten", str(command.spec.method not in calls)),
                    ("good", _call(command, good)),
                    ("ends", _listed(_call(command, good | each) for each in _each_end(command))),
                    ("unknown", _listed(_call(command, good | each) for each in _each_unknown(command))),
                    ("beyond", _listed(_params(good | each) for each in _each_beyond(command))),
                    ("frames", _listed(str(frame.value) for frame in command.frames)),
                    ("as_int", _params({param.number: _as_int(param, good) for param in command.params})),
                )
            )
        )
    return tuple(found)


def _listed(texts: Iterator[str]) -> str:
    return f"[{', '.join(texts)}]"


def _call(command: Command, samples: dict[int, _Sample]) -> str:
    """``((1.0, 0.0, ...), (1.0,))``: the parameters and the arguments in the order of the method."""
    arguments = "".join(f"{samples[param.number].argument}, " for param in command.params)
    return f"({_params(samples)}, ({arguments.strip()}))"


def _params(samples: dict[int, _Sample]) -> str:
    return f"({', '.join(samples[number].wire if number in samples else '0.0' for number in range(1, 8))})"


def _each_end(command: Command) -> Iterator[dict[int, _Sample]]:
    return ({param.number: sample} for param in command.params for sample in _ends(param))


def _each_unknown(command: Command) -> Iterator[dict[int, _Sample]]:
    for param in command.params:
        if param.default is not None:
            yield {param.number: _Sample(_NAN, argument_text(param, param.default))}
        elif param.is_none_for_nan:
            yield {param.number: _Sample(_NAN, "None")}
        for number in param.left:
            yield {param.number: _Sample(repr(float(number)), "None")}


def _each_beyond(command: Command) -> Iterator[dict[int, _Sample]]:
    for param in command.params:
        for wire in _beyond(param):
            yield {param.number: _Sample(wire, "None")}


def _ends(param: CommandParam) -> list[_Sample]:
    """The smallest and the largest value, as far as there are any that a float of 32 bits is exactly; at least one."""
    if param.enum is not None:
        values = [Fraction(each) for each in _carried(param.enum) if _is_within(param, Fraction(each))]
        values = [each for each in values if each not in param.left] or values
        return [_sample(param, values[0]), _sample(param, values[-1])]
    ends = [end for end in (param.minimum, param.maximum) if end is not None]
    usable = [end for end in ends if _is_usable(param, end)]
    if usable:
        return [_sample(param, end) for end in usable]
    within = (value for value in _between(param) if _is_within(param, value) and _is_usable(param, value))
    return [_sample(param, next(within))]


def _between(param: CommandParam) -> Iterator[Fraction]:
    """Values that may be accepted: whole arguments near one of the ends, which stand on the wire as they are."""
    start = param.minimum if param.minimum is not None else param.maximum or Fraction(0)
    ratio = param.scale.ratio or Fraction(1)
    first = math.floor(start * ratio)
    yield Fraction(0)
    for step in range(100000):
        yield Fraction(first + step) / ratio
        yield Fraction(first - step) / ratio


def _is_within(param: CommandParam, value: Fraction) -> bool:
    low = param.minimum is None or value >= param.minimum
    return low and (param.maximum is None or value <= param.maximum)


def _is_usable(param: CommandParam, wire: Fraction) -> bool:
    """Return whether a value stands on the wire as it is, and where the argument
    has to be whole is a whole one there.
    """
    if wire in param.left:
        return False
    if not param.is_whole or param.is_rounded:
        return single(wire) == wire
    argument = param.scale.exact(wire)
    return single(wire) == wire and argument is not None and argument.denominator == 1


def _sample(param: CommandParam, wire: Fraction) -> _Sample:
    argument = param.scale.settled(wire, float)
    if param.whole_ends is not None:
        low, high = param.whole_ends
        argument = min(max(round(argument), low), high)
    text = str(round(argument)) if param.is_whole else repr(argument)
    return _Sample(repr(float(wire)), text)


def _values(enum: EnumDefinition) -> list[int]:
    """The values of an enum in their order, of a bitmask 0 and all its flags."""
    values = sorted(entry.value for entry in enum.entries)
    if not enum.is_bitmask:
        return values
    mask = 0
    for value in values:
        mask |= value
    return [0, mask]


def _carried(enum: EnumDefinition) -> list[int]:
    """The same as far as floats of 32 bits are these; of more flags than those have room for the highest."""
    if not enum.is_bitmask:
        return [value for value in _values(enum) if single(Fraction(value)) == value]
    mask = _values(enum)[-1]
    while single(Fraction(mask)) != mask:
        mask &= mask - 1  # without its lowest flag
    return [0, mask]


def _beyond(param: CommandParam) -> Iterator[str]:
    for end, up in ((param.minimum, False), (param.maximum, True)):
        if end is not None and math.isfinite(_beside(end, up=up)):
            beside = _beside(end, up=up)
            if Fraction(beside) not in param.left:
                yield repr(beside)
            if param.is_whole and not param.is_rounded and param.enum is None:
                yield from _whole_beside(param, end, up=up)
    if param.default is None and not param.is_none_for_nan:
        yield _NAN
    yield _INFINITE
    yield f"-{_INFINITE}"
    if param.enum is not None:
        tried = (1 << bit for bit in range(64)) if param.enum.is_bitmask else range(1 << 20)
        yield from (repr(float(each)) for each in islice((one for one in tried if not _has(param.enum, one)), 1))
    if param.is_whole and not param.is_rounded and param.scale.ratio == 1:
        fraction = _fraction(param)
        if fraction is not None:
            yield repr(float(fraction))


def _whole_beside(param: CommandParam, end: Fraction, *, up: bool) -> Iterator[str]:
    """The next value beyond an end of which the argument is whole, where a float of 32 bits is it."""
    ratio = param.scale.ratio or Fraction(1)
    argument = math.floor(end * ratio) + 1 if up else math.ceil(end * ratio) - 1
    beside = Fraction(argument) / ratio
    if single(beside) == beside and beside not in param.left:
        yield repr(float(beside))


def _fraction(param: CommandParam) -> Fraction | None:
    """A number with a fraction that a float of 32 bits is, within the limits; None where these are all whole ones."""
    near = (Fraction(end) + side for end in (_ends(param)[0].wire, "0") for side in (Fraction(1, 2), Fraction(-1, 2)))
    return next((each for each in near if _is_within(param, each) and single(each) == each), None)


def _has(enum: EnumDefinition, value: int) -> bool:
    values = _values(enum)
    return not value & ~values[-1] if enum.is_bitmask else value in values


def _as_int(param: CommandParam, good: dict[int, _Sample]) -> _Sample:
    """The good value in a COMMAND_INT: x and y are whole, of a position and what else is multiplied as well."""
    sample = good[param.number]
    if param.steps is not None:
        low, high = param.int_ends
        sent = Fraction(round(Fraction(sample.wire) * param.steps))
        sent = sent if low is None else max(sent, low)
        return _Sample(str(sent if high is None else min(sent, high)), sample.argument)
    if param.number in WHOLE_IN_INT and param.is_whole and param.scale.ratio == 1:
        return _Sample(sample.argument, sample.argument)
    if param.number in WHOLE_IN_INT:
        return _Sample(str(math.floor(float(sample.wire))), sample.argument)
    return sample


def _beside(value: Fraction, *, up: bool) -> float:
    """The next float of 32 bits, of 0 one that is large enough to be written."""
    if value == 0:
        return float(single(Fraction(1 if up else -1, 10**6)))
    bits = struct.unpack("<i", struct.pack("<f", value))[0]
    bits += 1 if up == (bits > 0) else -1
    return float(struct.unpack("<f", struct.pack("<i", bits))[0])
