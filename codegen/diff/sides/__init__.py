"""The two sides of a comparison: what a command line means by a revision, a folder, an XML file or a dialect."""

import os
import re
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager

from codegen.diagnostics import Report
from codegen.diff.sides.release import ARCHIVES, INSTALLED, installed_side, release_folder, release_side
from codegen.diff.sides.revision import is_revision, revision_side
from codegen.diff.sides.side import Around, Side, Unreadable, dialect_side, project_side
from codegen.load.files import Files
from codegen.load.shipped import dialects_in, shipped_dialect_names
from codegen.project import PROJECT_FILES

WORK_TREE = "work tree"

_DIALECT_NAME = re.compile(r"[\w-]*")
_FILES = (".xml", ".yaml", ".yml", *ARCHIVES)

__all__ = ["Around", "Side", "Unreadable", "default_head", "opened"]


@contextmanager
def opened(text: str | None, around: Around) -> Iterator[Side | Unreadable]:
    """The side that ``text`` names, None for the project as it is. What it was read from is gone afterwards."""
    with ExitStack() as stack:
        files = _with_release(around)
        yield files if isinstance(files, Unreadable) else _side(text, around, files, stack)


def _with_release(around: Around) -> Files | Unreadable:
    """Return the files with the dialects of the pymavlink that is given, if one is, as those that are shipped."""
    if around.pymavlink is None:
        return around.files
    found = release_folder(around.pymavlink, around.files)
    if isinstance(found, Unreadable):
        return found
    folder, files = found
    report = Report()
    dialects = dialects_in(folder, files, report)
    if report.has_errors:
        return Unreadable(f"{around.pymavlink} cannot be read", findings=tuple(report))
    return files.with_dialects(dialects)


def _side(text: str | None, around: Around, files: Files, stack: ExitStack) -> Side | Unreadable:
    if text is None:
        if around.project is None:
            return Unreadable("there is no project here to compare with", "name both sides")
        return project_side(around.project, WORK_TREE, around, files)
    path, colon, name = text.rpartition(":")
    if os.path.exists(text) and not (_means_nothing(text) and is_revision(text, around)):
        return _ambiguous(text, "path", f".{os.sep}{text}", around) or _existing(text, around, files)
    if colon and _DIALECT_NAME.fullmatch(name) and os.path.exists(path) and not _means_nothing(path):
        return release_side(path, name, files)
    if path == INSTALLED:
        return installed_side(name, files)
    if text == INSTALLED:
        return installed_side(around.dialect, files)
    if text in shipped_dialect_names(files):
        return _ambiguous(text, "dialect of pymavlink", f"{INSTALLED}:{text}", around) or installed_side(text, files)
    return revision_side(text, around, files, stack)


def _means_nothing(path: str) -> bool:
    """Return whether a path is a file of no kind that is read here, such as the file HEAD of a bare repository."""
    return os.path.isfile(path) and not path.endswith(_FILES)


def _ambiguous(text: str, kind: str, plain: str, around: Around) -> Unreadable | None:
    """Return what is said where a revision has the name of something else: taking
    either would compare what was not meant.
    """
    if text.startswith((".", os.sep)) or text.endswith(_FILES) or not is_revision(text, around):
        return None
    return Unreadable(f"{text} is a {kind} and a revision", f"{plain} is the {kind}, {text}~0 the revision")


def _existing(path: str, around: Around, files: Files) -> Side | Unreadable:
    """Return what a path means: a dialect, a project, or a release of pymavlink."""
    if path.endswith(".xml") and os.path.isfile(path):
        return dialect_side(os.path.abspath(path), path, files)
    candidates = [os.path.join(path, name) for name in PROJECT_FILES]
    if path.endswith((".yaml", ".yml")):
        candidates = [path]
    for candidate in candidates:
        if os.path.isfile(candidate):
            return project_side(os.path.abspath(candidate), path, around, files)
    return release_side(path, around.dialect, files)


def default_head(base: Side) -> str | None:
    """Return what a side is compared with where only one is named: None for the project as it is."""
    return f"{INSTALLED}:{base.dialect.name}" if base.is_release else None
