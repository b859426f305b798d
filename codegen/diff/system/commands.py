"""Subjects of the commands that the vehicle is given, and of its modes."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.subject import Fact, Subject, amount, cited
from codegen.diff.system.trace_rules import CITATION, DOC
from codegen.model.command import BuiltInCommand, Command, CommandParam, Mode
from codegen.model.program import Program
from codegen.model.units.unit import map_words

_BASE = "whether stations are to be told of other flags in this mode"


def command_subjects(program: Program) -> Iterator[Subject]:
    """The commands of the project, those that the program answers by itself, and the modes."""
    yield from (_command(command) for command in program.commands)
    yield from (_built_in(command, program) for command in program.built_in)
    yield from (_mode(mode) for mode in program.modes)


def _command(command: Command) -> Subject:
    spec = command.spec
    citations = ", ".join(f"{name} {citation}" for name, citation in sorted(command.aspects.items()))
    facts = (
        Fact("called", command.name, rules.COMMAND, spec.place),
        Fact("by", f"{spec.method}({', '.join(param.name for param in command.params)})", rules.COMMAND, spec.place),
        Fact("allowed", spec.allowed.value, rules.COMMAND, spec.at("allowed")),
        Fact("from", spec.sender.value, rules.COMMAND, spec.at("from")),
        Fact("frames", ", ".join(frame.name for frame in command.frames), rules.COMMAND_UNIT, spec.at("frames")),
        Fact("takes long", "yes" if spec.long else "", rules.COMMAND, spec.at("long")),
        *(fact for param in command.params for fact in _param(param)),
        Fact("answers to", str(command.citation or ""), CITATION, spec.at("requirement")),
        Fact("aspects answer to", citations, CITATION, spec.at("criteria")),
        Fact("doc", spec.doc, DOC, spec.at("doc")),
    )
    name = command.name
    says = f"number {command.number}, done by {spec.method}()"
    citation = cited(command.citation, command.aspects)
    added, removed = rules.COMMAND_ADDED, rules.COMMAND_REMOVED
    # Who gives a command sends its number.
    return Subject(name, says, added, removed, spec.place, facts, citation, row=name, key=f"command {command.number}")


def _param(param: CommandParam) -> Iterator[Fact]:
    spec, at = param.spec, f"parameter {param.number}"
    accepted = (
        "" if param.minimum is None else f"from {amount(param.minimum, param.wire_unit.name)}",
        "" if param.maximum is None else f"to {amount(param.maximum, param.wire_unit.name)}",
        f"whole {param.unit.name}" if param.is_whole else "",
        f"{param.enum.name}: {', '.join(str(each.value) for each in param.enum.entries)}" if param.enum else "",
    )
    # On the wire, where the same limit is the same number in whatever unit the argument is.
    yield Fact(f"{at} accepts", ", ".join(filter(None, accepted)), rules.COMMAND_RANGE, spec.place, param.limits)
    ends = " to ".join(_on_the_wire(end, param) for end in param.ends)
    yield Fact(f"{at} is from", ends, rules.COMMAND_RANGE, spec.place, param.limits)
    said = "" if param.default is None else amount(param.default, param.unit.name)
    yield Fact(f"{at} for NaN", _on_the_wire(param.default, param), rules.COMMAND_RANGE, spec.at("default"), said)
    yield Fact(f"{at} left as it is by", _left(param), rules.COMMAND_UNIT, spec.at("unchanged"))
    unit = param.wire_unit.name or "a number"
    position = f", {param.axis.name.lower()}" if param.axis else ""
    position += ", an altitude" if param.is_altitude else ""
    position += "" if param.steps is None else f", in COMMAND_INT {amount(param.steps)} to one"
    yield Fact(f"{at} in", f"{unit}{position}", rules.COMMAND_UNIT, spec.at("unit"))
    yield Fact(
        f"{at} is given as", f"{param.name} {map_words(param.scale)} {param.unit.name}", rules.COMMAND, spec.place
    )
    yield Fact(f"{at} doc", spec.doc or "", DOC, spec.at("doc"))


def _on_the_wire(number: Fraction | None, param: CommandParam) -> str:
    """An argument in the unit that it arrives in, where that is a multiple; empty where there is none."""
    ratio = param.scale.ratio
    if number is None:
        return ""
    return amount(number, param.unit.name) if ratio is None else amount(number / ratio, param.wire_unit.name)


def _left(param: CommandParam) -> str:
    return ", ".join([*(["NaN"] if param.is_none_for_nan else []), *(amount(number) for number in param.left)])


def _built_in(command: BuiltInCommand, program: Program) -> Subject:
    return Subject(command.name, command.doc, rules.COMMAND_ADDED, rules.COMMAND_REMOVED, program.spec.place, ())


def _mode(mode: Mode) -> Subject:
    spec = mode.spec
    facts = (
        Fact("name", mode.name, rules.MODE, spec.at("name")),
        Fact(
            "true in it", ", ".join(quantity.path for quantity in mode.base), rules.MODE, spec.at("base"), doubt=_BASE
        ),
        Fact("answers to", str(mode.citation or ""), CITATION, spec.at("requirement")),
        Fact("doc", spec.doc, DOC, spec.at("doc")),
    )
    citation = cited(mode.citation)
    added, removed = rules.MODE_ADDED, rules.MODE_REMOVED
    return Subject(f"mode {mode.number}", mode.name, added, removed, spec.place, facts, citation, row=mode.name)
