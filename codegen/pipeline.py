"""The way of the data: read, resolve, check, then render; every command is a prefix of it."""

import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import TypeVar, cast

from codegen.cache import entry, keep_object, kept_object, pickled
from codegen.decode.decoded import decoded_with_includes
from codegen.decode.dialect_version import is_stated_version
from codegen.decode.programs import ListedProgram, list_programs
from codegen.decode.reach import folders_of
from codegen.decode.scenario import SCENARIOS, decode_scenarios
from codegen.decode.spec import decode_program, decode_spec
from codegen.decode.trace_lock import TRACE_LOCK, decode_trace_lock, read_trace_lock_text
from codegen.diagnostics import Diagnostic, Report
from codegen.load.confined import confined
from codegen.load.marked_tests import files_of_tests, read_marked_tests
from codegen.load.text import read_bytes, read_text
from codegen.load.trees import exists
from codegen.model.dialect import Dialect
from codegen.model.scenario import Scenario
from codegen.model.spec import Requirement, Spec
from codegen.model.system import System
from codegen.model.trace_lock_spec import TraceLockSpec
from codegen.resolve.adc_sources import with_adc_channels
from codegen.resolve.scenario import resolve_scenarios
from codegen.resolve.system import resolve_system
from codegen.rules import check_system
from codegen.source import Place, shown_path
from codegen.targets.firmware import render_firmware
from codegen.targets.listed import PROJECT_TARGETS, TARGETS
from codegen.tool import tool_digest
from codegen.trace.coverage import coverage_of
from codegen.trace.findings import trace_findings
from codegen.trace.generated_tests import generated_tests, tests_of
from codegen.trace.graph import Trace, hand_written, linked
from codegen.trace.lock import gone, reviews
from codegen.trace.page import render_trace
from codegen.trace.rows import rows_of
from codegen.trace.view import trace_view

_Made = TypeVar("_Made")


def read_system(project_file: str, report: Report) -> System | None:
    """The resolved and checked system of a project; None if too little could be read to resolve anything."""
    with confined(folders_of(project_file)):
        return _checked(decode_spec(project_file, report), None, report)


def read_systems(project_file: str, report: Report) -> tuple[System, ...]:
    """The system of a project and those of its further programs, which come last; what cannot be read is left out.

    What is wrong in a file that they share is reported once.
    """
    main = read_system(project_file, report)
    systems = [] if main is None else [main]
    with confined(folders_of(project_file)):
        programs = list_programs(project_file, report)
    for program in programs:
        found = Report()
        with confined(folders_of(project_file)):
            system = _checked(decode_program(program, found), main.dialect if main else None, found)
        known = {_said(finding) for finding in report}
        report.extend(_told(finding, program) for finding in found if _said(finding) not in known)
        if system is not None:
            systems.append(system)
    return tuple(systems)


def _said(finding: Diagnostic) -> tuple[Place, str, str]:
    """What makes two findings the same: hints may differ, as they name what each program has."""
    return finding.place, finding.rule.id, finding.message


def _told(finding: Diagnostic, program: ListedProgram) -> Diagnostic:
    """A finding of a further program: in a file of its base it tells for whom it is one."""
    folder = os.path.dirname(program.project_file)
    if finding.place.file.startswith(folder + os.sep):
        return finding
    return replace(finding, related=(*finding.related, (program.place, f"found for the program {program.name}")))


def _checked(spec: Spec | None, dialect: Dialect | None, report: Report) -> System | None:
    """The system of a specification, checked; ``dialect`` is the one that its base has read already."""
    if spec is None:
        return None
    dialect = dialect or read_dialect(spec, report)
    if dialect is None:
        return None
    system = resolve_system(with_adc_channels(spec, report), dialect, report)
    report.extend(check_system(system))
    return system


def read_scenarios(path: str, systems: Sequence[System], report: Report) -> dict[str, Scenario] | None:
    """The scenarios of a file, those with errors left out; None if it cannot be read.

    ``systems`` are those of the project; where its own could not be read, the scenarios are only checked.
    """
    written = decode_scenarios(path, report)
    if written is None:
        return None
    programs = {system.spec.program: system for system in systems}
    return resolve_scenarios(written, programs.pop("", None), report, programs)


