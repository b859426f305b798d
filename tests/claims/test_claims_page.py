"""docs/claims.md shows what the command does, and this repository's own documents claim nothing wrong."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from codegen.claims.reading import Reference
from codegen.cli import main
from codegen.commands.documents import found_claims, project_reference
from codegen.decode.waivers import decode_waivers
from codegen.diagnostics import Report
from codegen.findings.catalogue import rule_catalogue
from codegen.load.files import DISK
from codegen.project.systems import read_systems

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "claims.md").read_text()
DOCUMENTS = [
    *(path for path in (ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "CHANGELOG.md")),
    *(path for folder in ("docs", "specs", "generated/docs") for path in sorted((ROOT / folder).rglob("*.md"))),
]


@pytest.fixture
def proposal(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The page's example in a folder of its own, which is the working directory."""
    text = re.search(r"````markdown\n(.*?)````", PAGE, re.DOTALL)
    assert text
    (tmp_path / "proposal.md").write_text(text[1])
    monkeypatch.chdir(tmp_path)
    return tmp_path / "proposal.md"


def test_the_example_prints_what_the_page_shows(proposal: Path, capsys: Any) -> None:
    shown = re.search(r"```text\n\$ codegen (check .*?)\n(.*?)```", PAGE, re.DOTALL)
    assert shown
    assert proposal.exists()
    assert main(shown[1].split()) == 1
    assert capsys.readouterr().out == shown[2]


def test_the_waiver_of_the_page_is_for_the_example(proposal: Path, capsys: Any) -> None:
    written = re.search(r"```yaml\n(.*?)```", PAGE, re.DOTALL)
    assert written
    path = proposal.with_name("waivers.yaml")
    path.write_text(written[1])
    report = Report()
    (waiver,) = decode_waivers(str(path), DISK, report)
    assert list(report) == []
    main(["check", "proposal.md", "--format", "json"])
    found = json.loads(capsys.readouterr().out)["findings"]
    assert waiver.fingerprint in [one["fingerprint"] for one in found if one["rule"] == waiver.rule]


def test_the_page_lists_every_rule() -> None:
    rules = [name for name in rule_catalogue() if name.startswith(("claim-", "waiver-"))]
    assert [name for name in rules if f"`{name}`" not in PAGE] == []


@pytest.fixture(scope="module")
def own() -> Reference:
    """What the project says, with the messages that its overlays add."""
    found = project_reference(read_systems(str(ROOT / "specs" / "codegen.yaml"), Report()))
    assert found is not None
    return found


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_documents_of_this_repository_claim_nothing_wrong(own: Reference, path: Path) -> None:
    """Hundreds of figures, among them quotations of documents that are wrong."""
    if path.name != "claims.md":
        found = found_claims(path.read_text(), str(path), own, DISK)
        waived = {waiver.fingerprint for waiver in decode_waivers(str(ROOT / "specs" / "waivers.yaml"), DISK, Report())}
        assert [(one.place.line, one.message) for one in found if one.fingerprint not in waived] == []
