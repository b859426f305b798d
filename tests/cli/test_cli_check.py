"""codegen check with documents: what they are compared with, what is waived, and how a run ends."""

import json
import os
import shutil
from pathlib import Path
from typing import Any

import pytest

from codegen.diagnostics import Rule
from codegen.findings.catalogue import rule_catalogue

ROOT = Path(__file__).resolve().parents[2]
MINIMAL = ROOT / "tests" / "projects" / "minimal" / "specs"
WRONG = "# Notes\n\nA BATTERY_STATUS message (41 bytes).\n"
RIGHT = "# Notes\n\nA BATTERY_STATUS message (36 bytes).\n"
OWN = '<mavlink><messages><message id="9" name="OWN_STATUS">{}</message></messages></mavlink>'


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: Any) -> Path:
    """A working directory without a project."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "notes.txt").write_text(WRONG)
    (tmp_path / "right.md").write_text(RIGHT)
    return tmp_path


@pytest.fixture
def project(folder: Path) -> Path:
    """The specification of the smallest project in the working directory, with a dialect that has more messages."""
    specs = folder / "specs"
    shutil.copytree(MINIMAL, specs)
    written = (specs / "codegen.yaml").read_text()
    (specs / "codegen.yaml").write_text(written.replace("dialect: minimal", "dialect: common"))
    return specs


def test_a_document_is_checked_without_a_project_whatever_it_ends_in(folder: Path, run: Any) -> None:
    assert (folder / "notes.txt").exists()
    code, out, err = run("check", "right.md", "notes.txt")
    assert code == 1
    assert out.splitlines()[0] == (
        "notes.txt:3:27: error claim-message-size: BATTERY_STATUS has a payload of 36 bytes, 54 with extensions, not 41"
    )
    assert err == "1 error\n"
    assert run("check", "right.md") == (0, "", "")


def test_the_dialect_may_be_named(folder: Path, run: Any) -> None:
    fields = '<field type="uint8_t" name="a">A</field>'
    (folder / "own.xml").write_text(OWN.format(fields))
    (folder / "own.md").write_text("OWN_STATUS (#8) is 2 bytes, HEARTBEAT of MAVLink 300 bytes.\n")
    code, out, _ = run("check", "own.md", "--dialect", "own.xml")
    assert code == 1
    assert [line.split()[2] for line in out.splitlines() if " error " in line] == [
        "claim-message-id:", "claim-message-size:"
    ]  # fmt: skip
    (folder / "other.md").write_text("HEARTBEAT is 300 bytes.\n")
    out = run("check", "other.md", "--dialect", "minimal")[1]
    assert out.startswith("other.md:1:"), out
    assert "error claim-message-size: HEART" in out.splitlines()[0]
    assert run("check", "own.md", "--dialect", "nonsense")[0] == 2


@pytest.mark.parametrize("name", ["absent.md", ".", "bytes.md"])
def test_what_cannot_be_read_is_said_and_the_others_are_checked(folder: Path, run: Any, name: str) -> None:
    (folder / "bytes.md").write_bytes(b"\xff\xfe")
    code, out, _ = run("check", name, "notes.txt")
    assert code == 2
    assert "claim-message-size" in out


def test_a_dialect_without_documents_is_wrong_usage(folder: Path, run: Any) -> None:
    assert folder.exists()
    code, out, err = run("check", "--dialect", "common")
    assert (code, out) == (2, "")
    assert "--dialect goes with documents" in err


def test_the_documents_of_a_project_are_checked_with_it(project: Path, run: Any) -> None:
    """Claims are findings of the specification: at the lines of its requirement documents."""
    assert run("check")[0] == 0
    document = next((project / "requirements").glob("*.md"))
    text = document.read_text()
    document.write_text(text + "\n\nIn MAVLink, HEARTBEAT is 8 bytes.\n")
    code, out, _ = run("check")
    line = text.count("\n") + 3
    assert code == 1
    assert f"specs/requirements/{document.name}:{line}:26: error claim-message-size: HEARTBEAT has" in out


def test_after_an_error_of_the_specification_claims_wait(project: Path, run: Any) -> None:
    """They could not be compared with what is meant."""
    document = next((project / "requirements").glob("*.md"))
    document.write_text(document.read_text() + "\nIn MAVLink, HEARTBEAT is 8 bytes.\n")
    (project / "streams.yaml").write_text("streams: 3\n")
    code, out, _ = run("check")
    assert code == 1
    assert "claim-" not in out


def test_a_document_is_compared_with_the_project_and_its_broken_parts_are_not_told(project: Path, run: Any) -> None:
    assert run("check", "right.md") == (0, "", "")
    (project / "scenarios.yaml").write_text("nonsense\n")
    assert run("check", "right.md") == (0, "", "")
    (project / "codegen.yaml").write_text("project: p\n")
    code, out, _ = run("check", "right.md")
    assert (code, "missing-key" in out) == (1, True)
    assert run("check", "right.md", "--dialect", "common")[0] == 0, "with a dialect no project is needed"


WAIVERS = """\
waivers:
  - id: W-1
    rule: claim-message-size
    document: {document}
    fingerprint: {fingerprint}
    reason: It quotes what a radio's manual says.
    owner: Ada
    expires: {day}
