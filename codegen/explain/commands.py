"""Explains a command or a mode."""

from collections.abc import Iterator

from codegen.explain.corrections import correction_facts
from codegen.model.command import BuiltInCommand, Command, CommandParam, Mode
from codegen.model.dialect.dialect import Dialect, EnumEntry
from codegen.model.system import System
from codegen.model.units.unit import decimal, map_words
from codegen.model.vehicle import Citation
from codegen.targets.firmware.program.commands import left_words

Story = tuple[str, str, list[tuple[str, str]]]
"""Its name, its purpose, and facts with their names."""


def command_story(topic: str, system: System) -> Story | None:
    """The story of a command that the vehicle answers, or of a mode; None of neither."""
    program = system.program
    for mode in program.modes if program else ():
        if topic == mode.name:
            return _mode(mode)
    enum = system.dialect.enums.get("MAV_CMD")
    entry = enum.entry(topic) if enum else None
    if entry is None:
        return None
    for command in program.commands if program else ():
        if command.name == topic:
            return _command(command, system.dialect)
    for built_in in program.built_in if program else ():
        if built_in.name == topic:
            return _built_in(built_in, entry)
    return None


def unanswered_command_story(topic: str, system: System) -> Story | None:
    """The story of a command of the dialect that the vehicle does not answer; None where there is none of the name."""
    enum = system.dialect.enums.get("MAV_CMD")
    entry = enum.entry(topic) if enum else None
    return None if entry is None else _unknown(entry, system.dialect)


def command_topics(system: System) -> list[str]:
    """The names of the commands of the dialect, and of the modes."""
    enum = system.dialect.enums.get("MAV_CMD")
    modes = system.program.modes if system.program else ()
    return [*(entry.name for entry in (enum.entries if enum else ())), *(mode.name for mode in modes)]


def _command(command: Command, dialect: Dialect) -> Story:
    spec = command.spec
    method = f"{spec.method}({', '.join(param.name for param in command.params)})"
    facts = [
        ("done by", f"{method} of the vehicle, which code overrides"),
        *(fact for param in command.params for fact in _param(param, command, dialect)),
        ("frames", ", ".join(frame.name for frame in command.frames)),
        ("allowed", spec.allowed.value),
        ("from", spec.sender.value.replace("_", " ")),
        ("takes long", f"{spec.method}_progress() and {spec.method}_cancel() go with it" if spec.long else ""),
        ("criterion", _cited(command.citation)),
        *(("criterion", f"{aspect}: {_cited(citation)}") for aspect, citation in command.aspects.items()),
        ("declared at", spec.place.shown()),
    ]
    return f"{command.name} ({command.number})", spec.doc, facts


def _param(param: CommandParam, command: Command, dialect: Dialect) -> Iterator[tuple[str, str]]:
    words = [f"{param.name} is {param.limits}"]
    if param.scale.ratio != 1:
        words.append(f"on the wire {param.wire_unit.name} {map_words(param.scale)}")
    if param.axis is not None:
        words.append("in COMMAND_INT 1e-7 degrees")
    elif param.steps is not None:
        words.append(f"in COMMAND_INT multiplied by {decimal(param.steps)}")
    if not param.is_none_for_nan:
        words.append("NaN is denied" if param.default is None else f"{decimal(param.default)} for NaN")
    words += [f"None for {left_words(param)}, which leaves it as it is"] if left_words(param) else []
    yield f"param {param.number}", ", ".join(words)
    yield from correction_facts(dialect, command.name, str(param.number))


def _built_in(command: BuiltInCommand, entry: EnumEntry) -> Story:
    return f"{command.name} ({entry.value})", command.doc, [("answered", command.configured)]


def _unknown(entry: EnumEntry, dialect: Dialect) -> Story:
    params = [
        fact
        for param in entry.parameters
        if param.description not in ("", "Empty", "Reserved")
        for fact in (
            (f"param {param.number}", f"{dict(param.attributes).get('label', '')} {param.description}".strip()),
            *correction_facts(dialect, entry.name, param.number),
        )
    ]
    answer = ("answered", "MAV_RESULT_UNSUPPORTED; an entry of commands.yaml lets a method of the vehicle do it")
    return f"{entry.name} ({entry.value})", entry.description, [*params, answer]


def _mode(mode: Mode) -> Story:
    facts = [
        ("custom_mode", str(mode.number)),
        ("true in it", ", ".join(quantity.path for quantity in mode.base)),
        ("criterion", _cited(mode.citation)),
        ("declared at", mode.spec.place.shown()),
    ]
    return f"{mode.name} (mode {mode.number})", mode.spec.doc, facts


def _cited(citation: Citation | None) -> str:
    if citation is None:
        return ""
    text = citation.criterion.text if citation.criterion else citation.requirement.title
    return f"{citation}: {text}"
