"""Rules about a whole system say what to do: whoever reads the finding has written what it is about."""

import ast
from pathlib import Path

import pytest

RULES = sorted((Path(__file__).resolve().parents[2] / "codegen" / "rules").glob("*.py"))


def without_hint(tree: ast.AST) -> list[int]:
    """Return the lines of the findings that have no hint: place, rule and message only."""
    return [
        node.lineno
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        and ast.unparse(node.func) == "Diagnostic"
        and len(node.args) < 4
        and all(keyword.arg != "hint" for keyword in node.keywords)
    ]


@pytest.mark.parametrize("path", RULES, ids=lambda path: path.stem)
def test_each_finding_of_a_rule_has_a_hint(path: Path) -> None:
    assert without_hint(ast.parse(path.read_text("utf-8"))) == []


def test_one_without_a_hint_is_found() -> None:
    """So that the test above is one."""
    text = (
        "Diagnostic(place, RULE, 'no')\nDiagnostic(place, RULE, 'no', hint='do')\nDiagnostic(place, RULE, 'no', 'do')\n"
    )
    assert without_hint(ast.parse(text)) == [1]
