"""Runs of suites with faults leave none of their interpreters behind: one that hangs slows down all that follows."""

import sys
import time
from pathlib import Path

import mutation
import pytest
import reached
from process_group import outcome

HANGING = "import os, pathlib, time; pathlib.Path('pid').write_text(str(os.getpid())); time.sleep(60)"
STARTING = f"""
import pathlib, subprocess, sys, time
def test_it():
    subprocess.Popen([sys.executable, "-c", {HANGING!r}])
    while not pathlib.Path("pid").exists() or not pathlib.Path("pid").read_text():
        time.sleep(0.01)
"""


def has_ended(folder: Path) -> bool:
    """Return whether the process whose number lies in a folder ends soon: the kernel may take a moment."""
    path = Path("/proc", (folder / "pid").read_text(), "stat")
    for _ in range(200):
        if not path.exists() or path.read_text().rpartition(")")[2].split()[0] in "ZX":
            return True
        time.sleep(0.01)
    return False


@pytest.mark.parametrize("hangs", [False, True], ids=["ends", "hangs"])
def test_what_a_command_starts_ends_with_it(tmp_path: Path, *, hangs: bool) -> None:
    """Where the command ends as it should, too: one of its tests may have left an interpreter."""
    last = "time.sleep(60)" if hangs else "raise SystemExit(3)"
    for longest_s in (1, 10, 40):  # what hangs needs the time to begin
        done = outcome([sys.executable, "-c", f"{STARTING}\ntest_it(); print('so'); {last}"], tmp_path, longest_s)
        if (tmp_path / "pid").exists() and (done is not None or hangs):
            break
    assert (done and (done.returncode, done.stdout)) == (None if hangs else (3, "so\n"))
    assert has_ended(tmp_path)


@pytest.mark.parametrize("of", ["firmware", "generator"])
def test_a_fault_leaves_no_interpreter(tmp_path: Path, of: str) -> None:
    tests = tmp_path / "copy" / "tests"
    tests.mkdir(parents=True)
    (tests / "test_it.py").write_text(STARTING)
    if of == "firmware":
        assert mutation._passes(tests.parent, 60)
    else:
        assert reached.tests_of(tmp_path, ["copy/tests"], {}, 60)
    assert has_ended(tmp_path)
