"""A file of waivers into its records."""

import os

from codegen.decode.record_file import decode_record_file
from codegen.diagnostics import Report
from codegen.load.files import Files
from codegen.model.spec.waiver import SeveritySpec, WaiverSpec, WaiversSpec

WAIVERS = "waivers.yaml"
"""The waivers of a project, beside its project file."""


def decode_severities(path: str, files: Files, report: Report) -> tuple[SeveritySpec, ...]:
    """The severities that the same file sets for ``codegen diff``."""
    decoded = decode_record_file(os.path.abspath(path), WaiversSpec, files, report)
    return decoded.severities if decoded else ()


def decode_waivers(path: str, files: Files, report: Report) -> tuple[WaiverSpec, ...]:
    """The waivers of a YAML file, those with errors left out; what is wrong with it is reported with its place."""
    decoded = decode_record_file(os.path.abspath(path), WaiversSpec, files, report)
    return decoded.waivers if decoded else ()
