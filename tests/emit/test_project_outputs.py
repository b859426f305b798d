"""What is made of each project is what was made of it before, but for changes that somebody has looked at.

generated/ shows what a change of the generator does to the rover and the smart battery. The other projects have what
these do not: without this, a fault that only they show would be seen by nobody who does not run their suites.
"""

import ast
from collections.abc import Iterator
from functools import cache

import pytest
from project_outputs import COMMITTED, PLACES, ROOT, STORED, digests, rendered, stored

from codegen.commands.build import render_systems
from codegen.diagnostics import Report
from codegen.project.systems import read_systems

_made = cache(rendered)


@pytest.mark.parametrize("project", sorted(PLACES))
def test_what_is_made_is_what_was_made_before(project: str) -> None:
    """Byte for byte: a change that is meant is stored by `python tests/emit/project_outputs.py`."""
    made, before = digests(_made(project)), stored()[project]
    other = sorted(path for path in made.keys() | before.keys() if made.get(path) != before.get(path))
    assert not other, f"{project} is made otherwise; compare both, then run tests/emit/project_outputs.py"


def test_nothing_is_stored_of_what_there_is_not() -> None:
    """A project that is gone leaves no digests, and no project is without."""
    assert stored().keys() == PLACES.keys()
    assert all(stored().values())
    assert STORED.read_text(encoding="utf-8").endswith("}\n")


def test_what_is_committed_is_what_is_made() -> None:
    """`codegen build` has been run after the last change: the tests of generated/ judge this generator's output."""
    made = render_systems(read_systems(str(ROOT / "specs" / "codegen.yaml"), Report())).files
    other = [path for path, text in made.items() if (COMMITTED[0] / path).read_text(encoding="utf-8") != text]
    assert made
    assert not other, "codegen build"


@pytest.mark.parametrize("project", sorted(PLACES))
def test_machine_code_has_no_number_of_more_than_30_bits(project: str) -> None:
    """On a board such a literal is an object: machine code stores its address, or a module cannot be imported."""
    firmware = {path: text for path, text in _made(project).items() if path.startswith("firmware/")}
    firmware = {path: text for path, text in firmware.items() if path.endswith("_viper.py")}
    found = {path: numbers for path, text in firmware.items() if (numbers := list(_large_literals(text)))}
    assert not found
    assert bool(firmware) is ("machine_code: false" not in (PLACES[project] / "codegen.yaml").read_text())


def test_a_large_literal_is_seen() -> None:
    """With either sign and in any part of a statement, but only in machine code."""
    head = "@micropython.viper\ndef f(a):\n    "
    assert list(_large_literals(f"{head}a = 0x40000000 if a == 1073741823 else -1073741825")) == [2**30, 2**30 + 1]
    assert list(_large_literals(f"{head}a = -1073741824 + (1 << 30)")) == []
    assert list(_large_literals(f"_A = const({2**31})\n\n{head}return _A")) == [2**31]
    assert list(_large_literals(f"def f(a):\n    return {2**40}")) == []


def _large_literals(text: str) -> Iterator[int]:
    """Yield the numbers in functions of machine code, and in constants, that no small integer of a board holds."""
    places: list[ast.AST] = []
    for node in ast.walk(ast.parse(text)):
        is_constant = isinstance(node, ast.Call) and ast.unparse(node.func) == "const"
        decorators = map(ast.unparse, node.decorator_list) if isinstance(node, ast.FunctionDef) else ()
        if is_constant or "micropython.viper" in decorators:
            places.append(node)
    for place in places:
        nodes = list(ast.walk(place))
        least = {id(node.operand) for node in nodes if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub)}
        for node in nodes:
            if not isinstance(node, ast.Constant) or not isinstance(node.value, int):
                continue
            if node.value > 2**30 or (node.value == 2**30 and id(node) not in least):
                yield node.value
