"""The program that the board runs: main loop, storage, arming and what failsafes do."""

from collections.abc import Iterator, Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.measure import read_rate, read_time
from codegen.model.access import Access
from codegen.model.dialect.dialect import Dialect
from codegen.model.program import VEHICLE_QUANTITIES, Program
from codegen.model.spec.command import CommandsSpec
from codegen.model.spec.program import CodeSpec, VehicleSpec
from codegen.model.spec.spec import ParametersSpec, Requirement
from codegen.model.spec.state import StateSpec
from codegen.model.units.unit import unit_named
from codegen.model.vehicle import Citation, Cited, Component, Parameter
from codegen.model.watchdog import Watchdog
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.commands.commands import resolve_commands
from codegen.resolve.failsafes.failsafe import resolve_failsafes
from codegen.resolve.failsafes.priority import resolve_priority
from codegen.resolve.named import is_name
from codegen.resolve.program.absences import mission_results, resolve_absences
from codegen.resolve.program.modes import resolve_modes
from codegen.resolve.program.services import SENT, Uses, service_constants, service_messages
from codegen.source import Place

BAD_PROGRAM = Rule(
    "bad-program",
    "vehicle.yaml contradicts itself or the rest of the specification: what can be armed needs the component vehicle "
    "of the state with armed, ready, status, mode and load, failsafes need arming, parameters are saved in two files, "
    "and each action has a name of its own.",
)
LONGEST_PERIOD_US = (1 << 29) - 1
"""The largest difference of two ticks_us() on a board."""

_CALLS = {
    *("control", "measure", "check_arming", "on_arm", "on_disarm", "arm", "disarm"),
    *("reboot", "run", "run_pass", "act", "stop_motors", "halt_motors"),
}
_MODULES = {"main", "vehicle", "board", "state", "parameters", "streams", "telemetry", "messages", "dialect"}


def resolve_program(
    spec: VehicleSpec,
    written: ParametersSpec,
    parameters: Mapping[str, Parameter],
    components: Mapping[str, Component],
    state: StateSpec,
    dialect: Dialect,
    index: Mapping[str, Requirement],
    report: Report,
    *,
    commands: CommandsSpec | None,
    access: Access | None,
    watchdog: Watchdog | None,
    takes_time: bool,
    component_id: int,
    received: frozenset[str],
) -> Program | None:
    """The program of vehicle.yaml, with its ``commands``; None, with findings, where it cannot be built.

    ``access`` and ``watchdog`` are resolved already. ``takes_time``: a table has the time since 1970. Its own is
    ``component_id``; ``received`` are the messages that tables receive.
    """
    control = read_rate(spec.control.rate, spec.control.at("rate"), report)
    links = read_rate(spec.control.links, spec.control.at("links"), report)
    checks = read_rate(spec.control.checks, spec.control.at("checks"), report)
    report_ms = read_time(spec.control.report_every, unit_named("ms"), spec.control.at("report_every"), report)
    for place, message in _program_problems(spec, components, state):
        report.add(BAD_PROGRAM, place, message)
    failsafes = resolve_failsafes(spec, written, parameters, components, state, index, report)
    own = resolve_commands(commands, spec, dialect, index, report)
    modes = resolve_modes(spec, components, state, index, report)
    takes_long = any(command.spec.long for command in own)
    takes_keys = access is not None and bool(access.spec.setup)
    uses = Uses(
        takes_time=takes_time,
        has_commands=bool(own),
        takes_long=takes_long,
        has_modes=bool(modes),
        takes_keys=takes_keys,
    )
    services = service_messages(spec, dialect, report, uses)
    absences = resolve_absences(dialect, component_id, received | ({"SET_MODE"} if modes else frozenset()))
    cited: dict[str, Citation] = {}
    for name, text, place in (
        ("control", spec.control.requirement, spec.control.at("requirement")),
        ("storage", spec.storage.requirement, spec.storage.at("requirement")),
        *([("arming", spec.arming.requirement, spec.arming.at("requirement"))] if spec.arming else []),
        ("services", spec.services.requirement, spec.services.at("requirement")),
        *([("measure", spec.code.requirement, spec.code.at("requirement"))] if spec.code else []),
    ):
        citation = cite_optional(text, place, index, report)
        if citation is not None:
            cited[name] = citation
    sections = {"control": spec.control, "storage": spec.storage, "arming": spec.arming, "services": spec.services}
    aspects = {name: cite_aspects(section, index, report) for name, section in sections.items() if section}
    besides = _present(access=access, watchdog=watchdog)
    aspects |= {name: dict(part.aspects) for name, part in besides.items()}
    cited |= {name: part.citation for name, part in besides.items() if part.citation}
    code = spec.code or CodeSpec(place=spec.place)
    measure = read_rate(code.measure, code.at("measure"), report) if code.measure is not None else None
    step_limit = read_time(spec.storage.step_limit, unit_named("us"), spec.storage.at("step_limit"), report)
    for record, key, period_us in (
        (spec.control, "rate", 1000000 / control if control else 0),
        (spec.control, "links", 1000000 / links if links else 0),
        (spec.control, "checks", 1000000 / checks if checks else 0),
        (spec.control, "report_every", report_ms * 1000 if report_ms else 0),
        (code, "measure", 1000000 / measure if measure else 0),
    ):
        if period_us > LONGEST_PERIOD_US:
            report.add(BAD_PROGRAM, record.at(key), "a job of the main loop is due every 536 s at least")
    fastest = read_rate(spec.services.fastest, spec.services.at("fastest"), report)
    silence_ms = read_time(spec.services.silence, unit_named("ms"), spec.services.at("silence"), report)
    if control is None or links is None or report_ms is None or step_limit is None or fastest is None:
        return None
    if silence_ms is None or checks is None:
        return None
    if links > control:
        message = f"links are served in a pass of the main loop, and that runs at {spec.control.rate} only"
        report.add(BAD_PROGRAM, spec.control.at("links"), message)
    return Program(
        control_us=round(Fraction(1000000) / control),
        links_us=round(Fraction(1000000) / links),
        checks_us=round(Fraction(1000000) / checks),
        report_ms=report_ms,
        step_limit_us=step_limit,
        failsafes=failsafes,
        actions=spec.actions,
        services=services,
        sent=SENT,
        constants={**service_constants(spec, dialect, report, uses), **(mission_results(dialect) if absences else {})},
        fastest=fastest,
        module=code.module,
        class_name=code.class_name,
        measure_us=round(Fraction(1000000) / measure) if measure else None,
        silence_ms=silence_ms,
        cited=cited,
        aspects=aspects,
        spec=spec,
        commands=own,
        modes=modes,
        priority=resolve_priority(spec, failsafes, report),
        access=access,
        watchdog=watchdog,
        absences=absences,
    )


