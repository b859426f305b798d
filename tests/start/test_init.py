"""codegen init: what it writes is a project for each board, nothing is overwritten, what does not fit is told."""

import re
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.cli.init import start_kinds
from codegen.commands.init import boards
from codegen.diagnostics import Report
from codegen.project.systems import check_scenarios, read_systems
from codegen.tool.template_files import templates_folder

KINDS = start_kinds()
BOARDS = [name for name, _ in boards()]


def files(folder: Path) -> dict[str, str]:
    return {path.relative_to(folder).as_posix(): path.read_text() for path in folder.rglob("*") if path.is_file()}


SMALL = {"esp32", "pyboard"}
"""The boards whose heap the boat to begin with nearly fills."""


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def findings(project: Path) -> list[str]:
    """Return the findings in a project, as its author is told."""
    report = Report()
    systems = read_systems(str(project), report)
    check_scenarios(str(project), systems, report)
    return [f"{finding.place.shown()} {finding.message}" for finding in report]


def test_there_are_boards_of_both_kinds() -> None:
    assert {"pico", "pico_2_w", "esp32", "pyboard"} <= set(BOARDS)


@pytest.mark.parametrize("board", BOARDS)
@pytest.mark.parametrize("kind", ["minimal", "boat"])
def test_each_board_gets_a_project_without_a_finding(here: Path, kind: str, board: str) -> None:
    """A board without Wi-Fi is reached by a cable; one that has little memory for a boat says so."""
    assert main(["init", "a", "--from", kind, "--board", board]) == 0
    told = findings(here / "a/specs/codegen.yaml")
    assert ["of heap once it has started" in each for each in told] == [True] * (kind == "boat" and board in SMALL)
    written = (here / "a/specs/board.yaml").read_text()
    assert f"\nboard: {board}\n" in written
    assert ("usb: true" in written.split("\nlinks:\n")[1]) is (board in {"pico", "pico_2", "pyboard"})


def test_a_new_project_has_what_a_repository_and_an_editor_need(here: Path) -> None:
    assert main(["init", "my boat"]) == 0
    found = files(here / "my boat")
    assert {".gitattributes", ".gitignore", ".github/workflows/codegen.yml", "app.py"} <= set(found)
    assert "eol=lf" in found[".gitattributes"]
    assert 'project: "my boat"\n' in found["specs/codegen.yaml"]
    for path, text in found.items():
        if path.startswith("specs/") and path.endswith(".yaml"):
            schema = text.splitlines()[0].partition("$schema=")[2]
            assert (here / "my boat" / path).parent.joinpath(schema).is_file(), path
    assert findings(here / "my boat/specs/codegen.yaml") == []


