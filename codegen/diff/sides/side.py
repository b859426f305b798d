"""A side of a comparison: a project, or a dialect alone, with the name that people call it by."""

import os
from collections.abc import Callable

from codegen.decode.decoded import with_files_read
from codegen.diagnostics import Diagnostic, Report
from codegen.frozen import dataclass
from codegen.load.files import DISK, Files
from codegen.load.shipped import files_beside
from codegen.load.tree import Tree
from codegen.model.dialect.dialect import Dialect
from codegen.model.system import System


@dataclass(frozen=True, slots=True)
class Side:
    """One side: how people call it, and what there is: the systems of a project, the first its own, or a dialect.

    ``findings`` are the errors that reading it found; what they concern may be missing. ``files`` are those that it was
    read from, which hold while the side is opened. ``is_release`` marks a dialect of a pymavlink.
    """

    label: str
    systems: tuple[System, ...]
    dialect: Dialect
    findings: tuple[Diagnostic, ...]
    files: Files
    is_release: bool = False

    @property
    def is_project(self) -> bool:
        """Return whether it has a specification and not only a dialect."""
        return bool(self.systems)


@dataclass(frozen=True, slots=True)
class Unreadable:
    """The reason for which a side cannot be read: in words, with a hint, or as the findings of reading it."""

    message: str
    hint: str | None = None
    findings: tuple[Diagnostic, ...] = ()


@dataclass(frozen=True, slots=True)
class Around:
    """The context in which a side is looked up: the project file that the command works on, if any, and options.

    ``dialect`` is the dialect of a release that is meant where none is named; ``pymavlink`` a release whose dialects
    take the place of the installed ones. ``read_systems`` reads a project: the caller's, since comparing dialects needs
    nothing of what it does. ``files`` are those of the disk, beside those of the other side.
    """

    project: str | None
    dialect: str
    read_systems: Callable[[str, Report, Files], tuple[System, ...]]
    pymavlink: str | None = None
    files: Files = DISK


def project_side(file: str, label: str, around: Around, files: Files) -> Side | Unreadable:
    """A project, as far as it can be read."""
    report = Report()
    systems = around.read_systems(file, report, files)
    errors = tuple(finding for finding in report if finding.is_error)
    if not systems or systems[0].spec.program:
        return Unreadable(f"{label} has no specification that can be read", findings=errors or tuple(report))
    return Side(label, systems, systems[0].dialect, errors, files)


def dialect_side(path: str, label: str, files: Files, *, is_release: bool = False) -> Side | Unreadable:
    """A dialect with what it includes, as far as it can be read."""
    beside = files_beside(path, files)
    dialect, errors = with_files_read(("dialect", path), lambda noting: _read_dialect(path, noting), {}, beside)
    if dialect is None or (errors and not dialect.messages and not dialect.enums):
        return Unreadable(f"{label} is no dialect that can be read", findings=errors)
    return Side(label, (), dialect, errors, files, is_release)


def _read_dialect(path: str, files: Files) -> tuple[Dialect | None, tuple[Diagnostic, ...]]:
    """The dialect of a file and of what it includes, None where there is nothing, and the errors in it."""
    from codegen.decode.dialect.files import decode_dialect_files  # noqa: PLC0415  for a dialect that is not known yet
    from codegen.resolve.dialect.dialect import resolve_dialect  # noqa: PLC0415

    report = Report()
    found = decode_dialect_files(path, files, report)
    name = os.path.splitext(os.path.basename(path))[0]
    dialect = resolve_dialect(name, found, (), report) if found else None
    return dialect, tuple(finding for finding in report if finding.is_error)


def hang(label: str, tree: Tree, files: Files) -> tuple[str, Files]:
    """Return the path at which a tree hangs, with the files in which it does: they are shown as ``label:path``."""
    root = os.path.join(os.getcwd(), f"{label}:")
    while files.exists(root):  # both sides may be of one name
        root += ":"
    return root, files.with_tree(root, tree)
