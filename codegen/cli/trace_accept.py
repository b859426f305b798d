"""``codegen trace accept``: what the options say was looked at, and what the lock file has now."""

import argparse
import sys
from collections.abc import Sequence

from codegen.cli.findings import print_findings
from codegen.commands.trace import Refused
from codegen.commands.trace_accept import LookedAt
from codegen.commands.trace_accept import accept as accepted
from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.source import shown_path


def accept(arguments: argparse.Namespace, project: str, systems: Sequence[System]) -> int:
    """Write the lock file, say what it has now, and return the exit code."""
    links = arguments.link or ()
    seen = LookedAt(arguments.names[1:], arguments.all, links, arguments.reason, arguments.by)
    report = Report()
    done = accepted(project, systems, seen, report)
    if isinstance(done, Refused):
        print(f"codegen trace: {done.why}", file=sys.stderr)
        return 2
    if done is None:
        print_findings(report)
        return report.exit_code
    what = f"{len(links)} of the links from {done.criteria[0]}" if links else str(len(done.criteria))
    removed = f", {len(done.dropped)} removed" if done.dropped else ""
    print(f"{shown_path(done.path)}: {what} accepted{removed}", file=sys.stderr)
    print("next: codegen build, as docs/trace.html shows what was reviewed", file=sys.stderr)
    return 0
