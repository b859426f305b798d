"""Finds the project that a command works on."""

import argparse
import os

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


def report_no_project(form: str = "text") -> int:
    """Print in a format of findings that a project is needed, and return the exit code of that."""
    from codegen.cli.findings import print_findings
    from codegen.diagnostics import Report
    from codegen.load.text import FILE_NOT_FOUND
    from codegen.source import Place

    folder = os.getcwd()
    report = Report()
    report.add(
        FILE_NOT_FOUND,
        Place(os.path.join(folder, PROJECT_FILES[0])),
        f"there is no {' or '.join(PROJECT_FILES)} in {folder} or above it",
        "codegen init begins a project, --project FILE names another one",
    )
    print_findings(report, form)
    return report.exit_code
