"""A check that knows what an earlier one found says what a check that knows nothing says, whatever was changed."""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from short_documents import shorten_documents

from codegen.cli import main
from codegen.commands import document_findings, documents
from codegen.decode import decoded
from codegen.diagnostics import Diagnostic, Rule
from codegen.findings import catalogue
from codegen.load.files import Files
from codegen.source import Place, shown_path
from codegen.tool import cache
from codegen.tool import digest as tool

ROOT = Path(__file__).resolve().parents[2]

DOCUMENT = "specs/requirements/FR-00068-battery-status-telemetry.md"
OTHER_DOCUMENT = "specs/requirements/FR-00069-voltage-conversion.md"

WITH_TABLES = ("FR-00068", "FR-00069")
"""Documents of which the copies say anything: the cache does the same with each, and reading takes time."""

WRONG = """
## What is wrong

The message id of BATTERY_STATUS is 148. `BATT_VOLT_MULT` has the default 4.05. `BATT_ID` has the default 3.

HEARTBEAT is sent at 3 Hz. The vehicle sends the message BATTERY_STATUSX, too. BATTERY_STATUS.temperature is in kelvin.
BATTERY_STATUS_V2.id is a uint8_t.

With `dialects/battery_rfc_0018.xml` the base payload of BATTERY_STATUS_V2 has 25 bytes.
"""
"""Text that makes a document wrong in several ways."""

_ID, _WIDE_ID = 'type="uint8_t" name="id"', 'type="uint16_t" name="id"'
EDITS = {
    "a document": (DOCUMENT, "BATTERY_STATUS is 148", "BATTERY_STATUS is 149"),
    "a cell of a document": (DOCUMENT, "`{state: battery.consumed}`", "`{state: battery.energy}`"),
    "another document": (OTHER_DOCUMENT, "| 9549 |", "| 9548 |"),
    "parameters": ("specs/parameters.yaml", "default: 3.95", "default: 4.05"),
    "streams": ("specs/streams.yaml", "    rate: 1 Hz", "    rate: 3 Hz"),
    "a table": ("specs/messages/battery_status.yaml", "MAV_BATTERY_FUNCTION_ALL", "MAV_BATTERY_FUNCTION_AVIONICS"),
    "a draft that is listed": ("specs/dialects/battery_upstream.xml", _ID, _WIDE_ID),
    "a draft that is not listed": ("specs/dialects/battery_rfc_0018.xml", _ID, _WIDE_ID),
    "names that are known": ("specs/dialects/upstream.xml", "FUEL_STATUS", "BATTERY_STATUSX"),
    "the project": ("specs/codegen.yaml", "protocol: 2", "protocol: 1"),
    "a further program": ("specs/smart_battery/parameters.yaml", "default: 2\n", "default: 3\n"),
    "a waiver": ("specs/waivers.yaml", "rule: claim-unit", "rule: claim-units"),
}
"""One change for each kind of file; each is seen in what is found."""

MOST_MODULES = 500
"""The largest number of modules imported by a check that finds nothing new."""

IMPORTS = """
import sys
from codegen.cli import main
main(["check"])
print(*sys.modules)
"""

