"""Reads a side of a comparison from a revision of git: a project, or with a path behind a colon a dialect."""

import os
from contextlib import ExitStack
from difflib import get_close_matches

from codegen.diagnostics import did_you_mean
from codegen.diff.sides.side import Around, Side, Unreadable, dialect_side, hang, project_side
from codegen.load.files import Files
from codegen.load.git import GitFault, commit_of, repository_of
from codegen.load.git_tree import GitTree
from codegen.load.shipped import shipped_dialect_names
from codegen.project import PROJECT_FILES


def is_revision(text: str, around: Around) -> bool:
    """Return whether git knows a revision of this name."""
    repository = _repository(around)
    return isinstance(repository, str) and isinstance(commit_of(repository, text), str)


def revision_side(text: str, around: Around, files: Files, stack: ExitStack) -> Side | Unreadable:
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
        hint = commit.hint or did_you_mean(text, get_close_matches(text, shipped_dialect_names(files)))
        return Unreadable(f"{text} is no file, folder, dialect or revision: {commit.message}", hint)
    tree = stack.enter_context(GitTree(repository, commit))
    root, files = hang(revision, tree, files)
    found = _in_tree(text, path, root, repository, around, files)
    if tree.fault is not None:
        return Unreadable(f"{text} cannot be read: {tree.fault.message}", tree.fault.hint)
    return found


def _repository(around: Around) -> str | GitFault:
    """The repository of the project, or without one that of the working directory."""
    project = around.project and os.path.realpath(around.project)
    return repository_of(os.path.dirname(project) if project else os.getcwd())


def _in_tree(text: str, path: str, root: str, repository: str, around: Around, files: Files) -> Side | Unreadable:
    """Return what a revision that hangs at ``root`` has: at ``path``, or without one where the project is.

    A folder without a project is one of dialects, of which the one is meant that ``--dialect`` names.
    """
    if path.endswith(".xml"):
        return dialect_side(os.path.normpath(os.path.join(root, path)), text, files)
    candidates = [os.path.join(path, name) for name in ("", *PROJECT_FILES)]
    if not path:
        candidates = list(PROJECT_FILES)
        if around.project:
            candidates.insert(0, os.path.relpath(os.path.realpath(around.project), repository))
    for candidate in candidates:
        file = os.path.normpath(os.path.join(root, candidate))
        if files.is_file(file):
            return project_side(file, text, around, files)
    dialect = os.path.normpath(os.path.join(root, path, f"{around.dialect}.xml"))
    if path and files.is_file(dialect):
        return dialect_side(dialect, f"{text}:{around.dialect}", files)
    is_file_meant = path.endswith((".yaml", ".yml"))
    return Unreadable(f"{text} has no {path if is_file_meant else candidates[-1] if path else candidates[0]}")
