"""Tables of messages with which the program answers are refused; without a program they are tables like others."""

import shutil
from pathlib import Path

import pytest
from edited_project import edited

from codegen.model.program import SENT
from codegen.model.system import System

PROJECTS = Path(__file__).resolve().parents[1] / "projects"


TEXTS = {"STATUSTEXT": "text", "PARAM_VALUE": "param_id", "PARAM_ERROR": "param_id"}


def written(name: str, system: System) -> str:
    """A table that says 0, or a text, in each field."""
    fields = [
        f"  {field.name}: {{constant: {'ABC' if field.name == TEXTS.get(name) else 0}}}\n"
        for field in system.dialect.messages[name].fields
    ]
    return f"message: {name}\nrequirement: FR-301.1\nfields:\n{''.join(fields)}"


@pytest.mark.parametrize("name", SENT)
def test_the_program_answers_with_it(name: str, tmp_path: Path) -> None:
    shutil.copytree(PROJECTS / "commanded" / "specs", tmp_path / "specs")
    system, _ = edited(tmp_path / "specs")
    (tmp_path / "specs" / "messages" / "own.yaml").write_text(written(name, system))
    _, found = edited(tmp_path / "specs")
    told = [each for each in found if each.rule.id == "answer-of-program"]
    assert [each.message for each in told] == [f"the program sends {name} itself"], found
    assert told[0].place.file.endswith("own.yaml")
    assert told[0].advice is not None
    assert "leave the table out" in told[0].advice


def test_no_other_message_is(tmp_path: Path) -> None:
    for project in ("commanded", "received", "watched_boat"):
        shutil.copytree(PROJECTS / project / "specs", tmp_path / project)
        _, found = edited(tmp_path / project)
        assert not [each for each in found if each.rule.id == "answer-of-program"]
