"""The names that a module of Python defines, found in its source: it is never imported."""

import ast
import warnings
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field

from codegen.frozen import dataclass
from codegen.load.defined_classes import defined_classes
from codegen.model.spec.python_class import PythonClass


@dataclass(frozen=True, slots=True)
class DefinedNames:
    """The names of a module once it is imported, and which of them are classes that it defines itself.

    ``shapes`` are those of its classes of which the source shows all. ``is_open``: it can have other names, too, which
    its source does not show. ``fault`` is the line that is no Python, from 1 on, and what is wrong with it; then
    nothing else is known.
    """

    names: frozenset[str] = frozenset()
    classes: tuple[str, ...] = ()
    shapes: Mapping[str, PythonClass] = field(default_factory=dict)
    is_open: bool = False
    fault: tuple[int, str] | None = None

    def has(self, name: str) -> bool:
        """Return whether the module has a name, or can have it."""
        return self.is_open or name in self.names


def defined_names(text: str) -> DefinedNames:
    """Return what a module defines, imports or assigns where it is run, on any way through it."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(text)
    except SyntaxError as problem:
        return DefinedNames(fault=(problem.lineno or 1, problem.msg))
    except (ValueError, RecursionError, MemoryError):  # a null byte, or nested too deep: nothing is known of it
        return DefinedNames(is_open=True)
    names: set[str] = set()
    classes = []
    is_open = False
    for node in _run_on_import(tree.body):
        found = set(_bound(node))
        names |= found
        is_open = is_open or "*" in found or "__getattr__" in found or _is_globals(node)
        if isinstance(node, ast.ClassDef):
            classes.append(node.name)
    return DefinedNames(frozenset(names), tuple(dict.fromkeys(classes)), defined_classes(tree), is_open)


def _run_on_import(body: Iterable[ast.AST]) -> Iterator[ast.AST]:
    """Yield all nodes but those within functions and classes, which have names of their own.

    What a function declares as global can be assigned there.
    """
    waiting = list(body)
    for node in waiting:  # it grows
        yield node
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            yield from (each for each in ast.walk(node) if isinstance(each, ast.Global))
        elif not isinstance(node, ast.ClassDef):
            waiting += ast.iter_child_nodes(node)


def _bound(node: ast.AST) -> Iterator[str]:
    match node:
        case ast.ClassDef() | ast.FunctionDef() | ast.AsyncFunctionDef():
            yield node.name
        case ast.Import():
            yield from (alias.asname or alias.name.partition(".")[0] for alias in node.names)
        case ast.ImportFrom():
            yield from (alias.asname or alias.name for alias in node.names)
        case ast.Name(ctx=ast.Store()):
            yield node.id
        case ast.Global():
            yield from node.names
        case ast.ExceptHandler(name=str(name)):
            yield name


def _is_globals(node: ast.AST) -> bool:
    return isinstance(node, ast.Name) and node.id in ("globals", "exec", "setattr")
