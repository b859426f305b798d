"""Both words of `codegen diff BASE HEAD` are resolved, and meaningless ones are reported."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[1]

Run = Callable[..., tuple[int, str, str]]

XML = '<mavlink><messages><message id="{}" name="M"><description>d</description>{}</message></messages></mavlink>'
FIELD = '<field type="uint8_t" name="{}">a</field>'


def git(folder: Path, *arguments: str) -> str:
    command = ["git", "-c", "user.name=T", "-c", "user.email=t@example.com", *arguments]
    return subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout.strip()


@pytest.fixture(scope="module")
def repository(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three commits: a project whose dialect is its own XML, with another field in each; the last one is a branch's."""
    folder = tmp_path_factory.mktemp("sides")
    git(folder, "init", "-q", "-b", "main")
    (folder / "specs" / "requirements").mkdir(parents=True)
    (folder / "specs" / "messages").mkdir()
    texts = {
        "codegen.yaml": "project: p\ndialect: dialects/m.xml\nmachine_code: false\ncomponent_id: A\n",
        "board.yaml": "board: pico\n",
        "parameters.yaml": "parameters: {}\n",
        "streams.yaml": "streams:\n  only: {doc: d, rate: 1 Hz}\n",
        "state.yaml": "components:\n  vehicle: {doc: d, quantities: {x: {doc: d, initial: 1}}}\n",
        "messages/m.yaml": "message: M\nrequirement: FR-1\nstream: only\nfields: {a: {constant: 1}}\n",
        "requirements/FR-1.md": "# FR-1 | T\n\n## Metadata\n\n- Status: A\n\n## Acceptance Criteria\n\n1. It is.\n",
    }
    enum = '<enums><enum name="MAV_COMPONENT"><entry value="1" name="A"/></enum></enums>'
    for name, text in texts.items():
        (folder / "specs" / name).write_text(text)
    (folder / "specs" / "dialects").mkdir()
    for number, fields in enumerate(("a", "a", "ab"), 1):
        inner = "".join(FIELD.format(name) for name in fields)
        (folder / "specs" / "dialects" / "m.xml").write_text(
            XML.format(7, inner).replace("<messages>", f"{enum}<messages>")
        )
        if number == 2:
            git(folder, "checkout", "-q", "-b", "work")
            (folder / "specs" / "board.yaml").write_text("board: pico_2\n")
        if number == 3:
            (folder / "specs" / "messages" / "m.yaml").write_text(
                texts["messages/m.yaml"].replace("1}}", "1}, b: {constant: 2}}")
            )
        git(folder, "add", "-A")
        git(folder, "commit", "-q", "-m", str(number))
    git(folder, "checkout", "-q", "main")
    (folder / "specs" / "streams.yaml").write_text("streams:\n  only: {doc: d, rate: 2 Hz}\n")
    git(folder, "commit", "-q", "-a", "-m", "meanwhile on main")
    git(folder, "checkout", "-q", "work")
    return folder


