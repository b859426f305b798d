"""The tests of a project that say what they show, ``@pytest.mark.requirement("FR-00068.3")``; none of them is run.

Only texts are found; what a test computes its marks from, results in JUnit's format tell.
"""

import ast
import os
from collections.abc import Iterable, Iterator

from codegen.diagnostics import Report, Rule, Severity
from codegen.load.files import Files
from codegen.load.text import decode_text
from codegen.model.test_record import MarkedTest
from codegen.source import Place

MARKER = "requirement"
"""Name of the marker."""

TEST_SYNTAX = Rule(
    "test-syntax",
    "A file of tests is no Python that can be read, so it is not known what its tests show. Correct the named place.",
    Severity.WARNING,
    remedy="make it Python in UTF-8: python -m py_compile FILE says more",
)

_Function = (ast.FunctionDef, ast.AsyncFunctionDef)


def files_of_tests(folders: Iterable[str], files: Files, report: Report) -> list[str]:
    """The absolute paths of the Python files in folders and below, by name; what begins with a dot is left out."""
    found: set[str] = set()
    waiting = list(folders)
    while waiting:
        folder = waiting.pop()
        for name in files.names(folder, report):
            path = os.path.join(folder, name)
            if name.startswith((".", "__")):
                continue
            if files.is_folder(path) and not os.path.islink(path):
                waiting.append(path)
            elif name.endswith(".py"):
                found.add(path)
    return sorted(found)


def has_marks(data: bytes) -> bool:
    """Return whether a file with that content may have tests that are marked."""
    return f".{MARKER}(".encode() in data


def marked_tests(data: bytes, path: str, report: Report) -> list[MarkedTest]:
    """The tests of a file that are marked; one that is no Python has none, after a finding."""
    text = decode_text(data, path, Report())
    if text is None:
        report.add(TEST_SYNTAX, Place(path), "what its tests show is not known: it is not UTF-8")
        return []
    try:
        module = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as problem:
        place = Place(path, getattr(problem, "lineno", 1) or 1, getattr(problem, "offset", 1) or 1)
        report.add(TEST_SYNTAX, place, f"what its tests show is not known: {getattr(problem, 'msg', problem)}")
        return []
    return list(_marked(module.body, "", [], path))


def _marked(body: Iterable[ast.stmt], owner: str, inherited: list[ast.expr], path: str) -> Iterator[MarkedTest]:
    body = list(body)
    inherited = [*inherited, *(mark for statement in body for mark in _assigned(statement))]
    for statement in body:
        if isinstance(statement, _Function) and statement.name.startswith("test"):
            for mark in [*inherited, *statement.decorator_list]:
                for name in _names(mark):
                    place = Place(path, name.lineno, name.col_offset + 1)
                    yield MarkedTest(f"{owner}{statement.name}", str(name.value), place)
        elif isinstance(statement, ast.ClassDef) and statement.name.startswith("Test"):
            marks = [*inherited, *statement.decorator_list]
            yield from _marked(statement.body, f"{owner}{statement.name}::", marks, path)


def _assigned(statement: ast.stmt) -> list[ast.expr]:
    """Return what ``pytestmark = ...`` of a module or a class marks all of its tests with."""
    if not isinstance(statement, ast.Assign):
        return []
    is_mark = any(isinstance(target, ast.Name) and target.id == "pytestmark" for target in statement.targets)
    return [statement.value] if is_mark else []


def _names(mark: ast.expr) -> Iterator[ast.Constant]:
    """The texts that ``mark.requirement(...)`` has, also where a decorator gives it to single parameters."""
    for node in ast.walk(mark):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == MARKER:
            yield from (one for one in node.args if isinstance(one, ast.Constant) and isinstance(one.value, str))
