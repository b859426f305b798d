"""Finds the rules that can be reported at all, from the source: those that code loads which a command runs.

Everything in ``codegen.cli`` runs, and each ``check`` of the packages that are searched for them; so does what these
load. A method runs where anything loads an attribute of its name: too much counts as run rather than too little.
"""

import ast
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, lru_cache
from pathlib import Path

import codegen

PACKAGE = Path(codegen.__file__).parent

Constant = tuple[str, str]
"""A module by its dotted name, and the name of a constant in it."""


@dataclass(frozen=True)
class Unit:
    """A function, method, class or assignment by its name, or a nameless statement of a module: what it loads."""

    own: Constant
    is_method: bool
    constants: frozenset[Constant]
    attributes: frozenset[str]


@cache
def sources() -> dict[str, str]:
    """The text of each module by its dotted name."""
    paths = {path: path.relative_to(PACKAGE).with_suffix("").parts for path in sorted(PACKAGE.rglob("*.py"))}
    return {".".join(("codegen", *parts)).removesuffix(".__init__"): path.read_text() for path, parts in paths.items()}


@lru_cache(maxsize=2000)
def tree_of(text: str) -> ast.Module:
    """The tree of a module, parsed once for all that look at it."""
    return ast.parse(text)


def nodes_of(top: ast.AST) -> Iterator[ast.AST]:
    """Every node of a tree, in any order: twice as fast as ``ast.walk``."""
    waiting = [top]
    while waiting:
        node = waiting.pop()
        yield node
        for value in vars(node).values():
            if isinstance(value, ast.AST):
                waiting.append(value)
            elif isinstance(value, list):
                waiting += [each for each in value if isinstance(each, ast.AST)]


def reported(texts: Mapping[str, str]) -> set[Constant]:
    """The constants that are loaded by what runs."""
    trees = {name: tree_of(text) for name, text in texts.items()}
    imports = {name: _imports(tree) for name, tree in trees.items()}
    units = [unit for name, tree in trees.items() for unit in _units(name, tree, imports)]
    running = [unit for unit in units if _is_first(*unit.own)]
    waiting = [unit for unit in units if not _is_first(*unit.own)]
    constants: set[Constant] = set()
    attributes: set[str] = set()
    while running:
        constants.update(constant for unit in running for constant in unit.constants)
        attributes.update(name for unit in running for name in unit.attributes)
        reached = {unit for unit in waiting if (unit.own[1] in attributes and unit.is_method) or unit.own in constants}
        running, waiting = list(reached), [unit for unit in waiting if unit not in reached]
    return constants


def _is_first(module: str, name: str) -> bool:
    is_found = name == "check" and module.startswith(("codegen.rules.", "codegen.claims."))
    return is_found or module.startswith("codegen.cli") or not name


def _imports(tree: ast.Module) -> dict[str, Constant]:
    return {
        alias.asname or alias.name: (node.module or "", alias.name)
        for node in nodes_of(tree)
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }


def _units(module: str, tree: ast.Module, imports: Mapping[str, Mapping[str, Constant]]) -> Iterator[Unit]:
    for statement in tree.body:
        for name, nodes in _named(statement):
            constants, attributes = _loaded(nodes, module, imports)
            is_method = isinstance(statement, ast.ClassDef) and name != statement.name
            yield Unit((module, name), is_method, frozenset(constants), frozenset(attributes))


def _named(statement: ast.stmt) -> Iterator[tuple[str, Iterable[ast.AST]]]:
    """The parts of a statement by the name that runs them; a class runs what is no method, and its special methods."""
    match statement:
        case ast.FunctionDef(name=name) | ast.Assign(targets=[ast.Name(id=name)]):
            yield name, [statement]
        case ast.AnnAssign(target=ast.Name(id=name)):
            yield name, [statement]
        case ast.ClassDef(name=name, body=body):
            methods = [part for part in body if isinstance(part, ast.FunctionDef) and not part.name.startswith("__")]
            yield from ((method.name, [method]) for method in methods)
            rest = [part for part in body if part not in methods]
            yield name, [*statement.bases, *statement.decorator_list, *rest]
        case ast.Import() | ast.ImportFrom() | ast.Expr(value=ast.Constant()):
            pass
        case _:
            yield "", [statement]


def _loaded(
    nodes: Iterable[ast.AST], module: str, imports: Mapping[str, Mapping[str, Constant]]
) -> tuple[set[Constant], set[str]]:
    """Return the constants that loaded names stand for, and the names of attributes."""
    constants: set[Constant] = set()
    attributes: set[str] = set()
    for node in (found for top in nodes for found in nodes_of(top)):
        match node:
            case ast.Name(id=name, ctx=ast.Load()):
                constants.add(_declared(module, name, imports))
            case ast.Attribute(value=ast.Name(id=owner), attr=name) if owner in imports[module]:
                attributes.add(name)
                constants.add(_declared(".".join(imports[module][owner]), name, imports))
            case ast.Attribute(attr=name):
                attributes.add(name)
    return constants, attributes


def _declared(module: str, name: str, imports: Mapping[str, Mapping[str, Constant]]) -> Constant:
    """Return where a name of a module is declared: modules may import it from others, a package its own modules."""
    while imports.get(module, {}).get(name, (module, name)) != (module, name):
        module, name = imports[module][name]
    return module, name
