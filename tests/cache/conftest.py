"""These tests are about what is kept, and by whom."""

import pytest

from codegen.tool import cache


@pytest.fixture(autouse=True)
def read_again(monkeypatch: pytest.MonkeyPatch, read_once: None, compiled_once: None) -> None:  # noqa: ARG001  what it did is taken back
    """Files are decoded and firmware is compiled again unless the cache under test has them."""
    for name in ("kept", "kept_object", "keep", "keep_object"):
        monkeypatch.setattr(f"codegen.decode.decoded.{name}", getattr(cache, name))
    for name in ("kept_object", "keep_object"):
        monkeypatch.setattr(f"codegen.emit.mpy.{name}", getattr(cache, name))
