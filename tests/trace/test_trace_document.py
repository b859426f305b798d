"""docs/trace.md: its first example is what the command prints of the shipped project."""

from pathlib import Path

import pytest

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.draft("battery_upstream", "battery_cell_voltages_rfc_0018")
def test_the_first_example_is_what_the_command_prints(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its numbers change with the specification and with the tests: then the document has to follow."""
    text = (ROOT / "docs" / "trace.md").read_text()
    shown = text.split("```console\n$ codegen trace\n")[1].split("\n```")[0]
    monkeypatch.chdir(ROOT)
    assert main(["trace"]) == 0
    assert capsys.readouterr().out.rstrip("\n") == shown
