"""The lock file of the trace into its record."""

from codegen.decode.record_file import decode_record_text
from codegen.diagnostics import Report
from codegen.load.files import Files
from codegen.model.spec.trace_lock import TraceLockSpec

TRACE_LOCK = "trace.lock.yaml"
"""The lock file of a project, beside its project file."""


def read_trace_lock_text(path: str, files: Files, report: Report) -> str | None:
    """The text of the lock file; None where there is none, or, after a finding, where it cannot be read."""
    return files.read_text(path, report) if files.exists(path) else None


def decode_trace_lock(text: str, path: str, report: Report) -> TraceLockSpec | None:
    """Return what the text of a lock file says; None, after a finding, where it says nothing that can be used."""
    return decode_record_text(text, path, TraceLockSpec, report)
