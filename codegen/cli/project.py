"""Which project a command works on."""

import argparse
import os
import sys

from codegen.project_files import PROJECT_FILES


def project_file(arguments: argparse.Namespace) -> str | None:
    """The absolute path of ``--project`` or of the nearest project file; None without either."""
    given: str | None = getattr(arguments, "project", None)
    return nearest_project(os.getcwd()) if given is None else os.path.abspath(given)


def report_no_project() -> int:
    """Say on stderr that a project is needed, and return the exit code of that."""
    print(
        f"codegen: there is no {' or '.join(PROJECT_FILES)} in {os.getcwd()} or above it; name one with --project FILE",
        file=sys.stderr,
    )
    return 2


def nearest_project(folder: str) -> str | None:
    """The project file that lies nearest, in ``folder`` (absolute) or one above it."""
    while True:
        for candidate in PROJECT_FILES:
            path = os.path.join(folder, candidate)
            if os.path.isfile(path):
                return path
        above = os.path.dirname(folder)
        if above == folder:
            return None
        folder = above
