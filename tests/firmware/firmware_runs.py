"""Runs scripts with the plain firmware files and mocks where they stand, under CPython and under MicroPython."""

import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
CODEC = ROOT / "templates" / "codec"
FIRMWARE = ROOT / "templates" / "firmware"
PROGRAM = FIRMWARE / "program"
MOCKS = ROOT / "templates" / "mocks"
FOLDERS = (CODEC, FIRMWARE, PROGRAM, MOCKS)
TOOLS = Path(sys.executable).parent
EXERCISE = Path(__file__).with_name("exercise.py")
MODULES = (
    "checksum",
    "conversion",
    "fields",
    "live_fields",
    "frames",
    "frames_plain",
    "machine",
    "mavlink",
    "message",
    "micropython",
    "mock_time",
    "receiver",
    "sender",
    "signing",
)


def tool(name: str) -> str:
    """The path of a command that the development dependencies install."""
    path = TOOLS / name
    assert path.exists(), f"{name} is not installed"
    return str(path)


def interpret(interpreter: str, script: str, stdin: str = "", folders: tuple[Path, ...] = FOLDERS) -> str:
    """Run a script with `folders` to import from, and return what it prints."""
    path = os.pathsep.join(map(str, folders))
    if interpreter == "micropython":
        command = [tool("micropython"), "-X", "heapsize=256m", script]
    else:
        command = [sys.executable, "-B", script]
    done = subprocess.run(
        command,
        input=stdin,
        env=os.environ | {"MICROPYPATH": f"{path}{os.pathsep}.frozen", "PYTHONPATH": path},  # asyncio is in .frozen
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@dataclass(frozen=True)
class Exercise:
    """Runs operations of exercise.py on an interpreter."""

    interpreter: str

    @property
    def forms(self) -> set[str]:
        """The forms of the frames that there are."""
        return {"plain", "viper"} if self.interpreter == "micropython" else {"plain"}

    def __call__(self, operation: str, folders: tuple[Path, ...] = FOLDERS, **arguments: Any) -> Any:
        """Return the answer of an operation."""
        asked = json.dumps({"operation": operation} | arguments)
        return json.loads(interpret(self.interpreter, str(EXERCISE), asked, folders))


def failed_checks(interpreter: str, script: str, stdin: str = "") -> str:
    """Return the failures in the checks of a script of this folder; it is an error if there are no checks."""
    here = Path(__file__).parent
    outcomes = json.loads(interpret(interpreter, str(here / script), stdin, (*FOLDERS, here / "stand_in")))
    assert outcomes
    return "\n".join(f"{name}: {problem}" for name, problem in outcomes if problem is not None)


def as_json(value: Any) -> Any:
    """A field's value as exercise.py reads it."""
    if isinstance(value, bytes):
        return {"hex": value.hex()}
    if isinstance(value, (list, tuple)):
        return [as_json(item) for item in value]
    if isinstance(value, float) and (value != value or value in (float("inf"), float("-inf"))):  # noqa: PLR0124
        return {"float": str(value)}
    return value


def as_read(value: Any) -> Any:
    """Return a value as get() does: bytes that are ASCII come as text."""
    return value.decode() if isinstance(value, bytes) else as_json(value)
