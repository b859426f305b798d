"""A project, read: the specification of each of its programs, resolved and checked, and its scenarios."""

import os
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from codegen.decode.decoded import decoded_with_includes
from codegen.decode.dialect.version import is_stated_version
from codegen.decode.programs import ListedProgram, list_programs
from codegen.decode.reach import within
from codegen.decode.scenario import SCENARIOS, decode_scenarios
from codegen.decode.spec import decode_program, decode_spec
from codegen.decode.trace_lock import TRACE_LOCK
from codegen.diagnostics import Diagnostic, Report, Rule, Severity
from codegen.findings.fingerprint import fingerprint
from codegen.load.files import DISK, Files
from codegen.model.dialect.dialect import Dialect
from codegen.model.program_folders import ProgramFolders, is_one_of_several, program_folders
from codegen.model.scenario import Scenario
from codegen.model.spec.spec import Spec
from codegen.model.system import System
from codegen.project.waived import with_waived
from codegen.resolve.board.adc_sources import with_adc_channels
from codegen.resolve.scenarios.scenario import resolve_scenarios
from codegen.resolve.system import resolve_system
from codegen.rules import check_system
from codegen.source import Place

NO_FOLDER_OF_TESTS = Rule(
    "no-folder-of-tests",
    "codegen.yaml names a folder with tests written by hand that is not there, so codegen trace finds none of them.",
    Severity.WARNING,
    remedy="write the path of a folder, relative to codegen.yaml, or take it out of the list",
)

ONE_COMPONENT = Rule(
    "one-component",
    "Two programs of a project are one MAVLink component: both have the same ids. Connected to one vehicle each leaves "
    "alone what the other one sends, as its own, and both answer what a ground station asks one of them. Programs that "
    "are never there together can waive it.",
    Severity.WARNING,
    remedy="give the program a component_id of its own in its codegen.yaml, such as MAV_COMP_ID_USER1",
)


def read_system(project_file: str, report: Report, files: Files = DISK) -> System | None:
    """The resolved and checked system of a project; None if too little could be read to resolve anything."""
    own = within(project_file, files)
    return _checked(decode_spec(project_file, own, report), None, own, report)


def read_systems(project_file: str, report: Report, files: Files = DISK) -> tuple[System, ...]:
    """The system of a project and those of its further programs, which come last; what cannot be read is left out.

    What is wrong in a file that they share is reported once.
    """
    main = read_system(project_file, report, files)
    systems = [] if main is None else [main]
    own = within(project_file, files)
    for program in list_programs(project_file, own, report):
        found = Report()
        spec = decode_program(program, own, found)
        system = _checked(spec, main.dialect if main else None, own, found)
        known = {_said(finding) for finding in report}
        report.extend(_told(finding, program) for finding in found if _said(finding) not in known)
        if system is not None:
            alike = _check_ids(system, systems, program)
            report.extend(with_waived(alike, os.path.dirname(os.path.abspath(project_file)), own))
            systems.append(system)
    return tuple(systems)


def _check_ids(system: System, others: Iterable[System], program: ListedProgram) -> Iterator[Diagnostic]:
    """Yield a finding of a program that goes by the ids of another one, as it does unless a parameter is set."""
    for other in others:
        if (system.system_id, system.component_id) == (other.system_id, other.component_id):
            name = other.spec.program or other.spec.project.project
            message = f"{program.name} is system {system.system_id}, component {system.component_id}, as {name} is"
            about = fingerprint(ONE_COMPONENT.id, program.place.file, f"{program.name} {name}")
            yield Diagnostic(program.place, ONE_COMPONENT, message, fingerprint=about)
            return


def _said(finding: Diagnostic) -> tuple[Place, str, str]:
    """Return what makes two findings the same: hints may differ, as they name what each program has."""
    return finding.place, finding.rule.id, finding.message


def _told(finding: Diagnostic, program: ListedProgram) -> Diagnostic:
    """A finding of a further program: in a file of its base it tells for whom it is one."""
    folder = os.path.dirname(program.project_file)
    if finding.place.file.startswith(folder + os.sep):
        return finding
    return replace(finding, related=(*finding.related, (program.place, f"found for the program {program.name}")))


