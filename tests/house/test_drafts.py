"""Tests about a draft run while specs/codegen.yaml lists its overlay, and are counted while it does not."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks"))

import alternatives  # noqa: E402  it lies in a folder of its own

TESTS = """
import pytest


@pytest.mark.draft("battery_upstream")
def test_status(): ...


@pytest.mark.draft("battery_upstream", "battery_cell_voltages_rfc_0018")
def test_status_and_cells(): ...


def test_neither(): ...
"""


@pytest.mark.parametrize(
    ("alternative", "passed", "left", "options"),
    [
        ("", 3, 0, ()),
        ("battery_rfc_0018", 1, 2, ("-n", "1")),
        ("battery_rfc_0018", 1, 2, ()),
        ("battery_cell_faults_rfc_0018", 2, 1, ()),
    ],
)
def test_those_of_other_drafts_are_left_out_and_counted(
    alternative: str, passed: int, left: int, options: tuple[str, ...], tmp_path: Path
) -> None:
    """With the shipped choice all run, with another one the others, in one process and with workers."""
    text = SHIPPED if not alternative else alternatives.switched(SHIPPED, alternative)
    (tmp_path / "specs").mkdir()
    (tmp_path / "specs" / "codegen.yaml").write_text(text)
    (tmp_path / "tests").mkdir()
    shutil.copy(ROOT / "tests" / "conftest.py", tmp_path / "tests")
    (tmp_path / "tests" / "test_them.py").write_text(TESTS)
    command = [sys.executable, "-m", "pytest", "--strict-markers", *options, "-p", "no:cacheprovider", "tests"]
    environment = {name: value for name, value in os.environ.items() if not name.startswith("PYTEST_")}
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"{passed} passed" in done.stdout
    assert (f"{left} tests are about drafts" in done.stdout) == bool(left)
    assert left or "are about drafts" not in done.stdout


def _shipped() -> str:
    """codegen.yaml with what is shipped, whatever this checkout lists."""
    text = (ROOT / "specs" / "codegen.yaml").read_text()
    for chosen, other in alternatives.ALTERNATIVES.items():
        text = text.replace(f"  - dialects/{chosen}.xml\n", f"  - dialects/{other}.xml\n")
    return text


SHIPPED = _shipped()


@pytest.mark.parametrize("alternative", alternatives.ALTERNATIVES)
def test_an_alternative_is_one_line(alternative: str) -> None:
    """Nothing else of codegen.yaml changes, and the overlay is there."""
    changed = set(alternatives.switched(SHIPPED, alternative).splitlines()) - set(SHIPPED.splitlines())
    assert changed == {f"  - dialects/{alternative}.xml"}
    assert (ROOT / "specs" / "dialects" / f"{alternative}.xml").is_file()
    with pytest.raises(ValueError, match="not listed once"):
        alternatives.switched(SHIPPED.replace("  - dialects/battery", "  - dialects/no"), alternative)