@pytest.fixture
def run(repository: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    def command(*argv: str, folder: Path = repository) -> tuple[int, str, str]:
        monkeypatch.chdir(folder)
        code = main(["diff", *argv])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return command


def rules(out: str) -> list[str]:
    return [line.split(": ")[1].split()[1] for line in out.splitlines() if not line.startswith(" ")]


def test_a_revision_is_compared_with_the_work_tree_and_with_another_one(run: Run) -> None:
    """Any form of a revision that git knows; what was at another line is named as git names it."""
    told = rules(run("work~1")[1])
    assert told == ["crc-extra-changed", "bandwidth-changed"]
    assert rules(run("work~2", "work~1")[1]) == ["program-changed"]
    assert rules(run("HEAD^{/2}")[1]) == rules(run("work~1")[1])
    out = run("work~1", "work~2")[1]
    assert out.startswith("work~2:specs/board.yaml:1:8: error program-changed")


def test_three_dots_mean_where_both_parted(run: Run) -> None:
    """Changes on main meanwhile are no changes of the branch."""
    assert "stream-rate-changed" in rules(run("main")[1])
    assert "stream-rate-changed" not in rules(run("main...")[1])
    assert "program-changed" in rules(run("main...")[1])


def test_a_file_of_a_revision_is_a_dialect_and_a_folder_of_one_a_project(run: Run, repository: Path) -> None:
    code, out, _ = run("work~1:specs/dialects/m.xml", "specs/dialects/m.xml")
    assert (code, rules(out)) == (1, ["crc-extra-changed"])
    assert "follows: field-added: M.b: now uint8_t" in out
    assert rules(run("work~1:specs", ".")[1]) == rules(run("work~1")[1])
    assert rules(run("work~1", folder=repository / "specs" / "messages")[1]) == rules(run("work~1")[1])
    assert run(".", "specs/codegen.yaml") == (0, "", "")


def test_the_work_tree_is_left_alone(run: Run, repository: Path) -> None:
    """Blobs are read; nothing is checked out, and no index is refreshed."""
    before = git(repository, "status", "--porcelain"), git(repository, "rev-parse", "HEAD")
    run("main")
    assert (git(repository, "status", "--porcelain"), git(repository, "rev-parse", "HEAD")) == before


def test_in_a_hook_the_project_and_not_its_surroundings_counts(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """git tells its hooks where its own repository is, relative to where they start."""
    git(tmp_path, "init", "-q", "other")
    expected = run("work~1")
    monkeypatch.setenv("GIT_DIR", str(tmp_path / "other" / ".git"))
    monkeypatch.setenv("GIT_INDEX_FILE", ".git/index")
    assert run("work~1") == expected


def test_releases_of_pymavlink_are_wheels_folders_and_the_installed_one(run: Run, older_pymavlink: Path) -> None:
    """Each with the dialect that is named, or else common, compared with the installed release."""
    wheel = str(older_pymavlink)
    code, out, err = run(f"{wheel}:minimal")
    assert code in (0, 1)
    assert err.splitlines()[-1].startswith(f"{wheel}:minimal -> pymavlink:minimal: ")
    assert f"{older_pymavlink.name}:pymavlink/dialects/v20/minimal.xml" in out
    assert run(f"{wheel}:minimal", "minimal")[1] == out
    code, out, err = run(wheel, wheel)
    assert (code, out) == (1, "")
    assert "STORAGE_INFORMATION.type: there is no enum STORAGE_TYPE" in err  # a fault of that release
    assert run(wheel, wheel, "--allow-errors")[:2] == (0, "")
    assert run(str(Path(sys.prefix)), "pymavlink") == (0, "", "")
    assert run("pymavlink:common", "common") == (0, "", "")


def test_a_project_is_read_with_another_pymavlink(older_pymavlink: Path, run: Run) -> None:
    """An update of pymavlink is compared by what concerns the project; the rest is counted."""
    project = str(ROOT / "projects" / "two_batteries")
    code, out, err = run(project, project, "--base-pymavlink", str(older_pymavlink))
    assert code in (0, 1)
    assert "BATTERY_STATUS" in out
    assert "GPS_RAW_INT" not in out
    assert "of the dialect concern nothing that this project sends or receives (see --all)" in err
    assert "GPS_RAW_INT" in run(project, project, "--base-pymavlink", str(older_pymavlink), "--all")[1]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["nonsense"], "git knows no revision nonsense"),
        (["comon"], "did you mean common"),
        (["HEAD:nothing.xml"], "HEAD:nothing.xml is no dialect that can be read"),
        (["pymavlink:comon"], "the installed pymavlink has no dialect comon (did you mean common"),
        (["specs/board.yaml"], "has no specification that can be read"),
        (["specs/messages"], "specs/messages holds neither a project nor the dialects of a pymavlink"),
        ([], "name the old version"),
        (["HEAD", "--fail-on", "breakin"], "--fail-on knows no breakin (did you mean breaking"),
        (["HEAD", "--bandwidth", "much"], "--bandwidth is a number of percent"),
        (["HEAD", "--base-pymavlink", "no/such.whl"], "no/such.whl does not exist"),
    ],
)
def test_what_means_nothing_is_said_in_a_line(words: list[str], said: str, run: Run) -> None:
    code, out, err = run(*words)
    assert (code, out) == (2, "")
    assert said in err
    assert "Traceback" not in err


