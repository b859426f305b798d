"""The lock file of the trace into its record."""

import os

from codegen.decode.record import decode_record
from codegen.diagnostics import Report
from codegen.load.text import decode_text, read_bytes
from codegen.load.trees import exists
from codegen.load.yaml_tree import parse_yaml
from codegen.model.trace_lock_spec import TraceLockSpec

TRACE_LOCK = "trace.lock.yaml"
"""The lock file of a project, beside its project file."""


def decode_trace_lock(path: str, report: Report) -> TraceLockSpec | None:
    """What the lock file says; None where there is none. One that cannot be read is reported and counts as empty."""
    path = os.path.abspath(path)
    if not exists(path):
        return None
    data = read_bytes(path, report)
    text = None if data is None else decode_text(data, path, report)
    return None if text is None else decode_trace_lock_text(text, path, report)


def decode_trace_lock_text(text: str, path: str, report: Report) -> TraceLockSpec | None:
    """The same for a text that was read already."""
    tree = parse_yaml(text, path, report)
    return None if tree is None else decode_record(tree, TraceLockSpec, report)
