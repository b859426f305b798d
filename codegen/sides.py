"""The two sides of a comparison: what a command line means by a revision, a folder, an XML file or a dialect."""

import os
import re
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from difflib import get_close_matches

from codegen.decode.dialect_files import decode_dialect_files
from codegen.diagnostics import Diagnostic, Report, did_you_mean
from codegen.load.archive import ENDINGS, read_archive
from codegen.load.git import GitFault, commit_of, repository_of
from codegen.load.git_tree import GitTree
from codegen.load.shipped import dialects_in, shipped_dialect_names, shipped_dialect_path, shipped_in
from codegen.load.trees import Tree, exists, file_names, hung, is_file
from codegen.model.dialect import Dialect
from codegen.model.system import System
from codegen.resolve.dialect import resolve_dialect

PROJECT_FILES = ("specs/codegen.yaml", "codegen.yaml")
INSTALLED = "pymavlink"
WORK_TREE = "work tree"

_DIALECTS = re.compile(r"(?:^|/)(?:dialects/v20|message_definitions/v1\.0)/[^/]+\.xml$")
_FOLDERS = ("", "pymavlink/dialects/v20", "dialects/v20", "v20", "message_definitions/v1.0")
_DIALECT_NAME = re.compile(r"[\w-]*")
_FILES = (".xml", ".yaml", ".yml", *ENDINGS)
_SITE_PACKAGES = re.compile(r"python3[.\d]*")


@dataclass(frozen=True, slots=True)
class Side:
    """One side: how people call it, and what there is: the systems of a project, the first its own, or a dialect.

    ``findings`` are the errors that reading it found; what they concern may be missing. ``is_release`` marks a dialect
    of a pymavlink.
    """

    label: str
    systems: tuple[System, ...]
    dialect: Dialect
    findings: tuple[Diagnostic, ...]
    is_release: bool = False

    @property
    def is_project(self) -> bool:
        """Whether it has a specification and not only a dialect."""
        return bool(self.systems)


@dataclass(frozen=True, slots=True)
class Unreadable:
    """Why there is no side: in words, with a hint, or by what reading it found."""

    message: str
    hint: str | None = None
    findings: tuple[Diagnostic, ...] = ()


@dataclass(frozen=True, slots=True)
class Around:
    """What a side is looked for in: the project file that the command works on, if there is one, and options.

    ``dialect`` is the dialect of a release that is meant where none is named; ``pymavlink`` a release whose dialects
    take the place of the installed ones. ``read_systems`` reads a project: the caller's, since comparing dialects needs
    nothing of what it does.
    """

    project: str | None
    dialect: str
    read_systems: Callable[[str, Report], tuple[System, ...]]
    pymavlink: str | None = None


@contextmanager
def opened(text: str | None, around: Around) -> Iterator[Side | Unreadable]:
    """The side that ``text`` names, None for the project as it is. What it was read from is gone afterwards."""
    with ExitStack() as stack:
        if around.pymavlink is None:
            side = _side(text, around, stack)
        else:
            folder = _release(around.pymavlink, stack)
            if isinstance(folder, Unreadable):
                side = folder
            else:
                with shipped_in(folder):
                    side = _side(text, around, stack)
        yield side


def _side(text: str | None, around: Around, stack: ExitStack) -> Side | Unreadable:
    if text is None:
        if around.project is None:
            return Unreadable("there is no project here to compare with", "name both sides")
        return _project(around.project, WORK_TREE, around)
    path, colon, name = text.rpartition(":")
    if os.path.exists(text) and not (_means_nothing(text) and _is_revision(text, around)):
        return _ambiguous(text, "path", f".{os.sep}{text}", around) or _existing(text, around, stack)
    if colon and _DIALECT_NAME.fullmatch(name) and os.path.exists(path) and not _means_nothing(path):
        return _of_release(path, name, stack)
    if path == INSTALLED:
        return _installed(name)
    if text == INSTALLED:
        return _installed(around.dialect)
    if text in shipped_dialect_names():
        return _ambiguous(text, "dialect of pymavlink", f"{INSTALLED}:{text}", around) or _installed(text)
    return _revision(text, around, stack)


