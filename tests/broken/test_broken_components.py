"""A component whose entry cannot be read is reported once: nothing that names it is told that there is none."""

import re
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from rover_alone import without_programs

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]
PROJECTS = [ROOT, *sorted((ROOT / "tests" / "projects").iterdir()), ROOT / "examples" / "boat"]
"""Tables, families, instances, generations, failsafes, modes, programs and receivers of these name components."""

_COMPONENT = re.compile(r"(?m)^  (?P<name>\w+):\n    doc: (?:>-\n(?:      .*\n)+|.*\n)")


def without_doc(text: str) -> Iterator[tuple[str, str]]:
    """Yield each component of a state.yaml, and the text without its doc, which a component must have."""
    for found in _COMPONENT.finditer(text):
        yield found["name"], f"{text[: found.start()]}  {found['name']}:\n{text[found.end() :]}"


@pytest.mark.parametrize(
    "project",
    [each for each in PROJECTS if (each / "specs" / "state.yaml").is_file()],
    ids=lambda path: str(path.relative_to(ROOT)),
)
def test_a_component_that_cannot_be_read_is_reported_once(
    project: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """At its own entry, whatever names it."""
    shutil.copytree(project / "specs", tmp_path / "specs")
    if project == ROOT:
        without_programs(tmp_path / "specs")
    state = tmp_path / "specs" / "state.yaml"
    changed = dict(without_doc(state.read_text()))
    assert changed
    monkeypatch.chdir(tmp_path)
    for name, text in changed.items():
        state.write_text(text)
        line = text[: text.index(f"\n  {name}:\n")].count("\n") + 2
        assert main(["build", "--dry-run"]) == 1
        errors = [each for each in capsys.readouterr().out.splitlines() if ": error " in each]
        assert errors == [f"specs/state.yaml:{line}:3: error missing-key: doc is missing"], name