def _checked(spec: Spec | None, dialect: Dialect | None, files: Files, report: Report) -> System | None:
    """The system of a specification, checked; ``dialect`` is the one that its base has read already."""
    if spec is None:
        return None
    if not spec.program:
        _check_folders_of_tests(spec, files, report)
    dialect = dialect or read_dialect(spec, files, report)
    if dialect is None:
        return None
    system = resolve_system(with_adc_channels(spec, report), dialect, report)
    report.extend(with_waived(check_system(system), spec.folder, files))
    return system


def _check_folders_of_tests(spec: Spec, files: Files, report: Report) -> None:
    """Report the folders that ``tests`` names and that are none; a project that names none may do without."""
    project = spec.project
    for index, name in enumerate(project.tests if "tests" in project.places else ()):
        path, place = os.path.normpath(os.path.join(spec.folder, name)), project.at(f"tests[{index}]")
        if not files.is_refused(path, place, Report()) and not files.is_folder(path):
            report.add(NO_FOLDER_OF_TESTS, place, f"there is no folder {name}")


def read_scenarios(
    path: str, systems: Sequence[System], report: Report, files: Files = DISK
) -> dict[str, Scenario] | None:
    """The scenarios of a file, those with errors left out; None if it cannot be read.

    ``systems`` are those of the project; where its own could not be read, the scenarios are only checked.
    """
    written = decode_scenarios(path, files, report)
    if written is None:
        return None
    programs = {system.spec.program: system for system in systems}
    return resolve_scenarios(written, programs.pop("", None), report, programs)


def read_own_scenarios(project_file: str, systems: Sequence[System], report: Report) -> dict[str, Scenario] | None:
    """The scenarios beside a project file, as ``read_scenarios`` has them; they reach no further than the project."""
    return read_scenarios(scenarios_path(project_file), systems, report, within(project_file, DISK))


def check_scenarios(project_file: str, systems: Sequence[System], report: Report) -> None:
    """Report what is wrong with the scenarios beside a project file, which may have none.

    After an error in the specification they are checked by themselves: what they lack there may be what is broken.
    """
    if DISK.exists(scenarios_path(project_file)):
        read_own_scenarios(project_file, () if report.has_errors else systems, report)


def scenarios_path(project_file: str) -> str:
    """The absolute path of the scenarios that belong to a project file."""
    return os.path.join(os.path.dirname(os.path.abspath(project_file)), SCENARIOS)


def read_dialect(spec: Spec, files: Files, report: Report) -> Dialect | None:
    """The dialect of a project with its includes, overlays and corrections."""
    project = spec.project
    if not is_stated_version(project, files, report):
        return None
    inputs = (spec.folder, project.dialect, project.overlays, project.known, spec.corrections, spec.refusals)

    def read(noting: Files, found: Report) -> Dialect | None:
        from codegen.project.dialect import decode_dialect  # noqa: PLC0415  most builds find it in the cache

        return decode_dialect(spec, noting, found)

    dialect, digest = decoded_with_includes("project", inputs, read, files, report)
    return None if dialect is None else replace(dialect, digest=digest)


def project_folder(systems: Sequence[System]) -> str:
    """The absolute path of the folder of a project: the one above that of its specification."""
    return os.path.dirname(systems[0].spec.folder) if systems else os.getcwd()


def files_read(systems: Iterable[System]) -> set[str]:
    """The absolute paths of every file that a build reads: specification, documents, dialect, scenarios, reviews."""
    systems = tuple(systems)
    read = {path for system in systems for path in (*system.spec.files, *system.dialect.files)}
    beside = {os.path.join(system.spec.folder, name) for system in systems for name in (SCENARIOS, TRACE_LOCK)}
    return read | {path for path in beside if DISK.exists(path)}


def folders_read(systems: Iterable[System]) -> list[str]:
    """The absolute paths of the folders of the specifications, that of the project first."""
    return [system.spec.own_folder for system in systems]


def output_folder(system: System) -> str:
    """The absolute path of the folder that the output goes to."""
    return os.path.normpath(os.path.join(system.spec.folder, system.spec.project.output))


def folders_of(system: System) -> ProgramFolders:
    """Return the folders that the output of a program lies in, as absolute paths."""
    own, name = output_folder(system), system.spec.program
    output = os.path.dirname(own) if name else own
    return program_folders(output, name, has_common=is_one_of_several(system.spec))
