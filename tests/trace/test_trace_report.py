"""The command: what it prints in each format, what makes it fail, and a real run of pytest from end to end."""

import json
import re
import subprocess
import sys
from pathlib import Path

import lxml.html
import pytest
from generated_suite import ALONE
from trace_project import Project

from codegen.cli import main
from codegen.commands.build import render_systems
from codegen.diagnostics import Report
from codegen.findings.comment import MOST_CHARACTERS, fitting
from codegen.project.systems import files_read, read_systems
from codegen.trace.needs import need_id

ROOT = Path(__file__).resolve().parents[2]


def test_the_shipped_project_is_covered(capsys: pytest.CaptureFixture[str]) -> None:
    """Every criterion has a test or is said to need the bench, every mark names one, and every text is reviewed."""
    assert main(["trace", "--project", str(ROOT / "specs" / "codegen.yaml")]) == 0
    said = capsys.readouterr()
    assert "trace-" not in said.out
    assert said.err == ""
    assert re.search(r"on the bench +3\n", said.out)


def test_the_summary_and_what_needs_attention(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    assert project.run() == 0  # the fourth criterion needs the bench
    project.change("- Criteria 3 and 4: the radio", "- Criterion 3: the radio")
    capsys.readouterr()
    assert project.run() == 1
    said = capsys.readouterr().out
    assert "1 requirement document, 4 criteria, 7 rows that cite them" in " ".join(said.split())
    assert re.search(r"\n  has tests +3\n", said)
    assert re.search(r"\n  no test +1\n", said)
    assert "specs/requirements/FR-1.md:14:1: error trace-uncovered: FR-1.4 has no test" in said
    assert said.count("trace-") == 1


@pytest.mark.parametrize(
    ("kinds", "code", "told"),
    [
        ("none", 0, {"trace-uncovered": "warning"}),
        ("orphaned,suspect", 0, {"trace-uncovered": "warning"}),
        ("uncovered", 1, {"trace-uncovered": "error"}),
        ("unspecified", 1, {"trace-uncovered": "warning", "trace-unspecified": "error"}),
        ("uncited", 1, {"trace-uncovered": "warning", "trace-uncited": "error"}),
    ],
)
def test_what_fails(
    kinds: str, code: int, told: dict[str, str], project: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    """The chosen kinds count; those that always deserve attention are told as warnings otherwise."""
    project.change("- Criteria 3 and 4: the radio", "- Criterion 3: the radio")
    assert project.run("--fail-on", kinds) == code
    said = capsys.readouterr().out
    assert {rule: severity for severity, rule in re.findall(r": (error|warning) (trace-\w+):", said)} == told


def test_the_tree_of_one_criterion(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """Its text, its row with file and line, the symbols, both kinds of tests."""
    assert project.run("FR-old.2") == 0
    said = capsys.readouterr().out
    for part in (
        "FR-1.2  [has tests]  specs/requirements/FR-1.md:11",
        "Its custom_mode is 7, which nobody reads.",
        "field HEARTBEAT.custom_mode  specs/messages/heartbeat.yaml:8",
        "firmware/telemetry_plain.py: write_heartbeat",
        "generated/tests/test_frames.py::test_frames  (2 cases, HEARTBEAT)",
        "tests/test_beat.py::TestMode::test_seven",
    ):
        assert part in said
    assert "FR-1.1" not in said


def test_a_mark_without_a_criterion(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """At the mark, with the nearest name; a file that is no Python is told, and the others count."""
    project.tests.write_text(project.tests.read_text().replace('"FR-1.1"', '"FR-1.7"'))
    (project.tests.parent / "test_broken.py").write_text('@pytest.mark.requirement("FR-1.1")\ndef test_(:\n')
    assert project.run() == 1
    said = capsys.readouterr().out
    assert "tests/test_beat.py:4:26: error trace-orphaned: tests/test_beat.py::test_beats shows FR-1.7" in said
    assert "hint: did you mean FR-1" in said
    assert "tests/test_broken.py:2:11: warning test-syntax" in said


def test_the_page(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """One row a criterion with tags to filter by, no double ids, and nothing from elsewhere; text stays text."""
    project.change("It beats once a second.", "It beats <b>once</b> a second & more.")
    assert project.run("--format", "html", "--out", "deep/trace.html") == 0
    text = (project.folder / "deep" / "trace.html").read_text()
    page = lxml.html.fromstring(text)
    rows = page.xpath("//table[@id='matrix']/tbody/tr")
    assert [row.get("id") for row in rows] == ["FR-1.1", "FR-1.2", "FR-1.3", "FR-1.4"]
    assert "bench" in rows[3].get("data-tags").split()
    ids = page.xpath("//@id")
    assert len(ids) == len(set(ids))
    assert not re.search(r"https?:|<link|src=", text.replace("http://www.w3.org", ""))
    assert "&amp; more" in text
    assert capsys.readouterr().out == ""


def test_the_page_of_a_build_is_the_same_every_time(project: Project) -> None:
    """It says what was reviewed, but knows of no test by hand, no result and no path of this machine."""
    project.run("accept", "--all", "--reason", "x")
    systems = read_systems(project.file, Report())
    first, second = (render_systems(systems).files["docs/trace.html"] for _ in range(2))
    assert first == second
    assert "test_seven" not in first
    assert "trace-uncovered" not in first
    assert re.search(r'warn">2</span> no generated test', first)
    assert "reviewed" in first
    assert str(project.folder) not in first
    assert str(project.lock) in files_read(systems)
    project.tests.unlink()
    assert render_systems(systems).files["docs/trace.html"] == first


def test_markdown(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """Every line of a table has its cells, whatever a criterion says."""
    project.change("It beats once a second.", "It beats | once `a|b` a second.")
    assert project.run("--format", "markdown") == 0
    lines = capsys.readouterr().out.splitlines()
    table = [line for line in lines if line.startswith("| FR-1.")]
    assert len(table) == 4
    assert {len(re.findall(r"(?<!\\)\|", line)) for line in table} == {5}


def test_needs_json(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """Ids as sphinx-needs takes them, and every link leads to a need of the file."""
    assert project.run("--format", "needs") == 0
    data = json.loads(capsys.readouterr().out)
    needs = data["versions"][data["current_version"]]["needs"]
    assert data["versions"][data["current_version"]]["needs_amount"] == len(needs)
    assert all(re.fullmatch("[A-Z0-9_]{5,}", name) and need["id"] == name for name, need in needs.items())
    assert {link for need in needs.values() for link in need["links"]} <= needs.keys()
    assert needs["FR_1_2"]["links"] == ["FR_1_"]
    assert needs["FR_1_2"]["content"] == "Its custom\\_mode is 7, which nobody reads."
    assert needs["FR_1_2"]["place"] == "specs/requirements/FR-1.md:11"
    kinds = {kind: sum(need["type"] == kind for need in needs.values()) for kind in ("req", "spec", "impl", "test")}
    assert kinds["req"] == 5
    assert min(kinds.values()) >= 2
    assert need_id("FR-00068.3") == "FR_00068_3"


@pytest.mark.parametrize(
    ("form", "part"), [("json", '"rule": "trace-uncovered"'), ("github", "::error file="), ("sarif", '"2.1.0"')]
)
def test_findings_alone(form: str, part: str, project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """As codegen check prints them, on stdout or in a file; GitHub's form is empty where there is nothing."""
    assert project.run("--format", form, "--out", "fine.txt") == 0
    fine = (project.folder / "fine.txt").read_text()
    project.change("- Criteria 3 and 4: the radio", "- Criterion 3: the radio")
    capsys.readouterr()
    assert project.run("--format", form) == 1
    said = capsys.readouterr().out
    assert part in said
    assert "FR-1.4 has no test" in said
    assert "FR-1.4" not in fine
    assert (fine == "") == (form == "github")


def test_no_documents(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """A table cites what is not there, so the specification itself is reported, and no trace of it."""
    project.document.unlink()
    assert project.run() == 1
    assert "error unknown-requirement" in capsys.readouterr().out


def test_a_report_that_cannot_be_written(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    (project.folder / "taken").mkdir()
    assert project.run("--out", "taken") == 2
    assert "error file-unwritable" in capsys.readouterr().out


@pytest.mark.parametrize("argument", ["missing.xml", "."])
def test_results_that_cannot_be_read(argument: str, project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """Then nothing is said about tests, which would all be without a result."""
    assert project.run("--results", argument) == 2
    said = capsys.readouterr().out
    assert "error file-not-" in said
    assert "trace-" not in said


def test_from_pytest_to_the_trace(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """Both suites really run, the generated one with plain pytest; what fails then is no longer covered."""
    assert main(["build", "--project", project.file]) == 0
    (project.folder / "pytest.ini").write_text("[pytest]\naddopts = --strict-markers\n")
    options = ["-q", "-p", "no:cacheprovider"]
    runs = [["generated/tests"], ["-p", "codegen.pytest_plugin", "tests"]]
    for number, run in enumerate(runs):
        command = [sys.executable, "-m", "pytest", *options, f"--junit-xml={number}.xml", *run]
        done = subprocess.run(command, cwd=project.folder, env=ALONE, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    capsys.readouterr()
    results = ["--results", "0.xml", "--results", "1.xml"]
    assert project.run(*results, "--fail-on", "uncovered,partly,orphaned") == 0
    assert re.search(r"passed +3\n", capsys.readouterr().out)
    written = (project.folder / "1.xml").read_text()
    failed = re.sub(r'(<testcase [^>]*name="test_seven"[^>]*>)', r'\1<failure message="no"/>', written)
    assert failed != written
    (project.folder / "1.xml").write_text(failed)
    assert project.run(*results) == 1
    assert "error trace-uncovered: FR-1.2 has failed: 2 passed, 1 failed" in capsys.readouterr().out


def test_markdown_is_no_longer_than_a_comment() -> None:
    """Of what is longer the first lines are kept, and the rows that are left out are counted."""
    row = f"| {'x' * 96} |"
    text = "\n".join(["# T", "", "| a |", "| --- |", *[row] * 700]) + "\n"
    cut = fitting(text, "criteria", "a page has all.")
    assert len(cut) <= MOST_CHARACTERS < len(text)
    kept = cut.count(row)
    assert cut.endswith(f"{700 - kept} further criteria do not fit into a comment: a page has all.\n")
    assert fitting(cut, "criteria", "") == cut


def test_documents_of_which_nothing_is_traced_are_told(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """Of what is not read nothing else would be seen: a heading that is misspelt, a document without criteria."""
    text = project.document.read_text().replace("FR-1 |", "REQ-2 |").replace("- Aliases: FR-old\n", "")
    (project.document.parent / "REQ-2.md").write_text(text.replace("## Acceptance Criteria", "## Acceptance Criterias"))
    (project.document.parent / "REQ-3.md").write_text(
        "# REQ-3 | T\n\n## Metadata\n\n- Status: Draft\n\n## Criteria\n\n1. a\n"
    )
    project.run()
    said = capsys.readouterr().out
    spelling = "warning section-spelling: what stands below Acceptance Criterias is not read"
    assert f"specs/requirements/REQ-2.md:7:1: {spelling}\n  hint: did you mean ## Acceptance Criteria?" in said
    assert (
        "specs/requirements/REQ-3.md:1:1: warning document-without-criteria: REQ-3 has no acceptance criteria" in said
    )