Check = Callable[..., list[dict[str, Any]]]
Known = tuple[Path, Path, list[str]]


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The rover with documents that are wrong, as the working directory."""
    folder = _copied(tmp_path)
    monkeypatch.chdir(folder)
    return folder


def _copied(parent: Path) -> Path:
    folder = parent / "project"
    shutil.copytree(ROOT / "specs", folder / "specs")
    shorten_documents(folder / "specs", WITH_TABLES, numbers_only=True)
    file = folder / DOCUMENT
    file.write_text(file.read_text() + WRONG)
    return folder


def _imported(folder: Path, kept: Path) -> list[str]:
    """Check in a process of its own; return the names of the modules that it has imported."""
    surroundings = {**os.environ, cache.VARIABLE: str(kept), "PYTHONPATH": str(ROOT)}
    ran = subprocess.run(
        [sys.executable, "-c", IMPORTS], capture_output=True, text=True, check=True, env=surroundings, cwd=folder
    )
    return ran.stdout.splitlines()[-1].split()


@pytest.fixture(scope="module")
def looked_at(tmp_path_factory: pytest.TempPathFactory) -> Known:
    """The same project, the cache that a check of it leaves, and what that check imported: in this folder, whose path
    is part of what is kept.
    """
    folder = _copied(tmp_path_factory.mktemp("looked_at"))
    kept = folder.with_name("cache")
    return folder, kept, _imported(folder, kept)


@pytest.fixture
def known(looked_at: Known, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Yield that project as the working directory, as it was; the checks of a test begin with what is kept."""
    folder, kept, _ = looked_at
    shutil.copytree(kept, tmp_path / "cache")
    monkeypatch.chdir(folder)
    yield folder
    shutil.rmtree(folder / "specs")
    _copied(folder.parent)


