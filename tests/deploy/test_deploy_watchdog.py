"""A watchdog runs on when its program is interrupted, and over a soft reset: a deploy and a prompt outlive it."""

import subprocess
import sys
import time
from pathlib import Path

import pytest
from board_on_pty import powered

from codegen.deploy.connection import Connection
from codegen.deploy.findings import BoardFaultError
from codegen.deploy.transfer import put

SECONDS = 2.0
"""Until the watchdog resets the board, which takes its power here; the raw REPL is there in a quarter of that."""


def flash_for(board: str, folder: Path) -> Path:
    """A flash with what the program of a board has there for its watchdog."""
    command = [sys.executable, "-m", "codegen"]
    subprocess.run([*command, "init", ".", "--board", board], cwd=folder, check=True, capture_output=True)
    subprocess.run([*command, "build"], cwd=folder, check=True, capture_output=True)
    image = folder / "flash"
    with powered(image) as made:
        connection = Connection(made.port)
        for name in ("watchdog.py", "guard.py"):
            put(connection, name, (folder / "generated" / "firmware" / name).read_bytes())
        connection.close()
    return image


@pytest.mark.parametrize(("board", "kind"), [("pico_2_w", "watchdog"), ("esp32", "fed"), ("pyboard", "fed")])
def test_the_board_stays_while_somebody_is_there(board: str, kind: str, tmp_path: Path) -> None:
    """It is stopped where it can be, and fed by a timer elsewhere; another soft reset does not change that."""
    image = flash_for(board, tmp_path)
    with powered(image, **{kind: SECONDS}) as running:
        connection = Connection(running.port)
        time.sleep(1.5 * SECONDS)
        assert connection.run("print('here')").strip() == "here"
        connection.begin_anew()
        time.sleep(1.5 * SECONDS)
        assert connection.run("print('here')").strip() == "here"
        assert connection.run("import sys; print('watchdog' in sys.modules)").strip() == "False"
        connection.close()


@pytest.mark.parametrize("kind", ["watchdog", "fed"])
def test_without_that_it_would_be_reset(kind: str, tmp_path: Path) -> None:
    """The stand-in for the watchdog bites."""
    with powered(tmp_path / "flash", **{kind: SECONDS}) as running:
        connection = Connection(running.port, answer_s=SECONDS)
        time.sleep(1.5 * SECONDS)
        with pytest.raises(BoardFaultError):
            connection.run("print('here')")
        connection.close()
