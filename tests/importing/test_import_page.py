"""docs/import.md shows a real document, and what codegen really makes of it."""

import re
from pathlib import Path

import pytest

from codegen.cli import main

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "import.md").read_text(encoding="utf-8")


def block(language: str, number: int = 0) -> str:
    return re.findall(rf"^```{language}\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)[number]


def test_the_example_is_real(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "pack.md").write_text(block("markdown"))
    assert main(["import", "pack.md"]) == 1
    printed = capsys.readouterr()
    assert printed.out == block("yaml")
    errors = [line for line in printed.err.splitlines() if "error" in line]
    assert block("console").splitlines()[1:] == errors
    assert main(["import", "pack.md", "--compare", "--project", str(ROOT / "specs" / "codegen.yaml")]) == 1
    rows = [line for line in capsys.readouterr().out.splitlines() if not line.startswith(("pack.md", "  "))]
    assert rows[1:] == block("text").splitlines()[1:]
