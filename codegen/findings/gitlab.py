"""Findings as a report of code quality of GitLab, which shows them in a merge request."""

import hashlib
import json
from collections.abc import Iterable

from codegen.diagnostics import Diagnostic, Severity
from codegen.findings.text import repository_path

_SEVERITIES = {Severity.ERROR: "major", Severity.WARNING: "minor", Severity.INFO: "info"}


def findings_gitlab(findings: Iterable[Diagnostic], base: str | None = None) -> str:
    """A list with an object for each finding; a waived one is of the severity info.

    ``base`` is the root of the repository, to which GitLab's paths are relative. No two have one fingerprint, since
    GitLab would show only one of them.
    """
    seen: dict[str, int] = {}
    return json.dumps([_issue(finding, base, seen) for finding in findings], indent=2)


def _issue(finding: Diagnostic, base: str | None, seen: dict[str, int]) -> dict[str, object]:
    path, _ = repository_path(finding.place.file, base)
    said = [finding.message]
    said += [f"hint: {finding.advice}"] if finding.advice is not None else []
    said += [f"waived: {finding.waived}"] if finding.waived is not None else []
    key = f"{finding.rule.id}\n{path}\n{finding.fingerprint or finding.message}"
    seen[key] = seen.get(key, 0) + 1
    digest = hashlib.sha256(f"{key}\n{seen[key]}".encode("utf-8", "surrogatepass")).hexdigest()
    return {
        "description": "; ".join(said),
        "check_name": finding.rule.id,
        "fingerprint": digest,
        "severity": "info" if finding.waived is not None else _SEVERITIES[finding.rule.severity],
        "location": {"path": path, "lines": {"begin": finding.place.line}},
    }