"""


def test_a_waived_claim_is_counted_and_shown_if_wanted(project: Path, run: Any) -> None:
    found = json.loads(run("check", "notes.txt", "--format", "json")[1])["findings"]
    values = {"document": "notes.txt", "fingerprint": found[0]["fingerprint"], "day": "9999-01-01"}
    (project / "waivers.yaml").write_text(WAIVERS.format(**values))
    assert run("check", "notes.txt") == (0, "", "1 waived\n")
    code, out, err = run("check", "notes.txt", "--waived")
    assert (code, err) == (0, "1 waived\n")
    assert "notes.txt:3:27: waived claim-message-size: " in out
    assert "  waived: W-1, Ada, until 9999-01-01: It quotes what a radio's manual says." in out.splitlines()
    assert run("check", "right.md") == (0, "", ""), "it is for another document"
    assert "waive" not in run("check")[1]
    (project.parent / "notes.txt").write_text("\n\n" + WRONG.replace("message (41", "message\n(**41**"))
    assert run("check", "notes.txt")[0] == 0, "moved and set in bold it is the same claim"
    (project.parent / "notes.txt").write_text(WRONG.replace("41", "42"))
    code, out, err = run("check", "notes.txt")
    assert (code, err) == (1, "1 error, 1 warning\n")
    assert "specs/waivers.yaml:2:5: warning waiver-unused: W-1 is not used" in out
    (project / "waivers.yaml").write_text(WAIVERS.format(**{**values, "day": "2001-01-01"}))
    (project.parent / "notes.txt").write_text(WRONG)
    code, out, err = run("check", "notes.txt")
    assert (code, err) == (1, "1 error, 1 warning\n")
    assert "specs/waivers.yaml:8:14: warning waiver-expired: W-1 ended on 2001-01-01" in out


def test_an_id_may_be_taken_by_any_dialect_that_is_shipped(folder: Path, run: Any) -> None:
    """150 is free in common; ArduPilot's vehicles have given it away."""
    xml = '<message id="150" name="OWN_STATUS"><field type="uint8_t" name="a">A</field></message>'
    (folder / "draft.md").write_text(f"```xml\n{xml}\n```\n")
    code, out, err = run("check", "draft.md")
    assert (code, err) == (0, "1 warning\n")
    assert out.startswith(
        "draft.md:2:1: warning claim-id-taken: OWN_STATUS has the id 150 of SENSOR_OFFSETS (likely, not certain)\n"
    )


def test_sarif_of_a_document_has_the_rule_and_the_fingerprint(folder: Path, run: Any) -> None:
    assert os.getcwd() == str(folder)
    (log,) = json.loads(run("check", "notes.txt", "--format", "sarif")[1])["runs"]
    (result,) = log["results"]
    assert result["ruleId"] == "claim-message-size"
    assert len(result["partialFingerprints"]["codegen/v1"]) == 12
    assert run("check", "notes.txt", "--format", "github")[1].startswith("::error file=notes.txt,line=3,col=27,title=")


def test_the_catalogue_knows_the_rules_of_claims() -> None:
    """Unknown rules in waivers are found by it, and unused waivers by the names of these rules."""
    claims = [rule for name, rule in rule_catalogue().items() if name.startswith("claim-")]
    assert len(claims) > 15
    assert all(isinstance(rule, Rule) for rule in claims)


def test_a_table_is_no_document(project: Path, run: Any) -> None:
    """Somebody who names the table that he has just written believes it checked, whatever is wrong in it."""
    table = next((project / "messages").iterdir())
    table.write_text(table.read_text() + "nonsense: true\n")
    for named in (f"specs/messages/{table.name}", "specs/state.yaml", "specs/codegen.yaml"):
        code, out, _ = run("check", named)
        assert code == 1
        assert f"{named}:1:1: error specification-as-document: " in out
        assert "hint: codegen check without names" in out
    assert run("check", "right.md", "specs/state.yaml")[0] == 1
    assert run("check", "specs/state.yaml", "--dialect", "common")[0] == 0
    assert run("check", "right.md")[0] == 0
