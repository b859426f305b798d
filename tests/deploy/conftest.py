"""Compiling without what makes modules smaller, which takes most of the time of a deploy."""

from types import SimpleNamespace

import pytest

from codegen.emit import mpy


@pytest.fixture
def compiled_as_written(monkeypatch: pytest.MonkeyPatch) -> None:
    """Modules go to mpy-cross with the names and tables that they are written with, and none is kept for others."""
    for name in ("kept_object", "keep_object"):
        monkeypatch.setattr(mpy, name, lambda *_: None)
    for name in ("direct", "with_constants", "with_short_arguments"):
        monkeypatch.setattr(mpy, name, lambda texts, *_: texts)
    monkeypatch.setattr(mpy, "shortened", lambda texts, _: SimpleNamespace(texts=texts, names={}))
    monkeypatch.setattr(
        mpy, "bundled", lambda texts, started, *_: SimpleNamespace(texts=texts, names={}, started=started)
    )
    for name in ("with_small_classes", "with_frequent_names_first"):
        monkeypatch.setattr(mpy, name, lambda text: text)
