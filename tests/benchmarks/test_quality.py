"""docs/quality.md shows what the commands about tests have stored, and nothing else."""

import json
import re
from pathlib import Path

import pytest
import quality
import quality_results


def test_the_page_shows_what_is_stored() -> None:
    """`python benchmarks/quality.py --stored` writes it anew."""
    assert quality.PAGE.read_text(encoding="utf-8") == quality.page(quality_results.read())


def test_every_stored_number_is_on_the_page() -> None:
    """A number that was changed in the one and not in the other is a fault."""
    page = quality.page(quality_results.read())
    stored = quality_results.read()
    for seed, run in stored.get("fuzz", {}).items():
        assert f"| seed {seed} | {run['inputs']:,} |" in page
    for folder, number in stored["counts"]["lines"].items():
        assert f"| `{folder}/` | {number:,} |" in page
    for folder, number in stored["counts"]["tests"].items():
        assert f"| `{folder}` | {number:,} |" in page


def test_what_is_stored_replaces_what_was_found_before(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Given the same; what others have stored stays."""
    monkeypatch.setattr(quality_results, "FILE", tmp_path / "quality.json")
    quality_results.store("fuzz", "1", {"inputs": 5})
    quality_results.store("fuzz", "2", {"inputs": 6})
    quality_results.store("fuzz", "1", {"inputs": 7})
    assert json.loads((tmp_path / "quality.json").read_text()) == {"fuzz": {"1": {"inputs": 7}, "2": {"inputs": 6}}}


def test_what_is_counted_is_there() -> None:
    """The counts are not those of nothing."""
    assert all(each["cases"] > 50 and each["checks"] > 20 for each in quality.generated().values())
    assert quality.lines("codegen") > 10_000
    found = quality.criteria()
    assert sum(found["by"].values()) > 100
    assert re.fullmatch(r"[a-z, ]+", "".join(found["by"]))
