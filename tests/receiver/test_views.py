"""Views over a while: generations, staleness, flags, time that is left, swaps; on both interpreters."""

import ast
import json
from functools import cache
from pathlib import Path

import pytest
from projects import HERE, run


def checks_of(script: str) -> list[str]:
    """The names of the checks of a script, without running it."""
    found = [node for node in ast.parse((HERE / script).read_text()).body if isinstance(node, ast.Assign)]
    listed = next(node.value for node in found if ast.unparse(node.targets[0]) == "CHECKS")
    assert isinstance(listed, ast.Tuple)
    return [ast.unparse(name) for name in listed.elts]


@cache
def outcomes(interpreter: str, script: str, generated: Path) -> dict[str, str | None]:
    found: dict[str, str | None] = json.loads(run(interpreter, HERE / script, [generated / "receiver"]))
    return found


@pytest.mark.requirement(
    "FR-00075.1", "FR-00075.2", "FR-00075.3", "FR-00075.4", "FR-00075.5", "FR-00075.6", "FR-00075.8"
)
@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
@pytest.mark.parametrize("name", checks_of("view_checks.py"))
def test_views(name: str, interpreter: str, packs: Path) -> None:
    """The check passes."""
    assert outcomes(interpreter, "view_checks.py", packs)[name] is None


@pytest.mark.requirement("FR-00075.2", "FR-00075.8", "FR-00075.10")
@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
@pytest.mark.parametrize("name", checks_of("contest_checks.py"))
def test_contests(name: str, interpreter: str, packs: Path) -> None:
    """The check passes."""
    assert outcomes(interpreter, "contest_checks.py", packs)[name] is None
