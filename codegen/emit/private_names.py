"""Names for what is a module's own, and which of them others can stand for.

A name with one underscore in front is private, unless something finds it by its text: a string, a keyword of a call, a
module that is not among these. Names of attributes meet where classes inherit from each other: modules of such classes
are one scope.
"""

import ast
import builtins
import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property, lru_cache

WORD = re.compile(r"[^\W\d]\w*")
_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
_NAMING = frozenset(
    (ast.Name, ast.Attribute, ast.keyword, ast.arg, ast.alias, ast.Global, ast.Nonlocal, *_FUNCTIONS, ast.ClassDef)
) | {ast.ExceptHandler}
"""The kinds of nodes that have names."""


class Module:
    """A module as its syntax tree has it: what is asked for is found out once, and nobody changes the tree."""

    def __init__(self, tree: ast.Module) -> None:
        """Take over a tree."""
        self.tree = tree
        self.nodes = tuple(walked(tree))

    @cached_property
    def written(self) -> str:
        """Its text, anew of its tree. ValueError: this Python cannot write what is in an f-string."""
        return ast.unparse(self.tree)

    @cached_property
    def classes(self) -> tuple[ast.ClassDef, ...]:
        """All classes."""
        return tuple(node for node in self.nodes if isinstance(node, ast.ClassDef))

    @cached_property
    def names(self) -> frozenset[str]:
        """Every name that is written in it."""
        return frozenset(name for node in self.nodes if type(node) in _NAMING for name in _names(node))

    @cached_property
    def bound(self) -> frozenset[str]:
        """The names that it gives to something itself."""
        return frozenset(name for node in self.nodes if type(node) in _NAMING for name in bound_by(node))

    @cached_property
    def set_elsewhere(self) -> frozenset[str]:
        """The attributes that it sets of objects whose class may be in any module."""
        return frozenset(_set_elsewhere(self.nodes, self.classes))

    @cached_property
    def imports(self) -> Mapping[str, tuple[str, str]]:
        """The module that an imported name comes from and what it is called there, "" for the module itself."""
        return dict(pair for node in self.nodes for pair in _imports(node))


_PARTLESS = frozenset(("ctx", "op", "ops", "id", "attr", "arg", "kind", "type_comment"))
"""Fields with no nodes, or with some that only say which of a few kinds theirs is: these are half of all."""


_PARTS: dict[type[ast.AST], tuple[str, ...]] = {ast.Constant: ()}
"""The fields of nodes with others below them, by their kinds, as far as they have been met."""


def children(node: ast.AST) -> list[ast.AST]:
    """Return the nodes right below one, as they are written, but for kinds of contexts and operators."""
    kind = type(node)
    parts = _PARTS.get(kind)
    if parts is None:
        parts = _PARTS[kind] = tuple(field for field in node._fields if field not in _PARTLESS)
    found: list[ast.AST] = []
    for part in parts:
        value = getattr(node, part, None)
        if isinstance(value, list):
            found += [each for each in value if isinstance(each, ast.AST)]
        elif isinstance(value, ast.AST):
            found.append(value)
    return found


