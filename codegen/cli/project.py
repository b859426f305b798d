"""Which project a command works on."""

import argparse
import os
import sys

from codegen.project_files import PROJECT_FILES


def project_file(arguments: argparse.Namespace) -> str | None:
    """The absolute path of ``--project`` or of the nearest project file; None without either.

    A folder stands for the project file in it, where there is one.
    """
    given: str | None = getattr(arguments, "project", None)
    if given is None:
        return nearest_project(os.getcwd())
    path = os.path.abspath(given)
    return _in_folder(path) or path


def _in_folder(folder: str) -> str | None:
    """The project file of a folder; None where it has none."""
    candidates = (os.path.join(folder, name) for name in PROJECT_FILES)
    return next((path for path in candidates if os.path.isfile(path)), None)


def report_no_project() -> int:
    """Say on stderr that a project is needed, and return the exit code of that."""
    print(
        f"codegen: there is no {' or '.join(PROJECT_FILES)} in {os.getcwd()} or above it; codegen init begins a "
        "project, --project FILE names another one",
        file=sys.stderr,
    )
    return 2


def nearest_project(folder: str) -> str | None:
    """The project file that lies nearest, in ``folder`` (absolute) or one above it."""
    while True:
        path = _in_folder(folder)
        if path is not None:
            return path
        above = os.path.dirname(folder)
        if above == folder:
            return None
        folder = above
