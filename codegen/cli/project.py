"""Which project a command works on."""

import argparse
import os
import sys

from codegen.project import PROJECT_FILES, nearest_project, project_in


def project_file(arguments: argparse.Namespace) -> str | None:
    """The absolute path of ``--project`` or of the nearest project file; None without either.

    A folder stands for the project file in it, where there is one.
    """
    given: str | None = getattr(arguments, "project", None)
    if given is None:
        return nearest_project(os.getcwd())
    path = os.path.abspath(given)
    return project_in(path) or path


def report_no_project() -> int:
    """Say on stderr that a project is needed, and return the exit code of that."""
    print(
        f"codegen: there is no {' or '.join(PROJECT_FILES)} in {os.getcwd()} or above it; codegen init begins a "
        "project, --project FILE names another one",
        file=sys.stderr,
    )
    return 2