def test_a_build_says_what_there_is_now(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Not only how many files: what they are, and what one can do next; then that there was nothing to do."""
    assert main(["init", "a", "--board", "esp32_c3"]) == 0
    capsys.readouterr()
    project = ["--project", str(here / "a")]
    assert main([*project, "build"]) == 0
    written, made, what_is_next = capsys.readouterr().err.splitlines()
    assert " files written" in written
    assert made == "a/generated/ has a with 2 messages: firmware, mocks, tests, pages (docs/index.html)"
    assert what_is_next == "next: codegen sim, pytest a/generated/tests, codegen deploy (to a board on USB)"
    assert main([*project, "build", "--check"]) == 0
    assert capsys.readouterr().err == ""
    assert main([*project, "build"]) == 0
    assert capsys.readouterr().err.startswith("up to date: ")


def test_nothing_is_overwritten_and_nothing_written_beside_it(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (here / "specs").mkdir()
    (here / "specs" / "state.yaml").write_text("mine\n")
    (here / "app.py").write_text("mine, too\n")
    assert main(["init"]) == 1
    assert files(here) == {"specs/state.yaml": "mine\n", "app.py": "mine, too\n"}
    (line, hint), said = capsys.readouterr().out.splitlines(), "they are there already: app.py, specs/state.yaml"
    assert f"error init-exists: {said}" in line
    assert "codegen init FOLDER" in hint
    assert main(["init", "app.py"]) == 1
    assert "not a folder" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--board", "esp23"], "did you mean esp32 or "),
        (["--dialect", "comon"], "did you mean common"),
        (["--dialect", "none.xml"], "none.xml does not exist"),
        (["--dialect", "minimal"], "minimal has no message NAMED_VALUE_FLOAT"),
        (["--from", "rover", "--board", "esp32"], "rover/specs/board.yaml"),
    ],
)
def test_what_does_not_fit_is_told_and_nothing_written(
    here: Path, capsys: pytest.CaptureFixture[str], options: list[str], said: str
) -> None:
    assert main(["init", "rover", *options]) in (1, 2)
    told = capsys.readouterr()
    assert said in told.out
    assert ("error init-unknown: " in told.out) is ("did you mean" in said)
    assert "nothing was written" in told.err
    assert list(here.iterdir()) == []


def test_a_dialect_of_ones_own_is_copied(here: Path) -> None:
    """It may include what pymavlink ships."""
    (here / "own.xml").write_text(
        '<mavlink><include>common.xml</include><messages><message id="54001" name="OWN"><description>Own.</description>'
        '<field type="uint8_t" name="a">A.</field></message></messages></mavlink>'
    )
    assert main(["init", "a", "--dialect", "own.xml"]) == 0
    assert "\ndialect: dialects/own.xml\n" in (here / "a/specs/codegen.yaml").read_text()
    assert findings(here / "a/specs/codegen.yaml") == []
    assert main(["init", "c", "--from", "codec", "--dialect", "ardupilotmega"]) == 0
    assert "<include>ardupilotmega.xml</include>" in (here / "c/dialects/mine.xml").read_text()


@pytest.mark.parametrize("dialect", ["common", "ardupilotmega", "all"])
def test_the_message_of_a_codec_is_new_to_each_dialect(
    here: Path, capsys: pytest.CaptureFixture[str], dialect: str
) -> None:
    """The id of TANK_LEVEL is given away by none that pymavlink ships."""
    assert main(["init", "c", "--from", "codec", "--dialect", dialect]) == 0
    wanted = ["--dialect", "c/dialects/mine.xml", "--messages", "HEARTBEAT,TANK_LEVEL", "--out", "lib"]
    assert main(["codec", *wanted]) == 0, capsys.readouterr().out
    assert (here / "lib" / "messages.py").exists()


def test_a_codec_has_no_board(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["init", "--from", "codec", "--board", "esp32"]) == 2
    assert "--board says nothing" in capsys.readouterr().err


def test_each_kind_is_offered(capsys: pytest.CaptureFixture[str]) -> None:
    """Each folder of a start is a kind, and so is codegen's own specification; the help names them all."""
    folders = {path.name for path in (Path(templates_folder()) / "start").iterdir() if path.is_dir()}
    assert folders - {"common"} < set(KINDS)
    assert len(KINDS) == len(folders)
    assert main(["init", "--help"]) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert all(f"{name}, {text}" in told for name, text in KINDS.items())


@pytest.mark.parametrize("kind", ["minimal", "boat", "rover"])
def test_a_board_without_wifi_has_a_cable_and_all_else(here: Path, kind: str) -> None:
    """Facts, inputs and instances of the kind stay: only the links are others."""
    assert main(["init", "w", "--from", kind]) == 0
    assert main(["init", "a", "--from", kind, "--board", "pico_2"]) == 0
    wireless, wired = ((here / name / "specs" / "board.yaml").read_text() for name in ("w", "a"))
    assert "\nlinks:\n  cable: {usb: true}\n" in wired
    assert "wifi" not in wired
    kept = [line for line in wireless.splitlines() if re.match(r"(?!links|board)\w+:", line)]
    assert kept == [line for line in wired.splitlines() if re.match(r"(?!links|board)\w+:", line)]
    assert findings(here / "a" / "specs" / "codegen.yaml") == []