def walked(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield a node and all below it, level by level."""
    level = [tree]
    while level:
        yield from level
        level = [below for node in level for below in children(node)]


@lru_cache(maxsize=256)
def read_module(text: str) -> Module:
    """Return a module of its text; several steps read the same texts."""
    return Module(ast.parse(text))


def words(text: str) -> list[str]:
    """Return what in a text could be a name."""
    return WORD.findall(text)


def constant_of(node: ast.AST) -> str | None:
    """Return the name of a statement ``NAME = const(...)``, None for every other one."""
    if not (isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.value, ast.Call)):
        return None
    name, called = node.targets[0], node.value.func
    is_const = isinstance(called, ast.Name) and called.id == "const"
    return name.id if is_const and isinstance(name, ast.Name) else None


def private_names(modules: Mapping[str, Module], others: Iterable[str]) -> dict[str, frozenset[str]]:
    """Return in which scopes each private name is that can have another one; scopes are named as their first module.

    ``others`` are the texts of all other modules of the program: what is a word there is left as it is.
    """
    fixed = {word for text in others for word in words(text)}
    for module in modules.values():
        fixed.update(_fixed(module, modules))
    scopes = _scopes(modules)
    bound = frozenset().union(*(module.bound for module in modules.values()))
    everywhere = frozenset().union(*(module.set_elsewhere for module in modules.values()))
    return {
        name: frozenset(scope for at, scope in scopes.items() if name in everywhere or name in modules[at].names)
        for name in bound - fixed
        if name[0] == "_" and name[1:2] not in ("", "_")
    }


def _names(node: ast.AST) -> Iterable[str]:
    if isinstance(node, ast.Name):
        return (node.id,)
    if isinstance(node, ast.Attribute):
        return (node.attr,)
    if isinstance(node, (ast.keyword, ast.arg)) and node.arg:
        return (node.arg,)
    if isinstance(node, ast.alias):
        return (*node.name.split("."), *([node.asname] if node.asname else []))
    if isinstance(node, (ast.Global, ast.Nonlocal)):
        return node.names
    return (node.name,) if isinstance(node, (*_FUNCTIONS, ast.ClassDef, ast.ExceptHandler)) and node.name else ()


def bound_by(node: ast.AST) -> Iterable[str]:
    """Return what a node gives a name to."""
    is_read = isinstance(node, (ast.Name, ast.Attribute)) and isinstance(node.ctx, ast.Load)
    return () if is_read or isinstance(node, (ast.alias, ast.keyword)) else _names(node)


def _set_elsewhere(nodes: Iterable[ast.AST], classes: Iterable[ast.ClassDef]) -> Iterator[str]:
    own = {id(node) for each in classes for node in walked(each)}
    for node in nodes:
        if isinstance(node, ast.Attribute) and not isinstance(node.ctx, ast.Load):
            is_own = id(node) in own and isinstance(node.value, ast.Name) and node.value.id == "self"
            if not is_own:
                yield node.attr


def sources_of(node: ast.AST) -> list[str]:
    """Return the modules that the names of an import come from, one for each of them; none of any other node."""
    if isinstance(node, ast.Import):
        return [each.name for each in node.names]
    return [node.module or ""] * len(node.names) if isinstance(node, ast.ImportFrom) else []


def _imports(node: ast.AST) -> Iterator[tuple[str, tuple[str, str]]]:
    if isinstance(node, ast.ImportFrom):
        yield from ((each.asname or each.name, (node.module or "", each.name)) for each in node.names)
    elif isinstance(node, ast.Import):
        yield from ((each.asname or each.name.partition(".")[0], (each.name, "")) for each in node.names)


def _fixed(module: Module, modules: Mapping[str, Module]) -> Iterator[str]:
    """Yield the names in a module that something other than the compiler of ``modules`` reads."""
    docs = docstrings(module.nodes)
    for node in module.nodes:
        constant = constant_of(node)
        if constant is not None:
            yield constant  # the compiler puts the number in its place: there is no such name
        elif isinstance(node, ast.Constant) and id(node) not in docs:
            yield from words(node.value if isinstance(node.value, str) else str(node.value))
        elif isinstance(node, ast.keyword) and node.arg:
            yield node.arg
    for name, (source, original) in module.imports.items():
        if source not in modules or not original:
            yield from (name, original)


def docstrings(nodes: Iterable[ast.AST]) -> set[int]:
    """Return the ids of the nodes that are documentation."""
    first = (node.body[0] for node in nodes if isinstance(node, (ast.Module, ast.ClassDef, *_FUNCTIONS)) and node.body)
    return {id(each.value) for each in first if isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant)}


def _scopes(modules: Mapping[str, Module]) -> dict[str, str]:
    """Return the scope of each module: that of all modules with whose classes its own share their objects."""
    scopes = {name: name for name in modules}
    for name, module in modules.items():
        for other in {
            other for each in module.classes for base in each.bases for other in _origins(base, module, modules)
        }:
            joined = {scopes[name], scopes[other]}
            scopes |= {each: min(joined) for each, scope in scopes.items() if scope in joined}
    return scopes


def _origins(base: ast.expr, module: Module, modules: Mapping[str, Module]) -> Iterator[str]:
    """Yield the modules that a base of a class may come from."""
    own = {each.name for each in module.classes}
    for node in walked(base):
        if isinstance(node, ast.Name) and node.id not in own and not hasattr(builtins, node.id):
            if node.id not in module.imports:  # a variable
                yield from (source for source, _ in module.imports.values() if source in modules)
            else:
                source, original = module.imports[node.id]
                wanted = original or (base.attr if isinstance(base, ast.Attribute) else "")
                yield from _way(source, wanted, modules)


def _way(source: str, name: str, modules: Mapping[str, Module]) -> Iterator[str]:
    """Yield a module, and those from which it has a name itself."""
    if source in modules:
        yield source
        imports = modules[source].imports
        if name in imports or "*" in imports:
            further, original = imports.get(name) or imports["*"]
            yield from _way(further, name if original == "*" else original, modules)
