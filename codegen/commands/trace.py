"""Reads the trace of a project: its criteria, rows of tables, symbols and tests, and the reviewed texts."""

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING

from codegen.decode.marked_tests import read_tests_below
from codegen.decode.reach import within
from codegen.decode.trace_lock import TRACE_LOCK, decode_trace_lock, read_trace_lock_text
from codegen.diagnostics import Report, did_you_mean
from codegen.frozen import dataclass
from codegen.load.files import DISK, Files
from codegen.model.spec.spec import Requirement
from codegen.model.spec.trace_lock import TraceLockSpec
from codegen.model.system import System
from codegen.model.test_record import MarkedTest
from codegen.project.of_systems import of_systems
from codegen.source import Place

if TYPE_CHECKING:
    from codegen.trace.graph import Row, Test, Trace
from codegen.project.systems import project_folder

NOTHING_SHARED: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Refused:
    """The reason for which something cannot be done with a name that the user gave, in words."""

    why: str


def read_trace(
    systems: Sequence[System], report: Report, files: Files = DISK, shared: Mapping[str, str] = NOTHING_SHARED
) -> "Trace":
    """Return what criteria, tables, symbols and tests of a project have to do with one another.

    ``shared`` says where modules lie that programs share. A finding is about a file of tests that says nothing, or
    about a folder of tests that lies outside of the project.
    """
    from codegen.trace.graph import hand_written, linked
    from codegen.trace.placed import placed

    marked = _marked_tests(systems, files, report)
    tests = (*generated_tests(systems), *hand_written(marked, project_folder(systems)))
    return linked(documents_of(systems), placed(rows(systems), shared), tests)


def shared_modules(systems: Sequence[System]) -> Mapping[str, str]:
    """Return where the modules of firmware lie that programs share, as ``Output.shared`` has it."""
    return of_systems(_shared_modules, *systems) if len(systems) > 1 else NOTHING_SHARED


def generated_tests(systems: Iterable[System]) -> "Iterator[Test]":
    """The tests of the suites of a project and of its further programs, one for each criterion that they show."""
    for system in systems:
        yield from of_systems(_tests_of, system)


def rows(systems: Iterable[System]) -> "tuple[Row, ...]":
    """The rows of a project and of its further programs in the order of their files."""
    return of_systems(_rows_of, *systems)


def _rows_of(*systems: System) -> "tuple[Row, ...]":
    from codegen.trace.rows import rows_of

    return rows_of(systems)


def _shared_modules(*systems: System) -> dict[str, str]:
    from codegen.targets.firmware import render_firmware
    from codegen.targets.shared_files import laid_out

    return dict(laid_out({system.spec.program: render_firmware(system) for system in systems}).shared)


def _tests_of(system: System) -> "tuple[Test, ...]":
    from codegen.trace.generated_tests import tests_of

    return tests_of(system)


def _marked_tests(systems: Sequence[System], files: Files, report: Report) -> list[MarkedTest]:
    """The marked tests in the folders that the project file lists."""
    if not systems:
        return []
    own = within(systems[0].spec.project.place.file, files)
    folders = [path for path, place in folders_of_tests(systems).items() if not own.is_refused(path, place, report)]
    return read_tests_below(folders, own, report)


def documents_of(systems: Iterable[System]) -> Iterable[Requirement]:
    """The requirement documents of all programs, each once."""
    return {each.place: each for system in systems for each in system.requirements.values()}.values()


def read_trace_lock(project_file: str, report: Report) -> TraceLockSpec | None:
    """Return which texts of criteria were reviewed, as the lock file beside a project file says; None without one."""
    path = trace_lock_path(project_file)
    text = read_trace_lock_text(path, within(project_file, DISK), report)
    return None if text is None else decode_trace_lock(text, path, report)


def chosen_criteria(names: Sequence[str], trace: "Trace") -> set[str] | Refused:
    """Return the criteria that are meant, of a document all of them; all there are where nothing is named."""
    if not names:
        return set(trace.criteria)
    chosen: set[str] = set()
    for name in names:
        called = trace.called(name)
        if called is None:
            hint = did_you_mean(name, [*trace.names, *trace.criteria])
            return Refused(f"no document has {name}{f'; {hint}' if hint else ''}")
        chosen |= {one for one in trace.criteria if one == called or one.startswith(f"{called}.")}
    return chosen


def trace_lock_path(project_file: str) -> str:
    """The absolute path of the lock file that belongs to a project file."""
    return os.path.join(os.path.dirname(os.path.abspath(project_file)), TRACE_LOCK)


def folders_of_tests(systems: Iterable[System]) -> dict[str, Place]:
    """The absolute paths of the folders with tests that are written by hand, and where they are listed."""
    projects = [(system.spec.folder, system.spec.project) for system in systems]
    listed = {
        os.path.normpath(os.path.join(folder, name)): project.at("tests")
        for folder, project in projects
        for name in project.tests
    }
    return dict(sorted(listed.items()))
