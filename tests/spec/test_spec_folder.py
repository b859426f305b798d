"""The folder of a project: which files are read and accounted for, and what is said about missing and stray ones."""

import hashlib
import os
import shutil
from pathlib import Path

import pytest
from spec_examples import GOOD

from codegen.cli import main
from codegen.decode.spec import decode_spec
from codegen.diagnostics import Report, Severity
from codegen.load.files import DISK
from codegen.model.spec.spec import Spec
from codegen.source import Place

RECEIVED = "receive: HEARTBEAT\nrequirement: FR-1.1\nfields:\n  custom_mode: {state: tank.level}\n"
REQUIREMENT = "# FR-{} | Title\n\n## Metadata\n\n- Status: Draft\n\n## Acceptance Criteria\n\n1. a\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A complete project without mistakes."""
    files = {f"{kind}.yaml": GOOD[kind] for kind in ("state", "board", "parameters", "streams")}
    files["codegen.yaml"] = GOOD["codegen"] + "corrections: [dialects/fixes.yaml]\n"
    files["a.xml"] = "<mavlink/>"
    files["dialects/fixes.yaml"] = GOOD["corrections"]
    files["messages/b.yaml"] = GOOD["message"]
    files["messages/a.yaml"] = GOOD["message"].replace("BATTERY_STATUS", "HEARTBEAT")
    files["requirements/FR-1.md"] = REQUIREMENT.format(1)
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return tmp_path


def read(folder: Path) -> tuple[Spec | None, list[tuple[str, str, int, int]]]:
    report = Report()
    spec = decode_spec(str(folder / "codegen.yaml"), DISK, report)
    return spec, [(d.rule.id, os.path.relpath(d.place.file, folder), d.place.line, d.place.column) for d in report]


def test_a_project_is_read_and_every_file_accounted_for(folder: Path) -> None:
    """The tables by the names of their files; the hashes are those of the bytes, XML that is not read here included."""
    spec, findings = read(folder)
    assert findings == []
    assert spec is not None
    assert spec.folder == str(folder)
    assert [table.message for table in spec.populations] == ["HEARTBEAT", "BATTERY_STATUS"]
    assert [correction.message for correction in spec.corrections] == ["M"]
    assert [requirement.id for requirement in spec.requirements] == ["FR-1"]
    expected = {
        str(path): hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.rglob("*") if path.is_file()
    }
    assert spec.files == expected
    assert list(spec.files) == sorted(expected)


def test_the_project_may_be_named_relative_to_the_working_directory(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder.parent)
    spec = decode_spec(f"{folder.name}/codegen.yaml", DISK, Report())
    assert spec is not None
    assert spec.folder == str(folder)
    assert spec.project.place.file == str(folder / "codegen.yaml")


def test_without_a_project_file_there_is_one_finding(tmp_path: Path) -> None:
    report = Report()
    assert decode_spec(str(tmp_path / "codegen.yaml"), DISK, report) is None
    assert [(d.rule.id, d.place) for d in report] == [("file-not-found", Place(str(tmp_path / "codegen.yaml")))]
    assert report.exit_code == 2


@pytest.mark.parametrize("name", ["state.yaml", "board.yaml", "parameters.yaml", "streams.yaml"])
def test_a_missing_file_is_reported_at_the_project_file(folder: Path, name: str) -> None:
    (folder / name).unlink()
    assert read(folder) == (None, [("file-not-found", "codegen.yaml", 1, 1)])


def test_a_misspelt_file_is_pointed_out(folder: Path) -> None:
    (folder / "parameters.yaml").rename(folder / "paramters.yaml")
    report = Report()
    assert decode_spec(str(folder / "codegen.yaml"), DISK, report) is None
    missing, stray = report
    assert (missing.rule.id, missing.place) == ("file-not-found", Place(str(folder / "codegen.yaml")))
    assert (stray.rule.id, stray.place) == ("unread-file", Place(str(folder / "paramters.yaml")))
    assert stray.hint == "did you mean parameters.yaml?"
    assert stray.rule.severity is Severity.WARNING


