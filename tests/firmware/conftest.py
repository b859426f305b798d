"""Runs the plain firmware files and mocks where they stand, under CPython and under MicroPython."""

import importlib
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from firmware_runs import FIRMWARE, MOCKS, MODULES, Exercise, interpret


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


@pytest.fixture(params=["cpython", "micropython"])
def exercise(request: pytest.FixtureRequest) -> Exercise:
    """One operation of exercise.py, on each interpreter."""

    def run(operation: str, **arguments: Any) -> Any:
        script = str(Path(__file__).with_name("exercise.py"))
        return json.loads(interpret(request.param, script, json.dumps({"operation": operation} | arguments)))

    run.interpreter = request.param  # type: ignore[attr-defined]
    return run
