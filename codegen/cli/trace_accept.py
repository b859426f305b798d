"""``codegen trace accept``: criteria whose rows and tests were reviewed with their text as it is now."""

import argparse
import sys
from collections.abc import Sequence

from codegen.cli.findings import print_findings
from codegen.cli.trace_report import chosen_names
from codegen.commands.trace import read_trace, trace_lock_path
from codegen.decode.reach import folders_of
from codegen.decode.trace_lock import decode_trace_lock, read_trace_lock_text
from codegen.diagnostics import Report
from codegen.emit.file import write_file
from codegen.load.confined import confined
from codegen.model.spec.trace_lock import TraceLockSpec
from codegen.model.system import System
from codegen.source import Place, shown_path
from codegen.trace.graph import Trace
from codegen.trace.link import Link, chosen_link, suspects
from codegen.trace.lock import (
    LOCK_FORM,
    Review,
    accepted,
    gone,
    holds,
    lock_line,
    lock_line_by_link,
    required,
    reviews,
)


def accept(arguments: argparse.Namespace, project: str, systems: Sequence[System]) -> int:
    """Write the lock file, all other entries as they are, and return the exit code."""
    report = Report()
    path = trace_lock_path(project)
    with confined(folders_of(project)):
        written = read_trace_lock_text(path, report)
    lock = None if written is None else decode_trace_lock(written, path, report)
    if report.has_errors:
        print_findings(report)
        return report.exit_code
    trace = read_trace(systems, Report())
    dropped = list(gone(trace, lock))
    names = _names(arguments.names[1:], trace, dropped)
    if names is None:
        return 2
    if arguments.all:
        names = [name for name, review in reviews(trace, lock).items() if review is not Review.REVIEWED]
    else:
        dropped = [name for name in dropped if name in arguments.names]
    if arguments.link:
        line = _line_of_links(names, trace, lock, arguments)
        if line is None:
            return 2
        lines = {names[0]: line}
    else:
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
    accept = f"{len(arguments.link)} of the links from {names[0]}" if arguments.link else str(len(lines))
    said = f"{accept} accepted" + (f", {len(dropped)} removed" if dropped else "")
    print(f"{shown_path(path)}: {said}", file=sys.stderr)
    return 0


def _line_of_links(
    names: Sequence[str], trace: Trace, lock: TraceLockSpec | None, arguments: argparse.Namespace
) -> str | None:
    """The line of the one criterion of which single links are accepted; None, after saying so, where it has none."""
    links = _suspects_of(names, trace, lock)
    chosen = links if isinstance(links, str) else [chosen_link(asked, links) for asked in arguments.link]
    refused = [chosen] if isinstance(chosen, str) else [each for each in chosen if isinstance(each, str)]
    if refused or lock is None or isinstance(links, str):
        print(f"codegen trace: {refused[0]}", file=sys.stderr)
        return None
    looked_at = [each.name for each in chosen if isinstance(each, Link)]
    is_partial = any(link.name not in looked_at for link in links)
    name = names[0]
    text = trace.criteria[name][1].text
    kept = lock.criteria[name]
    return lock_line_by_link(name, kept, text, arguments.reason, arguments.by, looked_at, is_partial=is_partial)


def _suspects_of(names: Sequence[str], trace: Trace, lock: TraceLockSpec | None) -> Sequence[Link] | str:
    """The suspect links from the one criterion that is meant; in words, why there are none."""
    if len(names) != 1:
        return "accept --link takes one criterion"
    name = names[0]
    if lock is None or name not in lock.criteria:
        return f"{name} was never reviewed: accept it without --link, with all that answers to it"
    links = suspects(trace, lock).get(name)
    return f"the text of {name} is the one that was reviewed: none of its links is suspect" if links is None else links


def _names(asked: Sequence[str], trace: Trace, dropped: Sequence[str]) -> list[str] | None:
    """The criteria that are meant, in their order; None, after saying so, where one does not exist or only decides."""
    chosen = chosen_names([name for name in asked if name not in dropped], trace) if asked else set()
    if chosen is None:
        return None
    asking = required(trace)
    return [name for name in asking if name in chosen] if set(asked) - set(dropped) else []
