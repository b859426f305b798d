"""A worse level cannot have an action that gives way to that of a milder one."""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main

BOAT = Path(__file__).resolve().parents[1] / "projects" / "watched_boat" / "specs"


@pytest.mark.parametrize(
    ("priority", "told"),
    [
        ("[stop, slow]", []),
        (
            "[slow, stop]",
            [
                "hot would stop, which gives way to slow of warm",
                "lost would stop, which gives way to slow of silent",
            ],
        ),
    ],
)
def test_levels_that_contradict_the_priority_are_found(
    priority: str, told: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """At the action of the worse level; an action that a parameter chooses may be any."""
    specs = Path(shutil.copytree(BOAT, tmp_path / "specs"))
    path = specs / "vehicle.yaml"
    text = path.read_text()
    assert "priority: [stop, slow]" in text
    path.write_text(text.replace("priority: [stop, slow]", f"priority: {priority}"))
    assert main(["check", "--project", str(specs / "codegen.yaml")]) == bool(told)
    found = [line for line in capsys.readouterr().out.splitlines() if " error " in line]
    line = next(number for number, each in enumerate(text.splitlines(), 1) if "lost: {after: 20 s" in each)
    assert [each.split("bad-priority: ")[1].split(" [")[0] for each in found] == told
    assert all(f"vehicle.yaml:{line}:" in each for each in found)
