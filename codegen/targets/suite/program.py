"""The generated tests of the program: facts of the specification in one module, checks that read them, and a runner."""

from codegen.frozen import dataclass
from codegen.model.armed_flag import armed_flag
from codegen.model.command import Needs
from codegen.model.program import LinkKind, Program
from codegen.model.quantities.conversion import Conversion
from codegen.model.system import System
from codegen.model.vehicle import Component, Parameter, Reading, by_instance
from codegen.render.rendered import rendered
from codegen.targets.firmware.failsafes.failsafe import failsafe_views
from codegen.targets.firmware.messages.streams import StreamsView, streams_view
from codegen.targets.firmware.program.parameters import ParameterView, parameter_views
from codegen.targets.firmware.program.program import ProgramView, program_view
from codegen.targets.firmware.readings.board import ReaderView, plain_readers
from codegen.targets.firmware.words import word_layout
from codegen.targets.imports import one_by_one, tuple_text
from codegen.targets.naming import parameter_attribute
from codegen.targets.origin import copied_files, headed, origin_of
from codegen.targets.suite.criteria import check_criteria
from codegen.targets.suite.facts.calm_inputs import CalmInput, calm_inputs
from codegen.targets.suite.facts.commands import CommandFacts, command_facts
from codegen.targets.suite.facts.components import ComponentFacts, component_facts
from codegen.targets.suite.facts.failsafes import PairFacts, WatchFacts, pair_facts, watch_facts
from codegen.targets.suite.facts.generations import (
    GenerationFacts,
    MessageFacts,
    generation_facts,
    message_facts,
    shared_facts,
)
from codegen.targets.suite.facts.links import LinkFacts, link_facts
from codegen.targets.suite.withheld import KnownWord, known_words, withheld_messages

_PROGRAM = "tests/program"
_TCP = (LinkKind.TCP_SERVER, LinkKind.TCP_CLIENT)

COMMAND_CHECKS = "tests/command_checks.py"
"""Checks of commands and modes of the project's own."""

ACCESS_CHECKS = "tests/access_checks.py"
"""Checks of signed and listed links."""

TWIN_CHECKS = "tests/twin_checks.py"
"""Checks where a parameter gives the component id: two of the program can have the same one."""

BYTEWISE_CHECKS = "tests/bytewise_checks.py"
"""Checks where parameters go over the wire as the bytes of their types."""

WATCHDOG_CHECKS = "tests/watchdog_checks.py"
"""Checks of the watchdog."""

TCP_CHECKS = "tests/tcp_checks.py"
"""Checks of connections over TCP."""

LEFT_TO_THE_PROJECT = ("tests/day_checks.py", "tests/heap_checks.py")
"""Checks that a further program's suite does without: long ones, of modules that all programs share."""


@dataclass(frozen=True, slots=True)
class MeasuredFamilies:
    """Attributes of the parameters that each instance of a measured component has of its own, by instance."""

    pin: tuple[str, ...]
    multiplier: tuple[str, ...]
    enabled_by: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class InputView:
    """The default input of an instance, and whether it is measured at all."""

    gpio: int
    is_on: bool


@dataclass(frozen=True, slots=True)
class AccessFacts:
    """The links of each kind, the system ids of listed stations, and the file of the key; tuples as Python has them."""

    signed: str
    listed: str
    stations: str
    setup: str
    key: str


@dataclass(frozen=True, slots=True)
class ProgramSuiteView:
    """The expected values of the checks of the program; ``criteria`` are those of each aspect of the checks."""

    program: ProgramView
    pairs: tuple[PairFacts, ...]
    watched: tuple[WatchFacts, ...]
    components: tuple[ComponentFacts, ...]
    readers: tuple[ReaderView, ...]
    calm: tuple[CalmInput, ...]
    parameters: tuple[ParameterView, ...]
    streams: StreamsView
    sent: tuple[int, ...]
    on_request: list[int]
    shortest_us: tuple[int, ...]
    families: dict[str, MeasuredFamilies]
    inputs: dict[str, tuple[InputView, ...]]
    generations: tuple[GenerationFacts, ...]
    messages: tuple[MessageFacts, ...]
    shared: dict[int, tuple[MessageFacts, ...]]
    known: tuple[KnownWord, ...]
    withheld: dict[int, tuple[str, ...]]
    access: "AccessFacts | None"
    criteria: dict[str, tuple[str, ...]]
    answered: tuple[int, ...]
    absent: tuple[tuple[int, int], ...]
    links: tuple[LinkFacts, ...]
    told_armed: tuple[bool, bool] | None


@dataclass(frozen=True, slots=True)
class ModeFacts:
    """A mode, what it is called, and the attributes of the vehicle that are true in it."""

    number: int
    name: str
    base: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class CommandSuiteView:
    """The expected values of the checks of commands and modes."""

    commands: tuple[CommandFacts, ...]
    modes: tuple[ModeFacts, ...]
    mode_flags: tuple[str, ...]