def _means_nothing(path: str) -> bool:
    """Whether a path is a file of no kind that is read here, such as the file HEAD of a bare repository."""
    return os.path.isfile(path) and not path.endswith(_FILES)


def _ambiguous(text: str, kind: str, plain: str, around: Around) -> Unreadable | None:
    """What is said where a revision has the name of something else: taking either would compare what was not meant."""
    if text.startswith((".", os.sep)) or text.endswith(_FILES) or not _is_revision(text, around):
        return None
    return Unreadable(f"{text} is a {kind} and a revision", f"{plain} is the {kind}, {text}~0 the revision")


def _is_revision(text: str, around: Around) -> bool:
    repository = _repository(around)
    return isinstance(repository, str) and isinstance(commit_of(repository, text), str)


def _existing(path: str, around: Around, stack: ExitStack) -> Side | Unreadable:
    """What a path means: a dialect, a project, or a release of pymavlink."""
    if path.endswith(".xml") and os.path.isfile(path):
        return _dialect(os.path.abspath(path), path)
    candidates = [os.path.join(path, name) for name in PROJECT_FILES]
    if path.endswith((".yaml", ".yml")):
        candidates = [path]
    for candidate in candidates:
        if os.path.isfile(candidate):
            return _project(os.path.abspath(candidate), path, around)
    return _of_release(path, around.dialect, stack)


def _project(file: str, label: str, around: Around) -> Side | Unreadable:
    report = Report()
    systems = around.read_systems(file, report)
    errors = tuple(finding for finding in report if finding.is_error)
    if not systems or systems[0].spec.program:
        return Unreadable(f"{label} has no specification that can be read", findings=errors or tuple(report))
    return Side(label, systems, systems[0].dialect, errors)


def _dialect(path: str, label: str, *, is_release: bool = False) -> Side | Unreadable:
    report = Report()
    files = decode_dialect_files(path, report)
    errors = tuple(finding for finding in report if finding.is_error)
    if not files:
        return Unreadable(f"{label} is no dialect that can be read", findings=errors)
    dialect = resolve_dialect(os.path.splitext(os.path.basename(path))[0], files, (), report)
    errors = tuple(finding for finding in report if finding.is_error)
    if errors and not dialect.messages and not dialect.enums:
        return Unreadable(f"{label} is no dialect that can be read", findings=errors)
    return Side(label, (), dialect, errors, is_release)


def _installed(name: str) -> Side | Unreadable:
    path = shipped_dialect_path(name)
    if path is None:
        return Unreadable(f"the installed pymavlink has no dialect {name}", did_you_mean(name, shipped_dialect_names()))
    return _dialect(path, f"{INSTALLED}:{name}", is_release=True)


def _of_release(release: str, name: str, stack: ExitStack) -> Side | Unreadable:
    folder = _release(release, stack)
    if isinstance(folder, Unreadable):
        return folder
    dialects = dialects_in(folder)
    if name not in dialects:
        return Unreadable(f"{release} has no dialect {name}", did_you_mean(name, dialects))
    return _dialect(dialects[name], f"{release}:{name}", is_release=True)


