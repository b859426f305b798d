"""The soak finds nothing in the shipped firmware, and what is wrong in a changed one; `make soak` goes on for days."""

import subprocess
import sys
from pathlib import Path

import pytest
from whole_program import whole_program

ROOT = Path(__file__).resolve().parents[2]
HOUR = 660
"""Simulated seconds, with the guest's arrival."""
SHORT = 120
"""Simulated seconds in which nobody misses anything but the guest, who comes later."""
NO_GUEST = "the guest got 0 of 39 parameters"

CHANGES = [
    (
        "services.py",
        "self._connection.link.send(message)  # a late",
        "pass  # a late",
        "message 4 came 0 times",
        SHORT,
    ),
    ("scan_viper.py", "slot[0] = due_ms\n", "slot[0] = due_ms + 9\n", "message 0 came", HOUR),
    ("sender.py", "self._frame[self._sequence_at] = value & 0xFF", "pass", "a gap in the frames for 1", SHORT),
    ("stations.py", "_MOST = const(4)", "_MOST = const(2)", NO_GUEST, HOUR),
]
"""A file of the firmware, what is changed in it, what the soak says of that, and after how long."""


def soaked(generated: Path, seconds: int = HOUR) -> "subprocess.CompletedProcess[str]":
    """Run a short hour of the firmware in a folder."""
    command = [sys.executable, "benchmarks/soak.py", "--hours", "1", "--hours32", "0", "--hour", str(seconds)]
    return subprocess.run(
        [*command, "--firmware", str(generated)], cwd=ROOT, capture_output=True, text=True, check=False
    )


def test_nothing_is_wrong() -> None:
    """Rates, answers, numbers of frames and parameters."""
    done = soaked(ROOT / "generated")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("micropython: 1 simulated hours in ")
    assert done.stdout.endswith(", 0 faults\n")


def test_in_a_short_time_the_guest_alone_is_missed() -> None:
    """Whatever else is said of a changed firmware comes of the change."""
    done = soaked(ROOT / "generated", SHORT)
    assert done.stdout.endswith(f", 1 faults\n  {NO_GUEST}\n")


@pytest.mark.parametrize(("file", "old", "new", "said", "seconds"), CHANGES)
def test_what_is_wrong_is_found(tmp_path: Path, file: str, old: str, new: str, said: str, seconds: int) -> None:
    """Answers that do not come, rates that drift, numbers that are left out, stations without a place."""
    whole_program(ROOT / "generated", tmp_path)
    text = (tmp_path / "firmware" / file).read_text()
    assert text.count(old) == 1
    (tmp_path / "firmware" / file).write_text(text.replace(old, new))
    done = soaked(tmp_path, seconds)
    assert done.returncode == 1
    assert said in done.stdout
