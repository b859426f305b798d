"""Findings for people: one line each, then its hint and what explains it."""

from collections.abc import Iterable

from codegen.diagnostics import Diagnostic, Severity
from codegen.source import shown_path

WAIVED = "waived"
"""The word in place of the severity of a finding that is waived."""

_COLOURS = {Severity.ERROR: "\x1b[1;31m", Severity.WARNING: "\x1b[1;33m", Severity.INFO: "\x1b[2m", WAIVED: "\x1b[2m"}
_PLAIN = "\x1b[0m"
_PACKAGES = ("site-packages/", "dist-packages/", ".whl:", ".whl/", ".tar.gz:", ".tar.gz/")


def finding_text(finding: Diagnostic, *, is_coloured: bool = False) -> str:
    """``file:line:col: error RULE_ID: message``, then indented the hint, the waiver and the related places."""
    standing = finding.rule.severity if finding.waived is None else WAIVED
    label = f"{_COLOURS[standing]}{standing}{_PLAIN}" if is_coloured else str(standing)
    lines = [f"{printable(finding.place.shown())}: {label} {finding.rule.id}: {printable(finding.message)}"]
    if finding.advice is not None:
        lines.append(f"  hint: {printable(finding.advice)}")
    if finding.waived is not None:
        lines.append(f"  waived: {printable(finding.waived)}")
    lines.extend(f"  {printable(place.shown())}: {printable(text)}" for place, text in finding.related)
    return "\n".join(lines)


def closing_line(findings: Iterable[Diagnostic]) -> str:
    """``2 errors, 1 warning, 1 waived``, without what there is none of; empty if there is nothing."""
    errors, warnings, waived = counts(findings)
    told = [f"{count} {noun}{'' if count == 1 else 's'}" for count, noun in ((errors, "error"), (warnings, "warning"))]
    return ", ".join(line for line in (*told, f"{waived} waived") if not line.startswith("0 "))


def counts(findings: Iterable[Diagnostic]) -> tuple[int, int, int]:
    """Return how many errors, warnings and waived findings there are."""
    standings = [finding.rule.severity if finding.waived is None else None for finding in findings]
    return standings.count(Severity.ERROR), standings.count(Severity.WARNING), standings.count(None)


def printable(text: str) -> str:
    """``text`` on one line and harmless to a terminal: it may quote whatever an input file holds."""
    text = " ".join(text.splitlines())
    if text.isprintable():
        return text
    return "".join(one if one.isprintable() else one.encode("unicode_escape").decode("ascii") for one in text)


def forward_path(path: str, base: str | None = None) -> str:
    """``path`` with forward slashes, relative to ``base`` (default: the working directory) if it lies below it."""
    return shown_path(path, base).replace("\\", "/")


def repository_path(path: str, base: str | None = None) -> tuple[str, bool]:
    """Return how a report of another service names a file, and whether it is one of the repository below ``base``.

    What lies in an installed package or an archive is named as there: no service can show it, and where it is
    installed is nobody's business.
    """
    shown = forward_path(path, base)
    for mark in _PACKAGES:
        inside = shown.rpartition(mark)[2]
        if inside != shown:
            return inside.lstrip("/"), False
    return shown, not (shown.startswith("/") or shown[1:2] == ":")