def _release(path: str, stack: ExitStack) -> str | Unreadable:
    """The folder with the dialects of a pymavlink: of a wheel, a source archive, a folder that one is installed in."""
    root = os.path.abspath(path)
    if os.path.isfile(path):
        if not path.endswith(ENDINGS):
            return Unreadable(f"{path} is neither a dialect (.xml) nor an archive", f"archives: {', '.join(ENDINGS)}")
        archive = read_archive(path, _DIALECTS)
        if isinstance(archive, str):
            return Unreadable(archive)
        root = _hang(os.path.basename(path), archive, stack)
        folders = sorted({os.path.dirname(inner) for inner in archive.paths()}, key=_is_second_choice)
        if folders:
            return os.path.join(root, folders[0])
    elif os.path.isdir(path):
        below = [os.path.join(root, "lib", name, "site-packages") for name in file_names(os.path.join(root, "lib"))]
        for start in (root, *(one for one in below if _SITE_PACKAGES.fullmatch(one.split(os.sep)[-2]))):
            for folder in _FOLDERS:
                candidate = os.path.join(start, folder).rstrip(os.sep)
                if is_file(os.path.join(candidate, "common.xml")):
                    return candidate
    else:
        return Unreadable(
            f"{path} is neither a file nor a folder" if os.path.exists(path) else f"{path} does not exist"
        )
    return Unreadable(f"{path} holds neither a project nor the dialects of a pymavlink")


def _is_second_choice(folder: str) -> bool:
    return "v20" not in folder


def _hang(label: str, tree: Tree, stack: ExitStack) -> str:
    """The path at which a tree hangs: what lies there is shown as ``label:path``."""
    root = os.path.join(os.getcwd(), f"{label}:")
    while exists(root):  # both sides may be of one name
        root += ":"
    stack.enter_context(hung(root, tree))
    return root


def _revision(text: str, around: Around, stack: ExitStack) -> Side | Unreadable:
    """A project, or with ``:path`` a dialect or a project, as git has it at a revision."""
    repository = _repository(around)
    if isinstance(repository, GitFault):
        why = "this is no git repository" if "not a git repository" in repository.message else repository.message
        return Unreadable(f"{text} is no file, folder or dialect, and {why}", repository.hint)
    revision, path = text, ""
    commit = commit_of(repository, revision)
    if isinstance(commit, GitFault) and ":" in text.lstrip(":"):
        revision, _, path = text.rpartition(":")
        commit = commit_of(repository, revision)
        if path.startswith(("./", "../")):  # to git that is below the folder where the command runs
            path = os.path.relpath(os.path.join(os.path.realpath(os.getcwd()), path), repository)
    if isinstance(commit, GitFault):
        hint = commit.hint or did_you_mean(text, get_close_matches(text, shipped_dialect_names()))
        return Unreadable(f"{text} is no file, folder, dialect or revision: {commit.message}", hint)
    tree = stack.enter_context(GitTree(repository, commit))
    found = _in_tree(text, path, _hang(revision, tree, stack), repository, around)
    if tree.fault is not None:
        return Unreadable(f"{text} cannot be read: {tree.fault.message}", tree.fault.hint)
    return found


def _repository(around: Around) -> str | GitFault:
    """The repository of the project, or without one that of the working directory."""
    project = around.project and os.path.realpath(around.project)
    return repository_of(os.path.dirname(project) if project else os.getcwd())


def _in_tree(text: str, path: str, root: str, repository: str, around: Around) -> Side | Unreadable:
    """What a revision that hangs at ``root`` has: at ``path``, or without one where the project is."""
    if path.endswith(".xml"):
        return _dialect(os.path.normpath(os.path.join(root, path)), text)
    candidates = [os.path.join(path, name) for name in ("", *PROJECT_FILES)]
    if not path:
        candidates = list(PROJECT_FILES)
        if around.project:
            candidates.insert(0, os.path.relpath(os.path.realpath(around.project), repository))
    for candidate in candidates:
        file = os.path.normpath(os.path.join(root, candidate))
        if is_file(file):
            return _project(file, text, around)
    is_file_meant = path.endswith((".yaml", ".yml"))
    return Unreadable(f"{text} has no {path if is_file_meant else candidates[-1] if path else candidates[0]}")


def default_head(base: Side) -> str | None:
    """What a side is compared with where only one is named: None for the project as it is."""
    return f"{INSTALLED}:{base.dialect.name}" if base.is_release else None
