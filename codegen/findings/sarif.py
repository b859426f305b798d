"""Findings as SARIF 2.1.0 (OASIS), which code scanning services and editors read."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any
from urllib.parse import quote

from codegen import __version__
from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.findings.text import repository_path
from codegen.source import Place

SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
FINGERPRINT = "codegen/v1"
"""The name of our fingerprints among those that others may add."""

PACKAGES = "%PACKAGES%"
"""The base of paths of what is installed or lies in an archive, which no service has."""

_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}

_Object = dict[str, Any]


def findings_sarif(findings: Iterable[Diagnostic], base: str | None = None) -> str:
    """The log of one run. Paths are relative to ``base``, the root of the repository, those of
    installed packages to PACKAGES; others are file URIs.

    A waived finding is a result with a suppression, which services show as closed.
    """
    findings = list(findings)
    by_id = {finding.rule.id: finding.rule for finding in findings}
    rules = [rule for _, rule in sorted(by_id.items())]
    index = {rule.id: position for position, rule in enumerate(rules)}
    run = {
        "tool": {"driver": {"name": "codegen", "version": __version__, "rules": [_rule(rule) for rule in rules]}},
        "columnKind": "unicodeCodePoints",
        "results": [_result(finding, index[finding.rule.id], base) for finding in findings],
    }
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, indent=2)


def _rule(rule: Rule) -> _Object:
    first = rule.explanation.partition(". ")[0].rstrip(".") + "."
    return {
        "id": rule.id,
        "shortDescription": {"text": first},
        "fullDescription": {"text": rule.explanation},
        "help": {"text": rule.explanation},
        "defaultConfiguration": {"level": _LEVELS[rule.severity]},
    }


def _result(finding: Diagnostic, index: int, base: str | None) -> _Object:
    text = finding.message if finding.advice is None else f"{finding.message} (hint: {finding.advice})"
    result: _Object = {
        "ruleId": finding.rule.id,
        "ruleIndex": index,
        "level": _LEVELS[finding.rule.severity],
        "message": {"text": text},
        "locations": [_location(finding.place, base)],
    }
    if finding.related:
        result["relatedLocations"] = [
            {"id": number, **_location(place, base), "message": {"text": said}}
            for number, (place, said) in enumerate(finding.related, 1)
        ]
    if finding.fingerprint is not None:
        result["partialFingerprints"] = {FINGERPRINT: finding.fingerprint}
    if finding.waived is not None:
        result["suppressions"] = [{"kind": "external", "status": "accepted", "justification": finding.waived}]
    return result


def _location(place: Place, base: str | None) -> _Object:
    path, is_shown = repository_path(place.file, base)
    artifact = {"uri": quote(path), "uriBaseId": "%SRCROOT%" if is_shown else PACKAGES}
    if path.startswith("/") or path[1:2] == ":":
        artifact = {"uri": Path(place.file).as_uri()}
    return {
        "physicalLocation": {
            "artifactLocation": artifact,
            "region": {"startLine": place.line, "startColumn": place.column},
        }
    }
