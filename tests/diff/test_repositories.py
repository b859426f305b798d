"""Repositories as people have them: links, submodules, what is missing, no work tree, names with two meanings."""

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen.cli import main

Run = Callable[..., tuple[int, str, str]]

FIELD = '<field type="uint8_t" name="{}">d</field>'
OLD, NEW = "a", "ab"


def dialect(fields: str, *, include: str = "") -> str:
    inner = "".join(FIELD.format(name) for name in fields)
    message = f'<messages><message id="7" name="M"><description>d</description>{inner}</message></messages>'
    return f"<mavlink>{f'<include>{include}</include>' if include else message}</mavlink>"


def git(folder: Path, *arguments: str) -> str:
    config = ["user.name=T", "user.email=t@example.com", "protocol.file.allow=always"]
    command = ["git", *(word for each in config for word in ("-c", each)), *arguments]
    return subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout.strip()


def committed(folder: Path, texts: dict[str, str], message: str = "m") -> None:
    folder.mkdir(exist_ok=True)
    if not (folder / ".git").exists():
        git(folder, "init", "-q", "-b", "main")
    for name, text in texts.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    git(folder, "add", "-A")
    git(folder, "commit", "-q", "-m", message)


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """A dialect in a folder with an odd name, in two commits; the second adds a field."""
    folder = tmp_path / "r"
    committed(folder, {'ü "x"/m.xml': dialect(OLD)}, "first: one")
    committed(folder, {'ü "x"/m.xml': dialect(NEW)}, "second")
    return folder


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    def command(folder: Path, *argv: str) -> tuple[int, str, str]:
        monkeypatch.chdir(folder)
        code = main(["diff", *argv])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return command


def is_field_added(told: tuple[int, str, str]) -> bool:
    return told[0] == 1 and "follows: field-added: M.b: now uint8_t" in told[1] and told[1].count("error") == 1


def test_a_bare_repository_has_revisions(repository: Path, tmp_path: Path, run: Run) -> None:
    git(tmp_path, "clone", "-q", "--bare", str(repository), "bare.git")
    assert is_field_added(run(tmp_path / "bare.git", 'HEAD~1:ü "x"/m.xml', 'HEAD:ü "x"/m.xml'))


@pytest.mark.parametrize("revision", [":/first", "HEAD^{/first: one}", "HEAD~1^{}", "HEAD@{1}"])
def test_every_form_of_a_revision_is_git_s(revision: str, repository: Path, run: Run) -> None:
    code, _, err = run(repository, revision, "HEAD")
    assert (code, err) == (2, f"codegen diff: {revision} has no specs/codegen.yaml\n")


def test_a_path_of_a_revision_may_begin_where_the_command_runs(repository: Path, run: Run) -> None:
    """As git has it: ``REVISION:./path``."""
    assert is_field_added(run(repository / 'ü "x"', "HEAD~1:./m.xml", "HEAD:./m.xml"))
    assert is_field_added(run(repository / 'ü "x"', 'HEAD~1:../ü "x"/m.xml', "m.xml"))


def test_a_range_is_told_to_be_two_words(repository: Path, run: Run) -> None:
    assert "(the two sides are two words: codegen diff HEAD~1 main)" in run(repository, "HEAD~1..main")[2]
    assert "(the two sides are two words: codegen diff HEAD~1 HEAD)" in run(repository, "HEAD~1..")[2]


def test_a_name_that_means_two_things_is_not_taken_for_either(repository: Path, run: Run) -> None:
    """A branch called like a folder, or like a dialect: whichever is taken, "no change" might be of the other."""
    (repository / "development").mkdir()
    for name, kind, plain in (
        ("development", "path", "./development"),
        ("minimal", "dialect of pymavlink", "pymavlink:minimal"),
    ):
        git(repository, "branch", name)
        code, out, err = run(repository, name)
        assert (code, out) == (2, "")
        assert f"{name} is a {kind} and a revision ({plain} is the {kind}, {name}~0 the revision)" in err
    assert "has no specs/codegen.yaml" in run(repository, "minimal~0")[2]
    assert run(repository, "pymavlink:minimal") == (0, "", "")


