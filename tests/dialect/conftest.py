"""Dialects for the tests: written into a folder of their own, or those that pymavlink ships."""

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest

from codegen.decode.dialect.files import decode_dialect_files, decode_overlay
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_path
from codegen.model.dialect.dialect import Dialect, DialectFile
from codegen.resolve.dialect.dialect import resolve_dialect


@pytest.fixture
def write(tmp_path: Path) -> Callable[..., str]:
    """Write a file below the test's folder and return its absolute path."""

    def write(text: str | bytes, name: str = "d.xml") -> str:
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode() if isinstance(text, str) else text)
        return str(path)

    return write


@pytest.fixture
def read(write: Callable[..., str]) -> Callable[..., SimpleNamespace]:
    """Resolve XML text, later texts on top of it: dialect, files, report, and ``found`` as 'line:col rule'."""
    return reader(write, decode_dialect_files)


@pytest.fixture
def read_overlay(write: Callable[..., str]) -> Callable[..., SimpleNamespace]:
    """The same, with later texts as overlays of the project."""
    return reader(write, decode_overlay)


def reader(write: Callable[..., str], decode_later: Callable[..., tuple]) -> Callable[..., SimpleNamespace]:
    def read(*texts: str | bytes, corrections: tuple = ()) -> SimpleNamespace:
        report = Report()
        files: tuple[DialectFile, ...] = ()
        for index, text in enumerate(texts):
            decode = decode_later if index else decode_dialect_files
            files += decode(write(text, f"d{index or ''}.xml"), DISK, report)
        dialect = resolve_dialect("d", files, corrections, report)
        found = [f"{one.place.line}:{one.place.column} {one.rule.id}" for one in report]
        return SimpleNamespace(dialect=dialect, report=report, files=files, found=found)

    return read


@pytest.fixture(scope="session")
def shipped() -> Callable[[str], tuple[Dialect, Report]]:
    """Resolve a dialect that pymavlink ships, once per session."""
    resolved: dict[str, tuple[Dialect, Report]] = {}

    def shipped(name: str) -> tuple[Dialect, Report]:
        if name not in resolved:
            report = Report()
            path = shipped_dialect_path(name, DISK)
            assert path is not None
            resolved[name] = (resolve_dialect(name, decode_dialect_files(path, DISK, report), (), report), report)
        return resolved[name]

    return shipped
