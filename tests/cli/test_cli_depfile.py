"""``--depfile``: real make and real ninja run codegen again when, and only when, what it reads has changed."""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.emit.depfile import depfile_text

ROOT = Path(__file__).parents[2]
MINIMAL = ROOT / "tests" / "projects" / "minimal" / "specs"
NINJA = Path(sys.executable).parent / "ninja"

ODD = [
    "plain.yaml",
    "a b.yaml",
    "cost$5.yaml",
    "#1.yaml",
    "c:d.yaml",
    "a\\ b.yaml",
    "k=v.yaml",
    "äöü.yaml",
    "($x) #'.yaml",
]
"""Names that are legal and that make or ninja would take for something else."""


def make(folder: Path, *argv: str) -> str:
    done = subprocess.run(["make", *argv], cwd=folder, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def ninja(folder: Path) -> str:
    done = subprocess.run([NINJA], cwd=folder, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def change(path: Path, target: Path) -> None:
    """A change of ``path`` after ``target`` was made, in steps that every disk and clock shows."""
    now = time.time()
    for one, age in ((target, 100), (path, 50)):
        os.utime(one, (now - age, now - age))


def test_no_path_becomes_a_variable_of_make() -> None:
    """SHELL=x at the begin of a line would set the shell of every recipe."""
    text = depfile_text("out", ["SHELL=x", "b", "a"])
    assert text == "out: \\\n  a \\\n  b \\\n  SHELL=x\na:\nb:\n"
    assert depfile_text("out", ["a\nb", "c\\"]) == "out:\n", "make has no way to write them"


@pytest.mark.parametrize("name", ODD)
def test_make_watches_files_of_any_name(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("")
    (tmp_path / "out.d").write_text(depfile_text("out", [name, "zz"]))
    (tmp_path / "zz").write_text("")
    (tmp_path / "Makefile").write_text("out:\n\t@echo made; touch out\ninclude out.d\n")
    assert "made" in make(tmp_path, "out")
    assert "made" not in make(tmp_path, "out")
    change(tmp_path / name, tmp_path / "out")
    assert "made" in make(tmp_path, "out")
    assert "made" not in make(tmp_path, "out")
    (tmp_path / name).unlink()
    if "=" not in name:
        assert "made" in make(tmp_path, "out"), "what is gone is no reason to stop"


@pytest.mark.parametrize("name", [name for name in ODD if "\\" not in name])
def test_ninja_watches_files_of_any_name(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("")
    (tmp_path / "ready.d").write_text(depfile_text("out", [name, "zz"]))
    (tmp_path / "zz").write_text("")
    (tmp_path / "build.ninja").write_text(
        "rule r\n  command = cp ready.d out.d; touch out; echo made\n  depfile = out.d\nbuild out: r\n"
    )
    assert "made" in ninja(tmp_path)
    assert "no work" in ninja(tmp_path)
    later = time.time() + 10
    os.utime(tmp_path / name, (later, later))
    assert "made" in ninja(tmp_path)


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A small project in a folder with a blank in its name; the working directory."""
    folder = tmp_path / "my project"
    shutil.copytree(MINIMAL, folder / "specs")
    monkeypatch.chdir(folder)
    return folder


def prerequisites(depfile: Path) -> set[str]:
    rule = depfile.read_text().partition("\n\n")[0].split("\n", 1)[1]
    return {line.strip().removesuffix(" \\").replace("\\ ", " ") for line in rule.splitlines() if line.startswith("  ")}


def test_everything_that_is_read_is_named(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["build", "--depfile", "out/fw.d"]) == 0
    first = (project / "out" / "fw.d").read_text()
    assert first.startswith("out/fw: \\\n")
    named = prerequisites(project / "out" / "fw.d")
    assert {
        "specs/codegen.yaml",
        "specs/messages/heartbeat.yaml",
        "specs/requirements/FR-1.md",
        "specs/messages",
    } <= named
    assert any(name.endswith("v20/minimal.xml") for name in named)
    assert any(name.endswith("templates/firmware/telemetry.py.j2") for name in named)
    assert all(Path(name).exists() for name in named)
    (project / "out" / "fw.d").unlink()
    # However a build comes to its end, also the fast way, the file is there and the same.
    for path in project.rglob("*"):
        os.utime(path, (1_000_000_000, 1_000_000_000))
    for _ in range(2):
        assert main(["build", "--depfile", "out/fw.d"]) == 0
        assert (project / "out" / "fw.d").read_text() == first
    assert "unchanged" in capsys.readouterr().err


def test_nothing_is_written_after_a_fault(project: Path) -> None:
    table = project / "specs" / "messages" / "heartbeat.yaml"
    table.write_text(table.read_text().replace("custom_mode", "custom_mod"))
    assert main(["build", "--depfile", "fw.d"]) == 1
    assert not (project / "fw.d").exists()
    assert main(["codec", "--dialect", "minimal", "--messages", "NO", "--out", "c", "--depfile", "c.d"]) == 1
    assert not (project / "c.d").exists()


def test_a_codec_names_the_includes_of_its_dialect(project: Path) -> None:
    argv = ["codec", "--dialect", "common", "--messages", "HEARTBEAT", "--out", "c"]
    assert main([*argv, "--depfile", "c.d", "--depfile-target", "c/messages.py"]) == 0
    text = (project / "c.d").read_text()
    assert text.startswith("c/messages.py: \\\n")
    assert {name.rpartition("/")[2] for name in prerequisites(project / "c.d")} >= {
        "common.xml", "standard.xml", "minimal.xml", "message.py", "messages.py.in",
    }  # fmt: skip


@pytest.mark.parametrize(
    "argv",
    [["--depfile", "x"], ["--depfile", ".d"], ["--depfile-target", "x"], ["--depfile", "x.d", "--check"],
     ["--depfile", "x.d", "--diff"], ["--depfile", "x.d", "--dry-run"]],
)  # fmt: skip
def test_options_that_make_no_sense_are_refused(project: Path, argv: list[str]) -> None:
    assert main(["build", *argv]) == 2
    assert not (project / "x.d").exists()


def test_a_depfile_that_cannot_be_written_is_a_finding(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (project / "fw.d").mkdir()
    assert main(["build", "--depfile", "fw.d"]) == 2
    assert "fw.d:1:1: error file-unwritable" in capsys.readouterr().out


def test_make_builds_only_what_has_changed(project: Path) -> None:
    """The Makefile of the documentation: a stamp that codegen's rule touches, and the depfile beside it."""
    text = (ROOT / "docs" / "other-repositories.md").read_text()
    makefile = text.partition("```make\n")[2].partition("```")[0]
    (project / "Makefile").write_text(makefile.replace("codegen build", f"{sys.executable} -m codegen build"))
    assert "codegen build" in make(project)
    assert "codegen build" not in make(project)
    stamp = project / "build" / "firmware.stamp"
    change(project / "specs" / "requirements" / "FR-1.md", stamp)
    assert "codegen build" in make(project)
    assert "codegen build" not in make(project)
    (project / "specs" / "messages" / "new.yaml").write_text((MINIMAL / "messages" / "heartbeat.yaml").read_text())
    change(project / "specs" / "messages", stamp)
    done = subprocess.run(["make"], cwd=project, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode != 0, "a second table of the message is noticed, though no file that was read has changed"
