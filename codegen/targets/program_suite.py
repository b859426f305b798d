"""The generated tests of the program: facts of the specification in one module, checks that read them, and a runner."""

from codegen.frozen import dataclass
from codegen.model.program import Program
from codegen.model.system import System
from codegen.model.vehicle import Component, Conversion, Parameter, by_instance
from codegen.targets.check_criteria import check_criteria
from codegen.targets.component_facts import ComponentFacts, component_facts
from codegen.targets.failsafe_facts import PairFacts, WatchFacts, pair_facts, watch_facts
from codegen.targets.firmware.board import ReaderView, board_view
from codegen.targets.firmware.failsafe import failsafe_views
from codegen.targets.firmware.parameters import ParameterView, parameter_views
from codegen.targets.firmware.program import ProgramView, program_view
from codegen.targets.firmware.streams import StreamsView, streams_view
from codegen.targets.firmware.words import word_layout
from codegen.targets.generation_facts import (
    GenerationFacts,
    MessageFacts,
    generation_facts,
    message_facts,
    shared_facts,
)
from codegen.targets.naming import parameter_attribute
from codegen.targets.origin import copied_files, headed, origin_of
from codegen.targets.rendered import rendered
from codegen.targets.withheld import KnownWord, known_words, withheld_messages

_PROGRAM = "tests/program"

LEFT_TO_THE_PROJECT = ("tests/day_checks.py", "tests/heap_checks.py")
"""What a further program's suite does without: it takes long, and is about modules that all programs share."""


@dataclass(frozen=True, slots=True)
class MeasuredFamilies:
    """Attributes of the parameters that each instance of a measured component has of its own, by instance."""

    pin: tuple[str, ...]
    multiplier: tuple[str, ...]
    enabled_by: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class InputView:
    """Where an instance is read by default, and whether it is measured at all."""

    gpio: int
    is_on: bool


@dataclass(frozen=True, slots=True)
class ProgramSuiteView:
    """What the checks of the program compare with; ``criteria`` are those of each aspect of the checks."""

    program: ProgramView
    pairs: tuple[PairFacts, ...]
    watched: tuple[WatchFacts, ...]
    components: tuple[ComponentFacts, ...]
    readers: tuple[ReaderView, ...]
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
    withheld: dict[int, tuple[tuple[str, str], ...]]
    criteria: dict[str, tuple[str, ...]]


def render_program_suite(system: System, program: Program) -> dict[str, str]:
    """The files below ``tests/`` that are about the program."""
    files = {path.replace(_PROGRAM, "tests"): text for path, text in copied_files(_PROGRAM).items()}
    if system.spec.program:
        files = {path: text for path, text in files.items() if path not in LEFT_TO_THE_PROJECT}
    streams = streams_view(system)
    alone = [message for message in streams.messages if message.is_alone]
    streamed = {message.id for stream in streams.streams for message in stream.messages}
    view = ProgramSuiteView(
        program=program_view(system, program, failsafe_views(system, program, word_layout(system))),
        pairs=pair_facts(system, program),
        watched=watch_facts(system, program),
        components=tuple(component for component in component_facts(system) if component.measured),
        readers=board_view(system).readers,
        parameters=parameter_views(system),
        streams=streams,
        sent=tuple(message.id for message in alone),
        on_request=[message.id for message in alone if message.id not in streamed],
        shortest_us=tuple(message.shortest_us for message in alone),
        families={name: _families(system.components[name], each) for name, _, each in system.measured()},
        inputs={name: _inputs(system, system.components[name], each) for name, _, each in system.measured()},
        generations=generation_facts(system),
        messages=message_facts(system),
        shared=shared_facts(system),
        known=known_words(system),
        withheld={each.id: each.quantities for each in withheld_messages(system) if each.is_alone and each.is_on},
        criteria=check_criteria(system, program),
    )
    origin = origin_of(system, [path for path in system.spec.files if not path.endswith(".md")])
    text = rendered(f"{_PROGRAM}/program_facts.py.j2", view)
    files["tests/program_facts.py"] = headed(text, origin)
    return files


def _families(component: Component, conversion: Conversion) -> MeasuredFamilies:
    return MeasuredFamilies(
        pin=_attributes(conversion.channel.pin),
        multiplier=_attributes(conversion.multiplier),
        enabled_by=_attributes(component.switch),
    )


def _inputs(system: System, component: Component, conversion: Conversion) -> tuple[InputView, ...]:
    gpios = system.gpios(component, conversion.channel)
    switch = component.switch
    switches = by_instance(switch, system.parameters, component.instances) if switch else (None,) * len(gpios)
    return tuple(InputView(gpio, each is None or each.default != 0) for gpio, each in zip(gpios, switches, strict=True))


def _attributes(parameter: Parameter | None) -> tuple[str, ...]:
    return tuple(map(parameter_attribute, parameter.siblings)) if parameter else ()
