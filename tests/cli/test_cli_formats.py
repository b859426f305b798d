"""The forms that other programs read: JSON, GitHub's workflow commands, SARIF 2.1.0."""

import json
import re
from pathlib import Path
from typing import Any
from urllib.parse import unquote
from xml.etree import ElementTree

import pytest
from jsonschema import Draft202012Validator

from codegen import __version__
from codegen.diagnostics import Diagnostic, Report, Rule, Severity
from codegen.findings.as_json import findings_json
from codegen.findings.github import findings_github
from codegen.findings.gitlab import findings_gitlab
from codegen.findings.junit import findings_junit
from codegen.findings.sarif import findings_sarif
from codegen.findings.text import closing_line, finding_text
from codegen.source import Place

ERROR = Rule("broken-table", "A table is broken. Mend it, 100%.")
WARNING = Rule("doubtful-table", "A table may be wrong.", Severity.WARNING)
WAIVED = "W-1, Ada, until 2030-01-31: 100 %, as agreed"


@pytest.fixture
def findings(tmp_path: Path) -> Report:
    """An error with everything, a warning, and one that is waived."""
    here, there = str(tmp_path / "specs" / "a b,1:x%.yaml"), "/usr/share/common.xml"
    related = [(Place(there, 9, 2), "y is here"), (Place(here, 1, 1), "and here")]
    report = Report()
    report.add(ERROR, Place(here, 4, 7), "no field x:\n50 %0A, all", "did you mean y?", related)
    report.add(WARNING, Place(here, 5, 1), "doubt", fingerprint="0123456789ab")
    report.extend([Diagnostic(Place(there, 6, 1), ERROR, "kept", None, (), "aaaaaaaaaaaa", WAIVED)])
    return report


# What GitHub's runner makes of a command: @actions/toolkit escapes and the runner unescapes like this.
ANNOTATION = re.compile(r"::(error|warning|notice) ([^:]*)::([^\r\n]*)")
ESCAPES = (("%0D", "\r"), ("%0A", "\n"), ("%3A", ":"), ("%2C", ","), ("%25", "%"))


def unescaped(text: str) -> str:
    for escape, character in ESCAPES:
        text = text.replace(escape, character)
    return text


def annotations(text: str) -> list[tuple[str, dict[str, str], str]]:
    """Command, properties and message of each line."""
    found = []
    for line in text.splitlines():
        match = ANNOTATION.fullmatch(line)
        assert match, line
        properties = dict(pair.split("=", 1) for pair in match[2].split(","))
        found.append((match[1], {name: unescaped(value) for name, value in properties.items()}, unescaped(match[3])))
    return found


def test_github_reads_back_what_was_found(findings: Report, tmp_path: Path) -> None:
    found = annotations(findings_github(findings, str(tmp_path)))
    error, warning, waived = (next(one for one in found if one[2].startswith(text)) for text in ("no", "doubt", "/usr"))
    assert warning == (
        "warning",
        {"file": "specs/a b,1:x%.yaml", "line": "5", "col": "1", "title": "doubtful-table"},
        "doubt",
    )
    command, properties, message = error
    assert (command, properties["file"], properties["line"]) == ("error", "specs/a b,1:x%.yaml", "4")
    assert message.splitlines() == [
        "no field x: 50 %0A, all",
        "hint: did you mean y?",
        "/usr/share/common.xml:9:2: y is here",
        "specs/a b,1:x%.yaml:1:1: and here",
    ]
    assert waived == (
        "notice",
        {"title": "broken-table (waived)"},
        f"/usr/share/common.xml:6: kept\nwaived: {WAIVED}",
    )


def test_no_annotation_points_into_a_package(tmp_path: Path) -> None:
    """The place of an installation is nobody's business, and no service has its files."""
    installed = tmp_path / ".venv/lib/python3.11/site-packages/pymavlink/dialects/v20/common.xml"
    archived = tmp_path / "pymavlink-2.4.37-py3-none-any.whl:" / "pymavlink/dialects/v20/common.xml"
    inside = "pymavlink/dialects/v20/common.xml"
    for path in (installed, archived):
        finding = [Diagnostic(Place(str(path), 6, 1), ERROR, "kept")]
        root = str(tmp_path)
        assert annotations(findings_github(finding, root)) == [
            ("error", {"title": "broken-table"}, f"{inside}:6: kept")
        ]
        assert json.loads(findings_gitlab(finding, root))[0]["location"]["path"] == inside
        (result,) = json.loads(findings_sarif(finding, root))["runs"][0]["results"]
        artifact = result["locations"][0]["physicalLocation"]["artifactLocation"]
        assert artifact == {"uri": inside, "uriBaseId": "%PACKAGES%"}
        assert "site-packages" not in findings_junit(finding, root)


