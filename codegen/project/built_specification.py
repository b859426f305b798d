"""The hash of the specification that tests written by hand were run with, for their results.

They test what was generated, so it is what the generated suites say that they were made of: tables that were changed
since the last build are not what was tested.
"""

import json
import os

from codegen.decode.programs import list_programs
from codegen.decode.record_file import decode_record_file
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.model.spec.spec import Project
from codegen.model.test_record import specification_hash


def built_specification(project_file: str) -> str | None:
    """The hash for results of tests that run now; None where a suite was not generated, or cannot be read."""
    project = decode_record_file(os.path.abspath(project_file), Project, DISK, Report())
    if project is None:
        return None
    folder = os.path.join(os.path.dirname(os.path.abspath(project_file)), project.output)
    names = ["", *(program.name for program in list_programs(project_file, DISK, Report()))]
    digests = {name: _inputs(os.path.normpath(os.path.join(folder, name, "tests", "cases.json"))) for name in names}
    found = {name: digest for name, digest in digests.items() if digest is not None}
    return specification_hash(found) if len(found) == len(names) else None


def _inputs(path: str) -> str | None:
    """Return what a generated suite was made of, as the file of its cases says."""
    text = DISK.read_text(path, Report())
    try:
        inputs = json.loads(text or "")["generated"]["inputs"]
    except (ValueError, KeyError, TypeError, RecursionError):
        return None
    return inputs if isinstance(inputs, str) else None
