"""A project whose firmware is a stand-in that looks like the generated one from outside, and a ground station."""

import shutil
import socket
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from whole_program import whole_program

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]
STANDIN = Path(__file__).parent / "standin"


@dataclass
class Station:
    """The socket of a ground station on a port that was free."""

    socket: socket.socket

    @property
    def address(self) -> str:
        return f"udp:127.0.0.1:{self.socket.getsockname()[1]}"

    def received(self) -> list[tuple[bytes, int]]:
        """Every datagram that has arrived, with the port of its sender."""
        self.socket.setblocking(False)
        found = []
        while True:
            try:
                data, (_, port) = self.socket.recvfrom(2048)
            except BlockingIOError:
                return found
            found.append((data, port))


@pytest.fixture
def station() -> Iterator[Station]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as opened:
        opened.bind(("127.0.0.1", 0))
        yield Station(opened)


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project folder, which is the working directory."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    whole_program(ROOT / "generated", tmp_path / "generated")
    for file in STANDIN.glob("*.py"):
        shutil.copy(file, tmp_path / "generated" / "firmware")
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("CODEGEN_DEBUG", raising=False)
    return tmp_path


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], station: Station, project: Path) -> Callable[..., tuple[int, str, str]]:
    """Runs codegen sim in the project, as fast as it can, against the ground station: exit code, stdout and stderr."""
    assert Path.cwd() == project

    def command(*argv: str) -> tuple[int, str, str]:
        code = main(["sim", "--speed", "max", "--out", station.address, *argv])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return command
