"""Documents in memory, compared with the dialect that pymavlink ships."""

from collections.abc import Callable
from functools import cache

import pytest

from codegen.claims import check_claims
from codegen.claims.reading import Reading, Reference, read_document
from codegen.commands.codec import read_codec_dialect
from codegen.commands.documents import with_other_dialects
from codegen.diagnostics import Diagnostic, Report
from codegen.load.files import DISK

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
