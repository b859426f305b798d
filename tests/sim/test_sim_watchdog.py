"""Code of the user that does not return, in a simulation: the run ends, and the message says where the code stood."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.sim.run import SILENCE_S, simulate

ROOT = Path(__file__).resolve().parents[2]
CODE = """import time
from vehicle import Vehicle


class Rover(Vehicle):
    turns = 0

    def control(self):
        self.turns += 1
        if self.turns > 800:
            {hang}
"""
OPTIONS = ("--duration", "60 s", "--speed", "max", "--quiet", "--out", "udp:127.0.0.1:9")
RUNTIMES = pytest.mark.parametrize("runtime", ["micropython", "cpython"])


def simulated(folder: Path, hang: str, runtime: str) -> str:
    """Return the output of `codegen sim` for a rover whose control() hangs after two seconds."""
    code = folder / "mine.py"
    code.write_text(CODE.format(hang=hang))
    done = subprocess.run(
        [sys.executable, "-m", "codegen", "sim", "nominal", *OPTIONS, "--runtime", runtime, "--code", str(code)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        timeout=SILENCE_S + 60,
    )
    assert done.returncode == 1, done.stdout + done.stderr
    assert "Traceback" not in done.stdout + done.stderr
    return done.stderr


@RUNTIMES
def test_a_hung_loop_is_ended_by_the_watchdog(runtime: str, tmp_path: Path) -> None:
    """Code that waits in the time of the board: the simulated watchdog bites when the board's would."""
    said = simulated(tmp_path, "time.sleep_ms(100000)", runtime)
    pattern = r"codegen sim: error: the firmware stopped: (machine\.)?WatchdogReset: .* \(.*rover\.py:11\)"
    assert re.search(pattern, said), said


@pytest.mark.long
@RUNTIMES
def test_code_in_which_no_time_passes_is_found(
    runtime: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """No simulated time passes in an endless loop: after 30 s without a sign, here 4, it is interrupted there.

    It waits in the true time, and takes none of the processor's.
    """
    monkeypatch.setattr(simulate, "__defaults__", (4.0,))
    monkeypatch.chdir(ROOT)
    code = tmp_path / "mine.py"
    code.write_text(CODE.format(hang='while True: __import__("select").poll().poll(100)'))
    assert main(["sim", "nominal", *OPTIONS, "--runtime", runtime, "--code", str(code)]) == 1
    said = capsys.readouterr().err
    assert re.search(r"does not let time pass any more .* \(.*rover\.py:11\)", said), said
