"""Steps that take longer than a second are shown on a terminal, and nowhere else."""

import os
import pty
import subprocess
import sys

import pytest

SCRIPT = """
import sys, time
from codegen.cli import progress

progress._SOON_S = {soon}
with progress.working("reading [all] of it") as now:
    line = getattr(now, "__self__", None)
    while line is not None and {soon} == 0 and line._shown is None:  # rich is imported meanwhile
        time.sleep(0.01)
    time.sleep(0.3)
    now("writing it")
    time.sleep(0.4)
print("done", "rich" in sys.modules)
"""


def on_terminal(soon: float, **environment: str) -> str:
    """All that a terminal gets."""
    ours, theirs = pty.openpty()
    command = [sys.executable, "-c", SCRIPT.format(soon=soon)]
    running = subprocess.Popen(
        command, stdout=theirs, stderr=theirs, env={**os.environ, "TERM": "xterm", **environment}
    )
    os.close(theirs)
    shown = b""
    while True:
        try:
            piece = os.read(ours, 65536)
        except OSError:  # the other end is closed
            break
        if not piece:
            break
        shown += piece
    os.close(ours)
    assert running.wait(20) == 0
    return shown.decode()


def test_the_step_is_shown_and_taken_away() -> None:
    """Each step with its seconds; the line is cleared before anything else is printed."""
    shown = on_terminal(0.0)
    assert "reading [all] of it" in shown
    assert "writing it" in shown
    assert "0:00:00" in shown
    assert shown.endswith("\x1b[2Kdone True\r\n")
    assert "\x1b[32m" not in on_terminal(0.0, NO_COLOR="1")


@pytest.mark.parametrize(("soon", "environment"), [(30.0, {}), (0.0, {"TERM": "dumb"})])
def test_nothing_is_shown(soon: float, environment: dict[str, str]) -> None:
    """Of what is over before a second has passed, and on a terminal that can clear no line: no rich either."""
    assert on_terminal(soon, **environment) == "done False\r\n"


def test_nothing_goes_into_a_file() -> None:
    command = [sys.executable, "-c", SCRIPT.format(soon=0.0)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert (done.stdout, done.stderr) == ("done False\n", "")