def test_what_is_no_dialect_at_all_is_not_one_without_messages(tmp_path: Path, run: Run) -> None:
    """Else everything that the other side has would be reported as new, or as gone."""
    good, other, without = (tmp_path / name for name in ("good.xml", "other.xml", "without.xml"))
    good.write_text(XML.format(7, FIELD.format("a")))
    other.write_text("<html/>")
    without.write_text("<mavlink><include>no.xml</include></mavlink>")
    for bad, said in ((other, "the root element is <html>"), (without, "no.xml does not exist")):
        for sides in ((bad, good), (good, bad)):
            code, out, err = run(*map(str, sides))
            assert (code, out) == (2, "")
            assert said in err
            assert f"codegen diff: {bad} is no dialect that can be read" in err
    assert "/dev/null is neither a file nor a folder" in run("/dev/null", str(good))[2]


def test_a_damaged_archive_is_said_to_be_one(tmp_path: Path, run: Run) -> None:
    (tmp_path / "x.whl").write_bytes(b"PK\x03\x04 and nothing more")
    (tmp_path / "y.tar.gz").write_bytes(b"\x1f\x8b\x08 and nothing more")
    for name in ("x.whl", "y.tar.gz"):
        assert run(str(tmp_path / name))[2] == f"codegen diff: {name} is no archive that can be read\n"


def test_a_shallow_clone_is_told_the_command(repository: Path, tmp_path: Path, run: Run) -> None:
    """The one that brings the revision, and no more than it."""
    git(tmp_path, "clone", "-q", "--depth", "1", f"file://{repository}", "shallow")
    shallow = tmp_path / "shallow"
    head = git(repository, "rev-parse", "work~2")
    for revision, command in {
        "HEAD~1": "git fetch --deepen=1",
        "HEAD^^": "git fetch --deepen=2",
        "origin/main": "git fetch --depth=1 origin +refs/heads/main:refs/remotes/origin/main",
        head: f"git fetch --depth=1 origin {head}",
        "v1.0": "git fetch --unshallow",
    }.items():
        code, out, err = run(revision, folder=shallow)
        assert (code, out) == (2, "")
        assert f"(this clone is shallow: {command})" in err
    git(shallow, "fetch", "-q", "--depth=1", "origin", "+refs/heads/main:refs/remotes/origin/main")
    assert "stream-rate-changed" in rules(run("origin/main", folder=shallow)[1])


def test_outside_a_repository_a_word_is_no_revision(tmp_path: Path, run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(tmp_path.parent))
    code, out, err = run("HEAD~1", folder=tmp_path)
    assert (code, out) == (2, "")
    assert "HEAD~1 is no file, folder or dialect, and this is no git repository" in err


def test_a_broken_side_is_compared_as_far_as_it_can_be_read(repository: Path, run: Run) -> None:
    """An old version may have errors by the rules of today: the report says so at its head."""
    table = repository / "specs" / "messages" / "m.yaml"
    written = table.read_text()
    try:
        table.write_text(written.replace("b: {constant: 2}", "b: {constant: 2000}"))
        code, _, err = run("work~1")
        assert code == 1
        assert "specs/messages/m.yaml:4:42: error constant-out-of-range: work tree cannot be compared as a whole" in err
        assert "work tree has an error, and what it concerns may be missing (--allow-errors" in err
        table.write_text("message: [")
        code, _, err = run("HEAD")
        assert code in (1, 2)
        assert "Traceback" not in err
    finally:
        table.write_text(written)
