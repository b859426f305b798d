"""A specification reaches no further than its project: nothing outside is read, quoted or written.

And what cannot be read is never taken for empty.
"""

import os
import shutil
from pathlib import Path

import pytest
import yaml
from fuzzing.watch import watched

from codegen.cli import main
from codegen.load import yaml_composer

ROOT = Path(__file__).resolve().parents[2]
HIDDEN = "do not: [quote this\n"


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project of one message, in a folder with something beside it that is nobody's business."""
    folder = tmp_path / "above" / "project"
    shutil.copytree(ROOT / "tests" / "projects" / "minimal" / "specs", folder / "specs")
    (tmp_path / "secret").write_text(HIDDEN)
    monkeypatch.chdir(folder)
    return folder


def edit(path: Path, text: str) -> None:
    """Add lines to a file."""
    path.write_text(path.read_text() + text)


def test_a_project_file_is_not_parsed_for_each_question(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Protects a build of one with two million characters: its output, its folders and its programs are asked for, too.

    The programs are asked for once all other files have been read.
    """
    parsed, read = [], yaml_composer._Composer.read

    def noted(self: yaml_composer._Composer, text: str, loader: type[yaml.SafeLoader]) -> None:
        parsed.append(text)
        read(self, text, loader)

    monkeypatch.setattr(yaml_composer._Composer, "read", noted)
    edit(project / "specs" / "codegen.yaml", "no_such_key: 1\n")
    assert main(["build"]) == 1
    assert len([text for text in parsed if "no_such_key" in text]) == 2


@pytest.mark.parametrize(
    ("lines", "place"),
    [
        ("programs: {x: ../../../secret}\n", "codegen.yaml"),
        ("overlays: [../../../secret]\n", "codegen.yaml"),
        ("corrections: [../../../secret]\n", "codegen.yaml"),
        ("known: [../../../secret]\n", "codegen.yaml"),
    ],
)
def test_a_path_that_leads_outside(lines: str, place: str, project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It is a finding where it stands, and nothing of the file is printed."""
    edit(project / "specs" / "codegen.yaml", lines)
    assert main(["check"]) == 2
    printed = "".join(capsys.readouterr())
    assert f"specs/{place}" in printed
    assert " error outside-project: " in printed
    assert "quote this" not in printed


@pytest.mark.parametrize(
    "name",
    ["messages/one.yaml", "requirements/R-9.md", "state.yaml", "scenarios.yaml", "waivers.yaml", "trace.lock.yaml"],
)
def test_a_link_that_leads_outside(name: str, project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The same of a link, which a pull request can bring."""
    path = project / "specs" / name
    path.unlink(missing_ok=True)
    path.symlink_to(project.parents[1] / "secret")
    assert main(["check"]) == 2
    printed = "".join(capsys.readouterr())
    assert " error outside-project: " in printed
    assert "quote this" not in printed


def test_an_included_dialect_that_leads_outside(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Includes are paths, too."""
    (project / "specs" / "own.xml").write_text("<mavlink><include>../../../secret</include></mavlink>")
    edit(project / "specs" / "codegen.yaml", "overlays: [own.xml]\n")
    assert main(["check"]) == 2
    printed = "".join(capsys.readouterr())
    assert "specs/own.xml:1:10: error outside-project: " in printed
    assert "quote this" not in printed


@pytest.mark.parametrize("output", ["../../made", "/etc/made"])
def test_output_that_lies_outside(output: str, project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It is refused, and nothing is written there."""
    edit(project / "specs" / "codegen.yaml", f"output: {output}\n")
    assert main(["build"]) == 1
    assert "lies outside of the project" in "".join(capsys.readouterr())
    assert not (project / "specs" / output).exists()


def test_output_that_is_a_link_which_leads_outside(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A pull request can bring one: nothing is written there unless the project lists it."""
    away = project.parents[1] / "away"
    away.mkdir()
    (project / "generated").symlink_to(away)
    assert main(["check"]) == 1
    assert main(["build"]) == 1
    assert "the output folder ../generated lies outside of the project" in "".join(capsys.readouterr())
    assert not list(away.iterdir())
    edit(project / "specs" / "codegen.yaml", "outside: [../generated]\n")
    assert main(["build"]) == 0
    assert (away / "firmware" / "telemetry.py").exists()


def test_what_is_listed_is_meant(project: Path) -> None:
    """Folders under outside are read, and may hold the output."""
    (project.parents[1] / "shared").mkdir()
    (project.parents[1] / "shared" / "empty.xml").write_text("<mavlink><messages></messages></mavlink>")
    edit(
        project / "specs" / "codegen.yaml",
        "overlays: [../../../shared/empty.xml]\noutput: ../../made\noutside: [../../../shared, ../../made]\n",
    )
    assert main(["build"]) == 0
    assert (project.parent / "made" / "firmware" / "telemetry.py").exists()


def test_a_folder_that_cannot_be_read_is_not_empty(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A link that leads in circles stands in for permissions, which do not bind everybody."""
    shutil.rmtree(project / "specs" / "messages")
    os.symlink("messages", project / "specs" / "messages")
    assert main(["check"]) == 2
    assert "specs/messages:1:1: error file-not-readable: the folder specs/messages" in "".join(capsys.readouterr())


@pytest.mark.parametrize("text", ["accepted: {a: [}\n", "unheard: of\n", "\x00\x01"])
def test_a_lock_file_that_is_damaged(text: str, project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It is found by check, not only by trace."""
    (project / "specs" / "trace.lock.yaml").write_text(text)
    assert main(["check"]) in (1, 2)
    assert "specs/trace.lock.yaml:" in "".join(capsys.readouterr())


def test_many_findings_of_one_kind_are_counted(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A hundred are shown, one line tells how many there are beside them."""
    edit(project / "specs" / "parameters.yaml", "".join(f"  P{number}: {{}}\n" for number in range(1000)))
    text = (project / "specs" / "parameters.yaml").read_text()
    (project / "specs" / "parameters.yaml").write_text(text.replace("parameters: {}", "parameters:"))
    assert main(["check"]) == 1
    printed = capsys.readouterr()
    lines = [line for line in printed.out.splitlines() if " error missing-key: " in line]
    assert len(lines) == 101
    assert lines[-1].startswith("specs/parameters.yaml:22:")
    assert lines[-1].endswith("4,900 more of these, of which this is the first, are not shown")
    assert printed.err.startswith("5000 errors")


@pytest.mark.parametrize("file", ["state.yaml", "messages"])
def test_a_name_that_micropython_could_not_hold(file: str, project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It has at most 255 characters with all its parts: 64 for each are enough."""
    path = project / "specs" / file
    if path.is_dir():
        path = next(iter(sorted(path.glob("*.yaml"))))
        edit(path, f"as: {'n' * 65}\n")
    else:
        edit(path, f"      {'n' * 65}: {{doc: d, initial: 0}}\n")
    assert main(["check"]) == 1
    assert "n" * 65 in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "command"),
    [("scenarios.yaml", "build"), ("scenarios.yaml", "sim"), ("trace.lock.yaml", "trace"), ("waivers.yaml", "diff")],
)
def test_other_commands_follow_no_link_either(
    name: str, command: str, project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Other commands refuse the links that check refuses."""
    path = project / "specs" / name
    path.unlink(missing_ok=True)
    path.symlink_to(project.parents[1] / "secret")
    shutil.copytree(project / "specs", project.parent / "before" / "specs", ignore=shutil.ignore_patterns(name))
    assert main([command, *(["../before", "."] if command == "diff" else [])]) in (1, 2)
    printed = "".join(capsys.readouterr())
    assert " error outside-project: " in printed
    assert "quote this" not in printed


@pytest.mark.parametrize("command", ["build", "check", "trace"])
def test_a_project_file_that_leads_outside_is_not_opened(
    command: str, project: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It could say itself that it may lie there."""
    path = project / "specs" / "codegen.yaml"
    path.unlink()
    path.symlink_to(project.parents[1] / "secret")
    with watched() as seen:
        assert main([command]) == 2
    assert " error outside-project: " in "".join(capsys.readouterr())
    assert str(path) not in seen.read


@pytest.mark.parametrize("name", ["messages", "requirements", "receives", "dialects", "boards"])
def test_a_folder_that_leads_outside(name: str, project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Not even the names of the files there are told."""
    shutil.rmtree(project / "specs" / name, ignore_errors=True)
    away = project.parents[1] / "away"
    away.mkdir()
    for ending in ("yaml", "md", "xml"):
        (away / f"hidden.{ending}").write_text(HIDDEN)
    (project / "specs" / name).symlink_to(away)
    assert main(["check"]) == 2
    printed = "".join(capsys.readouterr())
    assert f"specs/{name}:1:1: error outside-project: specs/{name} lies outside of the project" in printed
    assert "quote this" not in printed
    assert "hidden" not in printed


def test_tests_that_lie_outside(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Folders in which trace looks for marked tests are paths, too."""
    away = project.parents[1] / "away"
    away.mkdir()
    (away / "test_hidden.py").write_text('@pytest.mark.requirement("FR-1.1")\ndef test_hidden(: pass\n')
    edit(project / "specs" / "codegen.yaml", "tests: [../../../away]\n")
    assert main(["trace"]) == 2
    printed = "".join(capsys.readouterr())
    assert " error outside-project: ../" not in printed
    assert " error outside-project: " in printed
    assert "test_hidden" not in printed


def test_no_stamp_is_looked_for_outside(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Before the build says that the output may not lie there."""
    edit(project / "specs" / "codegen.yaml", "output: ../../made\n")
    monkeypatch.setattr("codegen.emit.stamp._kept", lambda folder: pytest.fail(f"{folder} was looked into"))
    assert main(["build"]) == 1


@pytest.mark.parametrize(
    ("output", "told"),
    [
        ("../.git", "is, or lies in, a folder of git"),
        ("../.git/hooks", "is, or lies in, a folder of git"),
        ("messages", "is, lies in or contains specs/messages, from which codegen reads"),
        ("requirements/made", "is, lies in or contains specs/requirements, from which codegen reads"),
        ("sail", "is, lies in or contains specs/sail, from which codegen reads"),
        ("sail/made", "is, lies in or contains specs/sail, from which codegen reads"),
        ("more", "is, lies in or contains specs/more/buoy, from which codegen reads"),
        ("..\\generated2", "has a backslash"),
    ],
)
def test_output_among_other_files(output: str, told: str, project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Nothing is written to folders of git, of the specification and of further programs, nor by a wrong name."""
    specs = project / "specs"
    edit(
        specs / "codegen.yaml",
        f"output: {output}\nprograms: {{sail: sail/codegen.yaml, buoy: more/buoy/codegen.yaml}}\n",
    )
    for folder, base in (("sail", ".."), ("more/buoy", "../..")):
        (specs / folder).mkdir(parents=True)
        (specs / folder / "codegen.yaml").write_text(f"base: {base}\nproject: further\n")
    before = sorted(specs.rglob("*"))
    assert main(["build"]) == 1
    lines = [line for line in capsys.readouterr().out.splitlines() if "bad-project" in line]
    assert [told in line for line in lines] == [True], lines
    assert sorted(specs.rglob("*")) == before
    assert not (project / ".git").exists()


def test_output_beside_the_folders_of_the_specification(project: Path) -> None:
    edit(project / "specs" / "codegen.yaml", "output: made\n")
    assert main(["build"]) == 0