def check_scenarios(project_file: str, systems: Sequence[System], report: Report) -> None:
    """What is wrong with the scenarios beside a project file, which may have none.

    After an error in the specification they are checked by themselves: what they lack there may be what is broken.
    """
    path = scenarios_path(project_file)
    if exists(path):
        read_scenarios(path, () if report.has_errors else systems, report)


def check_documents(systems: Sequence[System], report: Report) -> None:
    """What the tables of the requirement documents say against the population tables and the dialect."""
    from codegen.importing.drift import drift  # noqa: PLC0415  a build needs neither
    from codegen.importing.stated import stated_fields  # noqa: PLC0415

    paths = (requirement.place.file for system in systems for requirement in system.requirements.values())
    for path in dict.fromkeys(paths):
        text = read_text(path, report)
        if text is not None:
            stated = stated_fields(text, path)
            report.extend(stated.findings)
            report.extend(drift(stated, systems))


def scenarios_path(project_file: str) -> str:
    """The absolute path of the scenarios that belong to a project file."""
    return os.path.join(os.path.dirname(os.path.abspath(project_file)), SCENARIOS)


def read_dialect(spec: Spec, report: Report) -> Dialect | None:
    """The dialect of a project with its includes, overlays and corrections."""
    project = spec.project
    if not is_stated_version(project, report):
        return None
    inputs = (spec.folder, project.dialect, project.overlays, project.known, spec.corrections, spec.refusals)
    dialect, digest = decoded_with_includes("project", inputs, lambda found: _decode_dialect(spec, found), report)
    return None if dialect is None else replace(dialect, digest=digest)


def _decode_dialect(spec: Spec, report: Report) -> Dialect | None:
    from codegen.project_dialect import decode_dialect  # noqa: PLC0415  most builds find it in the cache

    return decode_dialect(spec, report)


def read_trace(systems: Sequence[System], report: Report) -> Trace:
    """What criteria, tables, symbols and tests of a project have to do with one another.

    A finding is about a file of tests that says nothing.
    """
    marked = [test for path in files_of_tests(folders_of_tests(systems)) for test in read_marked_tests(path, report)]
    tests = (*generated_tests(systems), *hand_written(marked, project_folder(systems)))
    return linked(_documents(systems), rows_of(systems), tests)


def _documents(systems: Iterable[System]) -> Iterable[Requirement]:
    """The requirement documents of all programs, each once."""
    return {each.place: each for system in systems for each in system.requirements.values()}.values()


def read_trace_lock(project_file: str, report: Report) -> TraceLockSpec | None:
    """Which texts of criteria were reviewed, as the lock file beside a project file says; None without one."""
    path = trace_lock_path(project_file)
    text = read_trace_lock_text(path, report)
    return None if text is None else decode_trace_lock(text, path, report)


def trace_lock_path(project_file: str) -> str:
    """The absolute path of the lock file that belongs to a project file."""
    return os.path.join(os.path.dirname(os.path.abspath(project_file)), TRACE_LOCK)


def project_folder(systems: Sequence[System]) -> str:
    """The absolute path of the folder of a project: the one above that of its specification."""
    return os.path.dirname(systems[0].spec.folder) if systems else os.getcwd()


def folders_of_tests(systems: Iterable[System]) -> list[str]:
    """The absolute paths of the folders with tests that are written by hand."""
    specs = [system.spec for system in systems]
    return sorted({os.path.normpath(os.path.join(spec.folder, name)) for spec in specs for name in spec.project.tests})


def render_system(system: System) -> dict[str, str]:
    """Every output file of a system without errors: ``{path below its output folder: text}``."""
    files: dict[str, str] = {}
    for render in TARGETS if system.spec.program else (*TARGETS, *PROJECT_TARGETS):
        files.update(render(system))
    return files


def render_systems(systems: Sequence[System]) -> dict[str, str]:
    """Every output file of a project: those of a further program lie below the folder of its name.

    A program whose own files and those of its base that it uses are as they were is not rendered again.
    """
    files = {
        os.path.join(system.spec.program, path): text
        for system in systems
        for path, text in _once(render_system, system).items()
    }
    return files if not systems or systems[0].spec.program else files | _trace_page(systems)


