"""Finds attributes of the state that a module of the user's sets, in its source: it is never imported."""

import ast
import warnings
from collections.abc import Iterable, Iterator
from typing import NamedTuple

_STATE = "state"


class Stored(NamedTuple):
    """An attribute of a component that is set, ``state.COMPONENT.ATTRIBUTE = ...``, and where, from 1 on."""

    component: str
    attribute: str
    line: int
    column: int


class ModuleStores(NamedTuple):
    """The attributes of the state that a module sets, and the names of the modules that it imports."""

    stored: tuple[Stored, ...]
    imported: frozenset[str]


def state_stores(text: str) -> ModuleStores:
    """Return what is set through ``state`` or ``x.state`` at once, or through a name that stands for a component.

    Such a name is one that its function binds once, to nothing but a component.
    """
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):  # others say what is wrong with it
        return ModuleStores((), frozenset())
    shared = {name for node in ast.walk(tree) if isinstance(node, ast.Global | ast.Nonlocal) for name in node.names}
    found = list(_stored(tree, {}, shared))
    return ModuleStores(
        tuple(sorted(set(found), key=lambda each: (each.line, each.column))), frozenset(_imported(tree))
    )


def _stored(scope: ast.AST, outer: dict[str, str], shared: set[str]) -> Iterator[Stored]:
    """Yield what is set in a module, a function or a class; ``outer`` are the names of components around it.

    A name that is ``shared`` can be bound in another scope, too.
    """
    own = list(_own_nodes(scope))
    bound = _bindings(own)
    names = {name: component for name, component in outer.items() if name not in bound}
    names |= {name: each[0] for name, each in bound.items() if len(each) == 1 and each[0] and name not in shared}
    for node in own:
        if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store):
            component = _component(node.value) or (
                names.get(node.value.id) if isinstance(node.value, ast.Name) else None
            )
            if component is not None:
                line, column = node.end_lineno or node.lineno, node.end_col_offset or node.col_offset
                yield Stored(component, node.attr, line, column - len(node.attr) + 1)
        elif isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda | ast.ClassDef):
            yield from _stored(node, names, shared)


def _own_nodes(scope: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes of a scope, with the functions and classes in it, but not what is in these."""
    waiting = list(ast.iter_child_nodes(scope))
    for node in waiting:  # it grows
        yield node
        if not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda | ast.ClassDef):
            waiting += ast.iter_child_nodes(node)


def _bindings(own: Iterable[ast.AST]) -> dict[str, list[str | None]]:
    """Return what each name of a scope is bound to, each time: a component, or None for anything else."""
    found: dict[str, list[str | None]] = {}
    plain: dict[int, str | None] = {}
    for node in own:
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            plain[id(node.targets[0])] = _component(node.value)
        for name in _bound(node):
            found.setdefault(name, []).append(plain.get(id(node)))
    return found


def _bound(node: ast.AST) -> Iterator[str]:
    """Yield the names that a node binds."""
    match node:
        case ast.Name(ctx=ast.Store() | ast.Del()):
            yield node.id
        case ast.Global() | ast.Nonlocal():
            yield from node.names
        case ast.arg():
            yield node.arg
        case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef():
            yield node.name
        case ast.Import() | ast.ImportFrom():
            yield from (alias.asname or alias.name.partition(".")[0] for alias in node.names)
        case ast.ExceptHandler(name=str(name)) | ast.MatchAs(name=str(name)) | ast.MatchStar(name=str(name)):
            yield name


def _component(node: ast.AST) -> str | None:
    """Return the component that an expression is: ``state.battery``, ``self.state.battery[1]``."""
    if isinstance(node, ast.Subscript):
        node = node.value
    if not isinstance(node, ast.Attribute):
        return None
    owner = node.value
    is_state = isinstance(owner, ast.Name) and owner.id == _STATE
    return node.attr if is_state or (isinstance(owner, ast.Attribute) and owner.attr == _STATE) else None


def _imported(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield node.module
