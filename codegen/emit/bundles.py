"""Bundles: modules that a program always loads together are compiled into one.

A module takes some 200 bytes of a board's heap before anything is in it: its name, that of its file, its table of
names, and what it imports has a place in it. But what stands at the top level of a module is garbage only once all of
it has run: of a whole program that is more than several bundles leave, one after the other.
"""

import ast
from collections.abc import Iterator
from itertools import count

from codegen.emit.global_names import bound_at_top, seen_in
from codegen.emit.private_names import Module, constant_of
from codegen.emit.program import Program
from codegen.frozen import dataclass

MOST_NAMES = 500


@dataclass(frozen=True, slots=True)
class Bundle:
    """Modules, in the order in which they are loaded."""

    name: str
    modules: tuple[str, ...]


def bundles_of(program: Program) -> list[Bundle]:
    """Return the bundles of a program in the order in which they are loaded."""
    taken = {*program.modules, *(word for module in program.others for word in module.names)}
    free = (name for name in (f"part_{number}" for number in count()) if name not in taken)
    rows: list[list[str]] = [[]]
    names, kept = set[str](), set[str]()
    for name in program.loaded:
        own, fixed = _names_in(program.modules[name]), fixed_names(program, name)
        if name in program.alone or len(names | own) > MOST_NAMES or not kept.isdisjoint(fixed):
            rows, names, kept = [*rows, []], set(), set()
        if name not in program.alone:
            rows[-1].append(name)
            names |= own
            kept |= fixed
    return [Bundle(next(free), tuple(row)) for row in rows if row]


def fixed_names(program: Program, name: str) -> set[str]:
    """Return the names at the top level of a module that stay: those of classes, and what others look for by name."""
    module = program.modules[name]
    fixed = program.fixed.get(name, frozenset())
    own = bound_at_top(module.tree) - module.imports.keys()
    classes = {each.name for each in module.tree.body if isinstance(each, ast.ClassDef)}
    stays = fixed | program.named
    return {each for each in own if each in stays or (each[0] != "_" and (each in classes or "*" in fixed))}


def numbers_of(program: Program, name: str) -> dict[str, str]:
    """Return the public numbers of a module that its compiler can put in place, as they are written."""
    module = program.modules[name]
    fixed = program.asked.get(name, frozenset())
    found = {}
    for node in module.tree.body:
        value = node.value if isinstance(node, ast.Assign) and len(node.targets) == 1 else None
        target = node.targets[0] if isinstance(node, ast.Assign) else None
        if constant_of(node) is not None and isinstance(value, ast.Call):
            value = value.args[0]
        is_number = isinstance(value, ast.Constant) and type(value.value) is int
        if isinstance(value, ast.UnaryOp) and isinstance(value.op, ast.USub):
            is_number = isinstance(value.operand, ast.Constant) and type(value.operand.value) is int
        if isinstance(target, ast.Name) and target.id[0] != "_" and target.id not in fixed and value and is_number:
            found[target.id] = ast.unparse(value)
    bound = [each for node in module.nodes for each in _stored(node)]
    return {each: value for each, value in found.items() if bound.count(each) == 1}


def _stored(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
        yield node.id
    elif isinstance(node, (ast.arg, ast.Global)):
        yield from [node.arg] if isinstance(node, ast.arg) else node.names


def _names_in(module: Module) -> set[str]:
    """Return the names that a compiled module has a table of."""
    found = {*seen_in(module.tree).used, *bound_at_top(module.tree)}
    for node in module.nodes:
        if isinstance(node, ast.Attribute):
            found.add(node.attr)
        elif isinstance(node, (ast.keyword, ast.arg)) and node.arg:
            found.add(node.arg)
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            found.add(node.name)
    return found
