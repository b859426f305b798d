"""Runs the plain firmware files and mocks where they stand, under CPython and under MicroPython."""

import importlib
import sys
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import pytest
from firmware_runs import FOLDERS, MODULES, Exercise
from service_runs import Services, prepare


@pytest.fixture
def firmware() -> Iterator[SimpleNamespace]:
    """The modules, imported afresh and forgotten afterwards: generated/tests imports others of the same names."""
    before = {name: sys.modules.pop(name, None) for name in MODULES}
    path, write_bytecode = list(sys.path), sys.dont_write_bytecode
    sys.path[:0] = map(str, FOLDERS)
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
    return Exercise(request.param)


@pytest.fixture(scope="session")
def service_folders(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, ...]:
    """Return the folders from which the services and their modules are imported."""
    return prepare(tmp_path_factory.mktemp("services"))


@pytest.fixture(scope="session")
def bytewise_folders(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, ...]:
    """Return the same of services whose parameters go over the wire as the bytes of their types."""
    return prepare(tmp_path_factory.mktemp("bytewise"), is_bytewise=True)


@pytest.fixture(scope="session", params=["cpython", "micropython"])
def bytewise_services(request: pytest.FixtureRequest, bytewise_folders: tuple[Path, ...]) -> Iterator[Services]:
    """The services with bytewise parameters, on each interpreter."""
    running = Services(request.param, bytewise_folders)
    yield running
    running.close()


@pytest.fixture(scope="session", params=["cpython", "micropython"])
def services(request: pytest.FixtureRequest, service_folders: tuple[Path, ...]) -> Iterator[Services]:
    """The services, on each interpreter."""
    running = Services(request.param, service_folders)
    yield running
    running.close()
