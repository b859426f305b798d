"""``codegen import`` and ``codegen check`` as they are called, on a copy of the shipped project."""

import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from short_documents import shorten_documents

from codegen.cli import main

ROOT = Path(__file__).parents[2]
Run = Callable[..., tuple[int, str, str]]

DOCUMENT = """# FR-00068 | Telemetry of the pack

BATTERY_STATUS follows `SR0_EXTRA1`.

| Field | Value |
| --- | --- |
| id | 0 |
| type | 1 (MAV_BATTERY_TYPE_LIPO) |
| temperature | INT16_MAX |
| current_battery | -1 or estimate |
"""


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    def command(*argv: str) -> tuple[int, str, str]:
        code = main(list(argv))
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return command


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the document and no project; it is the working directory."""
    (tmp_path / "doc.txt").write_text(DOCUMENT)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def project(folder: Path) -> Path:
    """The same with a copy of the shipped specification, of which two documents are whole."""
    shutil.copytree(ROOT / "specs", folder / "specs")
    shorten_documents(folder / "specs", whole=["FR-00068", "ADR-00018"])
    return folder


@pytest.mark.usefixtures("folder")
def test_the_table_goes_to_stdout_and_the_findings_to_stderr(run: Run) -> None:
    code, out, err = run("import", "doc.txt")
    assert code == 1
    assert out.startswith("message: BATTERY_STATUS\nrequirement: FR-00068\n# stream: ...")
    assert "\nfields:\n  id: {constant: 0}  # FR-00068 line 7\n" in out
    assert "  # current_battery: unknown  # FR-00068 line 10: -1 or estimate\n" in out
    assert "doc.txt:10:21: error document-ambiguous: " in err
    assert err.endswith("1 error, 10 warnings\n")


def test_a_file_is_written_once(run: Run, folder: Path) -> None:
    code, out, _ = run("import", "doc.txt", "--out", "new/t.yaml")
    assert code == 1
    assert "document-ambiguous" in out
    written = (folder / "new" / "t.yaml").read_text()
    assert written.startswith("message: BATTERY_STATUS\n")
    code, out, err = run("import", "doc.txt", "--out", "new/t.yaml")
    assert (code, out) == (2, "")
    assert err.startswith("codegen import: new/t.yaml exists; --merge adds")
    assert (folder / "new" / "t.yaml").read_text() == written
    assert [path.name for path in (folder / "new").iterdir()] == ["t.yaml"]


def test_a_table_of_the_project_is_compared_and_merged(run: Run, project: Path) -> None:
    table = project / "specs" / "messages" / "battery_status.yaml"
    before = table.read_text()
    code, out, err = run("import", "doc.txt")
    assert "for_each: battery\nstream: EXTRA1\nfields:\n  id: {state: battery.instance}" in out
    assert "specs/messages/battery_status.yaml has a table: 1 same, 1 same value, 1 different, 1 not read" in err
    code, out, err = run("import", "doc.txt", "--compare")
    assert code == 1
    assert "BATTERY_STATUS: doc.txt beside specs/messages/battery_status.yaml\n" in out
    assert "different" in out
    assert table.read_text() == before
    line = "  type: {board: battery.chemistry, requirement: FR-00068.7}\n"
    table.write_text(before.replace(line, ""))
    code, out, err = run("import", "doc.txt", "--merge")
    assert err.startswith("added to specs/messages/battery_status.yaml: type\n")
    assert table.read_text() == before.replace(line, "  type: {enum: MAV_BATTERY_TYPE_LIPO}  # FR-00068 line 8\n")
    code, _, err = run("import", "doc.txt", "--merge")
    assert err.startswith("specs/messages/battery_status.yaml lacks none of these answers\n")


def test_what_the_table_lacks_differs(run: Run, project: Path) -> None:
    """As a gate --compare missed fields that stand in the document alone; --merge adds them."""
    table = project / "specs" / "messages" / "battery_status.yaml"
    (project / "one.md").write_text("## BATTERY_STATUS\n\n| Field | Value |\n| --- | --- |\n| type | 1 |\n| id | 0 |\n")
    table.write_text(re.sub(r"(?m)^  type: .*\n", "", table.read_text()))
    code, out, _ = run("import", "one.md", "--compare")
    assert "only in the document" in out
    assert not re.search(r"(?m)^different", out)
    assert code == 1
    assert run("import", "one.md", "--merge")[0] == 0


def test_a_table_that_cannot_be_read_is_not_one_that_is_missing(run: Run, project: Path) -> None:
    """A second table was written beside it, without a word of the first."""
    table = project / "specs" / "messages" / "battery_status.yaml"
    table.write_text(table.read_text().replace("fields:\n", "fields:\n  temperature: [1\n"))
    for options in (["--compare"], ["--merge"], ["--out", "specs/messages/second.yaml"], []):
        code, out, err = run("import", "doc.txt", *options)
        assert code == 2
        assert re.search(r"(?m)^specs/messages/battery_status.yaml:\d+:\d+: error yaml-syntax", out + err)
    assert not (project / "specs" / "messages" / "second.yaml").exists()


@pytest.mark.parametrize(
    ("argv", "said"),
    [
        (["doc.txt", "--merge", "--compare"], "codegen import: --compare writes nothing"),
        (["doc.txt", "--merge"], "codegen import: there is no table of BATTERY_STATUS yet"),
        (["doc.txt", "--compare"], "codegen import: there is no table of BATTERY_STATUS yet"),
        (
            ["doc.txt", "--dialect", "common", "--project", "x.yaml"],
            "codegen import: --dialect works without a project",
        ),
        (["nothing.md"], "nothing.md:1:1: error file-not-found"),
        (["doc.txt", "--dialect", "nosuch"], "nosuch:1:1: error codec-dialect"),
        (["doc.txt", "--project", "nothing.yaml"], "nothing.yaml:1:1: error file-not-found"),
        (["."], ".:1:1: error file-not-readable"),
    ],
)
@pytest.mark.usefixtures("folder")
def test_what_cannot_be_done_is_said(run: Run, argv: list[str], said: str) -> None:
    code, out, err = run("import", *argv)
    assert code == 2
    assert said in out + err
    assert "internal error" not in err


def test_names_of_the_project_are_checked(run: Run, project: Path) -> None:
    assert project.exists()
    code, _, err = run("import", "doc.txt", "--stream", "EXTRA9")
    assert (code, err) == (2, "codegen import: the project has no stream EXTRA9; did you mean EXTRA3 or EXTRA1?\n")
    code, _, err = run("import", "doc.txt", "--for-each", "batery")
    assert (code, err) == (2, "codegen import: the project has no component batery; did you mean battery?\n")


def test_another_table_is_not_merged_with(run: Run, folder: Path) -> None:
    other = "message: HEARTBEAT\nrequirement: FR-1\nfields:\n  type: {enum: MAV_TYPE_GROUND_ROVER}\n"
    (folder / "t.yaml").write_text(other)
    code, out, _ = run("import", "doc.txt", "--out", "t.yaml", "--merge")
    assert code == 1
    assert "t.yaml:1:10: error merge-message" in out
    assert (folder / "t.yaml").read_text() == other


def test_what_is_imported_can_be_built(run: Run, project: Path) -> None:
    """The shipped requirement gives a table that takes the place of the shipped one without a finding."""
    table = project / "specs" / "messages" / "battery_status.yaml"
    document = str(project / "specs" / "requirements" / "FR-00068-battery-status-telemetry.md")
    code, out, err = run("import", document, "--message", "battery_status")
    assert "\nrequirement: FR-00068.1\nfor_each: battery\nstream: EXTRA1\n" in out
    assert code == 0
    assert err.splitlines()[-1].endswith("14 same; --compare lists them")
    table.write_text(out)
    code, out, err = run("check")
    assert (code, ": error " in out, ": warning " in out, err) == (0, False, False, "1 waived\n")


FR = "specs/requirements/FR-00068-battery-status-telemetry.md"


def test_drift_of_the_table_names_both_places(run: Run, project: Path) -> None:
    table = project / "specs" / "messages" / "battery_status.yaml"
    table.write_text(table.read_text().replace("{state: battery.temperature,", "{unknown: true,"))
    code, out, _ = run("check")
    assert code == 1
    assert out[out.index(FR) :].splitlines() == [
        f"{FR}:62:35: error document-drift: BATTERY_STATUS.temperature is {{state: battery.temperature}} here, but unknown in the population table",
        "  hint: correct the one that is out of date",
        "  specs/messages/battery_status.yaml:10:3: the population table answers here",
    ]


def test_a_table_is_held_against_the_dialect_only_where_nothing_is_populated(run: Run, project: Path) -> None:
    document = project / "specs" / "requirements" / "FR-00020-battery-voltage-failsafe.md"
    rows = (
        "\n\nATTITUDE:\n\n| Field | Type | Unit |\n| --- | --- | --- |\n| roll | float | rad |\n| pitch | f64 | deg |\n"
    )
    document.write_text(document.read_text() + rows)
    code, out, _ = run("check")
    assert code == 1
    assert [line.split(": ")[1] for line in out.splitlines() if " error " in line] == [
        "error document-type", "error document-unit",
    ]  # fmt: skip


def test_a_message_of_a_further_program_is_held_against_its_table(run: Run, project: Path) -> None:
    """Only the smart battery sends this one."""
    (project / "specs" / "smart_battery" / "messages" / "system_time.yaml").write_text(
        "message: SYSTEM_TIME\nrequirement: FR-00074\nfields:\n"
        "  time_unix_usec: {constant: 0 us}\n  time_boot_ms: {constant: 1 ms}\n"
    )
    program = project / "specs" / "smart_battery" / "codegen.yaml"
    program.write_text(program.read_text().replace("messages: [", "messages: [SYSTEM_TIME, "))
    document = project / "specs" / "requirements" / "FR-00074-smart-battery.md"
    rows = "\n\nSYSTEM_TIME:\n\n| Field | Value |\n| --- | --- |\n| time_unix_usec | 0 us |\n| time_boot_ms | 2 ms |\n"
    document.write_text(document.read_text() + rows)
    code, out, _ = run("check")
    assert code == 1
    assert "error document-drift: SYSTEM_TIME.time_boot_ms is {constant: 2 ms} here, but {constant: 1 ms} in" in out
    assert "time_unix_usec" not in out