def test_yaml_that_nothing_reads_is_a_warning(folder: Path) -> None:
    """Also a table with the wrong ending and corrections that the project does not name; not an editor's own files."""
    for name in ("messages/c.yml", "dialects/more.yaml", "requirements/FR-2.yaml", "notes.txt", "messages/.c.yaml"):
        (folder / name).write_text("a: 1\n")
    (folder / "scenarios.yaml").write_text("a: 1\n")
    spec, findings = read(folder)
    assert spec is not None
    assert findings == [
        ("unread-file", "dialects/more.yaml", 1, 1),
        ("unread-file", "messages/c.yml", 1, 1),
        ("unread-file", "requirements/FR-2.yaml", 1, 1),
    ]


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("messages/c.YAML", "population tables end in .yaml"),
        ("messages/c.Yml", "population tables end in .yaml"),
        ("messages/sub/c.yaml", "only what lies in messages itself is read: move it to messages/c.yaml"),
        ("messages/sub/deep/c.yml", "only what lies in messages itself is read: move it to messages/c.yaml"),
        ("receives/c.YML", "tables of received messages end in .yaml"),
        ("receives/sub/c.yaml", "only what lies in receives itself is read: move it to receives/c.yaml"),
        ("requirements/FR-2.MD", "requirement documents are Markdown, and end in .md"),
        ("requirements/FR-2.markdown", "requirement documents are Markdown, and end in .md"),
        ("requirements/FR-2-beats.rst", "requirement documents are Markdown, and end in .md"),
        ("requirements/sub/FR-2.md", "only what lies in requirements itself is read: move it to requirements/FR-2.md"),
        ("dialects/more.YAML", "name it under corrections in codegen.yaml"),
        ("drivers/probe.YAML", "name it in board.yaml: driver: probe"),
        ("boards/own.YML", "name it in board.yaml: board: own"),
        ("commands.YAML", "did you mean commands.yaml?"),
    ],
)
def test_what_has_another_ending_or_lies_in_a_folder_below_is_a_warning(folder: Path, name: str, hint: str) -> None:
    """Each file that nothing reads is one, however it is called: what it says would be missing without a word."""
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text("a: 1\n")
    report = Report()
    assert decode_spec(str(folder / "codegen.yaml"), DISK, report) is not None
    found = [(one.rule.id, one.place, one.hint) for one in report]
    assert found == [("unread-file", Place(str(folder / name)), hint)]


def test_folders_of_pictures_and_links_in_a_circle_are_left_alone(folder: Path) -> None:
    for name in ("requirements/images/boat.png", "messages/.idea/a.yaml", "messages/notes.txt"):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text("a: 1\n")
    (folder / "messages" / "again").symlink_to(folder / "messages" / ".idea")
    (folder / "requirements" / "images" / "up").symlink_to(folder / "requirements" / "images")
    (folder / "messages" / ".idea" / "a.yaml").unlink()
    assert read(folder)[1] == []


def test_a_project_without_tables_is_an_error(folder: Path) -> None:
    for path in (folder / "messages").iterdir():
        path.unlink()
    spec, findings = read(folder)
    assert spec is not None
    assert findings == [("no-messages", "codegen.yaml", 1, 1)]
    (folder / "messages").rmdir()
    assert read(folder)[1] == findings