def _present(**parts: Cited | None) -> dict[str, Cited]:
    """The parts of the program that are there, by name."""
    return {name: part for name, part in parts.items() if part is not None}


def _program_problems(
    spec: VehicleSpec, components: Mapping[str, Component], state: StateSpec
) -> Iterator[tuple[Place, str]]:
    vehicle = components.get("vehicle")
    if spec.arming is None:
        for name, failsafe in spec.failsafes.items():
            yield failsafe.place, f"the failsafe {name} acts on what can be armed, and nothing can without arming"
        for action in spec.actions:
            yield action.place, f"{action.call} is what a failsafe does, and there is none without arming"
    elif vehicle.instances != 1 if vehicle else not state.has_written("vehicle"):
        yield spec.place, "the state has no single component vehicle"
    for name, kind in VEHICLE_QUANTITIES.items() if vehicle and spec.arming else ():
        quantity = vehicle.quantities.get(name) if vehicle else None
        if quantity is None and vehicle and vehicle.spec.is_written(name):
            continue  # what is wrong with it has been reported
        if quantity is None or quantity.kind.value != kind or not quantity.derivation.is_set_by_code:
            yield spec.place, f"the component vehicle of the state has no {kind} {name} that can be set"
    files = spec.storage.files
    if len(files) != 2 or files[0] == files[-1]:
        yield spec.storage.at("files"), "parameters are saved in turns in two files with different names"
    if not 16 <= spec.storage.chunk <= 256:
        yield spec.storage.at("chunk"), f"a step writes 16 to 256 bytes, not {spec.storage.chunk}"
    yield from _action_problems(spec, vehicle)
    yield from _code_problems(spec.code)


def _code_problems(code: CodeSpec | None) -> Iterator[tuple[Place, str]]:
    if code is None:
        return
    if not is_name(code.module) or code.module in _MODULES:
        yield code.at("module"), f"{code.module} cannot be the name of a module of its own"
    if not is_name(code.class_name.lower()) or code.class_name == "Vehicle":
        yield code.at("class"), f"{code.class_name} cannot be the name of a class of its own"


def _action_problems(spec: VehicleSpec, vehicle: Component | None) -> Iterator[tuple[Place, str]]:
    taken = set(_CALLS)
    values = {0}
    for action in spec.actions:
        if not is_name(action.call) or action.call in taken:
            yield action.at("call"), f"{action.call} cannot be the name of a call of its own"
        if action.value in values:
            yield action.at("value"), f"{action.value} stands for another action already, or for none"
        mode = vehicle.quantities.get("mode") if vehicle else None
        if mode is not None and action.mode is not None and not mode.minimum <= action.mode <= mode.maximum:
            yield action.at("mode"), f"{action.mode} is not a mode that vehicle.mode can have"
        taken.add(action.call)
        values.add(action.value)
