"""A worse level cannot have an action that gives way to that of a milder one."""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main

BOAT = Path(__file__).resolve().parents[1] / "projects" / "watched_boat" / "specs"


@pytest.mark.parametrize(
    ("priority", "told"),
    [
        ("[stop, slow]", {}),
        (
            "[slow, stop]",
            {
                "lost: {after: 20 s": "lost would stop, which gives way to slow of silent",
                "hot: {above: HOLD_HOT": "hot would stop, which gives way to slow of warm",
                "thick: {above: 35 %": "thick would stop, which gives way to slow of thin",
                "gone: {unknown: true": "gone would stop, which gives way to slow of lost",
            },
        ),
    ],
)
def test_levels_that_contradict_the_priority_are_found(
    priority: str, told: dict[str, str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """At the action of the worse level; an action that a parameter chooses may be any."""
    specs = Path(shutil.copytree(BOAT, tmp_path / "specs"))
    path = specs / "vehicle.yaml"
    text = path.read_text()
    assert "priority: [stop, slow]" in text
    path.write_text(text.replace("priority: [stop, slow]", f"priority: {priority}"))
    assert main(["check", "--project", str(specs / "codegen.yaml")]) == bool(told)
    found = [line for line in capsys.readouterr().out.splitlines() if " error " in line]
    lines = [next(at for at, each in enumerate(text.splitlines(), 1) if level in each) for level in told]
    assert [each.split("bad-priority: ")[1].split(" [")[0] for each in found] == list(told.values())
    assert [int(each.split("vehicle.yaml:")[1].split(":")[0]) for each in found] == lines
