"""A file of scenarios into its records."""

import os

from codegen.decode.record_file import decode_record_file
from codegen.diagnostics import Report
from codegen.load.files import Files
from codegen.model.spec.scenario import ScenariosSpec

SCENARIOS = "scenarios.yaml"
"""The scenarios of a project, beside its project file."""


def decode_scenarios(path: str, files: Files, report: Report) -> ScenariosSpec | None:
    """The scenarios of a YAML file; None if it cannot be read. What is wrong with it is reported with its place.

    A scenario with errors is left out, and its errors say why.
    """
    return decode_record_file(os.path.abspath(path), ScenariosSpec, files, report)
