"""Findings on the terminal: one form for every command."""

import os
import sys
from collections.abc import Iterable
from typing import TextIO

from codegen.cli.progress import is_terminal
from codegen.diagnostics import Diagnostic, Report
from codegen.findings.as_json import findings_json
from codegen.findings.shortened import shortened
from codegen.findings.text import closing_line, finding_text

FORMATS = ("text", "json", "github", "sarif", "junit", "gitlab")
"""Formats in which findings can be printed."""


def print_findings(report: Report, form: str = "text", *, shows_waived: bool = True) -> None:
    """Print the findings to stdout, sorted and each once, in one of ``FORMATS``; of one kind not more than tell enough.

    As text, how many there are goes to stderr; where there are none, nothing is printed. People may do without those
    that are waived, and see their number; programs get all.
    """
    if form == "text":
        _print_text(report, shows_waived=shows_waived)
        return
    text = findings_text(shortened(report), form)
    if text:
        print(text)


def findings_text(findings: Iterable[Diagnostic], form: str) -> str:
    """The findings in one of ``FORMATS`` that other programs read; paths are those of the repository."""
    if form == "json":
        return findings_json(findings)
    root = repository_root()
    if form == "github":
        from codegen.findings.github import findings_github

        return findings_github(findings, root)
    if form == "junit":
        from codegen.findings.junit import findings_junit

        return findings_junit(findings, root)
    if form == "gitlab":
        from codegen.findings.gitlab import findings_gitlab

        return findings_gitlab(findings, root)
    from codegen.findings.sarif import findings_sarif

    return findings_sarif(findings, root)


def repository_root() -> str:
    """The absolute path of the folder that paths in a repository are relative to: the working directory outside one."""
    start = folder = os.getcwd()
    while not os.path.exists(os.path.join(folder, ".git")):
        above = os.path.dirname(folder)
        if above == folder:
            return start
        folder = above
    return folder


def _print_text(report: Report, *, shows_waived: bool) -> None:
    is_coloured = wants_colour(sys.stdout)
    for finding in shortened(report):
        if finding.waived is not None and not shows_waived:
            continue
        print(finding_text(finding, is_coloured=is_coloured))
    closing = closing_line(report)
    if closing:
        print(end="", flush=True)  # where both streams go to one place, the count comes last
        print(closing, file=sys.stderr)


def wants_colour(stream: TextIO | None) -> bool:
    """Return whether a stream is a terminal that shows colours, of somebody who has nothing against them."""
    return is_terminal(stream) and not os.environ.get("NO_COLOR")
