"""The claims of docs/platforms.md on Windows, as far as another system can pose as it; line ends are tests/emit/'s."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

POSE = """
import os, signal, sys

def refuse(*_args, **_options):
    raise OSError("A required privilege is not held by the client")

for name in ("fcntl", "grp", "pwd", "pty", "resource", "syslog", "termios", "tty"):
    sys.modules[name] = None
for name in ("chown", "fork", "forkpty", "getegid", "geteuid", "getgid", "getuid", "killpg", "mkfifo", "set_blocking"):
    delattr(os, name)
for name in ("O_CLOEXEC", "O_DIRECTORY", "O_NOFOLLOW", "O_NONBLOCK"):
    delattr(os, name)
for name in ("SIGALRM", "SIGHUP", "SIGKILL", "SIGUSR1"):
    delattr(signal, name)
os.symlink = refuse
sys.platform = "win32"
from codegen.__main__ import run
sys.argv = ["codegen", *sys.argv[1:]]
run()
"""
"""Windows has none of these; making a link takes a right there that few have."""


def codegen(folder: Path, *arguments: str, poses: bool = True) -> "subprocess.CompletedProcess[str]":
    """Run a command with no encoding but UTF-8 anywhere: the one of the system would be another on each."""
    program = ["-c", POSE] if poses else ["-m", "codegen"]
    strict = ["-X", "warn_default_encoding", "-W", "error::EncodingWarning"]
    # An encoding that lacks most characters, as that of a Windows console may.
    environment = {**os.environ, "PYTHONIOENCODING": "cp1252", "XDG_CACHE_HOME": str(folder / "cache")}
    command = [sys.executable, *strict, *program, *arguments]
    return subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, encoding="cp1252", check=False
    )


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A boat that was begun and built there."""
    folder = tmp_path_factory.mktemp("there")
    for arguments in (["init", "--from", "boat"], ["build"]):
        done = codegen(folder, *arguments)
        assert done.returncode == 0, done.stdout + done.stderr
    return folder


def test_the_output_is_that_of_every_system(project: Path, tmp_path: Path) -> None:
    """To the byte, with a name of the project's own in it."""
    elsewhere = tmp_path / project.name
    elsewhere.mkdir()
    for arguments in (["init", "--from", "boat"], ["build"]):
        assert codegen(elsewhere, *arguments, poses=False).returncode == 0
    files = {path.relative_to(elsewhere): path.read_bytes() for path in sorted((elsewhere / "generated").rglob("*.*"))}
    assert len(files) > 50
    assert files == {path: (project / path).read_bytes() for path in files}
    assert not [path for path, content in files.items() if b"\r" in content]


@pytest.mark.parametrize(
    "arguments",
    [
        ["build"],
        ["build", "--check"],
        ["build", "--mpy", "armv7emsp"],
        ["check"],
        ["check", "--format", "sarif"],
        ["explain", "GPS_RAW_INT"],
        ["trace"],
        ["trace", "--format", "html", "--out", "trace.html"],
        ["sim", "--list"],
        ["codec", "--dialect", "common", "--messages", "HEARTBEAT", "--package", "mine", "--out", "lib"],
        ["completion", "bash"],
        ["diff", "standard", "minimal", "--fail-on", "never"],
    ],
    ids=" ".join,
)
def test_commands_work(project: Path, arguments: list[str]) -> None:
    done = codegen(project, *arguments)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "internal error" not in done.stderr


def test_the_simulation_says_where_it_runs(project: Path) -> None:
    """It waits for pipes, which Windows cannot."""
    done = codegen(project, "sim")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "codegen sim: the simulation runs on Linux and macOS; under Windows, in its Linux (WSL)\n"
