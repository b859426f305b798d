"""Findings on the terminal: one form for every command."""

import json
import os
import sys
from typing import TextIO

from codegen.diagnostics import Diagnostic, Report, Severity
from codegen.source import shown_path

_COLOURS = {Severity.ERROR: "\x1b[1;31m", Severity.WARNING: "\x1b[1;33m"}
_PLAIN = "\x1b[0m"


def print_findings(report: Report) -> None:
    """Print the findings to stdout, sorted and each once, and how many there are to stderr (nothing if none)."""
    is_coloured = _wants_colour(sys.stdout)
    for finding in report:
        print(finding_text(finding, is_coloured=is_coloured))
    closing = closing_line(report)
    if closing:
        print(end="", flush=True)  # where both streams go to one place, the count comes last
        print(closing, file=sys.stderr)


def finding_text(finding: Diagnostic, *, is_coloured: bool = False) -> str:
    """``file:line:col: error RULE_ID: message``, then indented the hint and the related places."""
    severity = finding.rule.severity
    label = f"{_COLOURS[severity]}{severity}{_PLAIN}" if is_coloured else str(severity)
    lines = [f"{_escaped(finding.place.shown())}: {label} {finding.rule.id}: {_escaped(finding.message)}"]
    if finding.hint is not None:
        lines.append(f"  hint: {_escaped(finding.hint)}")
    lines.extend(f"  {_escaped(place.shown())}: {_escaped(text)}" for place, text in finding.related)
    return "\n".join(lines)


def findings_json(report: Report) -> str:
    """The findings as one JSON object with the keys findings, errors and warnings; paths as the text form has them."""
    found = [
        {
            "file": shown_path(finding.place.file),
            "line": finding.place.line,
            "column": finding.place.column,
            "severity": str(finding.rule.severity),
            "rule": finding.rule.id,
            "message": finding.message,
            "hint": finding.hint,
            "related": [
                {"file": shown_path(place.file), "line": place.line, "column": place.column, "message": text}
                for place, text in finding.related
            ],
        }
        for finding in report
    ]
    errors, warnings = _counts(report)
    return json.dumps({"findings": found, "errors": errors, "warnings": warnings}, indent=2)


def closing_line(report: Report) -> str:
    """``2 errors, 1 warning``, without what there is none of; empty if there is nothing."""
    counted = zip(_counts(report), ("error", "warning"), strict=True)
    return ", ".join(f"{count} {noun}{'' if count == 1 else 's'}" for count, noun in counted if count)


def _counts(report: Report) -> tuple[int, int]:
    severities = [finding.rule.severity for finding in report]
    return severities.count(Severity.ERROR), severities.count(Severity.WARNING)


def _escaped(text: str) -> str:
    """``text`` on one line and harmless to a terminal: it may quote whatever an input file holds."""
    text = " ".join(text.splitlines())
    if text.isprintable():
        return text
    return "".join(one if one.isprintable() else one.encode("unicode_escape").decode("ascii") for one in text)


def _wants_colour(stream: TextIO | None) -> bool:
    return stream is not None and stream.isatty() and not os.environ.get("NO_COLOR")