def test_what_a_revision_lacks_is_said_in_its_words(repository: Path, run: Run) -> None:
    assert run(repository, "HEAD:specs/codegen.yaml", "HEAD")[2].endswith("has no specs/codegen.yaml\n")
    assert run(repository, "HEAD:specs", "HEAD")[2].endswith("has no specs/codegen.yaml\n")


def test_links_to_folders_are_followed_in_a_revision(tmp_path: Path, run: Run) -> None:
    """A link of a link, out of the folder and into another one; a circle of links has no end."""
    folder = tmp_path / "r"
    committed(folder, {"real/deep/m.xml": dialect(OLD), "top.xml": dialect("", include="specs/dialects/m.xml")})
    (folder / "specs").mkdir()
    (folder / "specs" / "dialects").symlink_to("../alias/deep")
    (folder / "alias").symlink_to("real")
    (folder / "circle").symlink_to("circle")
    (folder / "self.xml").symlink_to("./top.xml")
    committed(folder, {})
    committed(folder, {"real/deep/m.xml": dialect(NEW)})
    assert is_field_added(run(folder, "HEAD~1:self.xml", "self.xml"))
    assert is_field_added(run(folder, "HEAD~1:specs/dialects/m.xml", "HEAD:alias/deep/m.xml"))
    assert "is no dialect that can be read" in run(folder, "HEAD:circle/m.xml", "top.xml")[2]


def test_a_submodule_is_read_at_the_commit_that_was_recorded(tmp_path: Path, run: Run) -> None:
    """Dialects often are one. One that is not there is no dialect without messages."""
    theirs, ours = tmp_path / "theirs", tmp_path / "ours"
    committed(theirs, {"v1.0/m.xml": dialect(OLD)})
    committed(ours, {"top.xml": dialect("", include="lib/mavlink/v1.0/m.xml")})
    git(ours, "submodule", "--quiet", "add", str(theirs), "lib/mavlink")
    committed(ours, {})
    committed(theirs, {"v1.0/m.xml": dialect(NEW)})
    git(ours / "lib" / "mavlink", "pull", "-q")
    committed(ours, {})
    assert is_field_added(run(ours, "HEAD~1:top.xml", "top.xml"))
    assert is_field_added(run(ours, "HEAD~1:lib/mavlink/v1.0/m.xml", "HEAD:top.xml"))
    git(tmp_path, "clone", "-q", str(ours), "clone")
    code, out, err = run(tmp_path / "clone", "HEAD~1:top.xml", "HEAD:top.xml")
    assert (code, out) == (2, "")
    assert "HEAD~1:top.xml cannot be read: the submodule lib/mavlink has no commit" in err
    assert "git submodule update --init lib/mavlink" in err


def test_what_git_cannot_hand_out_is_no_empty_file(repository: Path, tmp_path: Path, run: Run) -> None:
    """A partial clone without its remote, and a damaged repository: not all that is missing was removed."""
    git(repository, "config", "uploadpack.allowFilter", "true")
    for kind in ("blob:none", "tree:0"):
        name = kind.replace(":", "-")
        git(tmp_path, "clone", "-q", "--no-checkout", f"--filter={kind}", f"file://{repository}", name)
        git(tmp_path / name, "config", "remote.origin.url", str(tmp_path / "gone"))
        code, out, err = run(tmp_path / name, 'HEAD:ü "x"/m.xml', str(repository / 'ü "x"' / "m.xml"))
        assert (code, out) == (2, ""), kind
        assert 'HEAD:ü "x"/m.xml cannot be read: ' in err
    blob = git(repository, "rev-parse", 'HEAD~1:ü "x"/m.xml')
    (repository / ".git" / "objects" / blob[:2] / blob[2:]).unlink()
    code, out, err = run(repository, 'HEAD~1:ü "x"/m.xml', 'ü "x"/m.xml')
    assert (code, out) == (2, "")
    assert f"git has no object {blob[:12]} of it" in err


def test_a_repository_of_somebody_else_is_named_with_git_s_own_advice(
    repository: Path, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As in a container, where files belong to another user than the one that runs."""
    monkeypatch.setenv("GIT_TEST_ASSUME_DIFFERENT_OWNER", "1")
    code, _, err = run(repository, "HEAD~1")
    assert code == 2
    assert "dubious ownership" in err
    assert f"(git config --global --add safe.directory {repository})" in err
