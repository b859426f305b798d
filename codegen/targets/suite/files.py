"""The generated test suite: cases as data, one runner for every interpreter, and the comparison with pymavlink."""

from codegen.frozen import dataclass
from codegen.model.code.clock import CLOCK
from codegen.model.program_folders import COMMON, is_one_of_several
from codegen.model.system import System
from codegen.render.rendered import rendered
from codegen.targets.firmware.messages.streams import StreamView, stream_views
from codegen.targets.firmware.program.parameters import ParameterView, parameter_views
from codegen.targets.firmware.readings.board import BoardView, ReaderView, board_view, plain_readers
from codegen.targets.firmware.words import aged_words, word_layout
from codegen.targets.naming import parameter_attribute
from codegen.targets.origin import Origin, copied_files, headed, origin_of, origin_of_text
from codegen.targets.suite.amounts.file import render_amount_suite
from codegen.targets.suite.behaviour import BehaviourCheck, SharedMessage, behaviour_checks, shared_messages
from codegen.targets.suite.cases.file import cases_text
from codegen.targets.suite.facts.components import ComponentFacts, component_facts
from codegen.targets.suite.facts.counterparts import counterparts_view
from codegen.targets.suite.facts.readings import ReadingFacts, reading_facts
from codegen.targets.suite.program import render_program_suite
from codegen.targets.suite.receptions import render_reception_suite
from codegen.targets.suite.sources import render_source_suite
from codegen.targets.suite.withheld import KnownWord, WithheldMessage, known_words, withheld_messages

_INTERPRETERS = "tests/interpreters.py"
_COUNTERPARTS = "tests/counterparts_facts.py"
RENDERED = ("behaviour.py", "test_frames.py")


@dataclass(frozen=True, slots=True)
class SuiteView:
    """The data for the templates of the suite."""

    system_id: int
    component_id: int
    board: BoardView
    components: tuple[ComponentFacts, ...]
    measured: tuple[ComponentFacts, ...]
    readers: tuple[ReaderView, ...]
    readings: tuple[ReadingFacts, ...]
    builders: tuple[str, ...]
    streams: tuple[StreamView, ...]
    looks_per_s: int
    shared: tuple[SharedMessage, ...]
    withheld: tuple[WithheldMessage, ...]
    known: tuple[KnownWord, ...]
    choosers: tuple[str, ...]
    has_program: bool
    parameters: tuple[ParameterView, ...]
    checks: tuple[BehaviourCheck, ...]
    expiring: dict[str, tuple[str, ...]]
    ageing: dict[str, tuple[str, ...]]
    aged: int
    clocked: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class FoldersView:
    """The folders in which the suite finds the firmware, the mocks and itself.

    ``common`` is the folder of what all programs of the project have alike, empty where there is one program. It lies
    in the parent of number ``above`` of the suite: 0 is that which the suite lies in.
    """

    common: str
    above: int


def render_suite(system: System) -> dict[str, str]:
    """The files below ``tests/``."""
    origin = suite_origin(system)
    about: dict[str, object] = {"from": list(origin.sources), "inputs": origin.digest}
    files = {**copied_files("tests"), "tests/cases.json": cases_text(system, about)}
    board, components, streams = board_view(system), component_facts(system), stream_views(system)
    shared, withheld = shared_messages(system), withheld_messages(system)
    measured = tuple(component for component in components if component.measured)
    readings = reading_facts(system)
    view = SuiteView(
        system_id=system.system_id,
        component_id=system.component_id,
        board=board,
        components=components,
        measured=measured,
        readers=plain_readers(system),
        readings=readings,
        builders=tuple(message.name.lower() for message in system.messages),
        streams=streams,
        looks_per_s=100 if all(stream.fastest_hz <= 50 for stream in streams) else 400,
        shared=shared,
        withheld=withheld,
        known=known_words(system),
        choosers=tuple(parameter_attribute(each.parameter.name) for each in system.generations if each.parameter),
        has_program=system.program is not None,
        parameters=parameter_views(system),
        checks=behaviour_checks(plain_readers(system), readings, streams, components, shared, withheld),
        aged=len(tuple(aged_words(word_layout(system)))),
        ageing={path: _ageing(path, system) for path in _aging_paths(system)},
        expiring={component.name: _readers(component.name, system) for component in components},
        clocked=_readers(CLOCK, system),
    )
    common = COMMON if is_one_of_several(system.spec) else ""
    folders = rendered(f"{_INTERPRETERS}.j2", FoldersView(common, above=1 if system.spec.program else 0))
    files[_INTERPRETERS] = headed(folders, origin_of_text(f"templates/{_INTERPRETERS}.j2", folders))
    if not readings:
        del files["tests/single_readings.py"]
    for name in RENDERED:
        files[f"tests/{name}"] = headed(rendered(f"tests/{name}.j2", view), origin)
    drawn = rendered(f"{_COUNTERPARTS}.j2", counterparts_view(system, components, readings))
    files[_COUNTERPARTS] = headed(drawn, origin)
    files |= render_source_suite(system)
    files |= render_amount_suite(system)
    files |= render_reception_suite(system)
    return files if system.program is None else files | render_program_suite(system, system.program)


def suite_origin(system: System) -> Origin:
    """Return what the suite is made of: everything but the documents, and the messages that are sent."""
    wires = [message.wire for message in system.messages]
    return origin_of(system, [path for path in system.spec.files if not path.endswith(".md")], wires)


def _aging_paths(system: System) -> list[str]:
    """The quantities that are forgotten once code has not set them for a while."""
    quantities = (quantity for component in system.components.values() for quantity in component.quantities.values())
    return [quantity.path for quantity in quantities if quantity.ages]


def _ageing(path: str, system: System) -> tuple[str, ...]:
    """The messages, in lower case, whose builders read a quantity of the first instance and notice its age."""
    return tuple(
        message.name.lower()
        for message in system.messages
        if path.partition(".")[0] not in message.represents
        and any(quantity.decided_by == path for answer in message.answers for quantity in answer.quantities)
    )


def _readers(component: str, system: System) -> tuple[str, ...]:
    """The messages, in lower case, whose builders read a component and so notice that it went stale."""
    return tuple(
        message.name.lower()
        for message in system.messages
        if any(quantity.component == component for answer in message.answers for quantity in answer.quantities)
    )
