"""A file of scenarios into its records."""

import os

from codegen.decode.record import decode_record
from codegen.diagnostics import Report
from codegen.load.text import decode_text, read_bytes
from codegen.load.yaml_tree import parse_yaml
from codegen.model.scenario_spec import ScenariosSpec

SCENARIOS = "scenarios.yaml"
"""The scenarios of a project, beside its project file."""


def decode_scenarios(path: str, report: Report) -> ScenariosSpec | None:
    """The scenarios of a YAML file; None if it cannot be read. What is wrong with it is reported with its place.

    A scenario with errors is left out, and its errors say why.
    """
    path = os.path.abspath(path)
    data = read_bytes(path, report)
    text = None if data is None else decode_text(data, path, report)
    tree = None if text is None else parse_yaml(text, path, report)
    return None if tree is None else decode_record(tree, ScenariosSpec, report)
