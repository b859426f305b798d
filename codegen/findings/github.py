"""Findings as workflow commands of GitHub Actions, which shows them beside the lines of a pull request."""

from collections.abc import Iterable

from codegen.diagnostics import Diagnostic, Severity
from codegen.findings.text import WAIVED, printable, repository_path


def findings_github(findings: Iterable[Diagnostic], base: str | None = None) -> str:
    """One ``::error file=...,line=...,col=...,title=RULE::message`` for each finding; empty where there is none.

    ``base`` is the root of the repository, to which GitHub's paths are relative; what is not in it is named by the
    message and stands at no file. Hint and related places are further lines of the message. A waived finding is a
    notice.
    """
    return "\n".join(_annotation(finding, base) for finding in findings)


def _annotation(finding: Diagnostic, base: str | None) -> str:
    place = finding.place
    is_waived = finding.waived is not None
    file, is_shown = repository_path(place.file, base)
    lines = [printable(finding.message if is_shown else f"{file}:{place.line}: {finding.message}")]
    if finding.advice is not None:
        lines.append(f"hint: {printable(finding.advice)}")
    if finding.waived is not None:
        lines.append(f"waived: {printable(finding.waived)}")
    for other, text in finding.related:
        lines.append(
            f"{printable(repository_path(other.file, base)[0])}:{other.line}:{other.column}: {printable(text)}"
        )
    properties = {"file": file, "line": str(place.line), "col": str(place.column)} if is_shown else {}
    properties["title"] = f"{finding.rule.id} ({WAIVED})" if is_waived else finding.rule.id
    stated = ",".join(f"{name}={_property(value)}" for name, value in properties.items())
    is_quiet = is_waived or finding.rule.severity is Severity.INFO
    command = "notice" if is_quiet else str(finding.rule.severity)
    message = "\n".join(lines)
    return f"::{command} {stated}::{_message(message)}"


def _message(text: str) -> str:
    """``text`` with what would end the command, or be taken for an escape, escaped as GitHub's toolkit does it."""
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    """``text`` as the value of a property, which colons and commas would end."""
    return _message(text).replace(":", "%3A").replace(",", "%2C")
