"""The generated suite has the call that makes a driver as literals: no text of a specification is evaluated by it."""

import ast
from pathlib import Path

import pytest

from codegen.targets.suite.making import call_literal

SUITE = Path(__file__).resolve().parents[2] / "templates" / "tests"
OF_MODULES = {"machine_code_run.py"}
"""Tries a text of its own: whether the interpreter has machine code."""


@pytest.mark.parametrize(
    ("expression", "made"),
    [
        ("Driver()", {"call": "Driver", "given": (), "named": {}}),
        ('Driver("a b", -1, (1, 2))', {"call": "Driver", "given": ("a b", -1, (1, 2)), "named": {}}),
        ("Driver(0.5, on=True)", {"call": "Driver", "given": (0.5,), "named": {"on": True}}),
        (
            "Driver(lambda: machine.Pin(3, machine.Pin.IN))",
            {
                "call": "Driver",
                "given": ({"call": "machine.Pin", "given": (3, {"name": "machine.Pin.IN"}), "named": {}},),
                "named": {},
            },
        ),
    ],
)
def test_a_call_is_its_parts(expression: str, made: object) -> None:
    """What a driver calls itself stands for what that returns."""
    assert ast.literal_eval(call_literal(expression)) == made


def test_what_is_not_a_literal_is_no_part() -> None:
    with pytest.raises(ValueError, match="malformed"):
        call_literal("Driver([each for each in ()])")


def test_no_check_of_the_generated_suite_evaluates_text() -> None:
    """Names and texts of a specification are data there; one check runs a text of its own."""
    found = [
        path.name
        for path in SUITE.rglob("*.py*")
        for node in (ast.walk(ast.parse(path.read_text())) if path.suffix == ".py" else ())
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("eval", "exec")
    ]
    assert set(found) == OF_MODULES
