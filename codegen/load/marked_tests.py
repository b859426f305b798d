"""The tests of a project that say what they show, ``@pytest.mark.requirement("FR-00068.3")``; none of them is run.

Only texts are found; what a test computes its marks from, results in JUnit's format tell.
"""

import ast
import os
import warnings
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from codegen.diagnostics import Report, Rule, Severity
from codegen.frozen import dataclass
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
    found = Report()
    text = decode_text(data, path, found)
    if text is None:
        first = next(iter(found))
        report.add(TEST_SYNTAX, first.place, f"what its tests show is not known: {first.message}")
        return []
    try:
        module = ast.parse(text)
        with warnings.catch_warnings():  # what Python warns of when it compiles is for who runs the tests
            warnings.simplefilter("ignore")
            compile(module, path, "exec", dont_inherit=True)  # finds what no syntax tree shows, such as a double name
    except (SyntaxError, ValueError, RecursionError, MemoryError) as problem:
        place = Place(path, getattr(problem, "lineno", 1) or 1, getattr(problem, "offset", 1) or 1)
        report.add(TEST_SYNTAX, place, f"what its tests show is not known: {getattr(problem, 'msg', problem)}")
        return []
    return list(_marked(module.body, _Scope("", (), {}, path)))


@dataclass(frozen=True, slots=True)
class _Scope:
    """The classes that a body can name, and the marks and the name that its tests have from what is around it."""

    owner: str
    marks: tuple[ast.expr, ...]
    classes: Mapping[str, ast.ClassDef]
    path: str


def _marked(body: Iterable[ast.stmt], scope: _Scope) -> Iterator[MarkedTest]:
    """Yield the tests of a module: functions, and the methods of classes that pytest collects."""
    marks = (*scope.marks, *(mark for statement in body for mark in _assigned(statement)))
    classes = {**scope.classes, **{each.name: each for each in body if isinstance(each, ast.ClassDef)}}
    inside = replace(scope, marks=marks, classes=classes)
    for statement in body:
        if isinstance(statement, _Function):
            yield from _of_function(statement, inside)
        elif isinstance(statement, ast.ClassDef) and _is_collected(statement, classes):
            yield from _of_class(statement, inside)


def _of_function(function: ast.FunctionDef | ast.AsyncFunctionDef, scope: _Scope) -> Iterator[MarkedTest]:
    if not function.name.startswith("test"):
        return
    for mark in [*scope.marks, *function.decorator_list]:
        for name in _names(mark):
            place = Place(scope.path, name.lineno, name.col_offset + 1)
            yield MarkedTest(f"{scope.owner}{function.name}", str(name.value), place)


def _of_class(collected: ast.ClassDef, scope: _Scope) -> Iterator[MarkedTest]:
    """Yield the tests of a class, those that it inherits within the file included, with the marks of all its bases."""
    family = _family(collected, scope.classes)
    marks = [*scope.marks]
    for each in family:
        marks += [*each.decorator_list, *(mark for statement in each.body for mark in _assigned(statement))]
    known = {each.name: each for member in reversed(family) for each in member.body if isinstance(each, ast.ClassDef)}
    inside = replace(
        scope, owner=f"{scope.owner}{collected.name}::", marks=tuple(marks), classes={**scope.classes, **known}
    )
    taken: set[str] = set()
    for member in family:
        named = {each.name for each in member.body if isinstance(each, (*_Function, ast.ClassDef))}
        for statement in member.body:
            if isinstance(statement, _Function) and statement.name not in taken:
                yield from _of_function(statement, inside)
            elif isinstance(statement, ast.ClassDef) and statement.name not in taken:
                yield from _of_class(statement, inside) if _is_collected(statement, inside.classes) else ()
        taken |= named


def _family(derived: ast.ClassDef, classes: Mapping[str, ast.ClassDef]) -> list[ast.ClassDef]:
    """A class and its bases in the file, each once, what overrides before what is overridden."""
    found: list[ast.ClassDef] = []
    waiting = [derived]
    while waiting:
        each = waiting.pop(0)
        if each not in found:
            found.append(each)
            names = (base.id for base in each.bases if isinstance(base, ast.Name))
            waiting += [classes[name] for name in names if name in classes]
    return found


def _is_collected(defined: ast.ClassDef, classes: Mapping[str, ast.ClassDef]) -> bool:
    """Return whether pytest takes a class for tests: by its name, or as one of unittest."""
    bases = (_last_name(base) for each in _family(defined, classes) for base in each.bases)
    return defined.name.startswith("Test") or any(name.endswith("TestCase") for name in bases)


def _last_name(base: ast.expr) -> str:
    """``TestCase`` of ``unittest.TestCase``; empty for what has no name."""
    return base.attr if isinstance(base, ast.Attribute) else base.id if isinstance(base, ast.Name) else ""


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
