"""The program that the board runs: main loop, storage, arming and what failsafes do."""

from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.measure import read_rate, read_time
from codegen.model.access import Access
from codegen.model.dialect.dialect import Dialect
from codegen.model.program import SENT, Program
from codegen.model.spec.command import CommandsSpec
from codegen.model.spec.program import CodeSpec, VehicleSpec
from codegen.model.spec.spec import ParametersSpec, Requirement
from codegen.model.spec.state import StateSpec
from codegen.model.units.unit import unit_named
from codegen.model.vehicle import SLOWEST_ASKED, Citation, Cited, Component, Parameter
from codegen.model.watchdog import Watchdog
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.commands.commands import resolve_commands
from codegen.resolve.failsafes.failsafe import resolve_failsafes
from codegen.resolve.failsafes.priority import resolve_priority
from codegen.resolve.program.absences import mission_results, resolve_absences
from codegen.resolve.program.modes import resolve_modes
from codegen.resolve.program.problems import program_problems
from codegen.resolve.program.services import Uses, service_constants, service_messages
from codegen.resolve.program.watchdog import SHORTEST_MS

BAD_PROGRAM = Rule(
    "bad-program",
    "vehicle.yaml contradicts itself or the rest of the specification: what can be armed needs the component vehicle "
    "of the state with armed, ready, status, mode and load, actions need failsafes, parameters are saved in two files, "
    "each action has a name of its own, and what passes over the checks before arming is a number that a command can "
    "have and that not every one has.",
    remedy="make vehicle.yaml fit the component vehicle of state.yaml",
)
LONGEST_PERIOD_US = (1 << 29) - 1
"""The largest difference of two ticks_us() on a board."""
SHORTEST_REPORT_MS = 100
LONGEST_STEP_US = 1000 * SHORTEST_MS
"""A step of a save that takes longer is none: the watchdog of a board would end it."""


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
    for problem in program_problems(spec, components, state):
        report.add(BAD_PROGRAM, *problem)
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
            report.add(
                BAD_PROGRAM,
                record.at(key),
                "a job of the main loop is due every 536 s at least",
                hint=f"{key}: {'60 s' if key == 'report_every' else '1 Hz'}",
            )
    _check_times(spec, report_ms, step_limit, report)
    fastest = read_rate(spec.services.fastest, spec.services.at("fastest"), report)
    if fastest is not None and fastest < SLOWEST_ASKED:
        report.add(
            BAD_PROGRAM,
            spec.services.at("fastest"),
            f"{spec.services.fastest} is less often than once in 1073 s, the longest interval that can be asked for",
            hint="fastest: 0.001 Hz",
        )
    silence_ms = read_time(spec.services.silence, unit_named("ms"), spec.services.at("silence"), report)
    if control is None or links is None or report_ms is None or step_limit is None or fastest is None:
        return None
    if silence_ms is None or checks is None:
        return None
    if links > control:
        message = f"links are served in a pass of the main loop, and that runs at {spec.control.rate} only"
        report.add(
            BAD_PROGRAM, spec.control.at("links"), message, hint=f"links: {spec.control.rate} at most, or a higher rate"
        )
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
        encoding=written.encoding,
    )


def _check_times(spec: VehicleSpec, report_ms: int | None, step_limit_us: int | None, report: Report) -> None:
    """Report what is told too often, and what could never be told."""
    if report_ms is not None and report_ms < SHORTEST_REPORT_MS:
        message = f"{spec.control.report_every} is more than ten texts a second, which miss slots themselves"
        report.add(BAD_PROGRAM, spec.control.at("report_every"), message, "report_every: 10 s")
    if step_limit_us is not None and step_limit_us > LONGEST_STEP_US:
        message = f"no step of a save takes {spec.storage.step_limit}: to erase flash takes 0.4 s at most"
        report.add(BAD_PROGRAM, spec.storage.at("step_limit"), message, "step_limit: 10 ms, up to 1 s")


def _present(**parts: Cited | None) -> dict[str, Cited]:
    """The parts of the program that are there, by name."""
    return {name: part for name, part in parts.items() if part is not None}
