"""Finds, from the source, where a rule is reported, and whether a hint surely goes with it.

Surely: a text stands there, or something of which the source says that it is a text and never None. Whatever cannot be
followed so (a rule handed to another function, a hint that may be None) does not count as a hint.
"""

import ast
import builtins
import importlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import ModuleType

from rule_reach import nodes_of

from codegen.diagnostics import Rule

HINTS = {
    "Report.add": 3,
    "Diagnostic": 3,
    "Surroundings.bad": 3,
    "ScenarioValues.say": 3,
    "Mismatch": 2,
    "BoardFaultError": 2,
    "Problem": 2,
    "Reading.found": 4,
}
"""What reports a rule, with the position of the hint among its arguments; ``test_hints`` compares with signatures."""

_POSITIONS = {name.rpartition(".")[2]: position for name, position in HINTS.items()}


@dataclass(frozen=True)
class Reported:
    """A use of a rule in the source, with its line. ``is_hinted``: it is reported there with what is surely a hint."""

    rule: Rule
    line: int
    is_hinted: bool


def reports(tree: ast.Module, module: ModuleType | Mapping[str, object]) -> Iterator[Reported]:
    """Yield each use of a rule; ``module`` is what the names of the source stand for: the module, or its names."""
    names = dict(vars(module) if isinstance(module, ModuleType) else module)
    for node in nodes_of(tree):
        if isinstance(node, ast.ImportFrom) and node.module is not None:  # those of functions, too
            late = importlib.import_module(node.module)
            names.update({each.asname or each.name: getattr(late, each.name, None) for each in node.names})
    yield from _reports(tree, names, (), None)


def _reports(
    node: ast.AST, names: Mapping[str, object], functions: tuple[ast.FunctionDef, ...], call: ast.Call | None
) -> Iterator[Reported]:
    """The uses below ``node``, which stands in ``functions``, and is an argument of ``call`` or a choice of one."""
    if isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Load):
        rule = _value(node, names)
        if isinstance(rule, Rule):
            yield Reported(rule, node.lineno, call is not None and _has_hint(call, names, functions))
            return
    if isinstance(node, ast.FunctionDef):
        functions = (*functions, node)
    inner = node if isinstance(node, ast.Call) else call if isinstance(node, ast.IfExp) else None
    for child in ast.iter_child_nodes(node):
        yield from _reports(child, names, functions, inner)


def _value(node: ast.expr, names: Mapping[str, object]) -> object:
    """Return what a name stands for, or an attribute of one; None if that is not known."""
    match node:
        case ast.Name(id=name):
            return names.get(name, getattr(builtins, name, None))
        case ast.Attribute(value=ast.Name() as owner, attr=name):
            return getattr(_value(owner, names), name, None)
    return None


def _has_hint(call: ast.Call, names: Mapping[str, object], functions: tuple[ast.FunctionDef, ...]) -> bool:
    position = _POSITIONS.get(_called(call))
    if position is None:
        return False
    stated = [keyword.value for keyword in call.keywords if keyword.arg == "hint"]
    if not stated and len(call.args) > position and not any(isinstance(each, ast.Starred) for each in call.args):
        stated = [call.args[position]]
    return len(stated) == 1 and _is_text(stated[0], names, functions)


def _called(call: ast.Call) -> str:
    return call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")


def _is_text(node: ast.expr, names: Mapping[str, object], functions: tuple[ast.FunctionDef, ...]) -> bool:
    """Return whether an expression is sure to be a text that says something."""
    match node:
        case ast.Constant(value=str(text)):
            return bool(text.strip())
        case ast.JoinedStr():
            return True
        case ast.IfExp(body=body, orelse=other):
            return _is_text(body, names, functions) and _is_text(other, names, functions)
        case ast.BinOp(left=left, right=right):
            return _is_text(left, names, functions) or _is_text(right, names, functions)
        case ast.BoolOp(op=ast.Or(), values=[*_, value]) | ast.NamedExpr(value=value):
            return _is_text(value, names, functions)
        case ast.Call(func=called):
            function = _value(called, names)
            return getattr(function, "__annotations__", {}).get("return") in (str, "str")
        case ast.Name(id=name) if functions:
            return _is_local_text(name, names, functions)
        case ast.Name() | ast.Attribute():
            return isinstance(_value(node, names), str)
    return False


def _is_local_text(name: str, names: Mapping[str, object], functions: tuple[ast.FunctionDef, ...]) -> bool:
    """Return whether a name in a function is a text wherever it is set: in the innermost one that sets it."""
    for depth in range(len(functions), 0, -1):
        function = functions[depth - 1]
        arguments = function.args
        for each in (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs):
            if each.arg == name:
                return each.annotation is not None and ast.unparse(each.annotation) == "str"
        values = list(_set(name, function))
        if values:
            return not any(_names(value, name) for value in values) and all(
                value is not None and _is_text(value, names, functions[:depth]) for value in values
            )
    return isinstance(names.get(name), str)


def _set(name: str, function: ast.FunctionDef) -> Iterator[ast.expr | None]:
    """Yield what a name is set to in a function; None for what cannot be followed."""
    for node in ast.walk(function):
        match node:
            case ast.Assign(targets=[ast.Name(id=target)], value=value) if target == name:
                yield value
            case ast.NamedExpr(target=ast.Name(id=target), value=value) if target == name:
                yield value
            case ast.AnnAssign(target=ast.Name(id=target), value=value) if target == name and value is not None:
                yield value
            case ast.Assign(targets=[ast.Tuple(elts=targets)], value=ast.Tuple(elts=values)) if len(targets) == len(
                values
            ):
                yield from (
                    value for target, value in zip(targets, values, strict=True) if getattr(target, "id", "") == name
                )
            case (
                ast.Assign(targets=[ast.Tuple() as several])
                | ast.For(target=several)
                | ast.comprehension(target=several)
            ):
                if _names(several, name):
                    yield None


def _names(node: ast.AST | None, name: str) -> bool:
    return node is not None and any(isinstance(each, ast.Name) and each.id == name for each in ast.walk(node))
