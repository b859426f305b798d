"""The soak finds nothing in the shipped firmware, and what is wrong in a changed one; `make soak` goes on for days."""

import subprocess
import sys
from pathlib import Path

import pytest
from whole_program import whole_program

ROOT = Path(__file__).resolve().parents[2]
HOUR_S = 660
"""Simulated seconds, with the guest's arrival."""

CHANGES = [
    ("services.py", "self._connection.link.send(message)  # a late", "pass  # a late", "message 4 came 0 times"),
    ("scan_viper.py", "slot[0] = due_ms\n", "slot[0] = due_ms + 9\n", "message 0 came"),
    ("sender.py", "self._frame[self._sequence_at] = value & 0xFF", "pass", "a gap in the frames for 1"),
    ("stations.py", "_MOST = const(4)", "_MOST = const(2)", "the guest got 0 of 39 parameters"),
]
"""A file of the firmware, what is changed in it, and what the soak says of that."""


def soaked(generated: Path) -> "subprocess.CompletedProcess[str]":
    """Run a short hour of the firmware in a folder."""
    command = [sys.executable, "benchmarks/soak.py", "--hours", "1", "--hours32", "0", "--hour", str(HOUR_S)]
    return subprocess.run(
        [*command, "--firmware", str(generated)], cwd=ROOT, capture_output=True, text=True, check=False
    )


def test_nothing_is_wrong() -> None:
    """Rates, answers, numbers of frames and parameters."""
    done = soaked(ROOT / "generated")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("micropython: 1 simulated hours in ")
    assert done.stdout.endswith(", 0 faults\n")


@pytest.mark.parametrize(("file", "old", "new", "said"), CHANGES)
def test_what_is_wrong_is_found(tmp_path: Path, file: str, old: str, new: str, said: str) -> None:
    """Answers that do not come, rates that drift, numbers that are left out, stations without a place."""
    whole_program(ROOT / "generated", tmp_path)
    text = (tmp_path / "firmware" / file).read_text()
    assert text.count(old) == 1
    (tmp_path / "firmware" / file).write_text(text.replace(old, new))
    done = soaked(tmp_path)
    assert done.returncode == 1
    assert said in done.stdout