def _once(make: Callable[[System], _Made], system: System) -> _Made:
    """What ``make`` returns for a system, which depends on nothing else, by this run or an earlier one.

    That is for further programs, whose files mostly stay while those of the project are edited; what the project makes
    of its own files would only fill the cache.
    """
    spec = system.spec
    if not spec.program or not system.dialect.digest:
        return make(system)
    about = (spec.program, spec.folder, spec.own_folder, sorted(spec.files.items()))
    name = entry(make.__qualname__, tool_digest(), system.dialect.digest, pickled(about))
    known = kept_object(name)
    if known is not None:
        return cast(_Made, known)
    made = make(system)
    keep_object(name, made)
    return made


def _trace_page(systems: Sequence[System]) -> dict[str, str]:
    """The page of the requirements: like all output a function of the specification, so without tests by hand.

    What is wrong with the lock, codegen trace tells.
    """
    tests = [test for system in systems for test in _once(tests_of, system)]
    trace = linked(_documents(systems), rows_of(systems), tests)
    lock = read_trace_lock(systems[0].spec.project.place.file, Report())
    coverage = coverage_of(trace, reviews(trace, lock), None)
    findings = Report()
    findings.extend(trace_findings(trace, coverage, gone(trace, lock), only=("orphaned", "suspect")))
    name = systems[0].spec.project.project
    view = trace_view(name, project_folder(systems), trace, coverage, findings, only_generated=True)
    return render_trace(systems, view)


def stale_firmware(system: System) -> list[str]:
    """The modules of the firmware, by file name, that a build would change or add in the output folder."""
    folder = output_folder(system)
    return [
        os.path.basename(path)
        for path, text in render_firmware(system).items()
        if read_bytes(os.path.join(folder, path), Report()) != text.encode()
    ]


def compile_systems(systems: Iterable[System], architecture: str, report: Report) -> dict[str, str | bytes]:
    """The modules of all firmware as boards load them, those of a further program below the folder of its name."""
    return {
        os.path.join(system.spec.program, name): module
        for system in systems
        for name, module in compile_firmware(system, architecture, report).items()
    }


def compile_firmware(system: System, architecture: str, report: Report) -> dict[str, str | bytes]:
    """The modules of the firmware as a board loads them, by file name; empty after a diagnostic."""
    from codegen.mpy import compiled  # noqa: PLC0415  most builds compile nothing

    modules = firmware_modules(system, architecture)
    return compiled(modules, architecture, report, unnumbered=modules)


def firmware_modules(system: System, architecture: str) -> dict[str, str]:
    """The texts of the modules of the firmware for boards of an architecture, by file name."""
    from codegen.mpy import BYTECODE  # noqa: PLC0415

    if architecture == BYTECODE:
        project = replace(system.spec.project, machine_code=False)
        system = replace(system, spec=replace(system.spec, project=project))
    return {os.path.basename(path): text for path, text in render_firmware(system).items()}


def board_folder(system: System, architecture: str) -> str:
    """The absolute path of the folder that compiled modules go to."""
    return os.path.join(os.path.dirname(system.spec.folder), "build", architecture)


def files_read(systems: Iterable[System]) -> set[str]:
    """The absolute paths of every file that a build reads: specification, documents, dialect, scenarios, reviews."""
    systems = tuple(systems)
    read = {path for system in systems for path in (*system.spec.files, *system.dialect.files)}
    beside = {os.path.join(system.spec.folder, name) for system in systems for name in (SCENARIOS, TRACE_LOCK)}
    return read | {path for path in beside if exists(path)}


def folders_read(systems: Iterable[System]) -> list[str]:
    """The absolute paths of the folders of the specifications, that of the project first."""
    return [system.spec.own_folder for system in systems]


def what_is_made(systems: Sequence[System]) -> list[str]:
    """What a build has made, and what one can do with it now, for people."""
    main, *others = systems
    folder = shown_path(output_folder(main)).replace("\\", "/")
    count = len(main.messages)
    further = f", and beside it {', '.join(system.spec.program for system in others)}" if others else ""
    name, messages = main.spec.project.project, f"{count} {'message' if count == 1 else 'messages'}"
    lines = [f"{folder}/ has {name} with {messages}{further}: firmware, mocks, tests, pages (docs/index.html)"]
    steps = ["codegen sim", f"pytest {folder}/tests"] if main.program else [f"pytest {folder}/tests"]
    if main.spec.board_model is not None:
        steps.append("codegen deploy (to a board on USB)")
    return [*lines, f"next: {', '.join(steps)}"]


def output_folder(system: System) -> str:
    """The absolute path of the folder that the output goes to."""
    return os.path.normpath(os.path.join(system.spec.folder, system.spec.project.output))
