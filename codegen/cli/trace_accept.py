"""``codegen trace accept``: criteria whose rows and tests were reviewed with their text as it is now."""

import argparse
import sys
from collections.abc import Sequence

from codegen import pipeline
from codegen.cli.findings import print_findings
from codegen.cli.trace_report import chosen_names
from codegen.decode.reach import folders_of
from codegen.decode.trace_lock import decode_trace_lock, read_trace_lock_text
from codegen.diagnostics import Report
from codegen.emit.file import write_file
from codegen.load.confined import confined
from codegen.model.system import System
from codegen.source import Place, shown_path
from codegen.trace.graph import Trace
from codegen.trace.lock import LOCK_FORM, Review, accepted, gone, holds, lock_line, required, reviews


def accept(arguments: argparse.Namespace, project: str, systems: Sequence[System]) -> int:
    """Write the lock file, all other entries as they are, and return the exit code."""
    report = Report()
    path = pipeline.trace_lock_path(project)
    with confined(folders_of(project)):
        written = read_trace_lock_text(path, report)
    lock = None if written is None else decode_trace_lock(written, path, report)
    if report.has_errors:
        print_findings(report)
        return report.exit_code
    trace = pipeline.read_trace(systems, Report())
    dropped = list(gone(trace, lock))
    names = _names(arguments.names[1:], trace, dropped)
    if names is None:
        return 2
    if arguments.all:
        names = [name for name, review in reviews(trace, lock).items() if review is not Review.REVIEWED]
    else:
        dropped = [name for name in dropped if name in arguments.names]
    lines = {name: lock_line(name, trace.criteria[name][1].text, arguments.reason, arguments.by) for name in names}
    text = accepted(written, lines, dropped)
    faults, reading = Report(), Report()
    read_back = decode_trace_lock(text, path, reading)
    if reading.has_errors or not holds(read_back, lock, lines.keys(), dropped):
        faults.add(LOCK_FORM, Place(path), "it has to have one line for each criterion")
    elif text != written:
        write_file(path, text, faults)
    if faults.has_errors:
        print_findings(faults)
        return faults.exit_code
    said = f"{len(lines)} accepted" + (f", {len(dropped)} removed" if dropped else "")
    print(f"{shown_path(path)}: {said}", file=sys.stderr)
    return 0


def _names(asked: Sequence[str], trace: Trace, dropped: Sequence[str]) -> list[str] | None:
    """The criteria that are meant, in their order; None, after saying so, where one does not exist or only decides."""
    chosen = chosen_names([name for name in asked if name not in dropped], trace) if asked else set()
    if chosen is None:
        return None
    asking = required(trace)
    return [name for name in asking if name in chosen] if set(asked) - set(dropped) else []
