"""A file of waivers into its records."""

import os

from codegen.decode.record import decode_record
from codegen.diagnostics import Report
from codegen.load.text import decode_text, read_bytes
from codegen.load.yaml_tree import parse_yaml
from codegen.model.waiver_spec import WaiverSpec, WaiversSpec

WAIVERS = "waivers.yaml"
"""The waivers of a project, beside its project file."""


def decode_waivers(path: str, report: Report) -> tuple[WaiverSpec, ...]:
    """The waivers of a YAML file, those with errors left out; what is wrong with it is reported with its place."""
    path = os.path.abspath(path)
    data = read_bytes(path, report)
    text = None if data is None else decode_text(data, path, report)
    tree = None if text is None else parse_yaml(text, path, report)
    decoded = None if tree is None else decode_record(tree, WaiversSpec, report)
    return decoded.waivers if decoded else ()
