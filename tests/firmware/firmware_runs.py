"""Runs scripts with the plain firmware files and mocks where they stand, under CPython and under MicroPython."""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
FIRMWARE = ROOT / "templates" / "firmware"
MOCKS = ROOT / "templates" / "mocks"
TOOLS = Path(sys.executable).parent
MODULES = ("crc", "crc_plain", "crc_table", "fields", "mavlink", "machine", "mock_time")

Exercise = Callable[..., Any]


def tool(name: str) -> str:
    """The path of a command that the development dependencies install."""
    path = TOOLS / name
    assert path.exists(), f"{name} is not installed"
    return str(path)


def interpret(interpreter: str, script: str, stdin: str = "", folders: tuple[Path, ...] = (FIRMWARE, MOCKS)) -> str:
    """Run a script with `folders` to import from, and return what it prints."""
    path = os.pathsep.join(map(str, folders))
    if interpreter == "micropython":
        command = [tool("micropython"), "-X", "heapsize=256m", script]
    else:
        command = [sys.executable, "-B", script]
    done = subprocess.run(
        command,
        input=stdin,
        env=os.environ | {"MICROPYPATH": path, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout
