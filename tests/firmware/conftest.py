"""Runs the plain firmware files and mocks where they stand, under CPython and under MicroPython."""

import importlib
import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
FIRMWARE = ROOT / "templates" / "firmware"
MOCKS = ROOT / "templates" / "mocks"
TOOLS = Path(sys.executable).parent
MODULES = ("crc", "crc_plain", "crc_table", "fields", "mavlink", "machine", "mock_time")

Exercise = Callable[..., Any]


@pytest.fixture
def firmware() -> Iterator[SimpleNamespace]:
    """The modules, imported afresh and forgotten afterwards: generated/tests imports others of the same names."""
    before = {name: sys.modules.pop(name, None) for name in MODULES}
    path, write_bytecode = list(sys.path), sys.dont_write_bytecode
    sys.path[:0] = [str(FIRMWARE), str(MOCKS)]
    sys.dont_write_bytecode = True
    try:
        importlib.invalidate_caches()
        yield SimpleNamespace(**{name: importlib.import_module(name) for name in MODULES})
    finally:
        sys.path[:], sys.dont_write_bytecode = path, write_bytecode
        for name, module in before.items():
            sys.modules.pop(name, None)
            if module is not None:
                sys.modules[name] = module


def tool(name: str) -> str:
    """The path of an installed command; the test is skipped where its package has none for this system."""
    path = TOOLS / name
    if not path.exists():
        pytest.skip(f"{name} is not installed")
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


@pytest.fixture(params=["cpython", "micropython"])
def exercise(request: pytest.FixtureRequest) -> Exercise:
    """One operation of exercise.py, on each interpreter."""

    def run(operation: str, **arguments: Any) -> Any:
        script = str(Path(__file__).with_name("exercise.py"))
        return json.loads(interpret(request.param, script, json.dumps({"operation": operation} | arguments)))

    run.interpreter = request.param  # type: ignore[attr-defined]
    return run
