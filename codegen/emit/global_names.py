"""Gives other names to what a module has at its top level, wherever the module uses it."""

import ast
import builtins
from collections.abc import Container, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from codegen.emit.private_names import Module, bound_by, children, walked

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)
_INNER = (*FUNCTIONS, ast.ClassDef, ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)


class NameClashError(Exception):
    """A new name is one of a function's own there."""


class GlobalNames(ast.NodeTransformer):
    """Changes a syntax tree: ``names`` has new names for global ones. Imports stay as they are.

    ``attributes`` has, by names that stand for modules, new names for what these are asked for; of those that are
    ``beside`` it is global, too. ``used`` are afterwards the names that are looked up outside of functions' own, as
    they were, ``own`` those of functions and comprehensions, and of classes whose lines look something up outside.
    """

    def __init__(
        self,
        names: Mapping[str, str],
        attributes: Mapping[str, Mapping[str, str]] | None = None,
        beside: Container[str] = (),
    ) -> None:
        """Take over what has another name."""
        self.used: set[str] = set()
        self._attributes, self._beside = attributes or {}, beside
        self.own: set[str] = set()
        self._names = names
        self._scopes: list[set[str]] = []
        self._in_class: list[bool] = []

    def visit_Name(self, node: ast.Name) -> ast.Name:
        node.id = self._new(node.id)
        return node

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:
        alias = node.value.id if isinstance(node.value, ast.Name) and not self._is_own(node.value.id) else ""
        node.attr = self._attributes.get(alias, {}).get(node.attr, node.attr)
        if alias in self._beside:
            return ast.Name(self._checked(node.attr), node.ctx)
        self._visit(node, "value")
        return node

    def visit_Global(self, node: ast.Global) -> ast.Global:
        node.names = [self._names.get(name, name) for name in node.names]
        return node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        return self._function(node)

    def visit_AsyncFunctionDef(self, node: ast.AsyncFunctionDef) -> ast.AST:
        return self._function(node)

    def visit_Lambda(self, node: ast.Lambda) -> ast.AST:
        return self._function(node)

    def visit_ClassDef(self, node: ast.ClassDef) -> ast.ClassDef:
        node.name = self._new(node.name)
        self._visit(node, "decorator_list", "bases", "keywords")
        self._enter(node, _bound_in(node.body), is_class=True, parts=("body",))
        return node

    def visit_ListComp(self, node: ast.ListComp) -> ast.AST:
        return self._comprehension(node)

    def visit_SetComp(self, node: ast.SetComp) -> ast.AST:
        return self._comprehension(node)

    def visit_DictComp(self, node: ast.DictComp) -> ast.AST:
        return self._comprehension(node)

    def visit_GeneratorExp(self, node: ast.GeneratorExp) -> ast.AST:
        return self._comprehension(node)

    def _function(self, node: Any) -> ast.AST:
        if not isinstance(node, ast.Lambda):
            node.name = self._new(node.name)
            self._visit(node, "decorator_list", "returns")
        arguments = node.args
        self._visit(arguments, "defaults", "kw_defaults")
        every = [each for each in walked(arguments) if isinstance(each, ast.arg)]
        for each in every:
            self._visit(each, "annotation")
        body = node.body if isinstance(node.body, list) else [node.body]
        self._enter(node, _bound_in(body) | {each.arg for each in every}, is_class=False, parts=("body",))
        made: ast.AST = node
        return made

    def _comprehension(self, node: Any) -> ast.AST:
        targets = [each.target for each in node.generators]
        parts = tuple(part for part in ("elt", "key", "value", "generators") if hasattr(node, part))
        self._enter(node, _bound_in(targets), is_class=False, parts=parts)
        made: ast.AST = node
        return made

    def _enter(self, node: ast.AST, bound: set[str], *, is_class: bool, parts: Sequence[str]) -> None:
        self._scopes.append(bound)
        self._in_class.append(is_class)
        if not is_class:
            self.own |= bound
        self._visit(node, *parts)
        self._scopes.pop()
        self._in_class.pop()

    def _visit(self, node: ast.AST, *parts: str) -> None:
        for part in parts:
            value = getattr(node, part)
            if isinstance(value, list):
                value[:] = [each if each is None else self.visit(each) for each in value]
            elif value is not None:
                setattr(node, part, self.visit(value))

    def _new(self, name: str) -> str:
        if self._is_own(name):
            return name
        self.used.add(name)
        if self._in_class and self._in_class[-1] and not hasattr(builtins, name):
            self.own |= self._scopes[-1]
        return self._checked(self._names[name]) if name in self._names else name

    def _checked(self, name: str) -> str:
        if self._is_own(name):
            raise NameClashError(name)
        return name

    def _is_own(self, name: str) -> bool:
        """Return whether a name is a function's own here; those of a class are seen in its own lines alone."""
        innermost = len(self._scopes) - 1
        seen = (scope for at, scope in enumerate(self._scopes) if at == innermost or not self._in_class[at])
        return any(name in scope for scope in seen)


def _bound_in(body: Sequence[ast.AST]) -> set[str]:
    """Return what statements give a name to, and not what functions, classes and comprehensions in them do."""
    found: set[str] = set()
    declared: set[str] = set()
    for node in outside_functions(body):
        if isinstance(node, ast.Global):
            declared.update(node.names)
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            found.update(each.asname or each.name.partition(".")[0] for each in node.names)
        elif not isinstance(node, (ast.Attribute, ast.arg)):
            found.update(bound_by(node))
    return found - declared


def outside_functions(nodes: Sequence[ast.AST]) -> Iterator[ast.AST]:
    """Yield nodes, and those within them that are in no function, class or comprehension, as they are written."""
    left = [*reversed(nodes)]
    while left:
        node = left.pop()
        yield node
        if not isinstance(node, _INNER):
            left.extend(reversed(children(node)))


@lru_cache(maxsize=256)
def bound_at_top(tree: ast.Module) -> frozenset[str]:
    """Return the names that a module gives to something at its top level, or declares to in its functions."""
    declared = (name for node in walked(tree) if isinstance(node, ast.Global) for name in node.names)
    return frozenset((*_bound_in(tree.body), *declared))


class Seen(NamedTuple):
    """The names that GlobalNames has ``used``, and those that are functions' ``own``."""

    used: frozenset[str]
    own: frozenset[str]


@lru_cache(maxsize=256)
def seen_in(tree: ast.Module) -> Seen:
    """Return what is seen in a tree, which stays as it is."""
    seen = GlobalNames({})
    seen.visit(tree)
    return Seen(frozenset(seen.used), frozenset(seen.own))


def tree_of(module: Module) -> ast.Module:
    """Return a tree of a module that may be changed. ValueError: this Python cannot write what is in an f-string."""
    return ast.parse(module.written)
