"""The corrections that come with codegen for the dialects of pymavlink: one YAML file for each that needs some."""

import os
from collections.abc import Iterable

from codegen.decode.record_file import decode_record_file
from codegen.diagnostics import Report
from codegen.load.files import Files
from codegen.load.shipped import is_shipped
from codegen.model.dialect.dialect import DialectFile
from codegen.model.spec.spec import ShippedCorrection, ShippedCorrectionsSpec

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "corrections")
"""The absolute path of the folder that they lie in, each file called as its dialect."""


def shipped_corrections(dialects: Iterable[DialectFile], files: Files, report: Report) -> tuple[ShippedCorrection, ...]:
    """The corrections for those of the ``dialects`` that pymavlink ships; XML of a project has its own corrections."""
    corrections: list[ShippedCorrection] = []
    for file in dialects:
        path = os.path.join(FOLDER, os.path.splitext(os.path.basename(file.path))[0] + ".yaml")
        if is_shipped(file.path, files) and os.path.isfile(path):
            decoded = decode_record_file(path, ShippedCorrectionsSpec, files, report)
            corrections += decoded.corrections if decoded else ()
    return tuple(corrections)