@pytest.fixture
def check(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Iterator[Check]:
    """Yield a call for the findings of ``codegen check``, with a cache of the test's own or with none."""

    def found(*, knows: bool = True) -> list[dict[str, Any]]:
        monkeypatch.setenv(cache.VARIABLE, str(tmp_path / "cache") if knows else "off")
        _later_run()
        main(["check", "--waived", "--format", "json"])
        read: dict[str, list[dict[str, Any]]] = json.loads(capsys.readouterr().out)
        return read["findings"]

    yield found
    _later_run()


def _later_run() -> None:
    """Forget what this process knows of the folder."""
    cache.cache_folder.cache_clear()
    cache._new.clear()


@pytest.mark.usefixtures("project")
def test_the_documents_are_wrong_in_many_ways(check: Check) -> None:
    """The tests below compare what is found; where that is nothing they would show nothing."""
    rules = {finding["rule"] for finding in check()}
    assert {"claim-message-id", "claim-no-message", "claim-message-size", "claim-parameter", "claim-unit"} <= rules
    assert check() == check(knows=False)


@pytest.fixture(scope="module")
def first() -> list[list[dict[str, Any]]]:
    """The findings before an edit, once a test has asked for them: they are the same for each."""
    return []


@pytest.mark.parametrize("what", EDITS)
def test_after_an_edit_the_findings_are_those_of_a_run_that_knows_nothing(
    known: Path, check: Check, first: list[list[dict[str, Any]]], what: str
) -> None:
    path, old, new = EDITS[what]
    if not first:
        first.append(check())
    text = (known / path).read_text()
    assert old in text
    (known / path).write_text(text.replace(old, new, 1))
    after = check()
    assert after == check(knows=False)
    assert after != first[0]
    (known / path).write_text(text)
    assert check() == first[0]


def test_documents_that_come_and_go_are_noticed(known: Path, check: Check) -> None:
    before = check()
    own = known / DOCUMENT
    further = own.with_name("FR-00099-further.md")
    further.write_text(own.read_text().replace("# FR-00068", "# FR-00099", 1))
    assert check() == check(knows=False) != before
    further.unlink()
    assert check() == before


def test_a_file_that_a_draft_includes_counts_as_well(project: Path, check: Check) -> None:
    """The project does not name it."""
    draft = project / "specs" / "dialects" / "battery_upstream.xml"
    included = draft.with_name("included.xml")
    draft.rename(included)
    draft.write_text("<mavlink><include>included.xml</include></mavlink>")
    before = check()
    text = included.read_text()
    assert _ID in text
    included.write_text(text.replace(_ID, _WIDE_ID, 1))
    after = check()
    assert after == check(knows=False)
    assert after != before


def test_a_document_is_read_again_only_where_something_changed(
    project: Path, check: Check, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And an edit of one document leaves the others alone."""
    read: list[str] = []
    found_claims = documents.found_claims

    def noted(text: str, path: str, reference: Any, files: Files, known: Any) -> Any:
        read.append(Path(path).name)
        return found_claims(text, path, reference, files, known)

    monkeypatch.setattr(documents, "found_claims", noted)
    check()
    assert len(read) == len(set(read)) > 15
    read.clear()
    check()
    assert read == []
    file = project / DOCUMENT
    file.write_text(file.read_text() + "\nMore.\n")
    check()
    assert read == [file.name]


def test_an_edit_of_the_specification_compares_no_statement_about_messages(
    project: Path, check: Check, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only what documents say of the project is compared again; an edit of a draft concerns all the rest, too."""
    read: list[str] = []
    of_dialects = documents.of_dialects

    def noted(text: str, path: str, reference: Any, files: Files) -> Any:
        read.append(Path(path).name)
        return of_dialects(text, path, reference, files)

    monkeypatch.setattr(documents, "of_dialects", noted)
    check()
    assert len(read) == len(set(read)) > 15
    read.clear()
    parameters = project / "specs" / "parameters.yaml"
    parameters.write_text(parameters.read_text().replace("default: 3.95", "default: 4.05"))
    assert [finding for finding in check() if finding["rule"] == "claim-parameter"]
    assert read == []
    path, old, new = EDITS["a draft that is listed"]
    (project / path).write_text((project / path).read_text().replace(old, new))
    check()
    assert len(read) > 15


@pytest.mark.usefixtures("project")
def test_another_codegen_looks_again(check: Check, monkeypatch: pytest.MonkeyPatch) -> None:
    check()
    for module in (catalogue, decoded, document_findings, tool):
        monkeypatch.setattr(module, "tool_digest", lambda: "another")
    monkeypatch.setattr(documents, "found_claims", lambda *_: [])
    assert not [finding for finding in check() if finding["rule"].startswith("claim-")]


def test_what_is_found_may_name_files_as_they_are_called_from_here(
    project: Path, check: Check, monkeypatch: pytest.MonkeyPatch
) -> None:
    def found(_text: str, path: str, *_: object) -> list[Diagnostic]:
        return [Diagnostic(Place(path), Rule("claim-anything", ""), shown_path(path))]

    monkeypatch.setattr(documents, "found_claims", found)
    for folder in (project, project / "specs"):
        monkeypatch.chdir(folder)
        told = [finding for finding in check() if finding["rule"] == "claim-anything"]
        assert told
        assert [finding for finding in told if finding["message"] != finding["file"]] == []


LEFT_OUT = ("lxml", "markdown_it", "jinja2", "pathlib", "codegen.claims", "codegen.importing", "codegen.targets")


def test_a_run_that_knows_everything_imports_nothing_that_reads_or_judges_documents(
    known: Path, tmp_path: Path, looked_at: Known
) -> None:
    """Counted, as times depend on the computer: some 495 modules in place of 730, and nothing new to keep."""
    kept = tmp_path / "cache"
    files = sorted(kept.iterdir())
    imported = _imported(known, kept)
    assert [name for name in imported if name.startswith(LEFT_OUT)] == []
    assert len(imported) <= MOST_MODULES < len(looked_at[2])
    assert sorted(kept.iterdir()) == files


_NOT_AGAIN = {"yaml", "codegen.importing.drift", "codegen.importing.comparison"}


def test_an_edit_behind_the_lists_of_fields_does_not_compare_them_again(
    known: Path, tmp_path: Path, looked_at: Known
) -> None:
    """To load the reader of YAML and what compares tables takes a twentieth of such a check."""
    assert _NOT_AGAIN.issubset(looked_at[2])
    file = known / DOCUMENT
    for _ in range(2):  # the second time shows that the order of what is hashed is the same in each process
        file.write_text(file.read_text() + "\nMore is said here.\n")
        assert _NOT_AGAIN.isdisjoint(_imported(known, tmp_path / "cache"))
