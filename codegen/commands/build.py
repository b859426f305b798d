"""Builds from systems: the files of the output folder, compiled modules for boards, and a summary of both."""

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from codegen.commands.trace import documents_of, generated_tests, read_trace_lock, rows
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.model.program_folders import ProgramFolders
from codegen.model.system import System
from codegen.project.of_systems import of_systems
from codegen.project.systems import folders_of, output_folder, project_folder
from codegen.source import shown_path
from codegen.targets.firmware import render_firmware
from codegen.targets.listed import PROJECT_TARGETS, TARGETS
from codegen.targets.origin import united
from codegen.targets.shared_files import Output, laid_out
from codegen.trace.coverage import coverage_of
from codegen.trace.findings import trace_findings
from codegen.trace.graph import linked
from codegen.trace.link import suspects
from codegen.trace.lock import gone, reviews
from codegen.trace.page import render_trace
from codegen.trace.placed import placed
from codegen.trace.view import trace_view


def render_system(system: System) -> dict[str, str]:
    """Every output file of a system without errors: ``{path below its output folder: text}``."""
    files: dict[str, str] = {}
    for render in TARGETS if system.spec.program else (*TARGETS, *PROJECT_TARGETS):
        files.update(render(system))
    return files


def render_systems(systems: Sequence[System]) -> Output:
    """Every output file of a project, those of further programs and what all programs share included.

    A further program whose own files and those of its base that it uses are as they were is not rendered again.
    """
    output = laid_out(
        {
            system.spec.program: of_systems(render_system, system) if system.spec.program else render_system(system)
            for system in systems
        }
    )
    if not systems or systems[0].spec.program:
        return output
    return replace(output, files={**output.files, **_trace_page(systems, output.shared)})


def _trace_page(systems: Sequence[System], shared: Mapping[str, str]) -> dict[str, str]:
    """The page of the requirements: like all output a function of the specification, so without tests by hand.

    What is wrong with the lock, codegen trace tells.
    """
    trace = linked(documents_of(systems), placed(rows(systems), shared), generated_tests(systems))
    lock = read_trace_lock(systems[0].spec.project.place.file, Report())
    coverage = coverage_of(trace, reviews(trace, lock), suspects(trace, lock), None)
    findings = Report()
    findings.extend(trace_findings(trace, coverage, gone(trace, lock), only=("orphaned", "suspect")))
    name = systems[0].spec.project.project
    view = trace_view(name, project_folder(systems), trace, coverage, findings, only_generated=True)
    return render_trace(systems, view)


def stale_firmware(system: System) -> list[str]:
    """The modules of the firmware, by file name, that a build would change or add in the output folder."""
    folders = folders_of(system)
    return [
        os.path.basename(path) for path, text in render_firmware(system).items() if not _is_written(text, path, folders)
    ]


def _is_written(text: str, path: str, folders: ProgramFolders) -> bool:
    """Return whether a module is on the disk as it is rendered; the header of one that is common tells more sources."""
    place = folders.find(path)
    found = None if place is None else DISK.read_bytes(place, Report())
    if found is None or place == os.path.join(folders.own, path):
        return found == text.encode()
    return united([found.decode("utf-8", "replace"), text]) is not None


def compile_systems(systems: Iterable[System], architecture: str, report: Report) -> dict[str, str | bytes]:
    """The modules of all firmware as boards load them, those of a further program below the folder of its name."""
    return {
        os.path.join(system.spec.program, name): module
        for system in systems
        for name, module in compile_firmware(system, architecture, report).items()
    }


def compile_firmware(system: System, architecture: str, report: Report) -> dict[str, str | bytes]:
    """The modules of the firmware as a board loads them, by file name; empty after a diagnostic.

    What the user's own modules name keeps its name, as in a deploy. Those that are larger than the file system of the
    board are one, too.
    """
    from codegen.deploy.contents import own_modules
    from codegen.deploy.findings import BOARD_FULL
    from codegen.emit.mpy import compiled

    modules = firmware_modules(system, architecture)
    own = own_modules(system, project_folder([system]), modules, Report())
    files = compiled(modules, architecture, report, unnumbered=modules, beside=own.values())
    room = system.board.memory.files if system.board and system.board.memory else None
    size = sum(len(content) for content in files.values())
    if room is not None and size > room:
        message = (
            f"its files take {-(-size // 1024)} KB, and the file system of the {system.board_name} has {room // 1024}"
        )
        hint = "codegen explain heap tells what a program is made of"
        report.add(BOARD_FULL, system.spec.board.at("board"), message, hint)
        return {}
    return files


def firmware_modules(system: System, architecture: str) -> dict[str, str]:
    """The texts of the modules of the firmware for boards of an architecture, by file name."""
    system = as_compiled_for(system, architecture)
    return {os.path.basename(path): text for path, text in render_firmware(system).items()}


def as_compiled_for(system: System, architecture: str) -> System:
    """The system of a program that is compiled for an architecture: bytecode has no machine code."""
    from codegen.emit.mpy import BYTECODE

    if architecture != BYTECODE:
        return system
    project = replace(system.spec.project, machine_code=False)
    return replace(system, spec=replace(system.spec, project=project))


def board_folder(system: System, architecture: str) -> str:
    """The absolute path of the folder that compiled modules go to."""
    return os.path.join(os.path.dirname(system.spec.folder), "build", architecture)


def what_is_made(systems: Sequence[System]) -> list[str]:
    """Return what a build has made, and what one can do with it now, for people."""
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
