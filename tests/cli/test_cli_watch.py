"""codegen watch: real changes of real files lead to a build and a check, and Ctrl-C ends it."""

import os
import queue
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

WAIT_S = 30


class Watching:
    """A running command, whose lines are read as they come."""

    def __init__(self, folder: Path, *options: str) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "codegen", "watch", *options],
            cwd=folder,
            env={**os.environ, "PYTHONUNBUFFERED": "1"},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self._lines: queue.Queue[str] = queue.Queue()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            self._lines.put(line)

    def until_it_waits(self) -> str:
        """Return its output until it watches again."""
        said = ""
        while not said.endswith("watching specs; Ctrl-C ends it\n"):
            said += self._lines.get(timeout=WAIT_S)
        return said

    def until(self, text: str) -> str:
        """Return its output until it has printed a text."""
        said = ""
        while text not in said:
            said += self._lines.get(timeout=WAIT_S)
        return said

    def close(self) -> None:
        self._process.kill()
        self._process.wait()
        self._reader.join()
        assert self._process.stdout is not None
        self._process.stdout.close()

    def end(self) -> int:
        self._process.send_signal(signal.SIGINT)
        return self._process.wait(WAIT_S)


@pytest.fixture
def project(tmp_path: Path, run: Any, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    assert run("init")[0] == 0
    (tmp_path / "own.xml").write_text("<mavlink><include>common.xml</include></mavlink>")
    return tmp_path


@pytest.fixture
def watching(project: Path) -> Iterator[Watching]:
    command = Watching(project)
    yield command
    command.close()


def change(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def test_a_folder_that_is_moved_is_a_change(project: Path, watching: Watching) -> None:
    """The system tells of the folder alone, and not of the files in it: that of a program, or of all tables."""
    watching.until_it_waits()
    sail = project / "specs" / "sail"
    sail.mkdir()
    (sail / "codegen.yaml").write_text("base: ..\nproject: sail\n")
    watching.until_it_waits()
    with (project / "specs" / "codegen.yaml").open("a") as file:
        file.write("programs: {sail: sail/codegen.yaml}\n")
    watching.until_it_waits()
    sail.rename(project / "elsewhere")
    said = watching.until_it_waits()
    assert "specs/sail changed\n" in said
    assert "specs/sail/codegen.yaml does not exist" in said
    (project / "elsewhere").rename(sail)
    said = watching.until_it_waits()
    assert "specs/sail changed\n" in said
    assert "error" not in said
    messages = project / "specs" / "messages"
    messages.rename(project / "specs" / "away")
    assert "error no-messages" in watching.until_it_waits()


def test_the_folder_of_a_program_that_lies_elsewhere_is_watched(project: Path, watching: Watching) -> None:
    """All of it, and not its project file alone."""
    watching.until_it_waits()
    sail = project / "boards" / "sail"
    (sail / "messages").mkdir(parents=True)
    (sail / "codegen.yaml").write_text("base: ../../specs\nproject: sail\n")
    with (project / "specs" / "codegen.yaml").open("a") as file:
        file.write("programs: {sail: ../boards/sail/codegen.yaml}\n")
    watching.until_it_waits()
    (sail / "messages" / "level.yaml").write_text("message: LEVEL\n")
    assert "boards/sail/messages/level.yaml changed" in watching.until_it_waits()


def test_each_change_is_built_and_checked(project: Path, watching: Watching) -> None:
    """A wrong one is told, a right one written; what another dialect file holds counts once the project names it."""
    assert " files written" in watching.until_it_waits()
    table = project / "specs/messages/level.yaml"
    change(table, "constant: LEVEL", "constant: TANKS")
    said = watching.until_it_waits()
    assert "specs/messages/level.yaml changed" in said
    assert "TANKS" in (project / "generated/docs/telemetry.md").read_text()
    change(table, "tank.level", "tank.levle")
    assert "did you mean tank.level?" in watching.until_it_waits()
    change(table, "tank.levle", "tank.level")
    assert "error" not in watching.until_it_waits()
    (project / "app.py").write_text("# the user's own code is no part of it\n")
    (project / "specs/.state.yaml.swp").write_text("")
    change(project / "specs/codegen.yaml", "dialect: common", "dialect: ../own.xml")
    assert "specs/codegen.yaml changed" in watching.until_it_waits()
    (project / "own.xml").write_text("<mavlink><include>comon.xml</include></mavlink>")
    said = watching.until_it_waits()
    assert "own.xml changed" in said
    assert "comon.xml does not exist" in said
    assert watching.end() == 0


def test_without_a_project_it_says_how_to_begin(tmp_path: Path, run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    code, out, _ = run("watch")
    assert code == 2
    assert "codegen init" in out
    assert run("watch", "--project", "none.yaml")[0] == 2


def test_a_simulation_is_started_anew(project: Path) -> None:
    """With each change of the specification or of the user's code that leaves nothing wrong."""
    command = Watching(project, "--sim")
    try:
        command.until("Wi-Fi is up")
        change(project / "app.py", "class", "# faster\nclass")
        assert "app.py changed" in command.until("Wi-Fi is up")
        (project / "generated/firmware/own.py").write_text("# what is generated is no code of the user's")
        change(project / "specs/messages/level.yaml", "tank.level", "tank.levle")
        said = command.until("did you mean tank.level?")
        assert "own.py" not in said
        assert "nominal: " not in said
        assert command.end() == 0
    finally:
        command.close()


def test_options_belong_together(run: Any) -> None:
    for options in (["--port", "/dev/ttyACM0"], ["--deploy", "--sim"]):
        assert run("watch", *options)[0] == 2
