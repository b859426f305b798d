"""What views say over a while: generations, staleness, flags, time that is left, swaps; on both interpreters."""

import ast
import json
from functools import cache
from pathlib import Path

import pytest
from projects import HERE, run

SCRIPT = HERE / "view_checks.py"
TOOLS = {"status", "status_v2", "info", "feed", "equals", "two_of_one_name", "outcome"}
NAMES = [
    node.name
    for node in ast.parse(SCRIPT.read_text()).body
    if isinstance(node, ast.FunctionDef) and node.name not in TOOLS
]


@cache
def outcomes(interpreter: str, generated: Path) -> dict[str, str | None]:
    found: dict[str, str | None] = json.loads(run(interpreter, SCRIPT, [generated / "receiver"]))
    return found


@pytest.mark.requirement(
    "FR-00075.1", "FR-00075.2", "FR-00075.3", "FR-00075.4", "FR-00075.5", "FR-00075.6", "FR-00075.8"
)
@pytest.mark.requirement("FR-00075.10")
@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
@pytest.mark.parametrize("name", NAMES)
def test_views(name: str, interpreter: str, packs: Path) -> None:
    """The check passes."""
    assert outcomes(interpreter, packs)[name] is None
