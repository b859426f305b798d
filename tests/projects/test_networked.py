"""The mast, whose links go over TCP: what a whole vehicle does with connections, on both interpreters."""

import json
import os
import shutil
import socket
import subprocess
import sys
from pathlib import Path

import in_process
import pytest

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent
TCP = {"tcp_client.py", "tcp_peer.py", "tcp_port.py", "tcp_server.py", "tcp_stations.py"}


def build(folder: Path) -> set[str]:
    """Build the project, and return the names of its firmware's files."""
    in_process.build(folder)
    return {path.name for path in (folder / "generated" / "firmware").iterdir()}


@pytest.fixture(scope="module")
def mast(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which it is built."""
    folder = tmp_path_factory.mktemp("mast")
    shutil.copytree(HERE / "networked" / "specs", folder / "specs")
    assert build(folder) >= TCP
    return folder


@pytest.mark.parametrize("interpreter", ["micropython", "python"])
def test_connections(mast: Path, interpreter: str) -> None:
    """Several stations, bytes in pieces and hostile ones, readers that stand still, losses, no heap while idle."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = str(probe.getsockname()[1])
    path = os.pathsep.join(f"generated/{name}" for name in ("firmware", "mocks", "tests"))
    command = [str(BIN / interpreter), *(["-X", "heapsize=64m"] if interpreter == "micropython" else ["-B"])]
    done = subprocess.run(
        [*command, str(HERE / "networked" / "tcp_checks.py"), port],
        cwd=mast,
        env=os.environ | {"MICROPYPATH": f"{path}{os.pathsep}.frozen", "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    outcomes = json.loads(done.stdout)
    assert len(outcomes) > 10
    assert "\n".join(f"{name}: {problem}" for name, problem in outcomes.items() if problem is not None) == ""


@pytest.mark.parametrize(
    ("kept", "left_out"),
    [("field", TCP), ("base", {"tcp_server.py"}), ("stations", {"tcp_client.py"})],
)
def test_only_what_is_used_is_generated(tmp_path: Path, kept: str, left_out: set[str]) -> None:
    """A project without TCP has no module for it, one with a server no client, and the other way round."""
    shutil.copytree(HERE / "networked" / "specs", tmp_path / "specs")
    board, vehicle = tmp_path / "specs" / "board.yaml", tmp_path / "specs" / "vehicle.yaml"
    lines = board.read_text("utf-8").splitlines(keepends=True)
    board.write_text("".join(line for line in lines if not line.startswith("  ") or line.startswith(f"  {kept}:")))
    text = vehicle.read_text("utf-8")
    vehicle.write_text(text[: text.index("access:")] + text[text.index("code:") :])
    files = build(tmp_path)
    assert TCP & files == TCP - left_out