@pytest.mark.parametrize("others", [(), ("commands.yaml",), ("commands.yaml", "receives/a.yaml")])
def test_a_project_that_sends_nothing_is_told_what_is_missing(
    others: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """With commands and tables of received messages as without: one error at codegen.yaml, and nothing is written."""
    monkeypatch.chdir(tmp_path)
    assert main(["init", "p"]) == 0
    monkeypatch.chdir(tmp_path / "p")
    shutil.rmtree("specs/messages")
    Path("specs/receives").mkdir()
    for name in others:
        text = RECEIVED if "/" in name else "commands: {MAV_CMD_USER_1: {doc: d, method: pump}}\n"
        Path("specs", name).write_text(text)
    if len(others) < 2:
        Path("specs/receives").rmdir()
    capsys.readouterr()
    assert main(["build"]) == 1
    out = capsys.readouterr().out
    errors = [line for line in out.splitlines() if ": error " in line]
    assert len(errors) == 1, out
    assert errors[0].startswith("specs/codegen.yaml:1:1: error no-messages: "), out
    assert "write messages/heartbeat.yaml" in out
    assert all(name.partition("/")[0] in errors[0] for name in others)
    assert not Path("generated/firmware").exists()


def test_two_tables_for_one_message_cite_each_other(folder: Path) -> None:
    (folder / "messages" / "z.yaml").write_text("\n" + GOOD["message"])
    report = Report()
    spec = decode_spec(str(folder / "codegen.yaml"), DISK, report)
    assert spec is not None
    assert len(spec.populations) == 2
    (finding,) = report
    assert (finding.rule.id, finding.place) == ("duplicate-table", Place(str(folder / "messages/z.yaml"), 2, 10))
    assert [place for place, _ in finding.related] == [Place(str(folder / "messages/b.yaml"), 1, 10)]
    assert finding.hint == "'as: NAME' gives one of them a name of its own"


def test_missing_corrections_are_reported_where_they_are_named(folder: Path) -> None:
    (folder / "dialects" / "fixes.yaml").unlink()
    spec, findings = read(folder)
    assert spec is not None
    assert findings == [("file-not-found", "codegen.yaml", 5, 15)]


def test_two_documents_with_one_id_are_reported_at_the_second(folder: Path) -> None:
    (folder / "requirements" / "FR-2.md").write_text(REQUIREMENT.format(1))
    assert read(folder)[1] == [("requirement-duplicate", "requirements/FR-2.md", 1, 1)]


def test_mistakes_of_all_files_are_reported_in_one_run(folder: Path) -> None:
    """Nothing hides anything else: not a broken project file the tables, not one table the next."""
    (folder / "codegen.yaml").write_text("project: 1\n")
    (folder / "state.yaml").write_text("components: [\n")
    (folder / "board.yaml").write_bytes(b"board: \xff\n")
    (folder / "streams.yaml").write_text("")
    (folder / "messages" / "a.yaml").write_text("message: A\nmessage: B\n")
    (folder / "messages" / "b.yaml").write_text(GOOD["message"] + "strem: X\n")
    (folder / "requirements" / "FR-1.md").write_text("no heading\n")
    spec, findings = read(folder)
    assert spec is None
    assert findings == [
        ("file-not-utf8", "board.yaml", 1, 8),
        ("missing-key", "codegen.yaml", 1, 1),
        ("wrong-type", "codegen.yaml", 1, 10),
        ("missing-key", "messages/a.yaml", 1, 1),
        ("missing-key", "messages/a.yaml", 1, 1),
        ("yaml-duplicate-key", "messages/a.yaml", 2, 1),
        ("unknown-key", "messages/b.yaml", 11, 1),
        ("requirement-title", "requirements/FR-1.md", 1, 1),
        ("yaml-syntax", "state.yaml", 2, 1),
        ("yaml-empty", "streams.yaml", 1, 1),
    ]


def test_strange_entries_in_the_folder_do_not_raise(folder: Path) -> None:
    """A folder where a file is expected, a file where a folder is, links into nowhere, names that are no text."""
    (folder / "messages" / "c.yaml").mkdir()
    (folder / "messages" / "d.yaml").symlink_to(folder / "nowhere")
    (folder / "requirements" / "FR-1.md").unlink()
    (folder / "requirements").rmdir()
    (folder / "requirements").write_text("x")
    (folder / "codegen.yaml").write_text('project: r\ndialect: "\\0.xml"\ncorrections: ["\\0", ., ""]\n')
    with open(os.path.join(os.fsencode(folder), b"messages/\xff.yaml"), "w") as file:
        file.write("a: 1")
    spec, findings = read(folder)
    assert spec is not None
    assert {rule for rule, *_ in findings} >= {"file-not-found", "file-not-readable", "unknown-key"}
    assert [place[1:] for place in findings if place[1] == "codegen.yaml"] == [
        ("codegen.yaml", 3, 15),
        ("codegen.yaml", 3, 21),
        ("codegen.yaml", 3, 24),
    ]


def test_several_missing_files_are_one_finding(folder: Path) -> None:
    """Whoever begins with codegen.yaml alone is told how to begin, once."""
    for name in ("state.yaml", "board.yaml", "streams.yaml"):
        (folder / name).unlink()
    for path in (folder / "messages").iterdir():
        path.unlink()
    report = Report()
    assert decode_spec(str(folder / "codegen.yaml"), DISK, report) is None
    (finding,) = report
    assert finding.rule.id == "incomplete-project"
    assert report.exit_code == 2
    assert finding.message == "there is no state.yaml, board.yaml and streams.yaml beside it"
    assert "codegen init" in (finding.hint or "")
