"""The printed form of findings: people read it, editors and scripts parse it."""

import json
import os
from pathlib import Path
from typing import Any

import pytest

from codegen.diagnostics import Diagnostic, Report, Rule, Severity
from codegen.findings.text import closing_line, finding_text
from codegen.source import Place

ERROR = Rule("broken-table", "")
WARNING = Rule("doubtful-table", "", Severity.WARNING)


def test_a_finding_is_one_line_then_its_hint_and_related_places(tmp_path: Path, monkeypatch: Any) -> None:
    monkeypatch.chdir(tmp_path)
    here, there = str(tmp_path / "specs" / "a.yaml"), "/usr/share/common.xml"
    finding = Diagnostic(
        Place(here, 4, 7), ERROR, "no field x", "did you mean y?", ((Place(there, 9, 2), "y is here"),)
    )
    assert finding_text(finding).splitlines() == [
        "specs/a.yaml:4:7: error broken-table: no field x",
        "  hint: did you mean y?",
        "  /usr/share/common.xml:9:2: y is here",
    ]


@pytest.mark.parametrize("text", ["two\nlines", "two\r\nlines", "\x1b[2Jtwo lines", "two\u2028lines", "two\0lines"])
def test_quoted_input_can_neither_break_the_line_nor_steer_the_terminal(text: str) -> None:
    shown = finding_text(Diagnostic(Place(f"/{text}"), ERROR, text, text))
    assert len(shown.splitlines()) == 2
    assert shown.replace("\n", "").isprintable()
    assert "two" in shown
    assert "\\n" not in shown, "lines of quoted input are joined, not spelled out"


def test_findings_are_sorted_and_each_is_printed_once(pipeline: Any, run: Any) -> None:
    pipeline.findings = [(ERROR, 9, "b"), (WARNING, 2, "a"), (ERROR, 9, "b"), (ERROR, 9, "a")]
    code, out, err = run("check")
    assert code == 1
    assert out.splitlines() == [
        "specs/codegen.yaml:2:1: warning doubtful-table: a",
        "specs/codegen.yaml:9:1: error broken-table: a",
        "specs/codegen.yaml:9:1: error broken-table: b",
    ]
    assert err == "2 errors, 1 warning\n"


@pytest.mark.parametrize(
    ("rules", "line"),
    [([], ""), ([WARNING], "1 warning"), ([ERROR], "1 error"), ([WARNING] * 2 + [ERROR] * 3, "3 errors, 2 warnings")],
)
def test_closing_line_counts(rules: list[Rule], line: str) -> None:
    report = Report()
    for number, rule in enumerate(rules):
        report.add(rule, Place("/x", number + 1), "m")
    assert closing_line(report) == line


def test_a_clean_check_prints_nothing(pipeline: Any, run: Any) -> None:
    assert run("check") == (0, "", "")
    assert pipeline.projects == [str(Path.cwd() / "specs" / "codegen.yaml")]


def test_json_holds_all_that_the_text_says(pipeline: Any, run: Any) -> None:
    pipeline.findings = [(ERROR, 9, "b"), (WARNING, 2, "a")]
    code, out, err = run("check", "--format", "json")
    held = json.loads(out)
    assert (code, err, held["errors"], held["warnings"]) == (1, "", 1, 1)
    assert held["findings"][1] == {
        "file": os.path.join("specs", "codegen.yaml"),
        "line": 9,
        "column": 1,
        "severity": "error",
        "rule": "broken-table",
        "message": "b",
        "hint": None,
        "related": [],
        "fingerprint": None,
        "waived": None,
    }


def test_json_of_a_clean_project_is_json(pipeline: Any, run: Any) -> None:
    assert pipeline.is_readable
    assert json.loads(run("check", "--format", "json")[1]) == {"findings": [], "errors": 0, "warnings": 0, "waived": 0}