# The parts of SARIF 2.1.0 (OASIS) that codegen writes: names, which are required, and types.
TEXT: dict[str, Any] = {
    "type": "object",
    "required": ["text"],
    "properties": {"text": {"type": "string", "minLength": 1}},
    "additionalProperties": False,
}
PHYSICAL: dict[str, Any] = {
    "type": "object",
    "required": ["artifactLocation"],
    "additionalProperties": False,
    "properties": {
        "artifactLocation": {
            "type": "object",
            "required": ["uri"],
            "properties": {
                "uri": {"type": "string", "pattern": "^[!-~]+$"},
                "uriBaseId": {"type": "string", "const": "%SRCROOT%"},
            },
            "additionalProperties": False,
        },
        "region": {
            "type": "object",
            "required": ["startLine"],
            "properties": {
                "startLine": {"type": "integer", "minimum": 1},
                "startColumn": {"type": "integer", "minimum": 1},
            },
            "additionalProperties": False,
        },
    },
}
LEVEL = {"enum": ["none", "note", "warning", "error"]}
RULE: dict[str, Any] = {
    "type": "object",
    "required": ["id"],
    "additionalProperties": False,
    "properties": {
        "id": {"type": "string"},
        "shortDescription": TEXT,
        "fullDescription": TEXT,
        "help": TEXT,
        "defaultConfiguration": {"type": "object", "properties": {"level": LEVEL}, "additionalProperties": False},
    },
}
RESULT: dict[str, Any] = {
    "type": "object",
    "required": ["message", "ruleId", "ruleIndex", "level", "locations"],
    "additionalProperties": False,
    "properties": {
        "ruleId": {"type": "string"},
        "ruleIndex": {"type": "integer", "minimum": 0},
        "level": LEVEL,
        "message": TEXT,
        "locations": {
            "type": "array",
            "minItems": 1,
            "items": {"type": "object", "properties": {"physicalLocation": PHYSICAL}, "additionalProperties": False},
        },
        "relatedLocations": {
            "type": "array",
            "uniqueItems": True,
            "items": {
                "type": "object",
                "required": ["id", "message"],
                "properties": {"id": {"type": "integer"}, "physicalLocation": PHYSICAL, "message": TEXT},
                "additionalProperties": False,
            },
        },
        "partialFingerprints": {"type": "object", "additionalProperties": {"type": "string"}},
        "suppressions": {
            "type": "array",
            "items": {
                "type": "object",
                "required": ["kind"],
                "properties": {
                    "kind": {"enum": ["inSource", "external"]},
                    "status": {"enum": ["accepted", "underReview", "rejected"]},
                    "justification": {"type": "string"},
                },
                "additionalProperties": False,
            },
        },
    },
}
DRIVER: dict[str, Any] = {
    "type": "object",
    "required": ["name"],
    "properties": {
        "name": {"const": "codegen"},
        "version": {"const": __version__},
        "rules": {"type": "array", "uniqueItems": True, "items": RULE},
    },
    "additionalProperties": False,
}
SARIF: dict[str, Any] = {
    "type": "object",
    "required": ["version", "runs"],
    "additionalProperties": False,
    "properties": {
        "$schema": {"type": "string", "format": "uri"},
        "version": {"const": "2.1.0"},
        "runs": {
            "type": "array",
            "items": {
                "type": "object",
                "required": ["tool", "results"],
                "additionalProperties": False,
                "properties": {
                    "tool": {"type": "object", "properties": {"driver": DRIVER}, "additionalProperties": False},
                    "columnKind": {"enum": ["utf16CodeUnits", "unicodeCodePoints"]},
                    "results": {"type": "array", "items": RESULT},
                },
            },
        },
    },
}


def test_sarif_has_the_form_of_its_standard(findings: Report, tmp_path: Path) -> None:
    for report in (findings, Report()):
        log = json.loads(findings_sarif(report, str(tmp_path)))
        assert [str(fault.message) for fault in Draft202012Validator(SARIF).iter_errors(log)] == []


