"""Findings as JSON, for scripts."""

import json
from collections.abc import Iterable

from codegen.diagnostics import Diagnostic
from codegen.findings.text import counts
from codegen.source import shown_path


def findings_json(findings: Iterable[Diagnostic]) -> str:
    """One object with the keys findings, errors, warnings and waived; paths as the text form has them."""
    findings = list(findings)
    found = [
        {
            "file": shown_path(finding.place.file),
            "line": finding.place.line,
            "column": finding.place.column,
            "severity": str(finding.rule.severity),
            "rule": finding.rule.id,
            "message": finding.message,
            "hint": finding.advice,
            "related": [
                {"file": shown_path(place.file), "line": place.line, "column": place.column, "message": text}
                for place, text in finding.related
            ],
            "fingerprint": finding.fingerprint,
            "waived": finding.waived,
        }
        for finding in findings
    ]
    errors, warnings, waived = counts(findings)
    return json.dumps({"findings": found, "errors": errors, "warnings": warnings, "waived": waived}, indent=2)
