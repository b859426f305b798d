"""Messages that a scenario sends are received into quantities, from who may send them, until they stop."""

import subprocess
import sys
from pathlib import Path

import pytest
from in_process import build

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent


@pytest.fixture(scope="module")
def receiving(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which the project is built."""
    folder = tmp_path_factory.mktemp("received")
    subprocess.run(["cp", "-r", str(HERE / "received" / "specs"), str(folder)], check=True)
    (folder / "specs" / "scenarios.yaml").write_bytes((HERE / "received" / "heard" / "scenarios.yaml").read_bytes())
    build(folder)
    return folder


@pytest.mark.parametrize("runtime", ["micropython", "cpython"])
def test_what_is_sent_arrives_in_the_state(receiving: Path, runtime: str) -> None:
    """The expectations of the scenario hold, at the times that it says."""
    command = [str(BIN / "codegen"), "sim", "steering", "--speed", "max", "--runtime", runtime]
    out = ["--out", "udp:127.0.0.1:9"]
    done = subprocess.run([*command, *out], cwd=receiving, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr
