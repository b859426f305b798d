"""Documents in memory, compared with the dialect that pymavlink ships."""

import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

from codegen.claims import check_claims
from codegen.claims.reading import Reading, Reference, read_document
from codegen.commands.codec import read_codec_dialect
from codegen.commands.documents import with_other_dialects
from codegen.diagnostics import Diagnostic, Report
from codegen.load.files import DISK

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))  # whose program scores the corpus
PATH = "/documents/notes.md"

Check = Callable[[str], list[Diagnostic]]


@cache
def reference() -> Reference:
    """The common dialect, without a project."""
    dialect = read_codec_dialect("common", Report())
    assert dialect is not None
    return Reference(dialect)


@pytest.fixture(scope="session")
def read() -> Callable[[str], Reading]:
    """Return what reads a text."""
    return lambda text: with_other_dialects(read_document(text, PATH, reference()), DISK)


@pytest.fixture(scope="session")
def check(read: Callable[[str], Reading]) -> Check:
    """What is found in a text, in its order."""
    return lambda text: check_claims(read(text))