def test_sarif_says_what_the_text_says(findings: Report, tmp_path: Path) -> None:
    (run,) = json.loads(findings_sarif(findings, str(tmp_path)))["runs"]
    rules = run["tool"]["driver"]["rules"]
    assert [(rule["id"], rule["help"]["text"]) for rule in rules] == [
        (rule.id, rule.explanation) for rule in (ERROR, WARNING)
    ]
    assert [rule["defaultConfiguration"]["level"] for rule in rules] == ["error", "warning"]
    results = {result["message"]["text"]: result for result in run["results"]}
    assert all(rules[result["ruleIndex"]]["id"] == result["ruleId"] for result in results.values())
    error = results["no field x:\n50 %0A, all (hint: did you mean y?)"]
    place = error["locations"][0]["physicalLocation"]
    assert (error["level"], place["region"]) == ("error", {"startLine": 4, "startColumn": 7})
    assert unquote(place["artifactLocation"]["uri"]) == "specs/a b,1:x%.yaml"
    assert [other["message"]["text"] for other in error["relatedLocations"]] == ["y is here", "and here"]
    outside = error["relatedLocations"][0]["physicalLocation"]["artifactLocation"]
    assert outside == {"uri": "file:///usr/share/common.xml"}, "what lies outside the repository has no base"
    assert "partialFingerprints" not in error
    assert list(results["doubt"]["partialFingerprints"].values()) == ["0123456789ab"]
    assert results["kept"]["suppressions"] == [{"kind": "external", "status": "accepted", "justification": WAIVED}]
    assert "suppressions" not in results["doubt"]


def test_waived_findings_are_seen_as_such(findings: Report) -> None:
    held = json.loads(findings_json(findings))
    assert (held["errors"], held["warnings"], held["waived"]) == (1, 1, 1)
    by_message = {found["message"]: found for found in held["findings"]}
    assert (by_message["kept"]["waived"], by_message["doubt"]["waived"]) == (WAIVED, None)
    assert by_message["doubt"]["fingerprint"] == "0123456789ab"
    assert closing_line(findings) == "1 error, 1 warning, 1 waived"
    text = next(finding_text(found) for found in findings if found.waived)
    assert text == f"/usr/share/common.xml:6:1: waived broken-table: kept\n  waived: {WAIVED}"


def test_the_command_prints_them_with_paths_of_the_repository(pipeline: Any, run: Any, monkeypatch: Any) -> None:
    """In a folder below the root of the repository, paths are still those of the root."""
    pipeline.findings = [(ERROR, 9, "b")]
    specs = Path(pipeline.folder).parent / "specs"
    (specs.parent / ".git").mkdir()
    monkeypatch.chdir(specs)
    code, out, err = run("check", "--format", "github")
    assert (code, out, err) == (1, "::error file=specs/codegen.yaml,line=9,col=1,title=broken-table::b\n", "")
    code, out, err = run("check", "--format", "sarif")
    (result,) = json.loads(out)["runs"][0]["results"]
    place = result["locations"][0]["physicalLocation"]["artifactLocation"]
    assert (code, place["uri"], err) == (1, "specs/codegen.yaml", "")


def test_nothing_found_is_nothing_said(pipeline: Any, run: Any) -> None:
    assert pipeline.is_readable
    assert run("check", "--format", "github") == (0, "", "")
    assert json.loads(run("check", "--format", "sarif")[1])["runs"][0]["results"] == []


def test_junit_has_a_case_for_each_finding(findings: Report, tmp_path: Path) -> None:
    """Servers count cases, failures and skips; what files hold is no markup."""
    suite = ElementTree.fromstring(findings_junit(findings, str(tmp_path)))[0]  # noqa: S314  our own
    assert (suite.get("tests"), suite.get("failures"), suite.get("skipped")) == ("3", "1", "1")
    failure = suite.find("./testcase/failure")
    assert failure is not None
    assert failure.get("message") == "no field x: 50 %0A, all"
    assert "did you mean y?" in (failure.text or "")
    waived = suite.find("./testcase/skipped")
    assert waived is not None
    assert waived.get("message") == WAIVED
    names = [case.get("name") for case in suite]
    assert len(names) == len(set(names))
    nothing = ElementTree.fromstring(findings_junit([]))[0]  # noqa: S314  our own
    assert (nothing.get("tests"), nothing.get("failures")) == ("1", "0")


def test_gitlab_tells_findings_apart(findings: Report, tmp_path: Path) -> None:
    """By fingerprints, of which no two are alike; severities are those that GitLab knows."""
    found = list(findings)
    issues = json.loads(findings_gitlab([*found, found[0]], str(tmp_path)))
    assert len({issue["fingerprint"] for issue in issues}) == len(issues) == 4
    assert sorted(issue["severity"] for issue in issues[:3]) == ["info", "major", "minor"]
    assert issues == json.loads(findings_gitlab([*found, found[0]], str(tmp_path)))
    assert {issue["location"]["path"] for issue in issues} >= {"specs/a b,1:x%.yaml"}
    assert all(issue["location"]["lines"]["begin"] >= 1 for issue in issues)
