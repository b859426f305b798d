"""Exceptions that the firmware catches itself, in a simulation: the run goes on, tells them, and does not succeed."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from codegen.sim.run import SILENCE_S

ROOT = Path(__file__).resolve().parents[2]
CODE = """from vehicle import Vehicle


class Rover(Vehicle):
    def __init__(self):
        super().__init__()
        self.scheduler.every(100000, self.look, "look")
        self.turns = 0

    def look(self):
        self.turns += 1
        {look}

    def control(self):
        {control}
"""
OPTIONS = ("--duration", "2 s", "--speed", "max", "--out", "udp:127.0.0.1:9")


def simulated(folder: Path, runtime: str, look: str = "pass", control: str = "pass") -> "tuple[int, str, str]":
    """Return the exit code and the output of `codegen sim` for a rover with this code."""
    code = folder / "mine.py"
    code.write_text(CODE.format(look=look, control=control))
    done = subprocess.run(
        [sys.executable, "-m", "codegen", "sim", "nominal", *OPTIONS, "--runtime", runtime, "--code", str(code)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        timeout=SILENCE_S + 60,
    )
    return done.returncode, done.stdout, done.stderr


@pytest.mark.parametrize("runtime", ["micropython", "cpython"])
def test_a_job_that_raises_is_told_with_its_place_and_the_code_is_1(runtime: str, tmp_path: Path) -> None:
    """It raises in every turn, is told once, and the simulation goes to its end, as a board would."""
    code, out, err = simulated(tmp_path, runtime, look="raise ValueError('no echo')")
    assert code == 1, out + err
    error = r"^codegen sim: error: look: ValueError: no echo \(.*rover\.py:12\), at 0\.\d s$"
    assert len(re.findall(error, err, re.M)) == 1, err
    assert out.count("look: ValueError: no echo") == 2, "as it happens, and in the result"
    assert "nominal: 2.0 s under" in out
    assert "Traceback" not in out + err


def test_what_two_parts_raise_is_told_of_both(tmp_path: Path) -> None:
    code, out, err = simulated(tmp_path, "micropython", look="self.turns.append(1)", control="speed.set(1)")
    assert code == 1, out + err
    assert re.search(r"error: control: NameError: .*speed.*\(.*rover\.py:15\)", err), err
    assert re.search(r"error: look: AttributeError: .*append.*\(.*rover\.py:12\)", err), err


def test_a_connection_that_catches_an_exception_is_told(tmp_path: Path) -> None:
    """Streams, replies and services run within a connection, which goes on after what they raise."""
    look = "self.connections[0].streams.run = lambda now_ms: 1 // 0"
    code, out, err = simulated(tmp_path, "micropython", look=look)
    assert code == 1, out + err
    assert re.search(r"error: \w+: ZeroDivisionError: .*\(.*rover\.py:12\)", err), err


def test_code_that_raises_nothing_succeeds(tmp_path: Path) -> None:
    code, out, err = simulated(tmp_path, "micropython")
    assert (code, "error" in err, "exception" in out) == (0, False, False), out + err