def left_out(system: System, program: Program) -> tuple[str, ...]:
    """The files of the suite that are about nothing here."""
    has_commands = program.commands or program.modes
    guards = program.access is not None and (program.access.signed or program.access.listed)
    return (
        *(LEFT_TO_THE_PROJECT if system.spec.program else ()),
        *(() if has_commands else (COMMAND_CHECKS,)),
        *(() if guards else (ACCESS_CHECKS,)),
        *(() if system.component_parameter else (TWIN_CHECKS,)),
        *(() if system.is_bytewise else (BYTEWISE_CHECKS,)),
        *(() if program.watchdog else (WATCHDOG_CHECKS,)),
        *(() if any(link.kind in _TCP for link in system.links) else (TCP_CHECKS,)),
    )


def render_program_suite(system: System, program: Program) -> dict[str, str]:
    """The files below ``tests/`` that are about the program."""
    files = {path.replace(_PROGRAM, "tests"): text for path, text in copied_files(_PROGRAM).items()}
    files = {path: text for path, text in files.items() if path not in left_out(system, program)}
    streams = streams_view(system)
    alone = [message for message in streams.messages if message.is_alone]
    streamed = {message.id for stream in streams.streams for message in stream.messages}
    layout = word_layout(system)
    view = ProgramSuiteView(
        program=program_view(system, program, failsafe_views(system, program, layout), layout),
        pairs=pair_facts(system, program),
        watched=watch_facts(program),
        components=tuple(component for component in component_facts(system) if component.measured),
        readers=plain_readers(system),
        calm=calm_inputs(system),
        parameters=parameter_views(system),
        streams=streams,
        sent=tuple(message.id for message in alone),
        on_request=[message.id for message in alone if message.id not in streamed],
        shortest_us=tuple(message.shortest_us for message in alone),
        families={each.component.name: _families(each) for each in _first(system)},
        inputs={each.component.name: _inputs(system, each.component, each.conversion) for each in _first(system)},
        generations=generation_facts(system),
        messages=message_facts(system),
        shared=shared_facts(system),
        known=known_words(system),
        withheld=_withheld_lines(system),
        access=_access(program),
        criteria=check_criteria(system, program),
        answered=_answered(program),
        absent=tuple((each.question.id, each.answer.id) for each in program.absences),
        links=link_facts(system),
        told_armed=armed_flag([message for message in system.messages if message.stream]),
    )
    origin = origin_of(system, [path for path in system.spec.files if not path.endswith(".md")])
    text = rendered(f"{_PROGRAM}/program_facts.py.j2", view)
    files["tests/program_facts.py"] = headed(text, origin)
    if program.commands or program.modes:
        text = rendered(f"{_PROGRAM}/command_facts.py.j2", _command_view(program))
        files["tests/command_facts.py"] = headed(text, origin)
    return files


def _access(program: Program) -> AccessFacts | None:
    if program.access is None:
        return None
    spec = program.access.spec
    return AccessFacts(
        signed=tuple_text(tuple(program.access.signed)),
        listed=tuple_text(program.access.listed),
        stations=tuple_text(spec.stations),
        setup=tuple_text(spec.setup),
        key=spec.key,
    )


def _answered(program: Program) -> tuple[int, ...]:
    """The numbers of the commands that not every program answers, beside arming."""
    modes = [program.constants[each.name] for each in program.built_in if each.needs is Needs.MODES]
    return (*(command.number for command in program.commands), *modes)


def _command_view(program: Program) -> CommandSuiteView:
    base = [quantity.attribute for mode in program.modes for quantity in mode.base]
    return CommandSuiteView(
        commands=command_facts(program),
        modes=tuple(
            ModeFacts(mode.number, mode.name, tuple(quantity.attribute for quantity in mode.base))
            for mode in program.modes
        ),
        mode_flags=tuple(dict.fromkeys(base)),
    )


def _withheld_lines(system: System) -> dict[int, tuple[str, ...]]:
    """Return by message the quantities that withhold it, as lines of a table."""
    return {
        each.id: tuple(
            one_by_one(f"    {each.id}: ", (f'("{owner}", "{name}")' for owner, name in each.causes), ",", "[]")
        )
        for each in withheld_messages(system)
        if each.is_alone and each.is_on
    }


def _first(system: System) -> list[Reading]:
    """The first reading of each component."""
    return [reading for reading in system.readings() if reading.is_first]


def _families(reading: Reading) -> MeasuredFamilies:
    component, conversion = reading.component, reading.conversion
    return MeasuredFamilies(
        pin=_attributes(conversion.channel.pin),
        multiplier=_attributes(conversion.multiplier if isinstance(conversion.multiplier, Parameter) else None),
        enabled_by=_attributes(component.switch),
    )


def _inputs(system: System, component: Component, conversion: Conversion) -> tuple[InputView, ...]:
    gpios = system.gpios(component, conversion.channel)
    switch = component.switch
    switches = by_instance(switch, system.parameters, component.instances) if switch else (None,) * len(gpios)
    represented = component.readings[0].quantity.derivation.represented
    setting = by_instance(represented.parameter, system.parameters, component.instances) if represented else ()
    by_code = [each.default == represented.steps for each in setting] if represented else [False] * len(gpios)
    return tuple(
        InputView(gpio, (each is None or each.default != 0) and not is_set)
        for gpio, each, is_set in zip(gpios, switches, by_code, strict=True)
    )


def _attributes(parameter: Parameter | None) -> tuple[str, ...]:
    return tuple(map(parameter_attribute, parameter.siblings)) if parameter else ()
